/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_slider_crank.c - motion of slider-cranks: against closed forms, against coordinates of the
** crank pin and the line of stroke and their differences in time, and at the angles that a short
** rod or a large offset leaves out.
*/
#include "mechanisms.h"

static fourlink_state at(const fourlink_mechanism *m, fourlink_branch branch, double theta2)
{
    fourlink_state state;

    assert_int_equal(analyse(m, branch, theta2, 1, 0, &state), FOURLINK_OK);
    return state;
}

static fourlink_branch branch_of(int n)
{
    return n % 2 ? FOURLINK_CROSSED : FOURLINK_OPEN;
}

/* The rod's extent along the stroke from the height of the crank pin: squared, in rod lengths. */
static double extent2(double r, double l, double e, double theta2)
{
    double height = r * sin(theta2) - e;

    return (l - height) / l * ((l + height) / l);
}

/* theory.md section 4 for e = 0, and the classical acceleration; the crossed branch is the open one
** turned by 180 deg, but for phi, whose sine is r sin(theta2) / l on both. */
TEST(test_closed_forms)
{
    uint64_t seed = 1;
    int i;

    for (i = 0; i < 10000; i++) {
        double r = uniform(&seed, 0.01, 2), n = 1 + exp(uniform(&seed, -4, 3)), l = n * r;
        double theta2 = uniform(&seed, -4 * PI, 4 * PI), w = uniform(&seed, -100, 100);
        double al = i % 3 ? uniform(&seed, -1e4, 1e4) : 0, side = i % 2 ? -1 : 1;
        double s = side * sin(theta2), c = side * cos(theta2);
        double root2 = n * n - s * s, root = sqrt(root2), root3 = root2 * root;
        double dphi = w * c / root;
        double ddphi = -w * w * s * (n * n - 1) / root3 + al * c / root;
        double slope = s + s * c / root;
        double curvature = c + (n * n * (c - s) * (c + s) + s * s * s * s) / root3;
        double condition = n * n / root2;
        fourlink_mechanism m = slider_crank(r, l, 0);
        fourlink_state state;

        assert_int_equal(analyse(&m, branch_of(i), theta2, w, al, &state), FOURLINK_OK);
        assert_near(state.x, r * (1 - c) + r * s * s / (n + root), 1e-14 * l * sqrt(condition));
        assert_near(state.v, r * w * slope, 1e-14 * r * fabs(w) * condition);
        assert_near(state.a, r * w * w * curvature + r * al * slope,
                    1e-14 * r * (w * w * condition + fabs(al)) * condition);
        assert_near(state.phi, asin(side * s / n), 1e-14 * condition);
        /* theta3 falls as phi rises where the piston is at +x, counted from the dead centre */
        assert_near(state.link[3].omega, -dphi, 1e-14 * fabs(w) * condition);
        assert_near(state.link[3].k * w, -dphi, 1e-14 * fabs(w) * condition);
        assert_near(state.link[3].alpha, -ddphi,
                    1e-14 * (w * w * condition + fabs(al)) * condition);
    }
}

/* The piston is where the circle about the crank pin cuts the line of stroke: at +x of the pin
** or at -x of it. */
TEST(test_coordinates)
{
    uint64_t seed = 2;
    int i, tested = 0;

    for (i = 0; i < 20000; i++) {
        double r = uniform(&seed, 0.05, 1), l = uniform(&seed, 0.05, 3);
        double e = i % 5 ? uniform(&seed, -1.5, 1.5) : 0, theta2 = uniform(&seed, -20, 20);
        double sine2 = extent2(r, l, e, theta2), side = i % 2 ? -1 : 1, tolerance;
        const fourlink_link_state *crank, *rod, *piston;
        fourlink_mechanism m = slider_crank(r, l, e);
        fourlink_state state;
        double X;

        if (sine2 < 1e-6)
            continue;
        tested++;
        state = at(&m, branch_of(i), theta2);
        crank = &state.link[2];
        rod = &state.link[3];
        piston = &state.link[4];
        X = r * cos(theta2) + side * l * sqrt(sine2);
        tolerance = 3e-15 * (r + l + fabs(e)) / sqrt(sine2);
        assert_near(crank->axis.x, cos(theta2), 1e-14);
        assert_near(crank->axis.y, sin(theta2), 1e-14);
        assert_near(rod->origin.x, r * cos(theta2), tolerance);
        assert_near(rod->origin.y, r * sin(theta2), tolerance);
        assert_near(piston->origin.x, X, tolerance);
        assert_true(piston->origin.y == e);
        assert_true(side * (piston->origin.x - rod->origin.x) > 0);
        assert_near(hypot(piston->origin.x - rod->origin.x, piston->origin.y - rod->origin.y), l,
                    tolerance);
        assert_near(l * cos(rod->theta), X - r * cos(theta2), tolerance);
        assert_near(l * sin(rod->theta), e - r * sin(theta2), tolerance);
        assert_near(state.sine, cos(rod->theta), tolerance / l);
        assert_true(piston->theta == 0 && piston->omega == 0 && piston->alpha == 0);
        assert_near(state.x, sqrt((r + l) * (r + l) - e * e) - side * X,
                    tolerance + 1e-15 * (r + l) * (r + l) / sqrt((r + l) * (r + l) - e * e));
    }
    assert_true(tested > 10000);
}

