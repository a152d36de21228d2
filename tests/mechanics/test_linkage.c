/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_linkage.c - the mechanism as a whole: its type, the crank angles at which it reaches, its limits.
**
** What is expected comes from the positions, one by one, or from triangles solved here in long double.
*/
#include <stdlib.h>

#include "formulas.h"
#include "mechanisms.h"

static fourlink_type type_of(const fourlink_mechanism *mechanism)
{
    fourlink_type type = FOURLINK_TYPE_END_;

    assert_int_equal(fourlink_type_of(mechanism, &type), FOURLINK_OK);
    return type;
}

static int status_at(const fourlink_mechanism *mechanism, double theta2)
{
    fourlink_state state;

    return fourlink_position(mechanism, FOURLINK_OPEN, theta2, &state);
}

static int reaches(int status)
{
    return status != FOURLINK_TOO_FAR && status != FOURLINK_TOO_NEAR &&
           status != FOURLINK_ROD_TOO_SHORT;
}

/* ---------------------------------------------------------------------------------------------
** Types
** ------------------------------------------------------------------------------------------- */

#define STEPS 120

/* Whether the crank can be turned all round, tried step by step. */
static int turns(const fourlink_mechanism *mechanism)
{
    int i;

    for (i = 0; i < STEPS; i++)
        if (status_at(mechanism, 2 * PI * i / STEPS) != FOURLINK_OK)
            return 0;
    return 1;
}

/* The same for any link against a neighbour, by making the neighbour the ground: the links in their
** order round the loop from the one that turns, the last is at rest. */
static int turns_against(double turning, double next, double opposite, double resting)
{
    fourlink_mechanism m = four_bar(turning, next, opposite, resting);

    return turns(&m);
}

/* How often a link turns while the crank turns once. */
static long turns_of(const fourlink_mechanism *mechanism, fourlink_branch branch, int link)
{
    fourlink_state state;
    double sum = 0, before = 0, step;
    int i;

    for (i = 0; i <= STEPS; i++) {
        assert_int_equal(fourlink_position(mechanism, branch, 2 * PI * i / STEPS, &state),
                         FOURLINK_OK);
        step = state.link[link].theta - before;
        if (i)
            sum += step - 2 * PI * floor(step / (2 * PI) + 0.5);
        before = state.link[link].theta;
    }
    return lround(sum / (2 * PI));
}

TEST(test_types_by_turning)
{
    int seen[FOURLINK_TRIPLE_ROCKER + 1] = {0}, i, k;
    uint64_t seed = 1;

    for (i = 0; i < some_of(4000); i++) {
        double x[4], s = 2, l = 0, sum = 0, a, b, c, d;
        int crank, rocker, on_crank, on_rocker;
        fourlink_mechanism m;
        fourlink_type type;

        for (k = 0; k < 4; k++) {
            x[k] = uniform(&seed, 0.1, 1);
            sum += x[k];
            s = x[k] < s ? x[k] : s;
            l = x[k] > l ? x[k] : l;
        }
        /* where a link turns all but a little, steps do not tell */
        if (2 * l > sum || fabs(2 * (s + l) - sum) < 0.02 * sum)
            continue;
        a = x[0], b = x[1], c = x[2], d = x[3];
        m = four_bar(a, b, c, d);
        type = type_of(&m);
        crank = turns_against(a, b, c, d);
        rocker = turns_against(c, b, a, d);
        on_crank = turns_against(b, c, d, a);
        on_rocker = turns_against(b, a, d, c);
        if (crank && rocker) {
            assert_int_equal(type, FOURLINK_DOUBLE_CRANK);
        } else if (crank) {
            assert_int_equal(type, FOURLINK_CRANK_ROCKER);
        } else if (rocker) {
            assert_int_equal(type, FOURLINK_ROCKER_CRANK);
        } else if (on_crank || on_rocker) {
            assert_true(on_crank && on_rocker);
            assert_int_equal(type, FOURLINK_DOUBLE_ROCKER);
        } else {
            assert_int_equal(type, FOURLINK_TRIPLE_ROCKER);
        }
        for (k = 0; k < 2 && crank; k++) {
            assert_int_equal(turns_of(&m, branches[k], 4), rocker ? 1 : 0);
            assert_int_equal(turns_of(&m, branches[k], 3), rocker ? 1 : 0);
        }
        seen[type]++;
    }
    for (k = FOURLINK_CRANK_ROCKER; k <= FOURLINK_TRIPLE_ROCKER; k++)
        assert_true(seen[k] > some_of(100));
}

/* Whole millimetres, in which s + l = p + q is exact but for the lengths' own rounding. */
static double millimetres(uint64_t *seed)
{
    return floor(uniform(seed, 10, 1000)) / 1000;
}

