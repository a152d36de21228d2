/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_friction.c - friction: against the fixed point on random machines, locking against statics
** by hand, mirrored and reversed motions.
*/
#include "samples.h"

/* Both solvers, which agree; the status of both. */
static int solve(const sample *s, const fourlink_friction *friction, fourlink_forces *f,
                 fourlink_losses *l)
{
    fourlink_forces other;
    fourlink_losses lost;
    int status =
        fourlink_solve_friction(&s->mechanism, &s->state, s->load, s->n_loads, friction, 1, f, l);
    double arm = s->design.link[2].length;

    assert_int_equal(fourlink_solve_friction(&s->mechanism, &s->state, s->load, s->n_loads,
                                             friction, 0, &other, &lost),
                     status);
    if (status != FOURLINK_OK)
        return status;
    assert_same_forces(f, &other, arm, 1e-10 * largest(f, arm) / fabs(s->state.sine));
    return status;
}

static fourlink_friction pins(double circle)
{
    fourlink_friction friction;
    int i;

    memset(&friction, 0, sizeof friction);
    for (i = 0; i < 4; i++)
        friction.circle[i] = circle;
    return friction;
}

/* ---------------------------------------------------------------------------------------------
** Random machines
** ------------------------------------------------------------------------------------------- */

static fourlink_friction draw_friction(uint64_t *seed)
{
    fourlink_friction friction;
    int i;

    memset(&friction, 0, sizeof friction);
    for (i = 0; i < 4; i++)
        friction.circle[i] = uniform(seed, 0, 0.02);
    friction.guide = uniform(seed, 0, 0.2);
    friction.guide_length = uniform(seed, 0, 1) < 0.3 ? 0 : uniform(seed, 0.1, 1);
    friction.direction = uniform(seed, 0, 1) < 0.5 ? -1 : 1;
    return friction;
}

/* Friction as it should be, from the forces of a solution: moments at the pins, the force of the guide. */
static void expected_sizes(const sample *s, const fourlink_friction *friction,
                           const fourlink_forces *f, double y[4])
{
    double N = 0, M = 0;
    int guide = s->design.kind == FOURLINK_FOUR_BAR       ? -1
                : s->design.kind == FOURLINK_SLIDER_CRANK ? 3
                                                          : 2;

    y[0] = friction->circle[0] * hypot(f->F12x, f->F12y);
    y[1] = friction->circle[1] * hypot(f->F23x, f->F23y);
    y[2] = friction->circle[2] * hypot(f->F34x, f->F34y);
    y[3] = friction->circle[3] * hypot(f->F14x, f->F14y);
    if (guide == 3) {
        N = f->F14y;
        M = f->M14;
    } else if (guide == 2) {
        N = f->N34;
        M = f->M34;
    }
    if (guide > 0)
        y[guide] = friction->guide * (friction->guide_length > 0
                                          ? fmax(fabs(N), 2 * fabs(M) / friction->guide_length)
                                          : fabs(N));
}

/* The loads of friction of sizes y, by the law: against the relative speed of each joint. */
static unsigned long friction_loads(const sample *s, const double y[4], double sense,
                                    fourlink_load *load)
{
    const fourlink_link_state *link = s->state.link;
    int guide = s->design.kind == FOURLINK_FOUR_BAR       ? -1
                : s->design.kind == FOURLINK_SLIDER_CRANK ? 3
                                                          : 2;
    double k[4] = {1, link[3].k - 1, link[4].k - link[3].k, link[4].k};
    static const int from[4] = {1, 2, 3, 1}, on[4] = {2, 3, 4, 4};
    unsigned long n = 0;
    int i;

    memset(load, 0, 8 * sizeof *load);
    for (i = 0; i < 4; i++) {
        double sign = k[i] * sense > 0 ? 1 : -1;

        if (i == guide && i == 3) {
            sign = link[4].k_origin.x * sense > 0 ? 1 : -1;
            load[n].link = 4;
            load[n++].force.x = -sign * y[i];
        } else if (i == guide) {
            double rx = link[3].origin.x - link[4].origin.x,
                   ry = link[3].origin.y - link[4].origin.y;
            double v = (link[3].k_origin.x + link[4].k * ry) * link[3].axis.x +
                       (link[3].k_origin.y - link[4].k * rx) * link[3].axis.y;

            sign = v * sense > 0 ? 1 : -1;
            load[n].link = 3;
            load[n].force.x = -sign * y[i] * link[3].axis.x;
            load[n++].force.y = -sign * y[i] * link[3].axis.y;
            load[n].link = 4;
            load[n].at.x = rx * link[4].axis.x + ry * link[4].axis.y;
            load[n].at.y = -rx * link[4].axis.y + ry * link[4].axis.x;
            load[n].force.x = sign * y[i] * link[3].axis.x;
            load[n++].force.y = sign * y[i] * link[3].axis.y;
        } else {
            load[n].link = on[i];
            load[n++].torque = -sign * y[i];
            if (from[i] > 1) {
                load[n].link = from[i];
                load[n++].torque = sign * y[i];
            }
        }
    }
    return n;
}