/* Central differences of order h^6, from f(-3h) ... f(3h). */
static double first(const double f[7], double h)
{
    return (45 * (f[4] - f[2]) - 9 * (f[5] - f[1]) + (f[6] - f[0])) / (60 * h);
}

static double second(const double f[7], double h)
{
    return (270 * (f[4] + f[2] - 2 * f[3]) - 27 * (f[5] + f[1] - 2 * f[3]) +
            2 * (f[6] + f[0] - 2 * f[3])) /
           (180 * h * h);
}

/* Speeds and accelerations are the differences of coordinates of a crank that turns either way and
** speeds up or slows down. */
TEST(test_differences)
{
    const double step = 0.01;
    uint64_t seed = 3;
    int i, k, tested = 0;

    for (i = 0; i < 8000; i++) {
        double r = uniform(&seed, 0.05, 1), l = uniform(&seed, 0.05, 3);
        double e = uniform(&seed, -1.2, 1.2), theta2 = uniform(&seed, -10, 10);
        double w = uniform(&seed, -20, 20), al = uniform(&seed, -300, 300);
        double sine2 = extent2(r, l, e, theta2), side = i % 2 ? -1 : 1;
        double X[7], theta3[7], time, h, at_rest, dX, ddX;
        fourlink_mechanism m = slider_crank(r, l, e);
        fourlink_state state;

        if (sine2 < 0.01)
            continue;
        tested++;
        /* `time` is that to the next dead position, or to turn by a radian: derivative n of a
        ** function of size M is below n! M / time^n there, and the differences are in error by
        ** less than 72 step^6 of M / time^2 and, by rounding, 1e-15 / (step^2 sine) of it */
        time = 1 / ((1 + 2 * r / (l * sine2)) * (fabs(w) + sqrt(fabs(al))));
        h = step * time;
        at_rest = atan2(e - r * sin(theta2), side * l * sqrt(sine2));
        for (k = 0; k < 7; k++) {
            double t = (k - 3) * h, angle = theta2 + (w + al * t / 2) * t;
            double extent = side * l * sqrt(extent2(r, l, e, angle));

            X[k] = r * cos(angle) + extent;
            theta3[k] = remainder(atan2(e - r * sin(angle), extent) - at_rest, 2 * PI);
        }
        assert_int_equal(analyse(&m, branch_of(i), theta2, w, al, &state), FOURLINK_OK);
        dX = first(X, h);
        ddX = second(X, h);
        assert_near(state.link[4].velocity.x, dX, 2e-12 * (r + l) / time);
        assert_near(state.link[4].acceleration.x, ddX, 1e-9 * (r + l) / (time * time));
        assert_near(state.v, -side * dX, 2e-12 * (r + l) / time);
        assert_near(state.a, -side * ddX, 1e-9 * (r + l) / (time * time));
        assert_near(state.link[3].omega, first(theta3, h), 2e-12 / time);
        assert_near(state.link[3].alpha, second(theta3, h), 1e-9 / (time * time));
        assert_near(state.link[3].k * w, first(theta3, h), 2e-12 / time);
        assert_near(state.link[4].k_origin.x * w, dX, 2e-12 * (r + l) / time);
        assert_true(state.link[4].velocity.y == 0 && state.link[4].acceleration.y == 0);
    }
    assert_true(tested > 3000);
}

/* The smallest (sign 1) or largest (sign -1) displacement near an angle. */
static double extreme(const fourlink_mechanism *m, fourlink_branch branch, double sign,
                      double around, double within, double *angle)
{
    double low = around - within, high = around + within;
    int i;

    for (i = 0; i < 100; i++) {
        double p = low + (high - low) / 3, q = high - (high - low) / 3;

        if (sign * at(m, branch, p).x < sign * at(m, branch, q).x)
            high = q;
        else
            low = p;
    }
    *angle = (low + high) / 2;
    return at(m, branch, *angle).x;
}

