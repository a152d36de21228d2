/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_motion.c - the crank positions to visit: the three motions of the paper's program, any range
** at constant acceleration, a crank that stops on its way, the placing of the rows, statuses.
*/
#include <float.h>
#include <limits.h>

#include "check.h"
#include "fourlink.h"

#define EPS 2.220446049250313e-16

/* A range in degrees. */
static fourlink_motion degrees(double from, double to, double interval, double speed,
                               double acceleration)
{
    fourlink_motion motion;

    memset(&motion, 0, sizeof motion);
    motion.angle_unit = DEG;
    motion.from = from;
    motion.to = to;
    motion.interval = interval;
    motion.speed = speed;
    motion.acceleration = acceleration;
    return motion;
}

static fourlink_range range_of(const fourlink_motion *motion)
{
    fourlink_range range;

    assert_int_equal(fourlink_motion_range(motion, &range), FOURLINK_OK);
    assert_true(range.n_rows >= 1);
    if (!range.stops)
        assert_true(range.stop_angle == 0);
    return range;
}

static fourlink_row row_of(const fourlink_motion *motion, const fourlink_range *range,
                           unsigned long i)
{
    fourlink_row row;

    assert_int_equal(fourlink_motion_row(motion, range, i, &row), FOURLINK_OK);
    assert_near(row.crank.theta2, row.angle * motion->angle_unit, EPS * fabs(row.crank.theta2));
    return row;
}

/* ---------------------------------------------------------------------------------------------
** The paper's three motions
** ------------------------------------------------------------------------------------------- */

TEST(test_one_revolution)
{
    fourlink_motion motion = degrees(0, 360, 40, 10.5, 0);
    fourlink_range range = range_of(&motion);
    unsigned long i;

    assert_int_equal(range.n_rows, 10);
    assert_false(range.stops);
    for (i = 0; i < range.n_rows; i++) {
        fourlink_row row = row_of(&motion, &range, i);

        assert_true(row.angle == 40.0 * (double)i);
        assert_true(row.crank.omega2 == 10.5 && row.crank.alpha2 == 0);
        assert_near(row.time, (double)i / 9 * 2 * PI / 10.5, 1e-15);
    }
}

/* The paper's loop: omega2 grows by sqrt(omega2^2 + 2 alpha2 dtheta) a row, alpha2 is 0 from the
** row of the limit on, and a whole revolution follows it. */
static void check_run_up(int limit, int interval, double acceleration)
{
    fourlink_motion motion = degrees(0, 0, interval, 0, acceleration);
    double sign = acceleration < 0 ? -1 : 1, vela = 0, dtheta = interval * DEG, time = 0, before;
    int rows = limit / interval + 360 / interval + 1, j;
    fourlink_range range;

    motion.run_up = limit;
    motion.speed = 77; /* not used */
    range = range_of(&motion);
    assert_int_equal(range.n_rows, rows);
    assert_false(range.stops);
    for (j = 0; j < rows; j++) {
        fourlink_row row = row_of(&motion, &range, (unsigned long)j);
        double acca = j >= limit / interval ? 0 : acceleration;

        /* exactly whole, also in the last row */
        assert_true(row.angle == sign * interval * j);
        assert_near(row.crank.omega2, sign * vela, 1e-14 * (1 + vela));
        assert_true(row.crank.alpha2 == acca);
        assert_near(row.time, time, 1e-13 * (1 + time));
        before = vela;
        vela = sqrt(vela * vela + 2 * fabs(acca) * dtheta);
        time += 2 * dtheta / (before + vela);
    }
}

TEST(test_run_up)
{
    check_run_up(120, 40, 2);
    check_run_up(720, 40, 0.5);
    check_run_up(720, 10, -3);
    check_run_up(90, 1, 5);
    check_run_up(360, 360, 1);
}

