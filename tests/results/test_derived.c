/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_derived.c - shaking force and moment, forces in the links' axes, offset inertia forces, mechanical
** advantage, instantaneous centres, superposition: on random mechanisms of both kinds.
*/
#include "check.h"
#include "mechanics/machine.h"
#include "results/analysis.h"
#include "fourlink.h"

typedef struct sample {
    fourlink_mechanism m;
    fourlink_branch branch;
    fourlink_crank crank;
    fourlink_load loads[3]; /* the last is the gas on the piston */
    double gas;
    fourlink_state state;
    fourlink_forces forces;
    flk_derived e;
} sample;

static uint64_t seed = 491;

/* What follows from the forces, with the given loads, and gas of this force. */
static void derive_from_forces(sample *x, double force)
{
    flk_element element[3];
    flk_machine machine;
    flk_acting acting;
    flk_given_load given[2];
    fourlink_load load[4];
    flk_gas gas;
    int i;

    memset(element, 0, sizeof element);
    memset(given, 0, sizeof given);
    memset(&machine, 0, sizeof machine);
    memset(&gas, 0, sizeof gas);
    for (i = 0; i < 2; i++) {
        given[i].load = x->loads[i];
        given[i].values.force = x->loads[i].force;
        given[i].values.torque = x->loads[i].torque;
        flk_element_of_given_load(&given[i], &element[i]);
    }
    gas.area = 1;
    gas.pressure = force;
    flk_element_of_gas(&gas, x->m.design.kind, &element[2]);
    machine.mechanism = x->m;
    machine.element = element;
    machine.n_elements = 3;
    flk_machine_finish(&machine);
    acting.load = load;
    acting.held = NULL;
    flk_machine_loads_at(&machine, x->branch, x->crank.theta2, x->crank.omega2, &acting);
    flk_derive_from_forces(&machine, &x->state, &x->forces, &acting, &x->e);
}

/* A random position well away from the dead ones. */
static void draw(sample *x)
{
    fourlink_design d;
    int i;

    do {
        memset(&d, 0, sizeof d);
        d.kind = uniform(&seed, 0, 1) < 0.5 ? FOURLINK_FOUR_BAR : FOURLINK_SLIDER_CRANK;
        for (i = 1; i <= 4; i++) {
            d.link[i].length = uniform(&seed, 0.2, 1);
            d.link[i].mass = uniform(&seed, 0, 3);
            d.link[i].inertia = uniform(&seed, 0, 0.3);
            d.link[i].cg.x = uniform(&seed, -0.5, 0.5);
            d.link[i].cg.y = uniform(&seed, -0.5, 0.5);
        }
        d.offset = d.kind == FOURLINK_SLIDER_CRANK ? uniform(&seed, -0.2, 0.2) : 0;
        d.gravity.x = uniform(&seed, -10, 10);
        d.gravity.y = uniform(&seed, -10, 10);
        x->branch = uniform(&seed, 0, 1) < 0.5 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        x->crank.theta2 = uniform(&seed, -6, 6);
        x->crank.omega2 = uniform(&seed, -5, 5);
        x->crank.alpha2 = uniform(&seed, -20, 20);
        memset(x->loads, 0, sizeof x->loads);
        for (i = 0; i < 2; i++) {
            x->loads[i].link = 2 + (int)uniform(&seed, 0, 3);
            x->loads[i].frame = i ? FOURLINK_FRAME_LINK : FOURLINK_FRAME_GROUND;
            x->loads[i].force.x = uniform(&seed, -50, 50);
            x->loads[i].force.y = uniform(&seed, -50, 50);
            x->loads[i].at.x = uniform(&seed, -1, 1);
            x->loads[i].torque = uniform(&seed, -20, 20);
        }
        x->gas = d.kind == FOURLINK_SLIDER_CRANK ? uniform(&seed, -100, 100) : 0;
        x->loads[2].link = FOURLINK_FOLLOWER;
        x->loads[2].force.x = -x->branch * x->gas;
        fourlink_prepare(&d, &x->m);
    } while (fourlink_analyse(&x->m, x->branch, &x->crank, x->loads, 3, &x->state, &x->forces) !=
                 FOURLINK_OK ||
             fabs(x->state.sine) < 0.3);
    flk_derive_from_motion(&x->m, &x->state, &x->e);
    derive_from_forces(x, x->gas);
    assert_int_equal(
        flk_derive_superposition(&x->m, &x->state, x->loads, 3, NULL, &x->forces, &x->e),
        FOURLINK_OK);
}

