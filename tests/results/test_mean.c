/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_mean.c - means and root mean squares of columns: by formulas in long double and the trapezoidal rule,
** by what an integral must be, and where there is none.
*/
#include <float.h>

#include "machines.h"

static int status_of(const char *contents, const char *name, fourlink_branch branch,
                     fourlink_value *v)
{
    fourlink_results *r = opened(contents);
    int status = fourlink_results_value(r, name, branch, 0, v);

    if (status == FOURLINK_OK)
        assert_string_equal(v->name, name); /* as long as the results */
    fourlink_results_free(r);
    return status;
}

static double value(const char *contents, const char *name, fourlink_branch branch)
{
    static char copy[100];
    fourlink_value v = {0};
    int status;

    snprintf(copy, sizeof copy, "%s", name);
    status = status_of(contents, copy, branch, &v);
    if (status != FOURLINK_OK)
        fail_msg("%s: %s\n%s", name, fourlink_status_text(status), contents);
    assert_int_equal(v.has_angle, 0);
    assert_int_equal(v.branch, (int)branch);
    return v.value;
}

static void check_value(const char *contents, const char *name, fourlink_branch branch,
                        double expected, double tolerance)
{
    double found = value(contents, name, branch);

    if (!(fabs(found - expected) <= tolerance))
        fail_msg("%s, %s = %.17g, expected %.17g\n%s", name, fourlink_branch_text((int)branch),
                 found, expected, contents);
}

/* ---- formulas; over a revolution the trapezoidal rule is exact to rounding, but for mu, which has
** corners */

typedef struct formula {
    const char *column;
    own_column *f;
} formula;

static void check_formulas(const char *contents, const formula *list, size_t n, own o)
{
    enum { STEPS = 3600 };
    size_t i;
    int k, j;

    for (i = 0; i < n; i++)
        for (k = 0; k < 2; k++) {
            long double sum = 0, squares = 0, before = 0;
            double size, close = strcmp(list[i].column, "mu") == 0 ? 1e-6 : 1e-10;

            o.branch = (int)branches[k];
            for (j = 0; j < STEPS; j++) {
                long double y = list[i].f(&o, 2 * PIL * j / STEPS);

                if (strncmp(list[i].column, "theta", 5) == 0) /* from -180 ... 180 deg on */
                    y -= 360 * floorl((y - before) / 360 + 0.5L);
                before = y;
                sum += y;
                squares += y * y;
            }
            size = (double)sqrtl(squares / STEPS);
            check_value(contents, print("mean(%s)", list[i].column), branches[k],
                        (double)(sum / STEPS), close * size);
            check_value(contents, print("rms(%s)", list[i].column), branches[k], size,
                        close * size);
        }
}

TEST(test_rockers)
{
    static const formula list[] = {{"theta4", own_theta4}, {"omega3", own_omega3},
                                   {"omega4", own_omega4}, {"alpha3", own_alpha3},
                                   {"alpha4", own_alpha4}, {"mu", own_mu}};
    uint64_t seed = 31;
    int i;

    for (i = 0; i < some_of(12); i++) {
        own o = random_rocker(&seed);

        check_formulas(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d,
                                revolution((double)o.speed)),
                       list, COUNT(list), o);
    }
}

TEST(test_engines)
{
    static const formula list[] = {{"x", own_x},   {"v", own_v},     {"a", own_a},
                                   {"Ts", own_Ts}, {"phi", own_phi}, {"omega3", own_rod_omega3}};
    uint64_t seed = 32;
    int i;

    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);

        o.mass = uniform(&seed, 1, 50);
        check_formulas(slider_crank((double)o.a, (double)o.b, (double)o.d,
                                    print("%s[gravity]\nacceleration = 0\n[piston]\n"
                                          "mass = %.17g kg\n",
                                          revolution((double)o.speed), (double)o.mass)),
                       list, COUNT(list), o);
    }
}

/* ---- what an integral must be */

static const char crusher[] = "mechanism = four-bar\n"
                              "[crank]\nlength = 50 cm\nmass = 0.8 kg\ncg = 25 cm\n"
                              "[coupler]\nlength = 100 cm\nmass = 1 kg\ncg = 50 cm\n"
                              "[rocker]\nlength = 120 cm\nmass = 1.5 kg\ncg = (78, -8) cm\n"
                              "[ground]\nlength = 150 cm\n"
                              "[point P]\nlink = coupler\nat = (30, 40) cm\n"
                              "[load F]\nlink = rocker\nat = (115, -24) cm\nforce = (-5000, 0) N\n"
                              "from = 47 deg\nto = 225 deg\n";

