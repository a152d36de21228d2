/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_quick_return.c - quick returns: reference values, the limits that the analysis finds, random
** problems, bad ones.
*/
#include <float.h>

#include "designs.h"

static fourlink_quick_return_task rocker(double time_ratio, double swing, double a, double b,
                                         double c, double d)
{
    fourlink_quick_return_task task = {
        .type = FOURLINK_CRANK_ROCKER, .time_ratio = time_ratio, .swing = swing};

    task.length[1] = d;
    task.length[2] = a;
    task.length[3] = b;
    task.length[4] = c;
    return task;
}

static fourlink_limits limits_of(const fourlink_solution *s)
{
    fourlink_mechanism m;
    fourlink_limits limits;

    assert_int_equal(fourlink_prepare(&s->design, &m), FOURLINK_OK);
    assert_int_equal(fourlink_limits_of(&m, FOURLINK_OPEN, &limits), FOURLINK_OK);
    return limits;
}

static double alpha_of(double time_ratio)
{
    return PI * (time_ratio - 1) / (time_ratio + 1);
}

TEST(crank_rocker)
{
    fourlink_quick_return_task task = rocker(10.0 / 9, 80 * DEG, 0.06, 0, 0, 0.12);
    fourlink_solution s;
    fourlink_limits limits;

    FOUND(quick_return, &task, &s);
    assert_near(length_of(&s, 3), 0.103197034989212, 1e-15);
    assert_near(length_of(&s, 4), 0.0939646098959277,
                1e-15); /* with 30 digits 93.96460989592769... mm */
    assert_near(s.mu_min / DEG, 35.038326, 5e-7);
    limits = limits_of(&s);
    assert_near(limits.time_ratio, 10.0 / 9, 1e-13);
    assert_near(limits.theta4_max - limits.theta4_min, 80 * DEG, 1e-13);
    task.length[2] = 0;
    FOUND(quick_return, &task, &s);
    /* with 40 digits a = 46.67174032527 mm: the top is flat, and half of the digits are lost there */
    assert_near(length_of(&s, 2), 0.04667174032527, 0.04667174032527 * sqrt(DBL_EPSILON));
    assert_near(length_of(&s, 3), 0.116161029, 1e-9);
    assert_near(length_of(&s, 4), 0.073883177, 1e-9);
    assert_near(s.mu_min / DEG, 37.732920, 5e-7);
    assert_int_equal(s.defects, 0);
}

TEST(slider_crank)
{
    fourlink_quick_return_task task = {.type = FOURLINK_ENGINE, .time_ratio = 1.25, .stroke = 0.1};
    fourlink_solution s, mirrored, again;
    fourlink_limits limits;

    task.length[2] = 0.045;
    FOUND(quick_return, &task, &s);
    assert_near(length_of(&s, 3), 0.133332789672402, 1e-15);
    assert_near(s.design.offset, 0.053877177286368, 1e-15);
    assert_near(s.mu_min / DEG, 42.133660, 5e-7);
    limits = limits_of(&s);
    assert_near(limits.stroke, 0.1, 1e-15);
    assert_near(limits.time_ratio, 1.25, 1e-14);
    /* the piston comes in slowly, with the crank counter-clockwise */
    assert_true(remainder(s.position[1].theta2 - s.position[0].theta2, 2 * PI) < 0);
    task.slow = FOURLINK_SLOW_AGAINST;
    FOUND(quick_return, &task, &mirrored);
    assert_near(mirrored.design.offset, -s.design.offset, 1e-16);
    assert_near(length_of(&mirrored, 3), length_of(&s, 3), 0);
    task.slow = 0;
    task.length[2] = 0;
    task.length[3] = length_of(&s, 3);
    FOUND(quick_return, &task, &again);
    assert_near(length_of(&again, 2), 0.045, 1e-15);
    task.length[3] = 0;
    task.offset = s.design.offset;
    FOUND(quick_return, &task, &again);
    assert_near(length_of(&again, 2), 0.045, 1e-15);
    assert_near(length_of(&again, 3), length_of(&s, 3), 1e-14);
    task.length[2] = 0.01;
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
}

