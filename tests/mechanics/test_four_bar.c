/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_four_bar.c - position, velocity and acceleration of four-bar linkages: against
** Freudenstein's equation, the loop's closure, central differences, closed forms of
** special linkages; change points; statuses.
*/
#include "mechanisms.h"

#define EPS 2.220446049250313e-16

static fourlink_state at(const fourlink_mechanism *mechanism, fourlink_branch branch, double theta2,
                         double omega2, double alpha2)
{
    fourlink_state state;

    assert_int_equal(analyse(mechanism, branch, theta2, omega2, alpha2, &state), FOURLINK_OK);
    return state;
}

/* The difference of two angles, in [-pi, pi]. */
static double turn(double to, double from)
{
    return remainder(to - from, 2 * PI);
}

/* z of (D - B) x (C - B), with B and C from the angles alone: positive where C is left of B->D. */
static double side(const fourlink_mechanism *mechanism, const fourlink_state *state)
{
    const fourlink_link *link = mechanism->design.link;
    double Bx = link[2].length * cos(state->link[2].theta);
    double By = link[2].length * sin(state->link[2].theta);
    double Cx = link[1].length + link[4].length * cos(state->link[4].theta);
    double Cy = link[4].length * sin(state->link[4].theta);

    return (link[1].length - Bx) * (Cy - By) + By * (Cx - Bx);
}

/* A random linkage, of any of Grashof's types, and a crank angle at which it can be assembled. */
typedef struct sample {
    fourlink_mechanism mechanism;
    fourlink_branch branch;
    double a, b, c, d, theta2, omega2, alpha2;
    fourlink_state state;
} sample;

static void draw(uint64_t *seed, double smallest_sine, sample *s)
{
    do {
        s->a = uniform(seed, 0.3, 3);
        s->b = uniform(seed, 0.3, 3);
        s->c = uniform(seed, 0.3, 3);
        s->d = uniform(seed, 0.3, 3);
        s->theta2 = uniform(seed, -3 * PI, 3 * PI);
        s->omega2 = uniform(seed, -20, 20);
        s->alpha2 = uniform(seed, -200, 200);
        s->branch = branches[uniform(seed, 0, 1) < 0.5];
        s->mechanism = four_bar(s->a, s->b, s->c, s->d);
    } while (analyse(&s->mechanism, s->branch, s->theta2, s->omega2, s->alpha2, &s->state) !=
                 FOURLINK_OK ||
             fabs(s->state.sine) < smallest_sine);
}

/* A step of the crank angle which is small beside its distance from the nearest dead position,
** where the derivatives have their singularity: sine^2 changes with at most 4 ad/(bc). */
static double small_step(const sample *s)
{
    double slope = 1 + 4 * s->a * s->d / (s->b * s->c);

    return 4e-3 * s->state.sine * s->state.sine / slope;
}

/* How large the speeds of links 3 and 4 can be for a unit crank speed. */
static double largest_speed(const sample *s)
{
    return s->a / (fmin(s->b, s->c) * fabs(s->state.sine));
}

/* First derivative from f(-2h), f(-h), f(h), f(2h): error of order h^4. */
static double derivative(const double f[4], double h)
{
    return (8 * (f[2] - f[1]) - (f[3] - f[0])) / (12 * h);
}

static const double stencil[4] = {-2, -1, 1, 2};

/* ---------------------------------------------------------------------------------------------
** Random linkages
** ------------------------------------------------------------------------------------------- */

/* theta4 = 2 atan((-B +- root)/(2A)), whose upper sign is the crossed branch: at a root of
** A t^2 + B t + C, 2At + B = +-root has the sign of -sin(theta4 - theta3).  theta3 then follows
** from the loop with both its sine and its cosine. */
TEST(test_freudenstein)
{
    uint64_t seed = 1;
    int n;

    for (n = 0; n < 5000; n++) {
        double K, A, B, C, root, theta3, theta4, tolerance;
        sample s;

        draw(&seed, 0.05, &s);
        K = (s.a * s.a - s.b * s.b + s.c * s.c + s.d * s.d) / 2;
        A = K - s.a * (s.d - s.c) * cos(s.theta2) - s.c * s.d;
        B = -2 * s.a * s.c * sin(s.theta2);
        C = K - s.a * (s.d + s.c) * cos(s.theta2) + s.c * s.d;
        if (fabs(A) < 0.1)
            continue;
        root = sqrt(B * B - 4 * A * C);
        theta4 = 2 * atan((-B + (s.branch == FOURLINK_OPEN ? -root : root)) / (2 * A));
        theta3 = atan2(s.c * sin(theta4) - s.a * sin(s.theta2),
                       s.d + s.c * cos(theta4) - s.a * cos(s.theta2));
        /* The formula subtracts terms of up to 40 and takes the root of their difference, which is
        ** 2bc |sine|; it divides by A >= 0.1. */
        tolerance = 1e-13 / fabs(s.state.sine);
        assert_near(turn(s.state.link[4].theta, theta4), 0, tolerance);
        assert_near(turn(s.state.link[3].theta, theta3), 0, tolerance);
    }
}