/* A limit between two rows is kept exactly, and the revolution ends one after it. */
TEST(test_run_up_between_rows)
{
    fourlink_motion motion = degrees(15, 0, 40, 0, 2);
    double omega2 = sqrt(2 * 2 * 100 * DEG), time = omega2 / 2;
    fourlink_range range;
    fourlink_row row;

    motion.run_up = 100;
    range = range_of(&motion);
    assert_int_equal(range.n_rows, 13); /* 15, 55 ... 455, and 475 */
    row = row_of(&motion, &range, 2);   /* 80 deg on */
    assert_near(row.crank.omega2, sqrt(2 * 2 * 80 * DEG), 1e-15);
    assert_true(row.crank.alpha2 == 2);
    row = row_of(&motion, &range, 3); /* 120 deg on */
    assert_near(row.crank.omega2, omega2, 1e-15);
    assert_true(row.crank.alpha2 == 0);
    assert_near(row.time, time + 20 * DEG / omega2, 1e-14);
    row = row_of(&motion, &range, 12);
    assert_near(row.angle, 475, 475 * EPS);
    assert_near(row.time, time + 360 * DEG / omega2, 1e-14);
}

/* The last row of a run-up in whole degrees is a whole number of degrees. */
TEST(test_run_up_stays_whole)
{
    int from, limit;

    for (from = -180; from <= 180; from += 45)
        for (limit = 30; limit <= 1080; limit += 30) {
            fourlink_motion motion = degrees(from, 0, 15, 0, limit % 4 ? 2 : -2);
            fourlink_range range;
            fourlink_row row;

            motion.run_up = limit;
            range = range_of(&motion);
            assert_int_equal(range.n_rows, (limit + 360) / 15 + 1);
            row = row_of(&motion, &range, range.n_rows - 1);
            assert_true(row.angle == from + (limit % 4 ? 1 : -1) * (limit + 360));
        }
}

TEST(test_one_instant)
{
    const double speeds[] = {10.5, -10.5, 0}, accelerations[] = {0, 3, -3};
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) {
            fourlink_motion motion = degrees(40, 40, 10, speeds[i], accelerations[k]);
            fourlink_range range = range_of(&motion);
            fourlink_row row = row_of(&motion, &range, 0);

            assert_int_equal(range.n_rows, 1);
            assert_false(range.stops);
            assert_true(row.angle == 40 && row.time == 0);
            assert_true(row.crank.omega2 == speeds[i]);
            assert_true(row.crank.alpha2 == accelerations[k]);
        }
}

/* ---------------------------------------------------------------------------------------------
** Any range
** ------------------------------------------------------------------------------------------- */

/* The time as the integral of ds/omega, with s = u^2 against the root at a start from rest; Gauss's
** rule of three points on 400 panels, exact to order six. */
static double quadrature(double speed, double acceleration, double s)
{
    enum { PANELS = 400 };
    static const double node[3] = {-0.77459666924148337704, 0, 0.77459666924148337704};
    static const double weight[3] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    double panel = sqrt(s) / PANELS, sum = 0;
    int i, k;

    for (i = 0; i < PANELS; i++)
        for (k = 0; k < 3; k++) {
            double u = panel * (i + 0.5 + 0.5 * node[k]);

            sum += weight[k] * panel * u / sqrt(speed * speed + 2 * acceleration * u * u);
        }
    return sum;
}