/* Two lengths of a random crank-rocker, its swing and its time ratio: that crank-rocker. */
TEST(random_rockers)
{
    uint64_t seed = 41;
    int n = 0;

    while (n < 1000) {
        fourlink_design d = {.kind = FOURLINK_FOUR_BAR};
        fourlink_quick_return_task task;
        fourlink_limits limits;
        fourlink_mechanism m;
        fourlink_solution s;
        fourlink_type type;
        int first = 1 + (int)uniform(&seed, 0, 4), second = 1 + (int)uniform(&seed, 0, 4), sign;
        unsigned long n_found;
        double swing, alpha, tolerance, I1, I2;

        for (int i = 1; i <= 4; i++)
            d.link[i].length = uniform(&seed, 0.1, 1);
        assert_int_equal(fourlink_prepare(&d, &m), FOURLINK_OK);
        assert_int_equal(fourlink_type_of(&m, &type), FOURLINK_OK);
        if (type != FOURLINK_CRANK_ROCKER || first == second)
            continue;
        fourlink_limits_of(&m, FOURLINK_OPEN, &limits);
        swing = limits.theta4_max - limits.theta4_min;
        task = rocker(limits.time_ratio, swing, 0, 0, 0, 0);
        task.length[first] = d.link[first].length;
        task.length[second] = d.link[second].length;
        sign = limits.theta2_max - limits.theta2_min > PI ? 1 : -1;
        task.slow = sign > 0 ? FOURLINK_SLOW_WITH : FOURLINK_SLOW_AGAINST;
        alpha = sign * alpha_of(limits.time_ratio);
        if (fourlink_synthesis_quick_return(&task, 1, &s, &n_found) != FOURLINK_OK)
            fail_msg("none for %g %g", swing, alpha);
        n++;
        /* near alpha = swing, 0 or swing / 2 the two lengths hardly determine the others */
        tolerance = 1e-9 / fmin(1, fmin(fabs(sin(alpha / 2)), fabs(sin((swing - alpha) / 2)))) /
                    fmin(fabs(sin(alpha / 2)), fabs(sin((swing - alpha) / 2)));
        for (int i = 1; i <= 4; i++)
            assert_near(length_of(&s, i), d.link[i].length, tolerance);
        assert_int_equal(s.defects, 0);
        assert_true(is_sound(&s));
        limits = limits_of(&s);
        assert_near(limits.theta4_max - limits.theta4_min, swing, 1e-11 * s.ratio / s.mu_min);
        I1 = pow(length_of(&s, 2) * cos(alpha / 2), 2) + pow(length_of(&s, 3) * sin(alpha / 2), 2) -
             pow(length_of(&s, 4) * sin(swing / 2), 2);
        I2 = pow(length_of(&s, 2) * cos((swing - alpha) / 2), 2) +
             pow(length_of(&s, 3) * sin((swing - alpha) / 2), 2) -
             pow(length_of(&s, 1) * sin(swing / 2), 2);
        assert_near(I1, 0, 1e-12);
        assert_near(I2, 0, 1e-12);
    }
}

/* mu_min for crank / coupler = 1 / (1 + e^-x), where c and d follow from a and b at any time ratio; from the
** ground and the crank b does not follow near alpha = swing.  -1: none. */
static double transmission(fourlink_quick_return_task task, double x)
{
    fourlink_solution s;
    unsigned long n;

    memset(task.length, 0, sizeof task.length);
    task.length[2] = 1 / (1 + exp(-x));
    task.length[3] = 1;
    return fourlink_synthesis_quick_return(&task, 1, &s, &n) == FOURLINK_OK ? s.mu_min : -1;
}