/* Momentum of the links, linear and about A, at a time t from the sample's. */
static void momentum(const sample *x, double t, double p[3])
{
    fourlink_crank c = x->crank;
    fourlink_state s;
    int i;

    c.theta2 += c.omega2 * t + 0.5 * c.alpha2 * t * t;
    c.omega2 += c.alpha2 * t;
    assert_int_equal(fourlink_analyse(&x->m, x->branch, &c, NULL, 0, &s, NULL), FOURLINK_OK);
    p[0] = p[1] = p[2] = 0;
    for (i = 2; i <= 4; i++) {
        const fourlink_link *link = &x->m.design.link[i];
        fourlink_vector G, v;

        fourlink_point(&s, i, &link->cg, &G, &v, NULL);
        p[0] += link->mass * v.x;
        p[1] += link->mass * v.y;
        p[2] += link->mass * (G.x * v.y - G.y * v.x) + link->inertia * s.link[i].omega;
    }
}

/* What weights and loads give, in F, x, y and about A; the gas is within the machine. */
static void add_given(const sample *x, double F[3])
{
    int i;

    for (i = 2; i <= 4; i++) {
        const fourlink_link *link = &x->m.design.link[i];
        const fourlink_vector *g = &x->m.design.gravity;
        fourlink_vector G;

        fourlink_point(&x->state, i, &link->cg, &G, NULL, NULL);
        F[0] += link->mass * g->x;
        F[1] += link->mass * g->y;
        F[2] += link->mass * (G.x * g->y - G.y * g->x);
    }
    for (i = 0; i < 2; i++) {
        const fourlink_load *l = &x->loads[i];
        const fourlink_link_state *s = &x->state.link[l->link];
        fourlink_vector P, f = l->force;

        if (l->frame == FOURLINK_FRAME_LINK) {
            f.x = cos(s->theta) * l->force.x - sin(s->theta) * l->force.y;
            f.y = sin(s->theta) * l->force.x + cos(s->theta) * l->force.y;
        }
        fourlink_point(&x->state, l->link, &l->at, &P, NULL, NULL);
        F[0] += f.x;
        F[1] += f.y;
        F[2] += P.x * f.y - P.y * f.x + l->torque;
    }
}

/* The frame gets what it gives the links at A and at D, or by the guide, and the gas on the head. */
TEST(test_sum_of_reactions)
{
    double worst = 0;
    int n, i;

    for (n = 0; n < 5000; n++) {
        double scale = 1000, Fx, Fy, moment;
        const fourlink_vector *D;
        sample x;

        draw(&x);
        D = &x.state.link[4].origin;
        Fx = -x.forces.F12x - x.forces.F14x + (double)x.branch * x.gas;
        Fy = -x.forces.F12y - x.forces.F14y;
        moment = -x.forces.Ts - x.forces.M14 - (D->x * x.forces.F14y - D->y * x.forces.F14x) -
                 x.m.design.offset * (double)x.branch * x.gas;
        scale += hypot(x.forces.F12x, x.forces.F12y) + hypot(x.forces.F14x, x.forces.F14y) +
                 fabs(x.forces.Ts) + fabs(x.forces.M14);
        for (i = 2; i <= 4; i++)
            assert_near(x.e.inertia[i].couple, -x.m.design.link[i].inertia * x.state.link[i].alpha,
                        0);
        worst = fmax(worst, fmax(fabs(x.e.Fsx - Fx), fabs(x.e.Fsy - Fy)) / scale);
        worst = fmax(worst, fabs(x.e.Ms - moment) / scale);
    }
    assert_true(worst < 1e-13);
}