/* A crank that turns fully: displacement 0 at the inner dead centre, where crank and rod are
** stretched in line, nowhere less; the stroke to where they are folded in line. */
TEST(test_dead_centres)
{
    enum { STEPS = 72 };
    uint64_t seed = 4;
    int i, k;

    for (i = 0; i < 400; i++) {
        double r = uniform(&seed, 0.05, 1), e = i % 4 < 2 ? uniform(&seed, -1, 1) : 0;
        double l = (r + fabs(e)) * uniform(&seed, 1.02, 4), size = l + r, in, out;
        double stroke = sqrt((l + r) * (l + r) - e * e) - sqrt((l - r) * (l - r) - e * e);
        double smallest = HUGE_VAL, largest = -HUGE_VAL, low = 0, high = 0, angle;
        fourlink_mechanism m = slider_crank(r, l, e);
        fourlink_branch branch = branch_of(i);
        fourlink_state state;

        for (k = 0; k < STEPS; k++) {
            double theta2 = 2 * PI * k / STEPS, x = at(&m, branch, theta2).x;

            assert_true(x >= -1e-14 * size);
            assert_true(x <= stroke + 1e-13 * size);
            if (x < smallest) {
                smallest = x;
                low = theta2;
            }
            if (x > largest) {
                largest = x;
                high = theta2;
            }
        }
        in = branch == FOURLINK_OPEN ? asin(e / (l + r)) : PI - asin(e / (l + r));
        out = branch == FOURLINK_OPEN ? PI + asin(e / (l - r)) : -asin(e / (l - r));
        smallest = extreme(&m, branch, 1, low, 2 * PI / STEPS, &angle);
        assert_near(smallest, 0, 1e-14 * size);
        /* the foot of a parabola is found to the square root of the rounding error */
        assert_near(remainder(angle - in, 2 * PI), 0, 1e-5);
        largest = extreme(&m, branch, -1, high, 2 * PI / STEPS, &angle);
        assert_near(largest, stroke, 1e-14 * size);
        assert_near(largest - smallest, stroke, 1e-14 * size);
        assert_near(remainder(angle - out, 2 * PI), 0, 1e-5);

        state = at(&m, branch, in);
        assert_near(remainder(state.link[3].theta - in, 2 * PI), 0, 1e-14);
        assert_near(state.x, 0, 1e-14 * size);
        assert_near(state.v, 0, 1e-14 * size);
        assert_true(state.a > 0);
        state = at(&m, branch, out);
        assert_near(remainder(state.link[3].theta - out - PI, 2 * PI), 0, 1e-14);
        assert_near(state.x, stroke, 1e-14 * size);
        assert_near(state.v, 0, 1e-14 * size);
    }
}

/* The displacement is never negative, however short the rod; its foot is where crank and rod are
** stretched in line, which every mechanism reaches that reaches any angle. */
TEST(test_displacement_of_any)
{
    uint64_t seed = 6;
    int i, k, full = 0;

    for (i = 0; i < 3000; i++) {
        double r = uniform(&seed, 0.05, 1), l = uniform(&seed, 0.05, 1);
        double e = uniform(&seed, -0.95, 0.95) * (r + l), in = asin(e / (r + l));
        fourlink_mechanism m = slider_crank(r, l, e);
        fourlink_branch branch = branch_of(i);
        fourlink_state state;

        full += l > r + fabs(e);
        if (branch == FOURLINK_CROSSED)
            in = PI - in;
        assert_near(at(&m, branch, in).x, 0, 2e-14 * (r + l));
        for (k = 0; k < 20; k++)
            if (analyse(&m, branch, uniform(&seed, -PI, PI), 1, 0, &state) == FOURLINK_OK)
                assert_true(state.x >= -1e-14 * (r + l));
    }
    assert_true(full > 300 && full < 2000);
}