TEST(test_accelerated_range)
{
    uint64_t seed = 1;
    int n;

    for (n = 0; n < 400; n++) {
        double sign = n % 2 ? 1 : -1, span = uniform(&seed, 1, 2000);
        double speed = n % 5 ? uniform(&seed, 0.5, 20) : 0;
        /* at most, what leaves a tenth of the energy at the end */
        double least = n % 5 ? -0.45 * speed * speed / (span * DEG) : 0;
        double acceleration = uniform(&seed, least, 20), from = uniform(&seed, -500, 500);
        fourlink_motion motion = degrees(from, from + sign * span, span / uniform(&seed, 1, 30),
                                         sign * speed, sign * acceleration);
        fourlink_range range = range_of(&motion);
        unsigned long i;

        assert_false(range.stops);
        for (i = 0; i < range.n_rows; i++) {
            fourlink_row row = row_of(&motion, &range, i);
            double s = fabs(row.angle - from) * DEG, time = row.time, omega2;

            omega2 = sign * row.crank.omega2;
            assert_true(row.crank.alpha2 == sign * acceleration);
            assert_true(omega2 >= 0 && time >= 0);
            /* s comes from a difference of angles of up to 2500 deg, with its rounding of 1e-13 */
            assert_near(omega2 * omega2, speed * speed + 2 * acceleration * s,
                        1e-14 * (speed * speed + 2 * fabs(acceleration) * (s + 1)));
            /* the smallest speed on the way is 0.3 of the first, or that of the first row */
            if (i > 0) {
                assert_close(time, quadrature(speed, acceleration, s), 1e-11);
                assert_close(speed * time + acceleration * time * time / 2, s, 1e-13);
                assert_close(speed + acceleration * time, omega2, 1e-13);
            }
        }
        assert_true(row_of(&motion, &range, 0).angle == from);
        assert_true(row_of(&motion, &range, 0).time == 0);
        assert_true(row_of(&motion, &range, range.n_rows - 1).angle == motion.to);
    }
}

TEST(test_constant_speed_both_ways)
{
    const double ends[2] = {-360, 360}, speeds[2] = {-2, 2};
    int i, k;
    unsigned long n;

    for (i = 0; i < 2; i++)
        for (k = 0; k < 2; k++) {
            fourlink_motion motion = degrees(0, ends[i], 45, speeds[k], 0);
            fourlink_range range = range_of(&motion);

            assert_int_equal(range.n_rows, 9);
            for (n = 0; n < 9; n++) {
                fourlink_row row = row_of(&motion, &range, n);

                assert_true(row.angle == ends[i] / 8 * (double)n);
                assert_true(row.crank.omega2 == speeds[k] && row.crank.alpha2 == 0);
                /* against its rotation, the crank passes the later rows earlier */
                assert_near(row.time * speeds[k], row.crank.theta2, 1e-14);
            }
        }
}

TEST(test_crank_at_rest)
{
    fourlink_motion motion = degrees(0, 90, 30, 0, 0);
    fourlink_range range = range_of(&motion);
    unsigned long i;

    assert_int_equal(range.n_rows, 4);
    for (i = 0; i < 4; i++) {
        fourlink_row row = row_of(&motion, &range, i);

        assert_true(row.crank.omega2 == 0 && row.crank.alpha2 == 0 && row.time == 0);
        assert_true(row.angle == 30.0 * (double)i);
    }
}

TEST(test_hold)
{
    const double accelerations[] = {0, 100, -100};
    int k, backwards;
    unsigned long i;

    for (k = 0; k < 3; k++)
        for (backwards = 0; backwards < 2; backwards++) {
            double to = backwards ? -360 : 360;
            fourlink_motion motion = degrees(0, to, 40, 2, accelerations[k]);
            fourlink_range range;

            motion.hold = 1;
            range = range_of(&motion);
            assert_int_equal(range.n_rows, 10);
            assert_false(range.stops);
            for (i = 0; i < 10; i++) {
                fourlink_row row = row_of(&motion, &range, i);

                assert_true(row.angle == to / 9 * (double)i);
                assert_true(row.crank.omega2 == 2);
                assert_true(row.crank.alpha2 == accelerations[k]);
                assert_near(row.time, accelerations[k] == 0 ? row.crank.theta2 / 2 : 0, 1e-14);
            }
        }
}

/* ---------------------------------------------------------------------------------------------
** A crank that stops
** ------------------------------------------------------------------------------------------- */