/* An engine in line whose rod is shorter than its crank, beside a dead position, 1e-2 to 1e-7 rad from it: the pin forces
** grow beyond all bounds, the moment of the piston's weight and of a torque do not.  From the place of the piston alone,
**
**    Ms = m x g_y + T,   Fsy = m g_y
*/
TEST(test_shaking_beside_a_dead_position)
{
    double worst = 0, largest = 0;
    int n;

    for (n = 0; n < 2000; n++) {
        double r = uniform(&seed, 0.5, 1), l = r * uniform(&seed, 0.3, 0.95), at, x_C, size;
        sample x;

        draw(&x);
        memset(&x.m.design, 0, sizeof x.m.design);
        x.m.design.kind = FOURLINK_SLIDER_CRANK;
        x.m.design.link[2].length = r;
        x.m.design.link[3].length = l;
        x.m.design.link[4].mass = uniform(&seed, 1, 2);
        x.m.design.gravity.x = uniform(&seed, -10, 10);
        x.m.design.gravity.y = uniform(&seed, 1, 10);
        assert_int_equal(fourlink_prepare(&x.m.design, &x.m), FOURLINK_OK);
        memset(x.loads, 0, sizeof x.loads);
        x.loads[0].link = x.loads[1].link = FOURLINK_COUPLER;
        x.loads[0].torque = uniform(&seed, -20, 20);
        x.crank.theta2 = at = asin(l / r) - pow(10, uniform(&seed, -7, -2));
        x.crank.alpha2 = 0;
        x.crank.omega2 = uniform(&seed, 100, 200);
        assert_int_equal(
            fourlink_analyse(&x.m, x.branch, &x.crank, x.loads, 1, &x.state, &x.forces),
            FOURLINK_OK);
        derive_from_forces(&x, 0);
        x_C = r * cos(at) + (double)x.branch * sqrt((l - r * sin(at)) * (l + r * sin(at)));
        size = x.m.design.link[4].mass * r * 10 + 20;
        worst = fmax(worst, fabs(x.e.Ms - x.m.design.link[4].mass * x_C * x.m.design.gravity.y -
                                 x.loads[0].torque) /
                                size);
        worst = fmax(worst, fabs(x.e.Fsy - x.m.design.link[4].mass * x.m.design.gravity.y) / 20);
        largest = fmax(largest, hypot(x.forces.F12x, x.forces.F12y));
    }
    assert_true(largest > 1e12);
    assert_true(worst < 1e-11);
}

/* Gas alone, in an engine at rest or without masses: the frame holds itself, whatever the pressure. */
TEST(test_gas_alone)
{
    int n, i;

    for (n = 0; n < 2000; n++) {
        sample x;

        do
            draw(&x);
        while (x.m.design.kind != FOURLINK_SLIDER_CRANK);
        x.m.design.gravity.x = x.m.design.gravity.y = 0;
        if (n % 2)
            x.crank.omega2 = x.crank.alpha2 = 0;
        else
            for (i = 2; i <= 4; i++)
                x.m.design.link[i].mass = x.m.design.link[i].inertia = 0;
        x.gas *= 1e4;
        x.loads[2].force.x *= 1e4;
        x.loads[0].force.x = x.loads[0].force.y = x.loads[0].torque = 0;
        x.loads[1] = x.loads[0];
        assert_int_equal(
            fourlink_analyse(&x.m, x.branch, &x.crank, &x.loads[2], 1, &x.state, &x.forces),
            FOURLINK_OK);
        derive_from_forces(&x, x.gas);
        assert_near(x.e.Fsx, 0, 1e-14 * fabs(x.gas));
        assert_near(x.e.Fsy, 0, 1e-14 * fabs(x.gas));
        assert_near(x.e.Ms, 0, 2e-14 * fabs(x.gas));
    }
}

/* The frame gets what weights and loads give, less what the momentum takes up. */
TEST(test_shaking)
{
    const double h = 1e-4;
    int n, i, k;

    for (n = 0; n < 2000; n++) {
        double p[4][3], F[3] = {0, 0, 0}, scale = 100;
        sample x;

        draw(&x);
        for (k = 0; k < 4; k++)
            momentum(&x, (k < 2 ? k - 2 : k - 1) * h, p[k]);
        add_given(&x, F);
        for (i = 0; i < 3; i++) {
            double rate = (p[0][i] - 8 * p[1][i] + 8 * p[2][i] - p[3][i]) / (12 * h);

            F[i] -= rate;
            if (fabs(rate) > scale)
                scale = fabs(rate);
        }
        assert_near(x.e.Fsx, F[0], 1e-6 * scale);
        assert_near(x.e.Fsy, F[1], 1e-6 * scale);
        assert_near(x.e.Ms, F[2], 1e-6 * scale);
    }
}