TEST(test_closure)
{
    uint64_t seed = 2;
    int n;

    for (n = 0; n < 10000; n++) {
        double Bx, By, f2, cosine, tolerance;
        const fourlink_link_state *link;
        sample s;

        draw(&seed, 1e-4, &s);
        link = s.state.link;
        Bx = s.a * cos(s.theta2);
        By = s.a * sin(s.theta2);
        /* Lengths up to 3, and both circles meet at an angle of that sine. */
        tolerance = 1e-14 / fabs(s.state.sine);
        assert_near(Bx + s.b * cos(link[3].theta), s.d + s.c * cos(link[4].theta), tolerance);
        assert_near(By + s.b * sin(link[3].theta), s.c * sin(link[4].theta), tolerance);
        assert_near(link[3].axis.x, cos(link[3].theta), tolerance);
        assert_near(link[3].axis.y, sin(link[3].theta), tolerance);
        assert_near(link[4].axis.x, cos(link[4].theta), tolerance);
        assert_near(link[4].axis.y, sin(link[4].theta), tolerance);
        assert_near(link[2].axis.x, cos(s.theta2), 1e-15);
        assert_near(link[2].axis.y, sin(s.theta2), 1e-15);
        assert_near(link[3].origin.x, Bx, 1e-14);
        assert_near(link[3].origin.y, By, 1e-14);
        assert_true(link[2].origin.x == 0 && link[2].origin.y == 0);
        assert_true(link[4].origin.x == s.d && link[4].origin.y == 0);
        assert_true(link[2].theta == s.theta2);
        assert_true(fabs(link[3].theta) <= PI && fabs(link[4].theta) <= PI);

        assert_near(s.state.sine, sin(link[4].theta - link[3].theta), tolerance);
        assert_true(s.state.branch == s.branch);
        assert_true(side(&s.mechanism, &s.state) * (int)s.branch > 0);
        assert_true(s.state.sine * (int)s.branch > 0);

        /* transmission angle: the acute angle at C of the triangle BCD */
        f2 = (s.d - Bx) * (s.d - Bx) + By * By;
        cosine = (s.b * s.b + s.c * s.c - f2) / (2 * s.b * s.c);
        assert_near(cos(s.state.mu), fabs(cosine), 1e-12);
        assert_true(s.state.mu >= 0 && s.state.mu <= PI / 2);
    }
}

TEST(test_velocity_by_differences)
{
    uint64_t seed = 3;
    int n, i, link;

    for (n = 0; n < 5000; n++) {
        double theta[5][4], h, scale;
        sample s;

        draw(&seed, 0.03, &s);
        h = small_step(&s);
        for (i = 0; i < 4; i++) {
            fourlink_state near = at(&s.mechanism, s.branch, s.theta2 + stencil[i] * h, 0, 0);

            for (link = 3; link <= 4; link++)
                theta[link][i] = turn(near.link[link].theta, s.state.link[link].theta);
        }
        /* The outer points are 1/125 of the way to the singularity, to the fourth power 4e-9, with
        ** factors below 1; rounding, eps/(sine h), is smaller. */
        scale = largest_speed(&s);
        for (link = 3; link <= 4; link++) {
            assert_near(s.state.link[link].k, derivative(theta[link], h), 4e-9 * scale);
            assert_near(s.state.link[link].omega, s.state.link[link].k * s.omega2,
                        1e-14 * fabs(s.state.link[link].omega));
        }
        assert_true(s.state.link[2].k == 1 && s.state.link[2].omega == s.omega2);
    }
}

/* The crank's own motion is theta2 + omega2 t + alpha2 t^2/2. */
TEST(test_acceleration_by_differences)
{
    uint64_t seed = 4;
    int n, i, link;

    for (n = 0; n < 5000; n++) {
        double omega[5][4], step, t, speed, scale;
        sample s;

        draw(&seed, 0.03, &s);
        if (n % 10 == 0) { /* starting from rest */
            s.omega2 = 0;
            s.state = at(&s.mechanism, s.branch, s.theta2, s.omega2, s.alpha2);
        }
        step = small_step(&s);
        t = step / (fabs(s.omega2) + sqrt(fabs(s.alpha2)));
        for (i = 0; i < 4; i++) {
            double time = stencil[i] * t;
            fourlink_state near =
                at(&s.mechanism, s.branch, s.theta2 + (s.omega2 + s.alpha2 * time / 2) * time,
                   s.omega2 + s.alpha2 * time, s.alpha2);

            for (link = 3; link <= 4; link++)
                omega[link][i] = near.link[link].omega;
        }
        speed = largest_speed(&s);
        scale = s.omega2 * s.omega2 * (1 + speed) * (1 + speed) / fabs(s.state.sine) +
                fabs(s.alpha2) * speed;
        for (link = 3; link <= 4; link++)
            assert_near(s.state.link[link].alpha, derivative(omega[link], t), 4e-9 * scale);
        assert_true(s.state.link[2].alpha == s.alpha2);
    }
}