/* The best is not below any of a fine scan.  As mu_min is concave there, it is not above the lines through
** the scan's best and its neighbours; it is the same for each length that may be given. */
TEST(best_transmission)
{
    uint64_t seed = 42;
    int n_best = 0;

    for (int k = 0; k < some_of(60); k++) {
        double swing = uniform(&seed, 10, 150) * DEG, ratio = uniform(&seed, 1.02, 2.5), best = -1,
               at = 0, rise = 0;
        fourlink_quick_return_task task = rocker(ratio, swing, 0, 0, 0, 1);
        fourlink_solution s, other;
        unsigned long n;
        int status;

        task.slow = k % 2 ? FOURLINK_SLOW_WITH : FOURLINK_SLOW_AGAINST;
        status = fourlink_synthesis_quick_return(&task, 1, &s, &n);
        for (int i = -1750; i <= 1750; i++) {
            double value = transmission(task, i / 250.0);

            if (value > best) {
                best = value;
                at = i / 250.0;
            }
        }
        for (int side = -1; side <= 1; side += 2)
            rise = fmax(rise, best - transmission(task, at + side / 250.0));
        if (best < 0) {
            assert_int_equal(status, FOURLINK_NO_FULL_TURN);
            continue;
        }
        if (status == FOURLINK_INFINITE_LINK)
            continue;
        assert_int_equal(status, FOURLINK_OK);
        n_best++;
        assert_true(s.mu_min >= best - 1e-9);
        fourlink_limits limits = limits_of(&s);
        /* near mu = 0 rounding of the lengths is seen 1 / mu times as large */
        assert_near(limits.theta4_max - limits.theta4_min, swing, 1e-11 * s.ratio / s.mu_min);
        assert_near(limits.time_ratio, ratio, 1e-11 * s.ratio / s.mu_min);
        assert_true(s.mu_min <= best + rise);
        for (int i = 1; i <= 4; i++) {
            task = rocker(ratio, swing, 0, 0, 0, 0);
            task.slow = k % 2 ? FOURLINK_SLOW_WITH : FOURLINK_SLOW_AGAINST;
            task.length[i] = 3 * length_of(&s, i);
            FOUND(quick_return, &task, &other);
            for (int j = 1; j <= 4; j++)
                assert_close(length_of(&other, j), 3 * length_of(&s, j), 1e-12);
        }
    }
    print_message("%d of %d have a best\n", n_best, some_of(60));
    assert_true(n_best > some_of(20));
}

/* The best crank is almost as long as the coupler. */
TEST(best_at_the_edge)
{
    fourlink_quick_return_task task = rocker(2.02957, 55.787590 * DEG, 0, 0, 0, 1);
    fourlink_solution s;
    double best = -1;

    task.slow = FOURLINK_SLOW_AGAINST;
    FOUND(quick_return, &task, &s);
    for (int i = 3000; i < 7000; i++)
        best = fmax(best, transmission(task, i / 1000.0));
    assert_true(s.mu_min >= best - 1e-12);
}

/* A crank-rocker exists if and only if -90 deg + swing / 2 < alpha < 90 deg + swing / 2. */
TEST(existence)
{
    const int step = tries_all() ? 6 : 12;

    for (int swing = 5; swing < 180; swing += step)
        for (int alpha = -177; alpha < 180; alpha += step) {
            double ratio = (180.0 + abs(alpha)) / (180 - abs(alpha));
            fourlink_quick_return_task task = rocker(ratio, swing * DEG, 0, 0, 0, 1);
            fourlink_solution s;
            unsigned long n;
            int status, exists = alpha > -90 + swing / 2.0 && alpha < 90 + swing / 2.0;

            task.slow = alpha < 0 ? FOURLINK_SLOW_AGAINST : FOURLINK_SLOW_WITH;
            status = fourlink_synthesis_quick_return(&task, 1, &s, &n);
            if (status == FOURLINK_OK || status == FOURLINK_INFINITE_LINK)
                assert_true(exists);
            else if (swing <
                     175) /* nearer to the edge the linkages that exist have a mu_min below 1 deg */
                assert_false(alpha > -89 + swing / 2.0 && alpha < 89 + swing / 2.0);
        }
}