/* What a guide exerts on link 4 has its friction; pins have no force of friction. */
static void add_friction_of_guide(const sample *s, const fourlink_load *load, unsigned long n,
                                  fourlink_forces *f)
{
    unsigned long i;

    for (i = 0; i < n; i++)
        if (load[i].link == 4 && s->design.kind == FOURLINK_SLIDER_CRANK) {
            f->F14x += load[i].force.x;
        } else if (load[i].link == 4) {
            f->F34x += load[i].force.x;
            f->F34y += load[i].force.y;
        }
}

/* The fixed point y = phi(x(y)); 0 if it does not converge. */
static int fixed_point(const sample *s, const fourlink_friction *friction, double sense,
                       fourlink_forces *f)
{
    fourlink_load load[MOST_LOADS + 8];
    double y[4] = {0, 0, 0, 0}, next[4];
    int step, i;

    memcpy(load, s->load, sizeof s->load);
    for (step = 0; step < 300; step++) {
        unsigned long n = friction_loads(s, y, sense, load + s->n_loads);
        double change = 0, size = 0;

        if (fourlink_solve(&s->mechanism, &s->state, load, s->n_loads + n, f) != FOURLINK_OK)
            return 0;
        expected_sizes(s, friction, f, next);
        for (i = 0; i < 4; i++) {
            change = fmax(change, fabs(next[i] - y[i]));
            size = fmax(size, fabs(next[i]));
            y[i] = next[i];
        }
        if (change <= 1e-14 * size) {
            add_friction_of_guide(s, load + s->n_loads, n, f);
            return 1;
        }
        if (!(size < 1e20))
            return 0;
    }
    return 0;
}

/* Of the power that comes in, at the crank or from the loads, what is not lost goes out at the other side. */
static void check_efficiency(const sample *s, const fourlink_forces *f, const fourlink_losses *l)
{
    double at_crank = f->Ts * s->crank.omega2;
    double in = at_crank > 0 ? at_crank : l->power - at_crank;
    double out = at_crank > 0 ? fmax(at_crank - l->power, 0) : -at_crank;

    assert_near(l->efficiency * in, out, 1e-9 * (in + l->power));
}

#define MACHINES 10000

TEST(test_fixed_point)
{
    uint64_t seed = 11;
    int n = 0, kinds[5] = {0, 0, 0, 0, 0}, locked = 0, tried = 0;

    while (n < MACHINES) {
        fourlink_friction friction = draw_friction(&seed);
        fourlink_forces f, by_iteration;
        fourlink_losses l;
        double arm, sense;
        sample s;
        int status;

        draw_any(&seed, tried++, &s);
        if (move(&s) != FOURLINK_OK || fabs(s.state.sine) < 0.1)
            continue;
        sense = s.crank.omega2 != 0 ? s.crank.omega2 : friction.direction;
        status = solve(&s, &friction, &f, &l);
        if (!fixed_point(&s, &friction, sense, &by_iteration)) {
            locked += status == FOURLINK_LOCKED;
            continue;
        }
        if (status == FOURLINK_LOCKED) { /* the fixed point need not be the continuation */
            locked++;
            continue;
        }
        assert_int_equal(status, FOURLINK_OK);
        arm = s.design.link[2].length;
        assert_same_forces(&f, &by_iteration, arm, 1e-10 * largest(&by_iteration, arm));
        assert_near(f.residual, 0, 1e-12);
        assert_true(l.power >= 0 && l.efficiency >= 0 && l.efficiency <= 1 + 1e-12);
        assert_near((f.Ts - l.Ts0) * s.crank.omega2, l.power,
                    1e-9 * (l.power + fabs(l.Ts0 * s.crank.omega2) + 100 * fabs(f.residual)));
        check_efficiency(&s, &f, &l);
        kinds[s.design.kind]++;
        n++;
    }
    print_message(
        "%d machines (%d four-bar, %d slider-crank, %d inverted) agree with the fixed point; "
        "%d locked\n",
        n, kinds[1], kinds[2], kinds[4], locked);
    assert_true(kinds[1] > 1000 && kinds[2] > 1000 && kinds[4] > 1000 && locked < MACHINES / 10);
}