static void check_change_point(double a, double b, double c, double d, fourlink_type expected)
{
    fourlink_mechanism m = four_bar(a, b, c, d);
    int at_0 = status_at(&m, 0), at_180 = status_at(&m, PI);

    if (type_of(&m) != expected)
        fail_msg("%g %g %g %g: %s", a, b, c, d, fourlink_type_text((int)type_of(&m)));
    /* it goes through a position with all links in one line */
    assert_true(at_0 == FOURLINK_CHANGE_POINT || at_180 == FOURLINK_CHANGE_POINT);
}

TEST(test_types_with_change_point)
{
    uint64_t seed = 2;
    int i, generic = 0;

    for (i = 0; i < some_of(2000); i++) {
        double x = millimetres(&seed), y = millimetres(&seed), z = millimetres(&seed), w;

        if (x == y)
            continue;
        check_change_point(x, x, x, x, FOURLINK_RHOMBUS);
        check_change_point(x, y, x, y, FOURLINK_PARALLELOGRAM);
        check_change_point(x, x, y, y, FOURLINK_DELTOID);
        check_change_point(x, y, y, x, FOURLINK_DELTOID);
        w = (floor(x * 1000 + 0.5) + floor(y * 1000 + 0.5) - floor(z * 1000 + 0.5)) / 1000;
        /* x + y = z + w: with x the shortest and y the longest, or the other pair */
        if (w <= 0.005 || fabs(w - x) < 0.0005 || fabs(w - y) < 0.0005 || fabs(z - x) < 0.0005 ||
            fabs(z - y) < 0.0005)
            continue;
        generic++;
        check_change_point(x, z, y, w, FOURLINK_CHANGE_POINT_LINKAGE);
        check_change_point(x, y, z, w, FOURLINK_CHANGE_POINT_LINKAGE);
        check_change_point(z, x, y, w, FOURLINK_CHANGE_POINT_LINKAGE);
        check_change_point(z, w, x, y, FOURLINK_CHANGE_POINT_LINKAGE);
    }
    assert_true(generic > some_of(500));
}

/* A millionth beside the change point the linkage is of one of the other types. */
TEST(test_types_beside_change_point)
{
    fourlink_mechanism m = four_bar(0.020, 0.066, 0.056, 0.070);

    assert_int_equal(type_of(&m), FOURLINK_CRANK_ROCKER);
    m = four_bar(0.020, 0.066, 0.056, 0.102);
    assert_int_equal(type_of(&m), FOURLINK_CHANGE_POINT_LINKAGE);
    m = four_bar(0.020, 0.066, 0.056, 0.102 * (1 - 1e-6));
    assert_int_equal(type_of(&m), FOURLINK_CRANK_ROCKER);
    m = four_bar(0.020, 0.066, 0.056, 0.102 * (1 + 1e-6));
    assert_int_equal(type_of(&m), FOURLINK_TRIPLE_ROCKER);
    m = four_bar(0.3, 0.8, 0.3 * (1 + 1e-6), 0.8);
    assert_int_equal(type_of(&m), FOURLINK_CRANK_ROCKER);
    m = four_bar(0.3, 0.8, 0.3, 0.8 * (1 + 1e-6));
    assert_int_equal(type_of(&m), FOURLINK_TRIPLE_ROCKER);
    m = four_bar(0.3, 0.3, 0.8, 0.8 * (1 + 1e-6));
    assert_int_equal(type_of(&m), FOURLINK_TRIPLE_ROCKER);
    m = four_bar(1, 2.5, 1,
                 1); /* two shortest links, or three, never satisfy Grashof's condition */
    assert_int_equal(type_of(&m), FOURLINK_TRIPLE_ROCKER);
}

TEST(test_types_of_slider_cranks)
{
    int seen[2] = {0}, i;
    uint64_t seed = 3;

    for (i = 0; i < some_of(2000); i++) {
        double r = uniform(&seed, 0.1, 1), l = uniform(&seed, 0.1, 3), e = uniform(&seed, -1, 1);
        fourlink_mechanism m = slider_crank(r, l, e);
        int full;

        if (fabs(l - r - fabs(e)) < 0.02 * l)
            continue;
        full = turns(&m);
        assert_int_equal(type_of(&m), full ? FOURLINK_ENGINE : FOURLINK_SLIDER_ROCKER);
        seen[full]++;
    }
    assert_true(seen[0] > some_of(200) && seen[1] > some_of(200));
    for (i = 0; i < some_of(2000); i++) {
        double r = millimetres(&seed), e = millimetres(&seed), l;
        fourlink_mechanism m;

        if (i % 3 == 0)
            e = 0;
        l = (floor(r * 1000 + 0.5) + floor(e * 1000 + 0.5)) / 1000;
        m = slider_crank(r, l, i % 2 ? e : -e);
        assert_int_equal(type_of(&m), FOURLINK_CHANGE_POINT_SLIDER);
        assert_int_equal(status_at(&m, i % 2 ? -PI / 2 : PI / 2), FOURLINK_CHANGE_POINT);
        m = slider_crank(r, l * (1 + 1e-6), i % 2 ? e : -e);
        assert_int_equal(type_of(&m), FOURLINK_ENGINE);
        m = slider_crank(r, l * (1 - 1e-6), i % 2 ? e : -e);
        assert_int_equal(type_of(&m), FOURLINK_SLIDER_ROCKER);
    }
}