TEST(test_axes)
{
    int n;

    for (n = 0; n < 1000; n++) {
        sample x;
        double t;

        draw(&x);
        t = x.state.link[3].theta;
        assert_near(x.e.F43.along * cos(t) - x.e.F43.across * sin(t), -x.forces.F34x, 1e-9);
        assert_near(x.e.F43.along * sin(t) + x.e.F43.across * cos(t), -x.forces.F34y, 1e-9);
        t = x.crank.theta2;
        assert_near(x.e.F32.along * cos(t) - x.e.F32.across * sin(t), -x.forces.F23x, 1e-9);
        assert_near(x.e.F12.along * sin(t) + x.e.F12.across * cos(t), x.forces.F12y, 1e-9);
        assert_near(x.e.F23.along * x.e.F23.along + x.e.F23.across * x.e.F23.across,
                    x.forces.F23x * x.forces.F23x + x.forces.F23y * x.forces.F23y,
                    1e-9 * (1 + x.e.F23.along * x.e.F23.along + x.e.F23.across * x.e.F23.across));
        t = x.state.link[4].theta;
        assert_near(x.e.F14.along * cos(t) - x.e.F14.across * sin(t), x.forces.F14x, 1e-9);
        assert_near(x.e.F34.along * sin(t) + x.e.F34.across * cos(t), x.forces.F34y, 1e-9);
    }
}

/* The single force in its place does what inertia force and couple do about any point, here A. */
TEST(test_offset_inertia_force)
{
    int n, i;

    for (n = 0; n < 1000; n++) {
        sample x;

        draw(&x);
        for (i = 2; i <= 4; i++) {
            const fourlink_link *link = &x.m.design.link[i];
            const flk_offset_force *F = &x.e.inertia[i];
            double fx = F->size * cos(F->direction), fy = F->size * sin(F->direction);
            fourlink_vector G, a, H;

            fourlink_point(&x.state, i, &link->cg, &G, NULL, &a);
            H.x = G.x - F->h * sin(F->direction);
            H.y = G.y + F->h * cos(F->direction);
            assert_near(fx, -link->mass * a.x, 1e-10 * (1 + F->size));
            assert_near(fy, -link->mass * a.y, 1e-10 * (1 + F->size));
            assert_near(H.x * fy - H.y * fx,
                        -link->mass * (G.x * a.y - G.y * a.x) -
                            link->inertia * x.state.link[i].alpha,
                        1e-9 * (1 + F->size + fabs(link->inertia * x.state.link[i].alpha)));
        }
    }
}

/* Velocity at a point P of the plane that moves with link i, for a unit crank speed. */
static fourlink_vector moving_with(const sample *x, int i, fourlink_vector P)
{
    const fourlink_link_state *s = &x->state.link[i];
    fourlink_vector v;

    v.x = s->k_origin.x - s->k * (P.y - s->origin.y);
    v.y = s->k_origin.y + s->k * (P.x - s->origin.x);
    return v;
}

TEST(test_instantaneous_centres)
{
    int n;

    for (n = 0; n < 2000; n++) {
        fourlink_vector v, w;
        double far;
        sample x;

        draw(&x);
        v = moving_with(&x, 3, x.e.I13);
        far = 1 + fabs(x.e.I13.x) + fabs(x.e.I13.y);
        assert_near(v.x, 0, 1e-12 * far);
        assert_near(v.y, 0, 1e-12 * far);
        v = moving_with(&x, 2, x.e.I24);
        w = moving_with(&x, 4, x.e.I24);
        far = 1 + fabs(x.e.I24.x) + fabs(x.e.I24.y);
        assert_near(v.x, w.x, 1e-12 * far);
        assert_near(v.y, w.y, 1e-12 * far);
        /* Kennedy: I24 is in line with B and C */
        v.x = x.state.link[3].axis.x;
        v.y = x.state.link[3].axis.y;
        w.x = x.e.I24.x - x.state.link[3].origin.x;
        w.y = x.e.I24.y - x.state.link[3].origin.y;
        assert_near(v.x * w.y - v.y * w.x, 0, 1e-11 * far);
    }
}