/* Points of all links, by differences of positions recomputed at nearby instants. */
TEST(test_points_by_differences)
{
    uint64_t seed = 5;
    int n, i, link;

    for (n = 0; n < 2000; n++) {
        fourlink_vector p[4], v[4], position, velocity, acceleration, where;
        double f[4], step, t, scale, speed;
        sample s;

        draw(&seed, 0.05, &s);
        step = small_step(&s);
        t = step / (fabs(s.omega2) + sqrt(fabs(s.alpha2)));
        speed = largest_speed(&s);
        where.x = uniform(&seed, -2, 2);
        where.y = uniform(&seed, -2, 2);
        for (link = 2; link <= 4; link++) {
            const fourlink_link_state *body = &s.state.link[link];
            double c = cos(body->theta), z = sin(body->theta);

            for (i = 0; i < 4; i++) {
                double time = stencil[i] * t;
                fourlink_state near =
                    at(&s.mechanism, s.branch, s.theta2 + (s.omega2 + s.alpha2 * time / 2) * time,
                       s.omega2 + s.alpha2 * time, s.alpha2);

                assert_int_equal(fourlink_point(&near, link, &where, &p[i], &v[i], NULL),
                                 FOURLINK_OK);
            }
            assert_int_equal(
                fourlink_point(&s.state, link, &where, &position, &velocity, &acceleration),
                FOURLINK_OK);
            assert_near(position.x, body->origin.x + where.x * c - where.y * z, 1e-12);
            assert_near(position.y, body->origin.y + where.x * z + where.y * c, 1e-12);
            /* arms of up to 6 m */
            scale = 6 * (1 + speed) * (fabs(s.omega2) + sqrt(fabs(s.alpha2)));
            for (i = 0; i < 4; i++)
                f[i] = p[i].x - position.x;
            assert_near(velocity.x, derivative(f, t), 4e-9 * scale);
            for (i = 0; i < 4; i++)
                f[i] = p[i].y - position.y;
            assert_near(velocity.y, derivative(f, t), 4e-9 * scale);
            scale = 6 * (s.omega2 * s.omega2 * (1 + speed) * (1 + speed) / fabs(s.state.sine) +
                         fabs(s.alpha2) * (1 + speed));
            for (i = 0; i < 4; i++)
                f[i] = v[i].x;
            assert_near(acceleration.x, derivative(f, t), 4e-9 * scale);
            for (i = 0; i < 4; i++)
                f[i] = v[i].y;
            assert_near(acceleration.y, derivative(f, t), 4e-9 * scale);
        }
    }
}

/* The linkage in a mirror (y to -y): the branches change places, all angles their sign. */
TEST(test_mirror)
{
    uint64_t seed = 6;
    int n, link;

    for (n = 0; n < 2000; n++) {
        fourlink_state mirror;
        sample s;

        draw(&seed, 1e-3, &s);
        mirror = at(&s.mechanism, s.branch == FOURLINK_OPEN ? FOURLINK_CROSSED : FOURLINK_OPEN,
                    -s.theta2, -s.omega2, -s.alpha2);
        for (link = 2; link <= 4; link++) {
            assert_close(mirror.link[link].theta, -s.state.link[link].theta, 4 * EPS);
            assert_close(mirror.link[link].omega, -s.state.link[link].omega, 1e-14);
            assert_close(mirror.link[link].alpha, -s.state.link[link].alpha, 1e-14);
        }
    }
}

/* ---------------------------------------------------------------------------------------------
** Special linkages
** ------------------------------------------------------------------------------------------- */

/* Angles in degrees over two revolutions each way, at least 1/8 deg off 0 and 180. */
static double odd_angle(int i)
{
    return -719.875 + i * 0.75;
}
#define ODD_ANGLES 1920

static void check_parallelogram(double a, double d)
{
    fourlink_mechanism m = four_bar(a, d, a, d);
    int i;

    for (i = 0; i < ODD_ANGLES; i++) {
        double theta2 = odd_angle(i) * DEG;
        /* sin(theta2) is the sine of the position, too: one factor for each derivative */
        double sine = fabs(sin(theta2)), tolerance = 1e-14 / sine;
        fourlink_state s = at(&m, FOURLINK_OPEN, theta2, -7, 11);

        assert_near(s.link[3].theta, 0, tolerance);
        assert_near(turn(s.link[4].theta, theta2), 0, tolerance);
        assert_near(s.link[3].omega, 0, 7 * tolerance / sine);
        assert_near(s.link[4].omega, -7, 7 * tolerance / sine);
        assert_near(s.link[3].alpha, 0, 60 * tolerance / (sine * sine));
        assert_near(s.link[4].alpha, 11, 60 * tolerance / (sine * sine));
    }
}

TEST(test_parallelogram)
{
    check_parallelogram(1, 2);
    check_parallelogram(0.1, 0.3);
    check_parallelogram(0.7, 0.33);
}

/* The anti-parallelogram is symmetric: C is A mirrored in the perpendicular bisector of BD. */
TEST(test_anti_parallelogram)
{
    const double a = 1, d = 2.5;
    fourlink_mechanism m = four_bar(a, d, a, d);
    int i;

    for (i = 0; i < ODD_ANGLES; i++) {
        double theta2 = odd_angle(i) * DEG;
        double f2 = a * a + d * d - 2 * a * d * cos(theta2);
        double Bx = a * cos(theta2), By = a * sin(theta2), ux = (d - Bx), uy = -By;
        double along = (0.5 * (Bx + d) * ux + 0.5 * By * uy) / f2;
        double Cx = 2 * along * ux, Cy = 2 * along * uy;
        /* for it, tan(theta2/2) and tan((theta4 - pi)/2) are in proportion: (d - a)/(d + a) */
        double k4 = (a * a - d * d) / f2, tolerance = 1e-13 / fabs(sin(theta2));
        fourlink_state s = at(&m, FOURLINK_CROSSED, theta2, 1, 0);

        assert_near(turn(s.link[4].theta, atan2(Cy, Cx - d)), 0, tolerance);
        assert_near(turn(s.link[3].theta, atan2(Cy - By, Cx - Bx)), 0, tolerance);
        assert_near(s.link[4].k, k4, tolerance);
    }
}