TEST(test_cycles)
{
    const char *one = print("%s[motion]\nspeed = -500 rpm\ninterval = 7 deg\n", crusher);
    const char *many =
        print("%s[motion]\nspeed = -500 rpm\ninterval = 7 deg\nto = -7200 deg\n", crusher);
    static const char *const zero[] = {"mean(P.vx)", "mean(P.vy)", "mean(P.ax)", "mean(omega4)",
                                       "mean(alpha3)"};
    static const char *const same[] = {"mean(Ts)", "rms(Ts)",     "mean(F12)",
                                       "rms(F14)", "rms(P.v)",    "mean(theta4)",
                                       "rms(mu)",  "rms(omega2)", "mean(P.ay)"};
    static fact_list facts;
    size_t i;
    int k;

    for (k = 0; k < 2; k++) {
        facts_of(one, &facts);
        check_value(one, "mean(Ts)", branches[k], -value_of(&facts, "mean_torque", branches[k]),
                    1e-7);
        check_value(one, "mean(omega2)", branches[k], -500 * PI / 30, 1e-12);
        check_value(one, "rms(omega2)", branches[k], 500 * PI / 30, 1e-12);
        check_value(one, "mean(theta2)", branches[k], -180, 1e-10);
        check_value(one, "rms(theta2)", branches[k], 360 / sqrt(3), 1e-10);
        check_value(many, "mean(theta2)", branches[k], -3600, 1e-9);
        check_value(many, "rms(theta2)", branches[k], 7200 / sqrt(3), 1e-9);
        check_value(many, "mean(time)", branches[k], 1.2, 1e-12);
        for (i = 0; i < COUNT(zero); i++)
            check_value(one, zero[i], branches[k], 0, 1e-9);
        for (i = 0; i < COUNT(same); i++) {
            double once = value(one, same[i], branches[k]);

            check_value(many, same[i], branches[k], once, 1e-9 * fabs(once) + 1e-9);
        }
    }
}

/* The angle of link 4 at the dead position, where crank, coupler and rocker are a triangle with the
** ground. */
static double dead_theta4(double *theta2)
{
    const double a = 0.3, b = 0.4, c = 0.5, d = 0.75;

    *theta2 = acos((a * a + d * d - (b + c) * (b + c)) / (2 * a * d));
    return atan2(a * sin(*theta2), a * cos(*theta2) - d);
}

/* The integral of a velocity is a distance: over a gap with dead positions on both sides, too. */
TEST(test_distances)
{
    const char *gap = four_bar(0.3, 0.4, 0.5, 0.75, "[motion]\nspeed = 2 rad/s\n");
    const char *part = four_bar(0.3, 0.4, 0.5, 0.75, "[motion]\nspeed = 2 rad/s\nto = 30 deg\n");
    double theta2, swing = 2 * (dead_theta4(&theta2) - PI);
    int k;

    for (k = 0; k < 2; k++) {
        fourlink_results *r = opened(part);
        fourlink_value from, to;

        assert_int_equal(fourlink_results_value(r, "theta4", branches[k], 0, &from), FOURLINK_OK);
        assert_int_equal(fourlink_results_value(r, "theta4", branches[k], 30, &to), FOURLINK_OK);
        fourlink_results_free(r);
        check_value(part, "mean(omega4)", branches[k], 2 * (to.value - from.value) / 30, 1e-10);
        check_value(gap, "mean(omega4)", branches[k], 2 * swing / (2 * theta2), 1e-8);
        check_value(gap, "mean(theta2)", branches[k], 180, 1e-9);
    }
}