/* Half the friction, half the rise of Ts: to second order. */
TEST(test_small)
{
    sample s = rocker(110);
    fourlink_forces f;
    fourlink_losses l;
    double rise[3];
    int i;

    s.load[0].link = 4;
    s.load[0].torque = 0.5;
    s.n_loads = 1;
    assert_int_equal(move(&s), FOURLINK_OK);
    for (i = 0; i < 3; i++) {
        fourlink_friction friction = pins(1e-6 / (1 << i));

        assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_OK);
        assert_close(l.Ts0, s.forces.Ts, 1e-14);
        rise[i] = f.Ts - l.Ts0;
    }
    assert_true(rise[0] > 0);
    assert_close(rise[0], 2 * rise[1], 1e-3);
    assert_near((rise[0] - 2 * rise[1]) / (rise[1] - 2 * rise[2]), 4, 0.1);
}

/* ---------------------------------------------------------------------------------------------
** Signs
** ------------------------------------------------------------------------------------------- */

/* Mirrored at the x axis, the machine has the mirrored forces. */
TEST(test_mirrored)
{
    uint64_t seed = 3;
    int n = 0, tried = 0;

    while (n < 300) {
        fourlink_friction friction = draw_friction(&seed);
        fourlink_forces f, g;
        fourlink_losses l, k;
        sample s, m;
        unsigned long i;
        int link;

        draw_any(&seed, tried++, &s);
        if (move(&s) != FOURLINK_OK || fabs(s.state.sine) < 0.1 ||
            solve(&s, &friction, &f, &l) != FOURLINK_OK)
            continue;
        m = s;
        m.crank.theta2 = -s.crank.theta2;
        m.crank.omega2 = -s.crank.omega2;
        m.crank.alpha2 = -s.crank.alpha2;
        m.design.offset = -s.design.offset;
        m.design.angle = -s.design.angle;
        m.design.gravity.y = -s.design.gravity.y;
        for (link = 2; link <= 4; link++)
            m.design.link[link].cg.y = -s.design.link[link].cg.y;
        for (i = 0; i < s.n_loads; i++) {
            m.load[i].force.y = -s.load[i].force.y;
            m.load[i].at.y = -s.load[i].at.y;
            m.load[i].torque = -s.load[i].torque;
        }
        if (s.design.kind == FOURLINK_FOUR_BAR)
            m.branch = s.branch == FOURLINK_OPEN ? FOURLINK_CROSSED : FOURLINK_OPEN;
        friction.direction = -friction.direction;
        assert_int_equal(move(&m), FOURLINK_OK);
        assert_int_equal(solve(&m, &friction, &g, &k), FOURLINK_OK);
        assert_near(g.Ts, -f.Ts, 1e-9 * (fabs(f.Ts) + fabs(l.Ts0)));
        assert_near(k.efficiency, l.efficiency, 1e-9);
        assert_near(k.power, l.power, 1e-9 * l.power);
        n++;
    }
}