/* Rhombus: open, a parallelogram; crossed, C stays at A. */
TEST(test_rhombus)
{
    fourlink_mechanism m = four_bar(0.3, 0.3, 0.3, 0.3);
    int i;

    check_parallelogram(0.3, 0.3);
    for (i = 0; i < ODD_ANGLES; i++) {
        double theta2 = odd_angle(i) * DEG, sine = fabs(sin(theta2)), tolerance = 1e-14 / sine;
        fourlink_state s = at(&m, FOURLINK_CROSSED, theta2, 3, 0);

        assert_near(turn(s.link[3].theta, theta2 + PI), 0, tolerance);
        assert_near(turn(s.link[4].theta, PI), 0, tolerance);
        assert_near(s.link[3].omega, 3, 3 * tolerance / sine);
        assert_near(s.link[4].omega, 0, 3 * tolerance / sine);
    }
}

/* a = b, c = d, where Freudenstein's A vanishes at every angle: C is A mirrored in BD (open), or
** stays at A (crossed). */
TEST(test_deltoid_about_BD)
{
    const double lengths[2][2] = {{1, 2}, {0.9, 0.4}};
    int k, i;

    for (k = 0; k < 2; k++) {
        double a = lengths[k][0], d = lengths[k][1];
        fourlink_mechanism m = four_bar(a, a, d, d);

        for (i = 0; i < ODD_ANGLES; i++) {
            double theta2 = odd_angle(i) * DEG, tolerance = 1e-13 / fabs(sin(theta2));
            double Bx = a * cos(theta2), By = a * sin(theta2), nx = By, ny = d - Bx;
            double distance = (Bx * nx + By * ny) / (nx * nx + ny * ny);
            double Cx = 2 * distance * nx, Cy = 2 * distance * ny;
            fourlink_state s = at(&m, FOURLINK_OPEN, theta2, 1, 0);

            assert_near(turn(s.link[3].theta, atan2(Cy - By, Cx - Bx)), 0, tolerance);
            assert_near(turn(s.link[4].theta, atan2(Cy, Cx - d)), 0, tolerance);
            s = at(&m, FOURLINK_CROSSED, theta2, 1, 0);
            assert_near(turn(s.link[3].theta, theta2 + PI), 0, tolerance);
            assert_near(turn(s.link[4].theta, PI), 0, tolerance);
            assert_near(s.link[3].k, 1, tolerance);
            assert_near(s.link[4].k, 0, tolerance);
        }
    }
}

/* a = d, b = c > a: C is on the line through A at half the crank angle, at the distance
** a cos(theta2/2) +- sqrt(b^2 - a^2 sin^2(theta2/2)), in which theta2/2 counts on past 180 deg: the
** linkage needs two revolutions to come back. */
TEST(test_deltoid_about_AC)
{
    const double a = 1, b = 1.7;
    fourlink_mechanism m = four_bar(a, b, b, a);
    int i, k;

    for (i = 0; i < ODD_ANGLES; i++)
        for (k = 0; k < 2; k++) {
            double theta2 = odd_angle(i) * DEG, z = sin(theta2 / 2), c = cos(theta2 / 2);
            double root = sqrt(b * b - a * a * z * z);
            double r = a * c + (branches[k] == FOURLINK_OPEN ? root : -root);
            fourlink_state s = at(&m, branches[k], theta2, 1, 0);
            double tolerance = 1e-13 / fabs(s.sine);

            assert_near(turn(s.link[4].theta, atan2(r * z, r * c - a)), 0, tolerance);
            assert_near(
                turn(s.link[3].theta, atan2(r * z - a * sin(theta2), r * c - a * cos(theta2))), 0,
                tolerance);
        }
}

/* The angle through which a link turns while the crank makes one revolution: the mean of a smooth
** periodic function over equal steps, which converges faster than any power of the step. */
static void check_turns(const double length[4], fourlink_branch branch, double turns3,
                        double turns4, double *reach)
{
    enum { STEPS = 2000 };
    fourlink_mechanism m = four_bar(length[0], length[1], length[2], length[3]);
    double sum3 = 0, sum4 = 0;
    int i;

    *reach = 0;
    for (i = 0; i < STEPS; i++) {
        fourlink_state s = at(&m, branch, i * 2 * PI / STEPS, 1, 0);

        sum3 += s.link[3].k;
        sum4 += s.link[4].k;
        if (fabs(s.link[3].theta) > *reach)
            *reach = fabs(s.link[3].theta);
    }
    assert_near(sum3 / STEPS, turns3, 1e-13);
    assert_near(sum4 / STEPS, turns4, 1e-13);
}

TEST(test_full_turns)
{
    const double drag_link[4] = {3, 2.5, 3.5, 1};     /* ground shortest: crank and rocker turn */
    const double crank_rocker[4] = {20, 66, 56, 80};  /* crank shortest: neither other turns */
    const double double_rocker[4] = {3, 1, 2.8, 3.4}; /* coupler shortest: only it turns */
    double reach;
    int k;

    for (k = 0; k < 2; k++) {
        fourlink_mechanism m;
        fourlink_state s;

        check_turns(drag_link, branches[k], 1, 1, &reach);
        assert_true(reach > 170 * DEG);
        check_turns(crank_rocker, branches[k], 0, 0, &reach);
        assert_true(reach < 90 * DEG);
        m = four_bar(double_rocker[0], double_rocker[1], double_rocker[2], double_rocker[3]);
        assert_int_equal(analyse(&m, branches[k], PI, 1, 0, &s), FOURLINK_TOO_FAR);
        assert_int_equal(analyse(&m, branches[k], 0, 1, 0, &s), FOURLINK_TOO_NEAR);
        assert_int_equal(analyse(&m, branches[k], 75 * DEG, 1, 0, &s), FOURLINK_TOO_FAR);
        assert_int_equal(analyse(&m, branches[k], 45 * DEG, 1, 0, &s), FOURLINK_OK);
    }
}