/* A light linkage at rest: what the crank needs to hold a load, by the nine equations. */
TEST(test_mechanical_advantage)
{
    int n;

    for (n = 0; n < 1000; n++) {
        fourlink_crank still = {0, 0, 0};
        fourlink_load load = {4, FOURLINK_FRAME_GROUND, {0, 0}, {0, 0}, 0};
        fourlink_mechanism light;
        fourlink_forces f;
        fourlink_state s;
        double given;
        sample x;
        int i;

        draw(&x);
        light = x.m;
        for (i = 2; i <= 4; i++)
            light.design.link[i].mass = light.design.link[i].inertia = 0;
        still.theta2 = x.crank.theta2;
        if (x.m.design.kind == FOURLINK_FOUR_BAR)
            load.torque = -1; /* the load resists, the rocker exerts +1 */
        else
            load.force.x = x.branch; /* the rock resists away from the crankshaft's side */
        assert_int_equal(fourlink_analyse(&light, x.branch, &still, &load, 1, &s, &f), FOURLINK_OK);
        given = x.m.design.kind == FOURLINK_FOUR_BAR ? f.Ts : f.Ts / x.m.design.link[2].length;
        if (fabs(given) > 1e-3)
            assert_close(x.e.mechanical_advantage, 1 / given, 1e-10);
    }
}

/* tan(theta4 / 2) is a root of Freudenstein's equation. */
TEST(test_freudenstein)
{
    int n;

    for (n = 0; n < 1000; n++) {
        double s, c;
        sample x;

        do
            draw(&x);
        while (x.m.design.kind != FOURLINK_FOUR_BAR);
        s = sin(x.state.link[4].theta / 2);
        c = cos(x.state.link[4].theta / 2);
        assert_near(x.e.A * s * s + x.e.B * s * c + x.e.C * c * c, 0, 1e-14);
        assert_near(flk_derive_freudenstein(&x.m.design),
                    (x.e.A + x.e.C) / 2 +
                        x.m.design.link[2].length * x.m.design.link[1].length * cos(x.crank.theta2),
                    1e-14);
    }
}

/* What has no value is NaN: centres at infinity, the offset of no force. */
TEST(test_undefined)
{
    const double right = 90 * DEG;
    int n, i;

    for (n = 0; n < 1000; n++) {
        sample x;

        draw(&x);
        if (x.m.design.kind ==
            FOURLINK_SLIDER_CRANK) { /* the rod at mid-stroke moves without turning */
            x.crank.theta2 = x.crank.theta2 > 0 ? right : -right;
            if (fourlink_analyse(&x.m, x.branch, &x.crank, NULL, 0, &x.state, &x.forces))
                continue;
            flk_derive_from_motion(&x.m, &x.state, &x.e);
            assert_true(isnan(x.e.I13.x) && isnan(x.e.I13.y) && !isnan(x.e.I24.y));
        }
        /* a balanced crank, and then all at rest */
        x.m.design.link[2].cg.x = x.m.design.link[2].cg.y = 0;
        derive_from_forces(&x, 0);
        assert_true(isnan(x.e.inertia[2].h) && !isnan(x.e.inertia[3].h));
        x.crank.omega2 = x.crank.alpha2 = 0;
        assert_int_equal(fourlink_analyse(&x.m, x.branch, &x.crank, NULL, 0, &x.state, &x.forces),
                         FOURLINK_OK);
        derive_from_forces(&x, 0);
        for (i = 2; i <= 4; i++)
            assert_true(isnan(x.e.inertia[i].h));
    }
}

/* A link whose centre of mass is not accelerated, but for rounding: it is at the pole. */
TEST(test_rounding_is_no_force)
{
    fourlink_link_state *rod;
    sample x;
    int n;

    for (n = 0; n < 1000; n++) {
        fourlink_vector at, a, e;
        double square;

        draw(&x);
        rod = &x.state.link[3];
        /* the pole of the accelerations of link 3 */
        square = pow(rod->omega, 4) + rod->alpha * rod->alpha;
        a = rod->acceleration;
        at.x = (rod->omega * rod->omega * a.x - rod->alpha * a.y) / square;
        at.y = (rod->omega * rod->omega * a.y + rod->alpha * a.x) / square;
        e = rod->axis;
        x.m.design.link[3].cg.x = at.x * e.x + at.y * e.y;
        x.m.design.link[3].cg.y = at.y * e.x - at.x * e.y;
        x.m.design.link[3].mass = 1;
        derive_from_forces(&x, 0);
        assert_true(isnan(x.e.inertia[3].h));
    }
}

TEST(test_superposition)
{
    int n;

    for (n = 0; n < 1000; n++) {
        sample x;

        draw(&x);
        assert_true(x.e.superposition < 1e-13);
        assert_near(x.e.Ts_static + x.e.Ts_inertia, x.forces.Ts,
                    1e-12 * (fabs(x.e.Ts_static) + fabs(x.e.Ts_inertia)));
        assert_close(x.e.condition, 1 / fabs(x.state.sine), 1e-15);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