/* The same positions in the other sense: the friction of a static load is reversed. */
TEST(test_reversed)
{
    fourlink_friction friction = pins(1e-4);
    fourlink_forces f, g, at_rest;
    fourlink_losses l;
    sample s = rocker(70);

    s.load[0].link = 4;
    s.load[0].torque = 5;
    s.n_loads = 1;
    s.crank.omega2 = 1e-6; /* no inertia to speak of */
    assert_int_equal(move(&s), FOURLINK_OK);
    assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_OK);
    s.crank.omega2 = -1e-6;
    assert_int_equal(move(&s), FOURLINK_OK);
    assert_int_equal(solve(&s, &friction, &g, &l), FOURLINK_OK);
    assert_true(f.Ts > l.Ts0 && g.Ts < l.Ts0);
    assert_close(f.Ts - l.Ts0, l.Ts0 - g.Ts, 0.02);
    s.crank.omega2 = 0;
    friction.direction = -1;
    assert_int_equal(move(&s), FOURLINK_OK);
    assert_int_equal(solve(&s, &friction, &at_rest, &l), FOURLINK_OK);
    assert_close(at_rest.Ts, g.Ts, 1e-9);
    assert_true(l.power == 0);
    friction.direction = 0;
    assert_int_equal(solve(&s, &friction, &at_rest, &l), FOURLINK_OK);
    assert_close(at_rest.Ts, f.Ts, 1e-9);
}

/* Where no force acts, nothing is lost, and there is no efficiency. */
TEST(test_no_force)
{
    fourlink_friction friction = pins(0.01);
    fourlink_forces f;
    fourlink_losses l;
    sample s;

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_SLIDER_CRANK;
    s.design.link[2].length = 0.05;
    s.design.link[3].length = 0.2;
    s.branch = FOURLINK_OPEN;
    s.crank.theta2 = s.crank.omega2 = 1;
    assert_int_equal(move(&s), FOURLINK_OK);
    assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_OK);
    assert_true(f.Ts == 0 && l.power == 0 && isnan(l.efficiency));
}

/* At a dead centre the piston stands still: its guide has no friction. */
TEST(test_dead_centre)
{
    fourlink_friction friction = pins(0);
    fourlink_forces f;
    fourlink_losses l;
    sample s;

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_SLIDER_CRANK;
    s.design.link[2].length = 0.05;
    s.design.link[3].length = 0.2;
    s.design.link[4].mass = 1;
    s.design.gravity.y = -9.81;
    s.branch = FOURLINK_OPEN;
    s.crank.omega2 = 10;
    friction.guide = 0.1;
    assert_int_equal(move(&s), FOURLINK_OK);
    assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_OK);
    assert_true(l.guide == 0 && f.Ts == l.Ts0);
    s.crank.theta2 = 1e-6;
    assert_int_equal(move(&s), FOURLINK_OK);
    assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_OK);
    assert_close(l.guide, 0.1 * fabs(f.F14y), 1e-12);
    assert_close(f.F14x, l.guide, 1e-12); /* the piston moves towards the crank */
}

/* The loads of friction have their places, whether joints have friction, and move, or not. */
TEST(test_places)
{
    static const int links[][FOURLINK_FRICTION_LOADS] = {{3, 2, 4, 3, 4, 2}, {3, 2, 3, 4, 4, 2}};
    uint64_t seed = 11;
    int n = 0, tried = 0, i;

    while (n < 60) {
        fourlink_friction friction = draw_friction(&seed);
        fourlink_forces f;
        fourlink_losses l;
        sample s;
        int row;

        draw_any(&seed, tried++, &s);
        friction.circle[n % 4] = 0;
        if (n % 3 == 0)
            friction.guide = 0;
        if (move(&s) != FOURLINK_OK || solve(&s, &friction, &f, &l) != FOURLINK_OK)
            continue;
        row = s.design.kind == FOURLINK_INVERTED_SLIDER_CRANK ? 1 : 0;
        assert_true(l.n_loads == FOURLINK_FRICTION_LOADS);
        for (i = 0; i < FOURLINK_FRICTION_LOADS; i++)
            assert_int_equal(l.load[i].link, links[row][i]);
        assert_true(fabs(l.load[5].torque) == l.pin[0] && fabs(l.load[0].torque) == l.pin[1] &&
                    l.load[0].torque == -l.load[1].torque);
        if (row == 0)
            assert_true(fabs(l.load[2].torque) == l.pin[2] &&
                        l.load[2].torque == -l.load[3].torque);
        else
            assert_close(hypot(l.load[2].force.x, l.load[2].force.y), l.guide, 1e-14);
        n++;
    }
}

/* ---------------------------------------------------------------------------------------------
** Locking
** ------------------------------------------------------------------------------------------- */