/* ---------------------------------------------------------------------------------------------
** Change points
** ------------------------------------------------------------------------------------------- */

/* Through two revolutions each way, the angles never jump: each step is that of the trapezoidal
** rule, whose error is step^3/12 times the third derivative. */
static void check_smooth(const fourlink_mechanism *m, fourlink_branch branch, double third)
{
    const double step = 0.0625 * DEG;
    fourlink_state before, here, far_side, same_side;
    int i, link, steps = (int)(4 * 360 / 0.0625 + 0.5);

    before = at(m, branch, -720 * DEG + step / 2, 1, 0);
    for (i = 1; i < steps; i++) {
        double theta2 = -720 * DEG + step / 2 + i * step;

        here = at(m, branch, theta2, 1, 0);
        for (link = 3; link <= 4; link++)
            assert_near(turn(here.link[link].theta, before.link[link].theta),
                        step / 2 * (here.link[link].k + before.link[link].k),
                        third * step * step * step);
        before = here;
    }
    /* after one revolution: on the other side with one change point, on the same with two */
    for (i = 1; i < 100; i++) {
        double theta2 = i * 3.59 * DEG;
        int swaps = m->change_stretched != m->change_folded;
        fourlink_branch other = branch == FOURLINK_OPEN ? FOURLINK_CROSSED : FOURLINK_OPEN;

        here = at(m, branch, theta2 + 2 * PI, 1, 0);
        same_side = at(m, branch, theta2, 1, 0);
        far_side = at(m, other, theta2, 1, 0);
        for (link = 3; link <= 4; link++)
            assert_near(
                turn(here.link[link].theta, (swaps ? far_side : same_side).link[link].theta), 0,
                1e-13 / fabs(here.sine));
        assert_true((side(m, &here) > 0) == (here.sine > 0));
        here = at(m, branch, theta2 + 4 * PI, 1, 0);
        for (link = 3; link <= 4; link++)
            assert_near(turn(here.link[link].theta, same_side.link[link].theta), 0,
                        1e-13 / fabs(here.sine));
    }
    /* the label is the side just after 0 */
    here = at(m, branch, 1e-3 * DEG, 1, 0);
    assert_true(side(m, &here) * (int)branch > 0);
}

static const struct {
    double a, b, c, d;
    int at_180, at_0;
} change_points[] = {
    {1, 2, 3, 4, 1, 0},         {0.1, 0.2, 0.3, 0.4, 1, 0}, /* sums not exact in binary */
    {1, 4, 2, 3, 0, 1},         {0.1, 0.4, 0.2, 0.3, 0, 1},
    {4, 2, 3, 1, 1, 0}, /* the ground shortest */
    {4, 3, 2, 1, 1, 0},         {3, 4, 2, 1, 0, 1},
    {1, 2, 1, 2, 1, 1},         {2, 1, 2, 1, 1, 1},
    {0.1, 0.1, 0.3, 0.3, 1, 1}, {1, 1.7, 1.7, 1, 0, 1},
    {0.3, 0.3, 0.3, 0.3, 1, 1},
};
#define CHANGE_POINTS COUNT(change_points)

TEST(test_change_points_are_passed)
{
    size_t i;
    int k;

    for (i = 0; i < CHANGE_POINTS; i++) {
        fourlink_mechanism m = four_bar(change_points[i].a, change_points[i].b, change_points[i].c,
                                        change_points[i].d);

        assert_int_equal(m.change_stretched, change_points[i].at_180);
        assert_int_equal(m.change_folded, change_points[i].at_0);
        for (k = 0; k < 2; k++)
            check_smooth(&m, branches[k], 4);
    }
}

TEST(test_change_points_are_said)
{
    const double turns[] = {-720, -360, 0, 360, 720};
    size_t i, n;
    int k;

    for (i = 0; i < CHANGE_POINTS; i++) {
        fourlink_mechanism m = four_bar(change_points[i].a, change_points[i].b, change_points[i].c,
                                        change_points[i].d);
        fourlink_state s;

        for (n = 0; n < COUNT(turns); n++)
            for (k = 0; k < 2; k++) {
                assert_int_equal(analyse(&m, branches[k], turns[n] * DEG, 1, 0, &s),
                                 change_points[i].at_0 ? FOURLINK_CHANGE_POINT : FOURLINK_OK);
                assert_int_equal(analyse(&m, branches[k], (turns[n] + 180) * DEG, 1, 0, &s),
                                 change_points[i].at_180 ? FOURLINK_CHANGE_POINT : FOURLINK_OK);
            }
    }
}

/* A linkage of two nearly equal pairs of links lies in one line at 0 deg within the rounding of its
** sine, whose square is (a - d - b + c) (a - d + b - c) (4 b c) / (4 b c)^2 there. */
TEST(test_nearly_equal_pairs)
{
    static const double off[] = {1e-8, 1e-6};
    fourlink_state s;
    int i;

    for (i = 0; i < 2; i++) {
        fourlink_mechanism m = four_bar(1 + off[i], 2 + 2 * off[i], 2, 1);

        assert_int_equal(m.change_folded, i == 0);
        assert_int_equal(m.change_stretched, 0);
        assert_int_equal(analyse(&m, FOURLINK_OPEN, 0, 1, 0, &s),
                         i == 0 ? FOURLINK_CHANGE_POINT : FOURLINK_TOO_NEAR);
    }
}