TEST(test_type_names)
{
    static const struct {
        double a, b, c, d;
        const char *name;
    } table[] = {{20, 66, 56, 80, "crank-rocker"},
                 {56, 66, 20, 80, "rocker-crank"},
                 {66, 56, 80, 20, "double crank (drag link)"},
                 {66, 20, 80, 56, "double rocker"},
                 {50, 40, 60, 100, "triple rocker (not Grashof)"},
                 {30, 70, 30, 70, "change point: parallelogram"},
                 {30, 30, 70, 70, "change point: deltoid"},
                 {30, 30, 30, 30, "change point: rhombus"},
                 {30, 50, 60, 80, "change point"}};
    fourlink_mechanism m;
    int i, j;

    for (i = 0; i < (int)COUNT(table); i++) {
        /* at any size */
        for (j = -12; j <= 12; j += 4) {
            double unit = pow(10, j);

            m = four_bar(table[i].a * unit, table[i].b * unit, table[i].c * unit,
                         table[i].d * unit);
            assert_string_equal(fourlink_type_text((int)type_of(&m)), table[i].name);
        }
    }
    m = slider_crank(0.15, 0.45, 0);
    assert_string_equal(fourlink_type_text((int)type_of(&m)),
                        "slider-crank, the crank turns fully");
    m = slider_crank(0.45, 0.15, 0);
    assert_string_equal(fourlink_type_text((int)type_of(&m)),
                        "slider-crank, the crank does not turn fully");
    m = slider_crank(0.15, 0.45, -0.30);
    assert_string_equal(fourlink_type_text((int)type_of(&m)), "slider-crank with change point");
    for (i = -2; i < 120; i++) {
        const char *name = fourlink_type_text(i);

        assert_non_null(name);
        assert_true(*name);
        if (i < FOURLINK_CRANK_ROCKER || i > FOURLINK_YOKE)
            assert_string_equal(name, "unknown type");
    }
}

/* ---------------------------------------------------------------------------------------------
** Reach
** ------------------------------------------------------------------------------------------- */

/* Distance of an angle from a range's inside: negative inside, in rad; all turns of it are tried. */
static double outside(double from, double to, double theta)
{
    double middle = (from + to) / 2, d = theta - middle;

    d -= 2 * PI * floor(d / (2 * PI) + 0.5);
    return fabs(d) - (to - from) / 2;
}

/* The boundary between an angle that is reached and one that is not. */
static double boundary(const fourlink_mechanism *mechanism, double good, double bad)
{
    int i;

    assert_true(reaches(status_at(mechanism, good)));
    assert_false(reaches(status_at(mechanism, bad)));
    for (i = 0; i < 60; i++) {
        double middle = (good + bad) / 2;

        if (reaches(status_at(mechanism, middle)))
            good = middle;
        else
            bad = middle;
    }
    return good;
}