TEST(test_stops_on_its_way)
{
    int backwards;

    for (backwards = 0; backwards < 2; backwards++) {
        double sign = backwards ? -1 : 1;
        /* 10^2/(2 5) = 10 rad */
        fourlink_motion motion = degrees(100, 100 + sign * 720, 40, sign * 10, -sign * 5);
        fourlink_range range = range_of(&motion);
        fourlink_row row;

        assert_true(range.stops);
        assert_near(range.stop_angle, 100 + sign * 10 / DEG, 1e-12);
        assert_int_equal(range.n_rows, 15); /* 0 ... 560 deg on, of 573 */
        row = row_of(&motion, &range, 14);
        assert_true(row.angle == 100 + sign * 560);
        assert_near(row.crank.omega2, sign * sqrt(100 - 10 * 560 * DEG), 1e-13);
        assert_near(sign * 10 - sign * 5 * row.time, row.crank.omega2, 1e-13);
    }
}

TEST(test_stops_at_a_row)
{
    fourlink_motion motion = degrees(0, 3, 0.5, 2, -1);
    fourlink_range range;
    fourlink_row row;

    motion.angle_unit = 1;
    range = range_of(&motion);
    assert_true(range.stops);
    assert_true(range.stop_angle == 2);
    assert_int_equal(range.n_rows, 5);
    row = row_of(&motion, &range, 4);
    assert_true(row.angle == 2 && row.crank.omega2 == 0 && row.time == 2);

    /* at the first interval's beginning: nothing but the first row */
    motion.interval = 2.5;
    range = range_of(&motion);
    assert_true(range.stops);
    assert_int_equal(range.n_rows, 1);
    assert_true(row_of(&motion, &range, 0).angle == 0);
    assert_true(row_of(&motion, &range, 0).crank.omega2 == 2);
}

TEST(test_stops_at_the_end)
{
    fourlink_motion motion = degrees(0, -2, 0.5, -2, 1);
    fourlink_range range;
    fourlink_row row;
    int degree;

    motion.angle_unit = 1;
    range = range_of(&motion);
    assert_false(range.stops);
    assert_int_equal(range.n_rows, 5);
    row = row_of(&motion, &range, 4);
    assert_true(row.angle == -2 && row.crank.omega2 == 0 && row.time == 2);

    /* where rounding decides whether a little speed is left: its square is, to eps */
    for (degree = 1; degree <= 720; degree++) {
        motion = degrees(0, degree, 1, sqrt(2 * 3 * degree * DEG), -3);
        range = range_of(&motion);
        assert_false(range.stops);
        assert_int_equal(range.n_rows, degree + 1);
        row = row_of(&motion, &range, (unsigned long)degree);
        assert_true(row.angle == degree);
        assert_near(row.crank.omega2, 0, 4e-8 * motion.speed);
        assert_near(row.time, motion.speed / 3, 4e-8 * motion.speed);
    }
}

/* ---------------------------------------------------------------------------------------------
** The placing of the rows
** ------------------------------------------------------------------------------------------- */

/* All rows of a range against the same sum in extended precision, and the last at its end. */
static void check_rows(double from, double to, double interval, unsigned long n_rows)
{
    fourlink_motion motion = degrees(from, to, interval, to < from ? -1 : 1, 0);
    fourlink_range range = range_of(&motion);
    double sign = to < from ? -1 : 1, largest = fmax(fabs(from), fabs(to)), before = 0;
    unsigned long i;
    fourlink_row row;

    assert_int_equal(range.n_rows, n_rows);
    for (i = 0; i < n_rows; i++) {
        long double exact = (long double)from + sign * (long double)i * (long double)interval;

        assert_int_equal(fourlink_motion_row(&motion, &range, i, &row), FOURLINK_OK);
        if (i + 1 < n_rows)
            assert_near(row.angle, (double)exact, EPS * largest);
        if (i > 0) /* no sliver, no row twice */
            assert_true(sign * (row.angle - before) > 1e-3 * interval);
        before = row.angle;
    }
    assert_true(row.angle == to);
}