/* Lengths in whole millimetres, given in metres: whether their sums agree is then a question of
** whole numbers, which rounding must not decide. */
TEST(test_change_points_of_decimal_lengths)
{
    uint64_t seed = 7;
    int n, tested = 0;

    for (n = 0; n < 20000; n++) {
        int a = (int)uniform(&seed, 5, 1000), b = (int)uniform(&seed, 5, 1000);
        int c = (int)uniform(&seed, 5, 1000), d = n % 2 ? b + c - a : a + c - b;
        fourlink_mechanism m;

        if (d < 5 || d >= 1000)
            continue;
        m = four_bar(a * 0.001, b * 0.001, c * 0.001, d * 0.001);
        assert_int_equal(m.change_stretched, a + d == b + c);
        assert_int_equal(m.change_folded, a + c == b + d || a + b == c + d);
        tested++;
    }
    assert_true(tested > 5000);
}

/* A row depends on its crank angle alone: not on what was computed before, nor on the memory. */
TEST(test_no_memory)
{
    fourlink_mechanism m = four_bar(1, 2, 3, 4);
    fourlink_state forwards[64], again;
    uint64_t seed = 8;
    int i, n;

    for (i = 0; i < 64; i++) {
        memset(&forwards[i], 0, sizeof forwards[i]);
        assert_int_equal(analyse(&m, FOURLINK_OPEN, i * 0.35 + 0.1, 1, 2, &forwards[i]),
                         FOURLINK_OK);
    }
    for (n = 0; n < 1000; n++) {
        i = (int)uniform(&seed, 0, 64);
        memset(&again, n & 0xff, sizeof again);
        assert_int_equal(analyse(&m, FOURLINK_OPEN, i * 0.35 + 0.1, 1, 2, &again), FOURLINK_OK);
        assert_true(again.link[3].theta == forwards[i].link[3].theta);
        assert_true(again.link[4].theta == forwards[i].link[4].theta);
        assert_true(again.link[3].alpha == forwards[i].link[3].alpha);
        assert_true(again.link[4].alpha == forwards[i].link[4].alpha);
        assert_true(again.sine == forwards[i].sine && again.mu == forwards[i].mu);
    }
}

/* ---------------------------------------------------------------------------------------------
** Statuses
** ------------------------------------------------------------------------------------------- */

/* Calls the position, which must fail and leave the state as it was. */
static void assert_no_position(const fourlink_mechanism *m, fourlink_branch branch, double theta2,
                               int status)
{
    fourlink_state state, pattern;
    fourlink_forces forces, forces_pattern;
    fourlink_crank crank;

    memset(&state, 0xa5, sizeof state);
    memset(&pattern, 0xa5, sizeof pattern);
    memset(&forces, 0xa5, sizeof forces);
    memset(&forces_pattern, 0xa5, sizeof forces_pattern);
    crank.theta2 = theta2;
    crank.omega2 = 1;
    crank.alpha2 = 1;
    assert_int_equal(fourlink_position(m, branch, theta2, &state), status);
    assert_memory_equal(&state, &pattern, sizeof state);
    assert_int_equal(fourlink_analyse(m, branch, &crank, NULL, 0, &state, &forces), status);
    assert_memory_equal(&state, &pattern, sizeof state);
    assert_memory_equal(&forces, &forces_pattern, sizeof forces);
}

/* The limits of the crank follow from the triangle ABD with BD = b + c, or |b - c|. */
TEST(test_reach)
{
    const double lengths[][4] = {{3, 1, 2, 3.5}, {2, 2.2, 0.9, 1.5}, {0.02, 0.03, 0.01, 0.04}};
    size_t i;
    int k, limits = 0;

    for (i = 0; i < COUNT(lengths); i++) {
        double a = lengths[i][0], b = lengths[i][1], c = lengths[i][2], d = lengths[i][3];
        fourlink_mechanism m = four_bar(a, b, c, d);
        double farthest = (a * a + d * d - (b + c) * (b + c)) / (2 * a * d);
        double nearest = (a * a + d * d - (b - c) * (b - c)) / (2 * a * d);
        fourlink_state s;

        for (k = 0; k < 2; k++) {
            if (fabs(farthest) < 1) {
                double limit = acos(farthest);

                assert_no_position(&m, branches[k], limit, FOURLINK_DEAD_POSITION);
                assert_no_position(&m, branches[k], -limit, FOURLINK_DEAD_POSITION);
                assert_no_position(&m, branches[k], 2 * PI - limit, FOURLINK_DEAD_POSITION);
                assert_no_position(&m, branches[k], limit + 1e-9, FOURLINK_TOO_FAR);
                assert_no_position(&m, branches[k], PI, FOURLINK_TOO_FAR);
                assert_int_equal(analyse(&m, branches[k], limit - 1e-9, 1, 0, &s), FOURLINK_OK);
                assert_true(fabs(s.sine) < 1e-3);
                limits++;
            }
            if (fabs(nearest) < 1) {
                double limit = acos(nearest);

                assert_no_position(&m, branches[k], limit, FOURLINK_DEAD_POSITION);
                assert_no_position(&m, branches[k], limit - 1e-9, FOURLINK_TOO_NEAR);
                assert_no_position(&m, branches[k], 0, FOURLINK_TOO_NEAR);
                assert_int_equal(analyse(&m, branches[k], limit + 1e-9, 1, 0, &s), FOURLINK_OK);
                limits++;
            }
        }
    }
    assert_int_equal(limits, 10);

    for (k = 0; k < 2; k++) {
        fourlink_mechanism never = four_bar(1, 1, 1, 10), inside = four_bar(1, 10, 1, 2);

        assert_no_position(&never, branches[k], 1, FOURLINK_TOO_FAR);
        assert_no_position(&inside, branches[k], 1, FOURLINK_TOO_NEAR);
    }
}