/* A massless slider-crank with friction in its guide, whose crank drives against P on the piston: with
** the obliquity phi of the rod, Q in the rod, N = Q sin(phi) and P + mu N = Q cos(phi), so that Q = P /
** (cos(phi) - mu sin(phi)). It locks where tan(phi) = 1 / mu. */
TEST(test_locking)
{
    double mu = 1.25;
    double locks = asin(1.2 * sin(atan(1 / mu)));
    fourlink_friction friction = pins(0);
    fourlink_forces f, before;
    fourlink_losses l, before_l;
    sample s;
    int i;

    memset(&s, 0, sizeof s);
    s.design.kind = FOURLINK_SLIDER_CRANK;
    s.design.link[2].length = 0.1;
    s.design.link[3].length = 0.12;
    s.branch = FOURLINK_OPEN;
    s.crank.omega2 = -1; /* towards the inner dead centre: the crank pushes the piston out */
    s.load[0].link = 4;
    s.load[0].force.x = -100;
    s.n_loads = 1;
    friction.guide = mu;
    for (i = 0; i < 20; i++) {
        double theta2 = locks + (i % 2 ? 1 : -1) * pow(10, -1 - i / 4.0), phi;

        s.crank.theta2 = theta2;
        phi = asin(sin(theta2) / 1.2);
        assert_int_equal(move(&s), FOURLINK_OK);
        memset(&before, i, sizeof before);
        memset(&before_l, i, sizeof before_l);
        f = before;
        l = before_l;
        if (i % 2) {
            assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_LOCKED);
            assert_memory_equal(&f, &before, sizeof f);
            assert_memory_equal(&l, &before_l, sizeof l);
        } else {
            double Q = 100 / (cos(phi) - mu * sin(phi));

            assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_OK);
            assert_close(hypot(f.F34x, f.F34y), Q, 1e-9 * Q);
            assert_close(l.guide, mu * Q * sin(phi), 1e-9 * Q);
        }
    }
    s.crank.theta2 =
        locks + 0.1; /* the other way the load drives: never locked, but it does not drive */
    s.crank.omega2 = 1;
    assert_int_equal(move(&s), FOURLINK_OK);
    assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_OK);
    assert_close(f.F34x, 100 / (1 + mu * tan(asin(sin(s.crank.theta2) / 1.2))), 1e-9);
}

TEST(test_bad)
{
    fourlink_friction good = pins(0.001), friction;
    sample s = rocker(40);
    fourlink_forces f, before;
    fourlink_losses l;
    double *numbers[6];
    int i;

    assert_int_equal(move(&s), FOURLINK_OK);
    for (i = 0; i < 4; i++)
        numbers[i] = &friction.circle[i];
    numbers[4] = &friction.guide;
    numbers[5] = &friction.guide_length;
    memset(&before, 1, sizeof before);
    f = before;
    for (i = 0; i < 6; i++) {
        friction = good;
        *numbers[i] = -1e-9;
        assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_BAD_FRICTION);
        *numbers[i] = NAN;
        assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_BAD_NUMBER);
        *numbers[i] = INFINITY;
        assert_int_equal(solve(&s, &friction, &f, &l), FOURLINK_BAD_NUMBER);
    }
    assert_int_equal(fourlink_solve_friction(&s.mechanism, &s.state, NULL, 1, &good, 1, &f, &l),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_solve_friction(&s.mechanism, &s.state, NULL, 0, NULL, 1, &f, &l),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_solve_friction(&s.mechanism, &s.state, NULL, 0, &good, 1, &f, NULL),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_solve_friction(&s.mechanism, NULL, NULL, 0, &good, 1, &f, &l),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_solve_friction(NULL, &s.state, NULL, 0, &good, 1, &f, &l),
                     FOURLINK_NULL);
    s.load[0].link = 1;
    assert_int_equal(fourlink_solve_friction(&s.mechanism, &s.state, s.load, 1, &good, 1, &f, &l),
                     FOURLINK_BAD_LINK);
    s.state.sine = 0;
    assert_int_equal(fourlink_solve_friction(&s.mechanism, &s.state, NULL, 0, &good, 1, &f, &l),
                     FOURLINK_SINGULAR);
    assert_memory_equal(&f, &before, sizeof f);
}

int main(void)
{
    return run_all_tests(NULL);
}