static int check_reach(const fourlink_mechanism *mechanism, double slow)
{
    fourlink_reach reach;
    int i, k;

    assert_int_equal(fourlink_reach_of(mechanism, &reach), FOURLINK_OK);
    assert_in_range(reach.n_ranges, 0, 2);
    for (k = reach.n_ranges; k < 2; k++)
        assert_true(reach.from[k] == 0 && reach.to[k] == 0);
    for (i = 0; i < 180; i++) {
        double theta = (2 * i + 0.123) * DEG, nearest = 9;

        for (k = 0; k < reach.n_ranges; k++) {
            double d = outside(reach.from[k], reach.to[k], theta);

            nearest = d < nearest ? d : nearest;
        }
        if (fabs(nearest) < 1e-9)
            continue;
        if (reaches(status_at(mechanism, theta)) != (nearest < 0))
            fail_msg("status %d at %.17g rad", status_at(mechanism, theta), theta);
    }
    for (k = 0; k < reach.n_ranges; k++) {
        double from = reach.from[k], to = reach.to[k], middle = (from + to) / 2, gap[2];

        assert_true(from < to);
        if (to - from == 2 * PI) {
            assert_int_equal(reach.n_ranges, 1);
            assert_true(from == 0);
            return 3;
        }
        /* the middles of the gaps before and after the range */
        gap[0] = from - (2 * PI - (to - from)) / 2;
        gap[1] = to + (2 * PI - (to - from)) / 2;
        if (reach.n_ranges == 2) {
            double other_from = reach.from[1 - k], other_to = reach.to[1 - k];

            gap[0] = k ? (other_to + from) / 2 : (other_to - 2 * PI + from) / 2;
            gap[1] = k ? (to + other_from + 2 * PI) / 2 : (to + other_from) / 2;
        }
        assert_near(boundary(mechanism, middle, gap[0]), from, 1e-9);
        assert_near(boundary(mechanism, middle, gap[1]), to, 1e-9);
        /* with a short coupler and rocker the rounding of the angle itself leads out of the dead position
         */
        if (slow < 4) {
            assert_int_equal(status_at(mechanism, from), FOURLINK_DEAD_POSITION);
            assert_int_equal(status_at(mechanism, to), FOURLINK_DEAD_POSITION);
        }
    }
    return reach.n_ranges;
}

TEST(test_reach_of_four_bars)
{
    int seen[4] = {0}, around_0 = 0, i;
    uint64_t seed = 4;

    for (i = 0; i < some_of(4000); i++) {
        double a = uniform(&seed, 0.1, 1), b = uniform(&seed, 0.1, 1), c = uniform(&seed, 0.1, 1),
               d = uniform(&seed, 0.1, 1);
        fourlink_mechanism m = four_bar(a, b, c, d);
        double l = fmax(fmax(a, b), fmax(c, d));
        int n = check_reach(&m, a * d / (b * c));

        assert_true((n == 0) == (2 * l > a + b + c + d));
        seen[n]++;
        around_0 += n == 1 && reaches(status_at(&m, 0));
    }
    for (i = 0; i < 4; i++)
        assert_true(seen[i] > some_of(200));
    assert_true(around_0 > some_of(200) && seen[1] - around_0 > some_of(200));
}

TEST(test_reach_of_slider_cranks)
{
    int seen[4] = {0}, i;
    uint64_t seed = 5;

    for (i = 0; i < some_of(4000); i++) {
        double r = uniform(&seed, 0.1, 1), l = uniform(&seed, 0.1, 1.5),
               e = uniform(&seed, -1.5, 1.5);
        fourlink_mechanism m = slider_crank(r, l, e);
        int n = check_reach(&m, r / l);

        assert_true((n == 0) == (fabs(e) > r + l));
        seen[n]++;
    }
    for (i = 0; i < 4; i++)
        assert_true(seen[i] > some_of(100));
}

/* 300, 400, 500, 750 mm: the triangle ABD has its side BD = 900 mm at the limit. */
TEST(test_reach_by_hand)
{
    fourlink_mechanism m = four_bar(0.3, 0.4, 0.5, 0.75);
    double end = acos((0.09 + 0.5625 - 0.81) / (2 * 0.3 * 0.75));
    fourlink_reach reach;

    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_int_equal(reach.n_ranges, 1);
    assert_near(reach.from[0], -end, 1e-15);
    assert_near(reach.to[0], end, 1e-15);
    assert_near(end / DEG, 110.487315114722, 1e-11);

    /* a rod as long as half the crank: |sin(theta2)| <= 1/2 */
    m = slider_crank(0.4, 0.2, 0);
    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_int_equal(reach.n_ranges, 2);
    assert_near(reach.from[0], -PI / 6, 1e-15);
    assert_near(reach.to[0], PI / 6, 1e-15);
    assert_near(reach.from[1], PI - PI / 6, 1e-15);
    assert_near(reach.to[1], PI + PI / 6, 1e-15);

    /* change points do not bound the reach */
    m = four_bar(0.3, 0.7, 0.3, 0.7);
    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_int_equal(reach.n_ranges, 1);
    assert_true(reach.from[0] == 0 && reach.to[0] == 2 * PI);
    m = slider_crank(0.2, 0.2, 0);
    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_int_equal(reach.n_ranges, 1);
    assert_true(reach.from[0] == 0 && reach.to[0] == 2 * PI);

    /* links that never meet */
    m = four_bar(0.2, 0.9, 0.3, 0.3);
    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_int_equal(reach.n_ranges, 0);
    m = slider_crank(0.2, 0.3, -0.51);
    assert_int_equal(fourlink_reach_of(&m, &reach), FOURLINK_OK);
    assert_int_equal(reach.n_ranges, 0);
}