static const double no_numbers[] = {NAN, INFINITY, -INFINITY, 1e31, -1e31, 1e300};
#define NO_NUMBERS COUNT(no_numbers)

static void assert_not_prepared(const fourlink_design *design, int status)
{
    fourlink_mechanism mechanism, pattern;

    memset(&mechanism, 0xa5, sizeof mechanism);
    memset(&pattern, 0xa5, sizeof pattern);
    assert_int_equal(fourlink_prepare(design, &mechanism), status);
    assert_memory_equal(&mechanism, &pattern, sizeof mechanism);
}

TEST(test_bad_designs)
{
    fourlink_design good = design_of(1, 3, 2.5, 3.5), bad;
    fourlink_mechanism mechanism;
    size_t i;
    int link, field;

    assert_int_equal(fourlink_prepare(&good, NULL), FOURLINK_NULL);
    assert_not_prepared(NULL, FOURLINK_NULL);
    bad = good;
    bad.kind = (fourlink_kind)0;
    assert_not_prepared(&bad, FOURLINK_BAD_KIND);
    bad.kind = (fourlink_kind)3;
    assert_not_prepared(&bad, FOURLINK_BAD_KIND);

    for (link = 1; link <= 4; link++) {
        bad = good;
        bad.link[link].length = 0;
        assert_not_prepared(&bad, FOURLINK_BAD_LENGTH);
        bad.link[link].length = -1;
        assert_not_prepared(&bad, FOURLINK_BAD_LENGTH);
        bad.link[link].length = 0.9e-15;
        assert_not_prepared(&bad, FOURLINK_BAD_NUMBER);
        bad.link[link].length = 1.1e15;
        assert_not_prepared(&bad, FOURLINK_BAD_NUMBER);
        for (i = 0; i < NO_NUMBERS; i++) {
            bad.link[link].length = no_numbers[i];
            assert_not_prepared(&bad, FOURLINK_BAD_NUMBER);
        }
        bad = good;
        bad.link[link].length = FOURLINK_LENGTH_MAX;
        assert_int_equal(fourlink_prepare(&bad, &mechanism), FOURLINK_OK);
        bad.link[link].length = FOURLINK_LENGTH_MIN;
        assert_int_equal(fourlink_prepare(&bad, &mechanism), FOURLINK_OK);
    }
    for (link = 2; link <= 4; link++) {
        bad = good;
        bad.link[link].mass = -1e-300;
        assert_not_prepared(&bad, FOURLINK_BAD_MASS);
        bad = good;
        bad.link[link].inertia = -1;
        assert_not_prepared(&bad, FOURLINK_BAD_MASS);
        for (field = 0; field < 4; field++)
            for (i = 0; i < NO_NUMBERS; i++) {
                bad = good;
                *(field == 0   ? &bad.link[link].mass
                  : field == 1 ? &bad.link[link].inertia
                  : field == 2 ? &bad.link[link].cg.x
                               : &bad.link[link].cg.y) = no_numbers[i];
                assert_not_prepared(&bad, FOURLINK_BAD_NUMBER);
            }
        bad = good;
        bad.link[link].cg.y = -1.1e15;
        assert_not_prepared(&bad, FOURLINK_BAD_NUMBER);
    }
    for (i = 0; i < NO_NUMBERS; i++) {
        bad = good;
        bad.gravity.x = no_numbers[i];
        assert_not_prepared(&bad, FOURLINK_BAD_NUMBER);
        bad = good;
        bad.gravity.y = no_numbers[i];
        assert_not_prepared(&bad, FOURLINK_BAD_NUMBER);
    }
    /* of the ground only the length is used */
    bad = good;
    bad.link[1].mass = -1;
    bad.link[1].cg.x = NAN;
    assert_int_equal(fourlink_prepare(&bad, &mechanism), FOURLINK_OK);
}

/* In all numbers that are used; other bytes have no value. */
static void assert_same_state(const fourlink_state *state, const fourlink_state *other)
{
    assert_memory_equal(&state->link[2], &other->link[2], 3 * sizeof state->link[2]);
    assert_int_equal(state->branch, other->branch);
    assert_memory_equal(&state->sine, &other->sine, sizeof *state - offsetof(fourlink_state, sine));
}