TEST(sliders)
{
    uint64_t seed = 43;
    int n_found = 0;

    while (n_found < some_of(1000)) {
        fourlink_quick_return_task task = {.type = FOURLINK_ENGINE};
        double ratio = uniform(&seed, 1, 2.5), s0 = uniform(&seed, 0.01, 1);
        fourlink_limits limits;
        fourlink_solution s;
        unsigned long n;
        int status;

        task.time_ratio = ratio;
        task.stroke = s0;
        task.slow = n_found % 2 ? FOURLINK_SLOW_WITH : FOURLINK_SLOW_AGAINST;
        if (n_found % 3)
            task.length[1 + n_found % 3] = s0 * uniform(&seed, 0.2, 2);
        status = fourlink_synthesis_quick_return(&task, 1, &s, &n);
        if (status != FOURLINK_OK) {
            assert_true(status == FOURLINK_NO_LINKAGE || status == FOURLINK_NO_FULL_TURN ||
                        status == FOURLINK_INFINITE_LINK);
            continue;
        }
        n_found++;
        limits = limits_of(&s);
        assert_close(limits.stroke, s0, 1e-11 * s.ratio);
        assert_close(limits.time_ratio, ratio, 1e-11 * s.ratio);
        assert_true(is_sound(&s));
        assert_int_equal(s.defects, 0);
        for (int i = 0; i < 2; i++)
            assert_true(miss_of(&s, i, 0) < 1);
    }
}

TEST(levers)
{
    uint64_t seed = 44;

    for (int k = 0; k < some_of(1000); k++) {
        fourlink_quick_return_task task = {.type =
                                               k % 2 ? FOURLINK_SLOTTED_LEVER : FOURLINK_WHITWORTH};
        double ratio = uniform(&seed, 1.05, 4);
        fourlink_limits limits;
        fourlink_solution s;

        task.time_ratio = ratio;
        task.length[1 + k / 2 % 2] = 0.3;
        if (k % 2) {
            task.offset = uniform(&seed, -0.05, 0.05);
            task.stroke = uniform(&seed, 0.1, 0.5);
        }
        if (k % 2 && fabs(task.offset) / 0.3 > sin(alpha_of(ratio) / 2) * 0.9)
            task.offset = 0;
        if (task.offset != 0) {
            unsigned long n;
            int status = fourlink_synthesis_quick_return(&task, 1, &s, &n);

            if (status == FOURLINK_NO_FULL_TURN)
                continue;
        }
        FOUND(quick_return, &task, &s);
        limits = limits_of(&s);
        assert_close(limits.time_ratio, ratio, 1e-12);
        assert_int_equal(s.defects, 0);
        if (k % 2) {
            assert_close(limits.theta4_max - limits.theta4_min, alpha_of(ratio), 1e-12);
            if (task.stroke > 0)
                assert_close(2 * length_of(&s, 4) *
                                 sin((limits.theta4_max - limits.theta4_min) / 2),
                             task.stroke, 1e-12);
            if (task.offset == 0)
                assert_close(length_of(&s, 2), length_of(&s, 1) * sin(alpha_of(ratio) / 2), 1e-14);
        }
        for (int i = 0; i < 2; i++)
            assert_true(miss_of(&s, i, 0) < 1);
    }
}