/* ---------------------------------------------------------------------------------------------
** Limits
** ------------------------------------------------------------------------------------------- */

typedef struct peak {
    double value, theta2;
} peak;

/* The maximum (sign 1) or minimum (-1) between two crank angles, in degrees or in metres. */
static peak own_extreme(own_column *f, const own *o, int sign, double from, double to)
{
    peaks all = {0};
    peak found;

    scan(f, o, sign, from, to, &all);
    found.value = (double)all.value;
    found.theta2 = (double)all.theta2[0];
    return found;
}

static fourlink_limits limits_of(const fourlink_mechanism *mechanism, fourlink_branch branch)
{
    fourlink_limits limits;

    assert_int_equal(fourlink_limits_of(mechanism, branch, &limits), FOURLINK_OK);
    return limits;
}

/* Two angles, but for whole turns. */
static void check_angle(double actual, double expected, double tolerance)
{
    double d = actual - expected;

    assert_near(d - 2 * PI * floor(d / (2 * PI) + 0.5), 0, tolerance);
}

static void assert_no_swing(const fourlink_limits *limits)
{
    assert_false(limits->has_swing);
    assert_true(limits->theta4_min == 0 && limits->theta4_max == 0 && limits->theta2_min == 0 &&
                limits->theta2_max == 0);
}

static void assert_no_stroke(const fourlink_limits *limits)
{
    assert_false(limits->has_stroke);
    assert_true(limits->stroke == 0 && limits->inner == 0 && limits->outer == 0);
}

TEST(test_limits_of_rockers)
{
    uint64_t seed = 6;
    int i, k, n = 0, quick[2] = {0};

    for (i = 0; i < some_of(4000) && n < some_of(150); i++) {
        double a = uniform(&seed, 0.1, 0.5), b = uniform(&seed, 0.3, 1), c = uniform(&seed, 0.3, 1),
               d = uniform(&seed, 0.3, 1.5);
        double l = fmax(b, fmax(c, d));
        fourlink_mechanism m = four_bar(a, b, c, d);

        /* near a change point the limits are as sharp as the scan is coarse */
        if (a > 0.95 * fmin(b, fmin(c, d)) || 2 * (a + l) > 0.98 * (a + b + c + d))
            continue;
        n++;
        for (k = 0; k < 2; k++) {
            own o = {a, b, c, d, (int)branches[k], 0, 0, 0, 0, 0};
            fourlink_limits limits = limits_of(&m, branches[k]);
            peak max = own_extreme(own_theta4, &o, 1, 0, 2 * PI),
                 min = own_extreme(own_theta4, &o, -1, 0, 2 * PI);
            /* the crossed branch is counted from 180 to 360 deg here, below the ground */
            double turn = branches[k] == FOURLINK_CROSSED ? 2 * PI : 0, sector;
            fourlink_state state;

            assert_true(limits.has_swing);
            assert_no_stroke(&limits);
            assert_near(limits.theta4_max, max.value * DEG - turn, 1e-12);
            assert_near(limits.theta4_min, min.value * DEG - turn, 1e-12);
            check_angle(limits.theta2_max, max.theta2, 1e-7);
            check_angle(limits.theta2_min, min.theta2, 1e-7);
            assert_true(0 <= limits.theta2_min && limits.theta2_min < 2 * PI);
            assert_true(0 <= limits.theta2_max && limits.theta2_max < 2 * PI);
            sector = fabs(max.theta2 - min.theta2);
            assert_close(limits.time_ratio,
                         sector > PI ? sector / (2 * PI - sector) : (2 * PI - sector) / sector,
                         1e-6);
            assert_true(limits.time_ratio >= 1);
            quick[sector > PI]++;
            /* the rocker stands still there */
            assert_int_equal(fourlink_position(&m, branches[k], limits.theta2_min, &state),
                             FOURLINK_OK);
            fourlink_velocity(&m, 1, &state);
            assert_near(state.link[4].k, 0, 1e-12);
            assert_near(state.link[4].theta, limits.theta4_min, 1e-12);
            assert_int_equal(fourlink_position(&m, branches[k], limits.theta2_max, &state),
                             FOURLINK_OK);
            fourlink_velocity(&m, 1, &state);
            assert_near(state.link[4].k, 0, 1e-12);
            assert_near(state.link[4].theta, limits.theta4_max, 1e-12);
        }
    }
    assert_int_equal(n, some_of(150));
    assert_true(quick[0] > some_of(20) && quick[1] > some_of(20));
}