TEST(test_intervals)
{
    check_rows(0, 360, 360, 2);
    check_rows(0, 360, 1000, 2);
    check_rows(0, 360, 40, 10);
    check_rows(0, 360, 7, 53);
    check_rows(0, 360, 100, 5);
    check_rows(0, 360, 0.1, 3601);
    check_rows(0, 360, 0.7, 516);
    check_rows(0, 360, 0.3, 1201);
    check_rows(0, 360, 1.0 / 3, 1081);
    check_rows(0, 360, 360.0 / 7, 8);
    check_rows(0, 360, 1e-3, 360001);
    check_rows(0, 360, 1e-4, 3600001);
    check_rows(0, 2.1, 0.7, 4); /* the quotient is above 3 */
    check_rows(0.1, 0.7, 0.1, 7);
    check_rows(-0.3, 0.3, 0.1, 7);
    check_rows(360, 0, 40, 10);
    check_rows(360, 0, 7, 53);
    check_rows(10, -350, 0.1, 3601);
    check_rows(-100, -820, 1e-3, 720001);
    check_rows(0, 360.05, 0.1, 3602);
    check_rows(0, 359.95, 0.1, 3601);
}

/* What is a whole number of degrees on paper is one in the table. */
TEST(test_whole_degrees)
{
    static const int parts[] = {1, 2, 4, 5, 10, 20, 100, 1000, 10000};
    size_t k;
    int degree, backwards;

    for (backwards = 0; backwards < 2; backwards++)
        for (k = 0; k < COUNT(parts); k++) {
            fourlink_motion motion =
                degrees(backwards ? 360 : -360, backwards ? -360 : 360, 1.0 / parts[k], 1, 0);
            fourlink_range range = range_of(&motion);

            assert_int_equal(range.n_rows, 720 * parts[k] + 1);
            for (degree = 0; degree <= 720; degree++) {
                fourlink_row row = row_of(&motion, &range, (unsigned long)(degree * parts[k]));

                assert_true(row.angle == (backwards ? 360 - degree : degree - 360));
            }
        }
}

/* A range of many rows still has its last, short interval, and no long one. */
TEST(test_short_last_interval)
{
    const double whole[] = {10, 1e3, 1e6, 1e8, 1e9, 1e10, 1e12};
    const double rest[] = {0.1, 0.3, 0.5, 0.7, 0.9};
    int i, k;

    for (i = 0; i < 7 && whole[i] + 2 <= (double)ULONG_MAX; i++) /* rows are counted in it */
        for (k = 0; k < 5; k++) {
            fourlink_motion motion = degrees(0, whole[i] + rest[k], 1, 1, 0);
            fourlink_range range = range_of(&motion);

            assert_true(range.n_rows == (unsigned long)whole[i] + 2);
            assert_true(row_of(&motion, &range, range.n_rows - 2).angle == whole[i]);
            assert_true(row_of(&motion, &range, range.n_rows - 1).angle == motion.to);
        }
}

/* ---------------------------------------------------------------------------------------------
** Statuses
** ------------------------------------------------------------------------------------------- */

static void assert_no_range(const fourlink_motion *motion, int status)
{
    fourlink_range range, pattern;

    memset(&range, 0xa5, sizeof range);
    memset(&pattern, 0xa5, sizeof pattern);
    assert_int_equal(fourlink_motion_range(motion, &range), status);
    assert_memory_equal(&range, &pattern, sizeof range);
}