/* An angle goes on over a gap: the mean is that of the range in one piece, but for whole turns, and so
** is the mean square of what it deviates by from its mean. */
TEST(test_angles_over_a_gap)
{
    static const char *const names[] = {"theta3", "theta4", "mu"};
    const char *gap = four_bar(0.3, 0.4, 0.5, 0.75, "[motion]\nspeed = 2 rad/s\n");
    const char *range =
        four_bar(0.3, 0.4, 0.5, 0.75, "[motion]\nspeed = 2 rad/s\nfrom = -180 deg\nto = 180 deg\n");
    size_t i;

    for (i = 0; i < COUNT(names); i++) {
        double whole = value(range, print("mean(%s)", names[i]), FOURLINK_OPEN);
        double found = value(gap, print("mean(%s)", names[i]), FOURLINK_OPEN);
        double rms_whole = value(range, print("rms(%s)", names[i]), FOURLINK_OPEN);
        double rms_found = value(gap, print("rms(%s)", names[i]), FOURLINK_OPEN);

        assert_near(turned(found - whole, 360), 0, 1e-7);
        assert_near(rms_found * rms_found - found * found, rms_whole * rms_whole - whole * whole,
                    1e-5);
    }
}

/* The angles of a drag link turn with the crank. */
TEST(test_turning_angles)
{
    own o = {0.05L, 0.06L, 0.055L, 0.03L, 1, 0, 3, 0, 0, 0};
    const char *contents =
        four_bar(0.05, 0.06, 0.055, 0.03, "[motion]\nspeed = 3 rad/s\nto = 2700 deg\n");
    enum { STEPS = 27000 };
    long double sum = 0, squares = 0, before = 0;
    fourlink_results *r = opened(contents);
    fourlink_value first;
    int j;

    assert_int_equal(fourlink_results_value(r, "theta4", FOURLINK_OPEN, 0, &first), FOURLINK_OK);
    fourlink_results_free(r);
    before = first.value;
    for (j = 0; j <= STEPS; j++) {
        long double y = own_theta4(&o, 15 * PIL * j / STEPS);
        long double weight = j == 0 || j == STEPS ? 0.5L : 1;

        y -= 360 * floorl((y - before) / 360 + 0.5L);
        before = y;
        sum += weight * y;
        squares += weight * y * y;
    }
    check_value(contents, "mean(theta4)", FOURLINK_OPEN, (double)(sum / STEPS), 1e-3);
    check_value(contents, "rms(theta4)", FOURLINK_OPEN, sqrt((double)(squares / STEPS)), 1e-3);
}

/* ---- sizes with a corner, where a vector passes through zero, or nearly one */

/* The distance along its line that a piston travels: its speed changes its sign within steps. */
static long double travel(const own *o, long double from, long double to)
{
    enum { STEPS = 360 };
    long double sum = 0, x = own_x(o, from);
    int i, k;

    for (i = 0; i < STEPS; i++) {
        long double low = from + (to - from) * i / STEPS,
                    high = from + (to - from) * (i + 1) / STEPS;
        long double next = own_x(o, high), first = own_v(o, low), end = high, turn;

        for (k = 0; k < 70 && first * own_v(o, end) < 0; k++) {
            long double middle = (low + high) / 2;

            *(first * own_v(o, middle) < 0 ? &high : &low) = middle;
        }
        turn = k ? own_x(o, low) : x;
        sum += fabsl(turn - x) + fabsl(next - turn);
        x = next;
    }
    return sum;
}

TEST(test_strokes)
{
    uint64_t seed = 33;
    int i;

    for (i = 0; i < some_of(5000); i++) {
        own o = random_engine(&seed, i % 2);
        double from = uniform(&seed, -360, 360), to = from + uniform(&seed, 20, 360), mean;

        o.branch = (int)branches[i / 2 % 2];
        mean = (double)(travel(&o, from * PIL / 180, to * PIL / 180) * fabsl(o.speed) /
                        ((to - from) * PIL / 180));

        check_value(slider_crank((double)o.a, (double)o.b, (double)o.d,
                                 print("[motion]\nspeed = %.17g rad/s\nfrom = %.17g deg\n"
                                       "to = %.17g deg\ninterval = 50 deg\n",
                                       fabs((double)o.speed), from, to)),
                    "mean(C.v)", branches[i / 2 % 2], mean, 1e-9 * mean);
    }
}

/* An adaptive sum of rows by Simpson's rule. */
typedef struct rows {
    fourlink_results *r;
    double smallest; /* part of the motion in which no halving is needed */
} rows;

static double row(const rows *x, double angle)
{
    double value;

    assert_int_equal(fourlink_results_at(x->r, FOURLINK_OPEN, angle, &value, NULL, NULL),
                     FOURLINK_OK);
    return value;
}