TEST(test_transmission_angles_of_four_bars)
{
    int seen[FOURLINK_TRIPLE_ROCKER + 1] = {0}, below_90 = 0, i, k;
    uint64_t seed = 7;

    for (i = 0; i < some_of(500); i++) {
        double a = uniform(&seed, 0.1, 1), b = uniform(&seed, 0.1, 1), c = uniform(&seed, 0.1, 1),
               d = uniform(&seed, 0.1, 1);
        fourlink_mechanism m = four_bar(a, b, c, d);
        own o = {a, b, c, d, 1, 0, 0, 0, 0, 0};
        double max = 0, min = 9;
        fourlink_reach reach;
        fourlink_limits limits;

        fourlink_reach_of(&m, &reach);
        for (k = 0; k < reach.n_ranges; k++) {
            /* dead positions, at the ends, have 0 deg, towards which mu goes as a square root */
            int full = reach.to[k] - reach.from[k] == 2 * PI;
            double inset = full ? 0 : 1e-13;
            peak p = own_extreme(own_mu, &o, 1, reach.from[k] + inset, reach.to[k] - inset);

            max = fmax(max, p.value * DEG);
            p = own_extreme(own_mu, &o, -1, reach.from[k] + inset, reach.to[k] - inset);
            min = fmin(min, full || p.value * DEG > 1e-3 ? p.value * DEG : 0);
        }
        if (!reach.n_ranges)
            continue;
        seen[type_of(&m)]++;
        for (k = 0; k < 2; k++) {
            limits = limits_of(&m, branches[k]);
            assert_near(limits.mu_min, min, 1e-9);
            assert_near(limits.mu_max, max, 1e-9);
            assert_int_equal(limits.has_swing, type_of(&m) == FOURLINK_CRANK_ROCKER);
            assert_no_stroke(&limits);
            if (!limits.has_swing) {
                assert_no_swing(&limits);
                assert_true(limits.time_ratio == 0);
            }
        }
        below_90 += max < PI / 2 - 1e-6;
    }
    for (k = FOURLINK_CRANK_ROCKER; k <= FOURLINK_TRIPLE_ROCKER; k++)
        assert_true(seen[k] > some_of(10));
    assert_true(below_90 > some_of(10));
}

TEST(test_limits_of_pistons)
{
    uint64_t seed = 8;
    int n = 0, i, k;

    for (i = 0; i < 150; i++) {
        double r = uniform(&seed, 0.1, 0.5), e = uniform(&seed, -0.7, 0.7),
               l = (r + fabs(e)) * uniform(&seed, 1.02, 4);
        fourlink_mechanism m = slider_crank(r, l, e);

        for (k = 0; k < 2; k++) {
            own o = {r, l, 0, e, (int)branches[k], 0, 0, 0, 0, 0};
            fourlink_limits limits = limits_of(&m, branches[k]);
            peak far = own_extreme(own_x, &o, -1, -1, 2 * PI - 1),
                 near = own_extreme(own_x, &o, 1, -1, 2 * PI - 1);
            peak most = own_extreme(own_rod_mu, &o, 1, 0, 2 * PI),
                 least = own_extreme(own_rod_mu, &o, -1, 0, 2 * PI);
            double sector;
            fourlink_state state;

            assert_true(limits.has_stroke);
            assert_no_swing(&limits);
            assert_near(limits.stroke, near.value - far.value, 1e-13);
            check_angle(limits.inner, far.theta2, 1e-7);
            check_angle(limits.outer, near.theta2, 1e-7);
            sector = fabs(far.theta2 - near.theta2);
            assert_close(limits.time_ratio,
                         sector > PI ? sector / (2 * PI - sector) : (2 * PI - sector) / sector,
                         1e-6);
            assert_true(limits.time_ratio >= 1);
            assert_true(0 <= limits.inner && limits.inner < 2 * PI);
            assert_true(0 <= limits.outer && limits.outer < 2 * PI);
            assert_near(limits.mu_min, least.value * DEG, 1e-9);
            assert_near(limits.mu_max, most.value * DEG, 1e-9);
            n += most.value < 90 - 1e-4;
            /* the piston stands still there */
            assert_int_equal(fourlink_position(&m, branches[k], limits.inner, &state), FOURLINK_OK);
            fourlink_velocity(&m, 1, &state);
            assert_near(state.v, 0, 1e-13);
            assert_near(state.x, 0, 1e-14);
            assert_int_equal(fourlink_position(&m, branches[k], limits.outer, &state), FOURLINK_OK);
            fourlink_velocity(&m, 1, &state);
            assert_near(state.v, 0, 1e-13);
            assert_near(state.x, limits.stroke, 1e-14);
        }
    }
    assert_true(n > 10);
}