TEST(test_bad_motions)
{
    static const double no_numbers[] = {NAN, INFINITY, -INFINITY, 1.1e30, -1e31};
    const fourlink_motion good = degrees(0, 360, 10, 5, 1);
    fourlink_motion bad;
    size_t i;
    int field;

    assert_no_range(NULL, FOURLINK_NULL);
    assert_int_equal(fourlink_motion_range(&good, NULL), FOURLINK_NULL);
    for (field = 0; field < 7; field++)
        for (i = 0; i < COUNT(no_numbers); i++) {
            double *numbers[7];

            bad = good;
            numbers[0] = &bad.angle_unit;
            numbers[1] = &bad.from;
            numbers[2] = &bad.to;
            numbers[3] = &bad.interval;
            numbers[4] = &bad.run_up;
            numbers[5] = &bad.speed;
            numbers[6] = &bad.acceleration;
            *numbers[field] = no_numbers[i];
            assert_no_range(&bad, FOURLINK_BAD_NUMBER);
        }
    bad = good;
    bad.angle_unit = 0;
    assert_no_range(&bad, FOURLINK_BAD_NUMBER);
    bad.angle_unit = -1;
    assert_no_range(&bad, FOURLINK_BAD_NUMBER);
    bad = good;
    bad.interval = 0;
    assert_no_range(&bad, FOURLINK_BAD_INTERVAL);
    bad.interval = -10;
    assert_no_range(&bad, FOURLINK_BAD_INTERVAL);
    bad = degrees(0, 0, 10, 0, 0);
    bad.run_up = 90;
    assert_no_range(&bad, FOURLINK_NO_RUN_UP);
    bad.speed = 5;
    assert_no_range(&bad, FOURLINK_NO_RUN_UP);
}

/* Outputs stay as they are. */
TEST(test_no_row_of_no_motion)
{
    static const double no_numbers[] = {NAN, INFINITY, -INFINITY};
    fourlink_motion motion = degrees(0, 360, 10, 5, 1);
    fourlink_row row, before;
    size_t i;

    memset(&before, 0xa5, sizeof before);
    row = before;
    for (i = 0; i < 3; i++)
        assert_int_equal(fourlink_motion_at(&motion, no_numbers[i], &row), FOURLINK_BAD_NUMBER);
    motion.run_up = NAN;
    assert_int_equal(fourlink_motion_at(&motion, 10, &row), FOURLINK_OK); /* none */
    row = before;
    motion.run_up = 90;
    motion.acceleration = 0;
    assert_int_equal(fourlink_motion_at(&motion, 10, &row), FOURLINK_NO_RUN_UP);
    motion = degrees(0, 360, 10, 1e-310, 0); /* its time would be infinite */
    assert_no_range(&motion, FOURLINK_BAD_NUMBER);
    motion = degrees(0, 360, 10, NAN, 1);
    assert_int_equal(fourlink_motion_at(&motion, 10, &row), FOURLINK_BAD_NUMBER);
    assert_memory_equal(&row, &before, sizeof row);
}

/* The square of a tiny speed is 0, the speed is not. */
TEST(test_tiny_speeds)
{
    static const double speeds[] = {5e-324, -5e-324, 1e-310, 1e-200, -1e-200, 1e-163};
    fourlink_motion motion;
    fourlink_range range;
    fourlink_row row;
    size_t i;

    for (i = 0; i < COUNT(speeds); i++) {
        motion = degrees(30, 30, 10, speeds[i], 0);
        assert_int_equal(fourlink_motion_at(&motion, 30, &row), FOURLINK_OK);
        assert_true(row.crank.omega2 == speeds[i] && row.time == 0);
    }
    motion = degrees(0, 360, 10, 1e-200, 0);
    range = range_of(&motion);
    row = row_of(&motion, &range, 36);
    assert_true(row.crank.omega2 == 1e-200);
    assert_close(row.time, 2 * PI / 1e-200, 1e-15);
    motion = degrees(0, 360, 10, 1e-200, -1e-200); /* it comes to rest at once */
    assert_int_equal(fourlink_motion_range(&motion, &range), FOURLINK_OK);
    assert_true(range.stops);
    assert_int_equal(range.n_rows, 1);
    motion = degrees(0, 0, 10, 0, 1e-310); /* a run-up that takes for ever */
    motion.run_up = 90;
    assert_int_equal(fourlink_motion_range(&motion, &range), FOURLINK_OK);
    row = row_of(&motion, &range, range.n_rows - 1);
    assert_true(row.time > 0 && row.time <= DBL_MAX && row.crank.omega2 > 0);
}