/* A rod as long as the crank: on the open branch it mirrors the crank, on the crossed one it lies
** along it with the piston pin on A, and passes +-90 deg smoothly. */
TEST(test_equal_lengths)
{
    uint64_t seed = 7;
    int i, k;

    for (i = 0; i < 6000; i++) {
        double r = uniform(&seed, 0.01, 2), w = uniform(&seed, -50, 50);
        double al = uniform(&seed, -500, 500), theta2 = uniform(&seed, -15, 15), c, s, tolerance;
        fourlink_mechanism m = slider_crank(r, r, 0);
        fourlink_state state;

        if (i % 3 == 0)
            theta2 = ((int)uniform(&seed, -5, 5) + 0.5) * PI +
                     uniform(&seed, 2, 9) * (i % 2 ? 1e-4 : -1e-4);
        c = cos(theta2);
        s = sin(theta2);
        tolerance = 4e-15 / fabs(c);
        assert_int_equal(analyse(&m, FOURLINK_OPEN, theta2, w, al, &state), FOURLINK_OK);
        assert_near(state.x, 2 * r * (1 - c), tolerance * r);
        assert_near(state.v, 2 * r * w * s, tolerance * r * fabs(w) / fabs(c));
        assert_near(state.a, 2 * r * (w * w * c + al * s),
                    tolerance * r * (w * w / fabs(c) + fabs(al)) / fabs(c));
        assert_near(state.link[3].omega, -w, tolerance * fabs(w));
        assert_near(state.link[3].alpha, -al, tolerance * (w * w / fabs(c) + fabs(al)));
        assert_int_equal(analyse(&m, FOURLINK_CROSSED, theta2, w, al, &state), FOURLINK_OK);
        assert_near(state.link[4].origin.x, 0, tolerance * r);
        assert_near(state.x, 2 * r, tolerance * r);
        assert_near(state.v, 0, tolerance * r * fabs(w) / fabs(c));
        assert_near(state.a, 0, tolerance * r * (w * w / fabs(c) + fabs(al)) / fabs(c));
        assert_near(remainder(state.link[3].theta - theta2 - PI, 2 * PI), 0, tolerance);
        assert_near(state.link[3].omega, w, tolerance * fabs(w));
        assert_near(state.link[3].alpha, al, tolerance * (w * w / fabs(c) + fabs(al)));
    }
    for (i = -7; i <= 7; i += 2)
        for (k = 0; k < 4; k++) {
            fourlink_mechanism m = slider_crank(0.1 + 0.07 * k, 0.1 + 0.07 * k, 0);
            fourlink_state state;

            assert_int_equal(analyse(&m, branch_of(k), i * 90 * DEG, 1, 0, &state),
                             FOURLINK_CHANGE_POINT);
        }
}

/* A rod shorter than the crank, or an offset, leaves angles out: there the status says so and the
** state is untouched; at all others the piston is on the line of stroke, a rod's length from the
** pin.  With an offset beyond r + l no angle is left. */
TEST(test_left_out)
{
    enum { SHORT_ROD, OFFSET, BOTH, NEVER, KINDS };
    uint64_t seed = 8;
    int i, k, reached[KINDS] = {0}, left_out[KINDS] = {0};

    for (i = 0; i < 4000; i++) {
        int kind = i % KINDS;
        double r = uniform(&seed, 0.1, 1), l = r * uniform(&seed, 0.05, 0.99), e = 0;
        fourlink_mechanism m;

        if (kind == OFFSET || kind == NEVER)
            l = r * uniform(&seed, 1, 4);
        if (kind == OFFSET)
            e = uniform(&seed, l - r, l + r);
        if (kind == BOTH)
            e = uniform(&seed, 0, l + r);
        if (kind == NEVER)
            e = (l + r) * uniform(&seed, 1.0001, 3);
        if (i % 8 < KINDS)
            e = -e;
        m = slider_crank(r, l, e);
        for (k = 0; k < 24; k++) {
            double theta2 = uniform(&seed, -4 * PI, 4 * PI), sine2 = extent2(r, l, e, theta2);
            fourlink_branch branch = branch_of(k);
            fourlink_state state, before;
            int status;

            /* so near the limit, rounding decides */
            if (fabs(sine2) < 1e-10)
                continue;
            memset(&before, 0x5A, sizeof before);
            state = before;
            status = analyse(&m, branch, theta2, 1, 0, &state);
            if (sine2 < 0) {
                left_out[kind]++;
                assert_int_equal(status, FOURLINK_ROD_TOO_SHORT);
                assert_memory_equal(&state, &before, sizeof state);
                assert_int_equal(fourlink_position(&m, branch, theta2, &state),
                                 FOURLINK_ROD_TOO_SHORT);
                assert_memory_equal(&state, &before, sizeof state);
            } else {
                double X = r * cos(theta2) + (double)branch * l * sqrt(sine2);

                reached[kind]++;
                assert_int_equal(status, FOURLINK_OK);
                assert_near(state.link[4].origin.x, X,
                            3e-15 * (r + l + fabs(e)) * (1 + r / l) / sqrt(sine2));
                assert_near(state.link[3].axis.y * l, e - r * sin(theta2), 1e-14 * (r + l));
            }
        }
    }
    for (k = 0; k < KINDS; k++) {
        assert_true(left_out[k] > 2000);
        assert_true(k == NEVER ? reached[k] == 0 : reached[k] > 2000);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