static void add_sums(const rows *x, double from, double to, const double y[3], double sum[2])
{
    double width = to - from, left = row(x, from + width / 4), right = row(x, to - width / 4);
    double one = width / 6 * (y[0] + 4 * y[1] + y[2]);
    double two = width / 12 * (y[0] + 4 * left + 2 * y[1] + 4 * right + y[2]);
    double halves[2][3] = {{y[0], left, y[1]}, {y[1], right, y[2]}};

    if (width > x->smallest && fabs(two - one) > 1e-12 * fabs(two)) {
        add_sums(x, from, from + width / 2, halves[0], sum);
        add_sums(x, from + width / 2, to, halves[1], sum);
        return;
    }
    sum[0] += two + (two - one) / 15;
    sum[1] += width / 12 *
              (y[0] * y[0] + 4 * left * left + 2 * y[1] * y[1] + 4 * right * right + y[2] * y[2]);
}

/* The mean and the root mean square of the only column. */
static void check_sums(const char *deck, const char *column, double from, double to)
{
    enum { PARTS = 50 };
    double sum[2] = {0, 0}, size;
    rows x;
    int i;

    x.r = opened(print("%s[table]\ncolumns = %s\n", deck, column));
    x.smallest = 1e-6 * (to - from);
    for (i = 0; i < PARTS; i++) {
        double low = from + (to - from) * i / PARTS, high = from + (to - from) * (i + 1) / PARTS;
        double y[3] = {row(&x, low), row(&x, (low + high) / 2), row(&x, high)};

        add_sums(&x, low, high, y, sum);
    }
    fourlink_results_free(x.r);
    size = sqrt(sum[1] / (to - from));
    check_value(deck, print("mean(%s)", column), FOURLINK_OPEN, sum[0] / (to - from), 1e-9 * size);
    check_value(deck, print("rms(%s)", column), FOURLINK_OPEN, size, 1e-9 * size);
}

/* A point of the coupler that is beside the centre of its turning at a crank angle stands nearly still there. */
TEST(test_points_that_nearly_stop)
{
    uint64_t seed = 34;
    int i;

    for (i = 0; i < some_of(1500); i++) {
        own o = random_rocker(&seed);
        double at = uniform(&seed, 0, 360), from = at - uniform(&seed, 10, 200);
        double to = at + uniform(&seed, 10, 150), away = pow(10, uniform(&seed, -12, -1)), x, y,
               angle;
        const char *deck =
            four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d,
                     print("[motion]\nspeed = 3 rad/s\nfrom = %.17g deg\nto = %.17g deg\n"
                           "interval = 50 deg\n[units]\nlength = m\n",
                           from, to));
        fourlink_results *r = opened(deck);

        x = value_at(r, "I13x", at) - value_at(r, "B.x", at);
        y = value_at(r, "I13y", at) - value_at(r, "B.y", at);
        angle = value_at(r, "theta3", at) * PI / 180;
        fourlink_results_free(r);
        if (i % 5 == 0)
            away = 0;
        if (hypot(x, y) < 10)
            check_sums(print("%s[point P]\nlink = coupler\nat = (%.17g, %.17g) m\n", deck,
                             x * cos(angle) + y * sin(angle) + away,
                             y * cos(angle) - x * sin(angle)),
                       "P.v", from, to);
    }
}