TEST(test_transmission_angles_of_slider_cranks)
{
    int seen[3] = {0}, i, k;
    uint64_t seed = 9;

    for (i = 0; i < some_of(500); i++) {
        double r = uniform(&seed, 0.1, 1), l = uniform(&seed, 0.1, 1), e = uniform(&seed, -1, 1);
        fourlink_mechanism m = slider_crank(r, l, e);
        own o = {r, l, 0, e, 1, 0, 0, 0, 0, 0};
        double max = 0;
        fourlink_limits limits;
        fourlink_reach reach;

        fourlink_reach_of(&m, &reach);
        if (!reach.n_ranges || l > r + fabs(e))
            continue;
        for (k = 0; k < reach.n_ranges; k++)
            max = fmax(
                max,
                own_extreme(own_rod_mu, &o, 1, reach.from[k] + 1e-13, reach.to[k] - 1e-13).value *
                    DEG);
        seen[reach.n_ranges]++;
        for (k = 0; k < 2; k++) {
            limits = limits_of(&m, branches[k]);
            assert_true(limits.mu_min == 0);
            assert_near(limits.mu_max, max, 1e-9);
            assert_no_swing(&limits);
            assert_no_stroke(&limits);
        }
    }
    assert_true(seen[1] > some_of(50) && seen[2] > some_of(50));
}

/* Strokes that are alike, or none, have no ratio. */
TEST(test_no_time_ratio)
{
    fourlink_mechanism m = slider_crank(1.4, 4, 0);

    assert_true(limits_of(&m, FOURLINK_OPEN).time_ratio == 0);
    m = slider_crank(4, 1.4, 1);
    assert_true(limits_of(&m, FOURLINK_OPEN).time_ratio == 0);
}

/* A mechanism with a change point passes it, and has neither limits nor dead centres. */
TEST(test_limits_with_change_point)
{
    fourlink_mechanism m = four_bar(0.3, 0.8, 0.6, 0.5);
    fourlink_limits limits;
    int k;

    for (k = 0; k < 2; k++) {
        m = four_bar(0.3, 0.5, 0.6, 0.8);
        assert_int_equal(type_of(&m), FOURLINK_CHANGE_POINT_LINKAGE);
        limits = limits_of(&m, branches[k]);
        assert_no_swing(&limits);
        assert_no_stroke(&limits);
        assert_near(limits.mu_min, 0, 1e-7);
        m = slider_crank(0.3, 0.3, 0);
        limits = limits_of(&m, branches[k]);
        assert_no_swing(&limits);
        assert_no_stroke(&limits);
        assert_near(limits.mu_min, 0, 0);
        assert_near(limits.mu_max, PI / 2, 1e-15);
    }
}

/* ---------------------------------------------------------------------------------------------
** Statuses
** ------------------------------------------------------------------------------------------- */