TEST(test_too_many_rows)
{
    fourlink_motion bad = degrees(0, 360, 1e-13, 5, 0);
    fourlink_range range;

    assert_no_range(&bad, FOURLINK_TOO_MANY_ROWS);
    bad.interval = 1e-300;
    assert_no_range(&bad, FOURLINK_TOO_MANY_ROWS);
    bad = degrees(-1e30, 1e30, 1, 5, 0);
    assert_no_range(&bad, FOURLINK_TOO_MANY_ROWS);
    bad = degrees(0, 360, 1e-20, 5, -0.1); /* and so stopping on its way */
    bad.to = 1e6;
    assert_no_range(&bad, FOURLINK_TOO_MANY_ROWS);
    bad = degrees(0, 0, 1e-20, 0, 1);
    bad.run_up = 360;
    assert_no_range(&bad, FOURLINK_TOO_MANY_ROWS);
    bad = degrees(-1e30, 1e30, 1e30, 5, 0);
    assert_int_equal(fourlink_motion_range(&bad, &range), FOURLINK_OK);
    assert_int_equal(range.n_rows, 3);
}

TEST(test_bad_ranges)
{
    static const struct {
        double to, speed, acceleration;
        int status;
    } cases[] = {
        {-360, 5, 1, FOURLINK_BAD_RANGE}, {-360, 5, -1, FOURLINK_BAD_RANGE},
        {360, -5, 1, FOURLINK_BAD_RANGE}, {360, -5, -1, FOURLINK_BAD_RANGE},
        {-360, 0, 1, FOURLINK_BAD_RANGE}, {360, 0, -1, FOURLINK_BAD_RANGE},
        {360, 5, 1, FOURLINK_OK},         {360, 5, -0.01, FOURLINK_OK},
        {-360, -5, -1, FOURLINK_OK},      {-360, -5, 0.01, FOURLINK_OK},
        {360, 0, 1, FOURLINK_OK},         {-360, 0, -1, FOURLINK_OK},
        {0, 5, -1, FOURLINK_OK},          {0, 0, -1, FOURLINK_OK},
        {-360, 5, 0, FOURLINK_OK},        {360, -5, 0, FOURLINK_OK},
    };
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_motion motion = degrees(0, cases[i].to, 10, cases[i].speed, cases[i].acceleration);

        if (cases[i].status == FOURLINK_OK)
            assert_int_equal(range_of(&motion).n_rows, cases[i].to == 0 ? 1 : 37);
        else
            assert_no_range(&motion, cases[i].status);
        motion.hold = 1;
        assert_int_equal(range_of(&motion).n_rows, cases[i].to == 0 ? 1 : 37);
    }
}

TEST(test_no_such_row)
{
    const fourlink_motion motion = degrees(0, 360, 40, 5, 1);
    const fourlink_range range = range_of(&motion);
    fourlink_row row, pattern;

    memset(&row, 0xa5, sizeof row);
    memset(&pattern, 0xa5, sizeof pattern);
    assert_int_equal(fourlink_motion_row(&motion, &range, 10, &row), FOURLINK_NO_SUCH_ROW);
    assert_int_equal(fourlink_motion_row(&motion, &range, (unsigned long)-1, &row),
                     FOURLINK_NO_SUCH_ROW);
    assert_int_equal(fourlink_motion_row(NULL, &range, 0, &row), FOURLINK_NULL);
    assert_int_equal(fourlink_motion_row(&motion, NULL, 0, &row), FOURLINK_NULL);
    assert_int_equal(fourlink_motion_row(&motion, &range, 0, NULL), FOURLINK_NULL);
    assert_memory_equal(&row, &pattern, sizeof row);
    assert_int_equal(fourlink_motion_row(&motion, &range, 9, &row), FOURLINK_OK);
}

int main(void)
{
    return run_all_tests(NULL);
}