/* A free crank that carries a rod of great inertia is quickest by far where that stands still: there the acceleration of a
** point has two peaks, narrower than a degree, and between them it is rounding error, which is not to use up the halvings.
** Against the sums of 36,000 rows. */
TEST(test_narrow_peaks)
{
    enum { ROWS = 36000 };
    static const char deck[] =
        "mechanism = inverted-slider-crank\naxes = ground\n[ground]\nlength = 80.6062 mm\n"
        "angle = 3.1415926535897931 rad\n[crank]\nmass = 0.23101 slug\nlength = 49.9728 mm\n"
        "gyration = 31.6642 mm\ncg = 16.4185 mm at 19.0945 deg\n[slider]\nmass = 0.805256 kg\n"
        "inertia = 0.00150359 kg m2\ncg = 16.8945 mm at -4.91001 deg\n[lever]\n"
        "cg = 4.68633267060238 cm at -180 deg\nmass = 1.5129 kg\noffset = 2.61003 mm\n"
        "inertia = 0.0187949 kg m2\n[load K]\nlink = slider\ntorque = -13.4298 N m\n[load L]\n"
        "link = lever\ntorque = 19.2918 N m\nfrom = 197 deg\nto = 234 deg\n[spring S]\n"
        "link = lever\nto = ground\ndamping = 0.0157094 N m s/rad\n[point P0]\nlink = lever\n"
        "at = (47.7076, -21.3986) mm\n[point P1]\nlink = lever\nat = (-28.2535, 0) mm\n"
        "[motion]\nmode = free\nfrom = 225 deg\nspeed = -37.2961 rad/s\nturns = -2\n"
        "interval = 0.02 deg\n[table]\ncolumns = P1.a\n[units]\npressure = Pa\n[output N36]\n"
        "rod_inertia = 2.0702e+05 kg m2\nrod_cg = 50 %\nlink = crank\nat = (9, 4) mm\n"
        "rod = 200 mm\nline = (20, 10) mm\nangle = 15 deg\n[friction]\nmu = 0 %\n"
        "radius = 13064 mm\nA = 0\n[gravity]\nacceleration = 9.80665 m/s2\ndirection = -90 deg\n";
    fourlink_results *r = opened(deck);
    unsigned long i;
    int k;

    for (k = 0; k < 2; k++) {
        double sum = 0, squares = 0, v;

        for (i = 0; i < ROWS; i++) {
            assert_int_equal(fourlink_results_row(r, branches[k], i, &v, NULL, NULL), FOURLINK_OK);
            sum += v / ROWS;
            squares += v * v / ROWS;
        }
        assert_close(named(r, "mean(P1.a)", branches[k], 0).value, sum, 1e-3);
        assert_close(named(r, "rms(P1.a)", branches[k], 0).value, sqrt(squares), 1e-3);
    }
    fourlink_results_free(r);
}

/* A force on the crank that is nearly that of the pin at a crank angle takes it away there. */
TEST(test_forces_that_nearly_vanish)
{
    uint64_t seed = 35;
    int i;

    for (i = 0; i < some_of(1500); i++) {
        double at = uniform(&seed, 0, 360), from = at - uniform(&seed, 10, 200);
        double to = at + uniform(&seed, 10, 150), away = pow(10, uniform(&seed, -12, -1));
        const char *deck = print(ROCKER "[motion]\nspeed = %.17g rad/s\nfrom = %.17g deg\n"
                                        "to = %.17g deg\ninterval = 50 deg\n",
                                 uniform(&seed, 5, 50), from, to);
        fourlink_results *r = opened(deck);
        double x = value_at(r, "F12x", at), y = value_at(r, "F12y", at);

        fourlink_results_free(r);
        if (i % 5 == 0)
            away = 0;
        check_sums(print("%s[load]\nlink = crank\nframe = ground\nforce = (%.17g, %.17g) N\n"
                         "at = (3, 4) mm\n",
                         deck, x * (1 + away), y * (1 + away)),
                   "F12", from, to);
    }
}

/* ---- where there is none */

TEST(test_poles)
{
    const char *gap = four_bar(0.3, 0.4, 0.5, 0.75, "[motion]\nspeed = 2 rad/s\n");
    const char *up = four_bar(0.3, 0.4, 0.5, 0.75, "[motion]\nspeed = 2 rad/s\nto = 150 deg\n");
    fourlink_value v = {0}, before = v;
    int k;

    for (k = 0; k < 2; k++) {
        double sign = k ? -1 : 1;

        assert_true(isfinite(value(up, "mean(omega4)", branches[k])));
        assert_true(value(up, "rms(omega4)", branches[k]) > DBL_MAX);
        assert_true(value(up, "rms(alpha4)", branches[k]) > DBL_MAX);
        assert_true(sign * value(up, "mean(alpha4)", branches[k]) > DBL_MAX);
        assert_true(value(gap, "rms(omega3)", branches[k]) > DBL_MAX);
        assert_true(value(crusher, "rms(mechanical_advantage)", branches[k]) > DBL_MAX);
        assert_int_equal(status_of(crusher, "mean(mechanical_advantage)", branches[k], &v),
                         FOURLINK_NO_MEAN);
        assert_int_equal(status_of(crusher, "mean(I13x)", branches[k], &v), FOURLINK_NO_MEAN);
        assert_memory_equal(&v, &before, sizeof v);
    }
}