TEST(test_statuses)
{
    fourlink_mechanism m = four_bar(0.02, 0.066, 0.056, 0.08);
    fourlink_limits limits, filled;
    fourlink_reach reach;
    fourlink_type type;

    memset(&filled, 0x5a, sizeof filled);
    limits = filled;
    assert_int_equal(fourlink_type_of(NULL, &type), FOURLINK_NULL);
    assert_int_equal(fourlink_type_of(&m, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_reach_of(NULL, &reach), FOURLINK_NULL);
    assert_int_equal(fourlink_reach_of(&m, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_limits_of(&m, FOURLINK_OPEN, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_limits_of(NULL, FOURLINK_OPEN, &limits), FOURLINK_NULL);
    assert_memory_equal(&limits, &filled, sizeof limits);
    assert_int_equal(fourlink_limits_of(&m, (fourlink_branch)0, &limits), FOURLINK_BAD_BRANCH);
    assert_int_equal(fourlink_limits_of(&m, (fourlink_branch)2, &limits), FOURLINK_BAD_BRANCH);
    assert_memory_equal(&limits, &filled, sizeof limits);

    type = FOURLINK_RHOMBUS;
    assert_int_equal(fourlink_type_of(NULL, &type), FOURLINK_NULL);
    assert_int_equal(type, FOURLINK_RHOMBUS);
    memset(&reach, 0x5a, sizeof reach);
    assert_int_equal(fourlink_reach_of(NULL, &reach), FOURLINK_NULL);
    assert_memory_equal(&reach, &filled, sizeof reach);
}

/* ---------------------------------------------------------------------------------------------
** The crank at any angle of a motion
** ------------------------------------------------------------------------------------------- */

static void assert_same_row(const fourlink_row *x, const fourlink_row *y)
{
    assert_true(x->angle == y->angle && x->time == y->time);
    assert_true(x->crank.theta2 == y->crank.theta2 && x->crank.omega2 == y->crank.omega2 &&
                x->crank.alpha2 == y->crank.alpha2);
}

TEST(test_motion_at_rows)
{
    int stops = 0, run_ups = 0, i;
    uint64_t seed = 10;

    for (i = 0; i < some_of(600); i++) {
        fourlink_motion motion;
        fourlink_range range;
        unsigned long k;

        memset(&motion, 0, sizeof motion);
        motion.angle_unit = i % 3 ? DEG : 1;
        motion.from = uniform(&seed, -300, 300) * DEG / motion.angle_unit;
        motion.interval = uniform(&seed, 1, 50) * DEG / motion.angle_unit;
        motion.to = motion.from + uniform(&seed, 1, 800) * DEG / motion.angle_unit;
        motion.speed = i % 5 ? uniform(&seed, 0, 20) : 0;
        motion.acceleration = uniform(&seed, -20, 20);
        if (i % 7 == 0) {
            motion.run_up = uniform(&seed, 1, 300) * DEG / motion.angle_unit;
            motion.speed = 0;
            run_ups++;
        } else if (i % 7 < 3) {
            motion.hold = i % 7 == 1;
            motion.acceleration = i % 7 == 2 ? 0 : motion.acceleration;
        }
        if (motion.speed == 0 && !motion.hold && motion.acceleration < 0 && motion.run_up <= 0)
            motion.acceleration = -motion.acceleration;
        assert_int_equal(fourlink_motion_range(&motion, &range), FOURLINK_OK);
        stops += range.stops;
        for (k = 0; k < range.n_rows; k++) {
            fourlink_row row, at;

            assert_int_equal(fourlink_motion_row(&motion, &range, k, &row), FOURLINK_OK);
            memset(&at, 0, sizeof at);
            assert_int_equal(fourlink_motion_at(&motion, row.angle, &at), FOURLINK_OK);
            assert_same_row(&row, &at);
        }
    }
    assert_true(stops > some_of(20) && run_ups > some_of(50));
}

/* Between the rows: the work of the acceleration, and the speed as the change of angle in time. */
TEST(test_motion_at_between_rows)
{
    uint64_t seed = 11;
    int i, k;

    for (i = 0; i < 300; i++) {
        fourlink_motion motion;
        fourlink_row row, before, after;
        double end = 0;

        memset(&motion, 0, sizeof motion);
        motion.angle_unit = DEG;
        motion.from = uniform(&seed, -90, 90);
        motion.to = motion.from + 360;
        motion.interval = 360;
        motion.acceleration = uniform(&seed, 1, 20);
        if (i % 2) {
            motion.run_up = uniform(&seed, 20, 200);
            end = motion.run_up;
        } else {
            motion.speed = uniform(&seed, 1, 20);
        }
        for (k = 0; k < 20; k++) {
            double s = uniform(&seed, 2, 358), h = 1e-3, square;
            int running_up = end == 0 || s < end;

            if (end > 0 && fabs(s - end) < 1)
                continue;
            assert_int_equal(fourlink_motion_at(&motion, motion.from + s, &row), FOURLINK_OK);
            assert_int_equal(fourlink_motion_at(&motion, motion.from + s - h, &before),
                             FOURLINK_OK);
            assert_int_equal(fourlink_motion_at(&motion, motion.from + s + h, &after), FOURLINK_OK);
            assert_true(row.angle == motion.from + s);
            assert_near(row.crank.theta2, (motion.from + s) * DEG, 1e-15);
            square = motion.speed * motion.speed +
                     2 * motion.acceleration * (running_up ? s : end) * DEG;
            assert_close(row.crank.omega2, sqrt(square), 1e-14);
            assert_true(row.crank.alpha2 == (running_up ? motion.acceleration : 0));
            assert_close(row.crank.omega2, 2 * h * DEG / (after.time - before.time), 1e-7);
            /* the time of the acceleration, and that of the turning after it */
            assert_close(row.time,
                         (sqrt(square) - motion.speed) / motion.acceleration +
                             (running_up ? 0 : (s - end) * DEG / sqrt(square)),
                         1e-12);
        }
    }
}

TEST(test_motion_at_statuses)
{
    fourlink_motion motion;
    fourlink_row row, filled;

    memset(&motion, 0, sizeof motion);
    motion.angle_unit = 1;
    memset(&filled, 0x5a, sizeof filled);
    row = filled;
    assert_int_equal(fourlink_motion_at(NULL, 1, &row), FOURLINK_NULL);
    assert_memory_equal(&row, &filled, sizeof row);
    assert_int_equal(fourlink_motion_at(&motion, 1, NULL), FOURLINK_NULL);
}

int main(void)
{
    return run_all_tests(NULL);
}