TEST(refused)
{
    fourlink_quick_return_task task = rocker(1.2, 60 * DEG, 0, 0, 0, 1), good = task;

    task.time_ratio = 0.9;
    REFUSED(quick_return, &task, FOURLINK_BAD_TIME_RATIO);
    task = good;
    task.swing = 0;
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
    task = good;
    task.stroke = 1;
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
    task = good;
    task.swing = PI;
    REFUSED(quick_return, &task, FOURLINK_BAD_NUMBER);
    task = good;
    task.length[1] = 0;
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
    task = rocker(1.2, 60 * DEG, 1, 1, 1, 0);
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
    task = rocker(1, 60 * DEG, 0, 0, 0, 1); /* mu_min grows with the coupler */
    REFUSED(quick_return, &task, FOURLINK_INFINITE_LINK);
    task = rocker(1.5, 36 * DEG, 0.1, 0, 0, 1); /* alpha = swing: a follows from d */
    REFUSED(quick_return, &task, FOURLINK_DEPENDENT);
    task = rocker(1.2, 60 * DEG, 5, 0, 0, 1);
    REFUSED(quick_return, &task, FOURLINK_NO_LINKAGE);
    task = rocker(1, 60 * DEG, 0.5, 0, 0, 0.5); /* the theory's two-position rocker, with c = 1 */
    REFUSED(quick_return, &task, FOURLINK_NO_LINKAGE);
    task = rocker(9, 20 * DEG, 0, 0, 0, 1);
    REFUSED(quick_return, &task, FOURLINK_NO_FULL_TURN);
    task = good;
    task.type = FOURLINK_DOUBLE_CRANK;
    REFUSED(quick_return, &task, FOURLINK_BAD_KIND);
    task = good;
    task.slow = 7;
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
    task = good;
    task.length[3] = NAN;
    REFUSED(quick_return, &task, FOURLINK_BAD_NUMBER);
    task.length[3] = -1;
    REFUSED(quick_return, &task, FOURLINK_BAD_LENGTH);
    REFUSED(quick_return, NULL, FOURLINK_NULL);
    memset(&task, 0, sizeof task);
    task.type = FOURLINK_WHITWORTH;
    task.time_ratio = 1;
    task.length[1] = 1;
    REFUSED(quick_return, &task, FOURLINK_NO_LENGTH);
    task.type = FOURLINK_SLOTTED_LEVER;
    REFUSED(quick_return, &task, FOURLINK_NO_LENGTH);
    task.time_ratio = 2;
    task.slow = FOURLINK_SLOW_AGAINST;
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
    task.slow = FOURLINK_SLOW_WITH;
    task.length[4] = task.stroke = 1; /* one follows from the other */
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
    task.length[4] = 0;
    task.swing = 1; /* the swing follows from the time ratio */
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
    task.time_ratio = task.swing = 0;
    REFUSED(quick_return, &task, FOURLINK_BAD_CHOICE);
}

TEST(bad_problems)
{
    static const int types[] = {FOURLINK_CRANK_ROCKER, FOURLINK_ENGINE, FOURLINK_SLOTTED_LEVER,
                                FOURLINK_WHITWORTH};
    uint64_t seed = 45;

    for (int k = 0; k < some_of(10000); k++) {
        fourlink_quick_return_task task = {.type = (fourlink_type)types[k % 4]};
        double *number[] = {&task.time_ratio, &task.swing,     &task.stroke,    &task.offset,
                            &task.length[1],  &task.length[2], &task.length[3], &task.length[4]};
        fourlink_solution s;
        unsigned long n;
        int status;

        task.time_ratio = uniform(&seed, 0.9, 3);
        task.swing = k % 4 ? 0 : uniform(&seed, 0, 3.3);
        task.stroke = k % 4 == 1 ? uniform(&seed, 0, 1) : 0;
        task.length[1 + (k % 4 == 1)] = uniform(&seed, 0, 1);
        for (unsigned i = 0; i < COUNT(number); i++)
            if (uniform(&seed, 0, 1) < 0.15)
                *number[i] = odd_number(&seed);
        task.slow = (int)uniform(&seed, -2, 3);
        status = fourlink_synthesis_quick_return(&task, 1, &s, &n);
        assert_true(status == FOURLINK_OK ? is_sound(&s) : status >= 20);
    }
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