TEST(test_nothing_to_integrate)
{
    const char *never =
        four_bar(0.3, 0.4, 0.5, 0.75, "[motion]\nspeed = 1 rad/s\nfrom = 120 deg\nto = 200 deg\n");
    static const char *const wrong[] = {"mean(Tx)", "mean()",  "rms( )",        "mean(Ts",
                                        "Mean(mu)", "mean mu", "mean(max(mu))", "average(mu)"};
    fourlink_value v = {0}, before = v;
    size_t i;

    assert_int_equal(status_of(never, "mean(theta4)", FOURLINK_OPEN, &v), FOURLINK_NOT_REACHED);
    assert_int_equal(status_of(never, "rms(omega2)", FOURLINK_OPEN, &v), FOURLINK_NOT_REACHED);
    for (i = 0; i < COUNT(wrong); i++)
        assert_int_equal(status_of(crusher, wrong[i], FOURLINK_OPEN, &v), FOURLINK_NO_SUCH_NAME);
    assert_memory_equal(&v, &before, sizeof v);
}

/* The force m (a_G - g) of a crank with r omega^2 = g vanishes once in a turn.  Until then its direction
** turns by half a turn; then it starts anew.  Each segment has a slope of 1/2 over its angles. */
TEST(test_direction_that_starts_anew)
{
    static const int turns[] = {1, 2, 3, 4, 20};
    size_t i;

    for (i = 0; i < COUNT(turns); i++) {
        int n = turns[i], to = 450 + 360 * n;
        double segment[3][3] = {{-130, -80, 1}, {100, 280, n - 1}, {100, 230, 1}};
        double mean = 0, square = 0;
        char *deck = print("mechanism = slider-crank\n[gravity]\nacceleration = 10 m/s2\n[crank]\n"
                           "length = 100 mm\nmass = 1 kg\ncg = 100 mm\n[rod]\nlength = 300 mm\n"
                           "[ground]\nangle = -100 deg\n[motion]\nspeed = 10 rad/s\n"
                           "from = 450 deg\nto = %d deg\n",
                           to);
        int k;

        for (k = 0; k < 3; k++) {
            double a = segment[k][0], b = segment[k][1], times = segment[k][2];

            mean += times * (b * b - a * a) / (360 * n);
            square += times * 2 * (b * b * b - a * a * a) / (3 * 360 * n);
        }
        check_value(deck, "mean(F12_dir)", FOURLINK_OPEN, mean, 1e-6);
        check_value(deck, "rms(F12_dir)", FOURLINK_OPEN, sqrt(square), 1e-6);
    }
}

/* ---- by name elsewhere */

TEST(test_expectations_and_outputs)
{
    static const int verdicts[] = {FOURLINK_AGREES, FOURLINK_DIFFERS, FOURLINK_NO_VALUE,
                                   FOURLINK_NO_VALUE};
    fourlink_results *r =
        opened(print("%s[motion]\nspeed = -500 rpm\n[expect]\nrms(omega2) = 500.0 rpm\n"
                     "mean(omega2) = 500.0 rpm\nmean(mechanical_advantage) = 1\nrms(Tt) = 1 N m\n",
                     crusher));
    const fourlink_value *outputs;
    fourlink_check check;
    unsigned long n, i;

    for (i = 0; i < COUNT(verdicts); i++) {
        assert_int_equal(fourlink_results_check(r, i, &check), FOURLINK_OK);
        assert_int_equal(check.verdict, verdicts[i]);
        assert_int_equal(check.has_angle, 0);
    }
    fourlink_results_free(r);
    r = opened(print("%s[motion]\nspeed = -500 rpm\n[sweep]\ncrank.length = 40 cm, 50 cm\n"
                     "output = mean(Ts), rms(F12)\n",
                     crusher));
    assert_int_equal(fourlink_results_list(r, FOURLINK_OUTPUTS, &outputs, &n), FOURLINK_OK);
    assert_int_equal(n, 2);
    assert_string_equal(outputs[0].name, "mean(Ts)");
    assert_string_equal(outputs[0].unit, "N.m");
    assert_string_equal(outputs[1].name, "rms(F12)");
    assert_string_equal(outputs[1].unit, "N");
    fourlink_results_free(r);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