TEST(test_bad_calls)
{
    fourlink_mechanism m = four_bar(1, 3, 2.5, 3.5);
    fourlink_state state = at(&m, FOURLINK_OPEN, 1, 2, 3), pattern = state;
    fourlink_vector where = {1, 2}, p = {7, 8}, bad;
    fourlink_crank crank = {1, 2, 3};
    size_t i;
    int k;

    for (i = 0; i < NO_NUMBERS; i++) {
        assert_no_position(&m, FOURLINK_OPEN, no_numbers[i], FOURLINK_BAD_NUMBER);
        assert_int_equal(fourlink_velocity(&m, no_numbers[i], &state), FOURLINK_BAD_NUMBER);
        assert_same_state(&state, &pattern);
        assert_int_equal(fourlink_acceleration(&m, no_numbers[i], &state), FOURLINK_BAD_NUMBER);
        assert_same_state(&state, &pattern);
        assert_int_equal(analyse(&m, FOURLINK_OPEN, 1, no_numbers[i], 0, &state),
                         FOURLINK_BAD_NUMBER);
        assert_same_state(&state, &pattern);
        assert_int_equal(analyse(&m, FOURLINK_OPEN, 1, 0, no_numbers[i], &state),
                         FOURLINK_BAD_NUMBER);
        assert_same_state(&state, &pattern);
        bad = where;
        bad.x = no_numbers[i];
        assert_int_equal(fourlink_point(&state, 3, &bad, &p, &p, &p), FOURLINK_BAD_NUMBER);
        bad = where;
        bad.y = no_numbers[i];
        assert_int_equal(fourlink_point(&state, 3, &bad, &p, &p, &p), FOURLINK_BAD_NUMBER);
        assert_true(p.x == 7 && p.y == 8);
    }
    assert_no_position(&m, (fourlink_branch)0, 1, FOURLINK_BAD_BRANCH);
    assert_no_position(&m, (fourlink_branch)2, 1, FOURLINK_BAD_BRANCH);
    assert_no_position(NULL, FOURLINK_OPEN, 1, FOURLINK_NULL);
    assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, 1, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_velocity(NULL, 1, &state), FOURLINK_NULL);
    assert_int_equal(fourlink_velocity(&m, 1, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_acceleration(NULL, 1, &state), FOURLINK_NULL);
    assert_int_equal(fourlink_acceleration(&m, 1, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_analyse(NULL, FOURLINK_OPEN, &crank, NULL, 0, &state, NULL),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_analyse(&m, FOURLINK_OPEN, NULL, NULL, 0, &state, NULL),
                     FOURLINK_NULL);
    assert_int_equal(fourlink_analyse(&m, FOURLINK_OPEN, &crank, NULL, 0, NULL, NULL),
                     FOURLINK_NULL);
    assert_same_state(&state, &pattern);

    assert_int_equal(fourlink_point(NULL, 3, &where, &p, &p, &p), FOURLINK_NULL);
    assert_int_equal(fourlink_point(&state, 3, NULL, &p, &p, &p), FOURLINK_NULL);
    for (k = -1; k <= 6; k++)
        if (k < 2 || k > 4)
            assert_int_equal(fourlink_point(&state, k, &where, &p, &p, &p), FOURLINK_BAD_LINK);
    assert_true(p.x == 7 && p.y == 8);
    assert_int_equal(fourlink_point(&state, 3, &where, NULL, NULL, NULL), FOURLINK_OK);

    /* the largest crank angle is still a position, and the steps keep what the next ones fill */
    assert_int_equal(fourlink_position(&m, FOURLINK_OPEN, 1e30, &state), FOURLINK_OK);
    for (k = 3; k <= 4; k++) {
        assert_true(state.link[k].omega == pattern.link[k].omega);
        assert_true(state.link[k].alpha == pattern.link[k].alpha);
    }
}

static void assert_finite_vector(fourlink_vector v)
{
    assert_true(isfinite(v.x) && isfinite(v.y));
}

/* Within the range of numbers, nothing overflows. */
TEST(test_extreme_numbers)
{
    uint64_t seed = 9;
    int n, link, positions = 0;

    for (n = 0; n < 20000; n++) {
        /* two pairs of like lengths, or it would never be assembled */
        double large = pow(10, uniform(&seed, -15, 15)), small = pow(10, uniform(&seed, -15, 15));
        double length[4];
        fourlink_mechanism m;
        fourlink_state s;
        int i;

        for (i = 0; i < 4; i++) {
            length[i] = ((n >> i) & 1 ? large : small) * uniform(&seed, 1, 1.5);
            length[i] = fmin(fmax(length[i], FOURLINK_LENGTH_MIN), FOURLINK_LENGTH_MAX);
        }
        m = four_bar(length[0], length[1], length[2], length[3]);
        if (analyse(&m, branches[n % 2], uniform(&seed, 0, 6.3), 1e30, -1e30, &s) != FOURLINK_OK)
            continue;
        positions++;
        assert_true(isfinite(s.sine) && isfinite(s.mu));
        for (link = 2; link <= 4; link++) {
            assert_true(isfinite(s.link[link].theta) && isfinite(s.link[link].k));
            assert_true(isfinite(s.link[link].omega) && isfinite(s.link[link].alpha));
            assert_finite_vector(s.link[link].axis);
            assert_finite_vector(s.link[link].velocity);
            assert_finite_vector(s.link[link].acceleration);
        }
    }
    assert_true(positions > 2000);
}

TEST(test_status_texts)
{
#define CODE(name, value, text) {name, value, text},
    static const struct {
        int code, value;
        const char *text;
    } codes[] = {FOURLINK_STATUS_LIST(CODE)};
    size_t n = COUNT(codes), i, k;

    for (i = 0; i < n; i++) {
        const char *text = fourlink_status_text(codes[i].code);

        assert_int_equal(codes[i].code, codes[i].value);
        assert_non_null(text);
        assert_string_equal(text, codes[i].text);
        assert_true(strlen(text) > 0);
        assert_string_not_equal(text, fourlink_status_text(1000));
        for (k = 0; k < i; k++) {
            assert_int_not_equal(codes[k].code, codes[i].code);
            assert_string_not_equal(codes[k].text, text);
        }
    }
    assert_int_equal(FOURLINK_OK, 0);
    assert_non_null(fourlink_status_text(-1));
    assert_non_null(fourlink_status_text(FOURLINK_STATUS_END_));
    assert_string_equal(fourlink_version(), FOURLINK_VERSION);
}

int main(void)
{
    return run_all_tests(NULL);
}
