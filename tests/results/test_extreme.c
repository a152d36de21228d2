/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_extreme.c - extremes of columns, compared with those of formulas in long double.
*/
#include "machines.h"

typedef struct own_entry {
    const char *name;
    own_column *f;
} own_entry;

static const own_entry of_four_bar[] = {
    {"theta3", own_theta3}, {"omega3", own_omega3}, {"alpha3", own_alpha3}, {"theta4", own_theta4},
    {"omega4", own_omega4}, {"alpha4", own_alpha4}, {"mu", own_mu},         {NULL, NULL}};

static const own_entry of_slider_crank[] = {{"x", own_x},       {"v", own_v},
                                            {"a", own_a},       {"theta3", own_rod_theta3},
                                            {"phi", own_phi},   {"omega3", own_rod_omega3},
                                            {"mu", own_rod_mu}, {"alpha3", own_rod_alpha3},
                                            {NULL, NULL}};

static const own_entry of_piston_forces[] = {{"Ts", own_Ts}, {NULL, NULL}};

typedef struct part {
    own o;
    long double from, to;
} part;

enum { VALUES = 1, ANGLES = 2 };

/* The extreme of a column, in the deck's unit. */
static fourlink_value extreme_of(fourlink_results *r, const char *column, fourlink_branch branch,
                                 int sign)
{
    static char name[100];
    fourlink_value e = {0};

    snprintf(name, sizeof name, "%s(%s)", sign > 0 ? "max" : "min", column);
    assert_int_equal(fourlink_results_value(r, name, branch, 0, &e), FOURLINK_OK);
    assert_string_equal(e.name, name);
    assert_int_equal(e.branch, (int)branch);
    assert_int_equal(e.has_angle, isfinite(e.value) != 0);
    return e;
}

/* Compare max(COLUMN) and min(COLUMN) of a deck with those of the parts of its motion, given for the
** open branch. */
static void check_extremes(const char *contents, const own_entry *columns, const part *parts,
                           int n_parts, int periodic, int what)
{
    fourlink_results *r = opened(contents);
    double from = problem_of(r).motion.from;
    int k, sign, i;

    for (; columns->name; columns++)
        for (k = 0; k < 2; k++)
            for (sign = -1; sign <= 1; sign += 2) {
                fourlink_value e = extreme_of(r, columns->name, branches[k], sign);
                double nearest = 1e9, turn = 0;
                peaks p = {0};

                for (i = 0; i < n_parts; i++) {
                    own o = parts[i].o;

                    o.branch = (int)branches[k];
                    scan(columns->f, &o, sign, parts[i].from, parts[i].to, &p);
                }
                if (strcmp(e.quantity, "angle") == 0)
                    turn = 360 * floor((e.value - (double)p.value) / 360 + 0.5);
                for (i = 0; i < p.n; i++) {
                    double d = e.angle - (double)(p.theta2[i] * 180 / PIL);

                    if (periodic)
                        d = turned(d, 360);
                    nearest = fabs(d) < nearest ? fabs(d) : nearest;
                }
                if (((what & VALUES) && !(fabs(e.value - turn - (double)p.value) <=
                                          1e-9 * fabs((double)p.value) + 1e-15)) ||
                    ((what & ANGLES) && !(nearest <= 1e-6)))
                    fail_msg("%s, %s = %.17g at %.17g deg, expected %.17g at %.17g\n%s", e.name,
                             fourlink_branch_text((int)branches[k]), e.value, e.angle,
                             (double)p.value, (double)(p.theta2[0] * 180 / PIL), contents);
                if (periodic)
                    assert_true(e.angle >= from - 360 && e.angle <= 720);
            }
    fourlink_results_free(r);
}

/* One revolution at constant speed. */
static void check_revolution(const char *contents, const own_entry *columns, own o, int what)
{
    part whole = {o, 0, 2 * PIL};

    check_extremes(contents, columns, &whole, 1, 1, what);
}

TEST(test_extremes_of_rockers)
{
    own o = {0.020L, 0.066L, 0.056L, 0.080L, 1, 0, 10.5L, 0, 0, 0};
    uint64_t seed = 1;
    int i;

    check_revolution(four_bar(0.020, 0.066, 0.056, 0.080, revolution(10.5)), of_four_bar, o,
                     VALUES | ANGLES);
    for (i = 0; i < 12; i++) {
        o = random_rocker(&seed);
        check_revolution(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d,
                                  revolution((double)o.speed)),
                         of_four_bar, o, VALUES | ANGLES);
    }
}

TEST(test_extremes_of_pistons)
{
    uint64_t seed = 2;
    int i;

    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);

        check_revolution(
            slider_crank((double)o.a, (double)o.b, (double)o.d, revolution((double)o.speed)),
            of_slider_crank, o, VALUES | ANGLES);
    }
}

TEST(test_extremes_of_torques)
{
    uint64_t seed = 3;
    int i;

    for (i = 0; i < 12; i++) {
        own o = random_engine(&seed, i % 2);
        double bore = uniform(&seed, 0.02, 0.2), p = uniform(&seed, 1e4, 1e6);

        o.mass = uniform(&seed, 1, 50);
        o.gas = PIL / 4 * bore * bore * p;
        check_revolution(slider_crank((double)o.a, (double)o.b, (double)o.d,
                                      print("%s[piston]\nmass = %.17g kg\n[gas]\nbore = %.17g m\n"
                                            "pressure = %.17g Pa\n[gravity]\nacceleration = 0\n",
                                            revolution((double)o.speed), (double)o.mass, bore, p)),
                         of_piston_forces, o, VALUES | ANGLES);
    }
}

/* Both cranks turn fully: what does not go on and on. */
TEST(test_extremes_of_a_drag_link)
{
    static const own_entry columns[] = {{"omega3", own_omega3}, {"alpha3", own_alpha3},
                                        {"omega4", own_omega4}, {"alpha4", own_alpha4},
                                        {"mu", own_mu},         {NULL, NULL}};
    own o = {0.50L, 0.45L, 0.60L, 0.20L, 1, 0, 3, 0, 0, 0};

    check_revolution(four_bar(0.50, 0.45, 0.60, 0.20, revolution(3)), columns, o, VALUES);
}

static void check_at(double angle, double expected, double turn)
{
    assert_near(turned(angle - expected, turn), 0, 1e-6);
}

/* A rocker that swings to and fro between two dead positions of the crank, through 180 deg: its angle goes
** on through the gap of the revolution, wherever this begins.  On the open branch it is greatest where
** BCD is a line, the crank at -dead, and least where ABC is a line;
** on the crossed branch the mirror image of this. */
TEST(test_extremes_of_an_angle_over_a_gap)
{
    static const double a = 0.040, b = 0.030, c = 0.050, d = 0.075;
    static const char *const motions[] = {"speed = 2 rad/s\n", "speed = -2 rad/s\n",
                                          "speed = 2 rad/s\nfrom = -60 deg\n",
                                          "speed = -2 rad/s\nfrom = 430.5 deg\n"};
    double dead = acos((a * a + d * d - (b + c) * (b + c)) / (2 * a * d));
    double greatest = 360 - atan2(a * sin(dead), a * cos(dead) - d) / DEG;
    double least = 180 - acos((c * c + d * d - (a + b) * (a + b)) / (2 * c * d)) / DEG;
    size_t i;
    fourlink_results *r;

    for (i = 0; i < COUNT(motions); i++) {
        fourlink_value open, crossed;

        r = opened(four_bar(a, b, c, d, print("[motion]\n%s", motions[i])));
        open = extreme_of(r, "theta4", FOURLINK_OPEN, 1);
        crossed = extreme_of(r, "theta4", FOURLINK_CROSSED, -1);
        assert_near(turned(open.value - greatest, 360), 0, 1e-6);
        assert_near(turned(crossed.value + greatest, 360), 0, 1e-6);
        check_at(open.angle, -dead / DEG, 360);
        check_at(crossed.angle, dead / DEG, 360);
        assert_near(open.value - extreme_of(r, "theta4", FOURLINK_OPEN, -1).value, greatest - least,
                    1e-6);
        assert_near(extreme_of(r, "theta4", FOURLINK_CROSSED, 1).value - crossed.value,
                    greatest - least, 1e-6);
        fourlink_results_free(r);
    }
}

/* The angle of a spring counts turns, whatever the gaps between its first row and its last. */
TEST(test_extremes_of_counted_turns)
{
    uint64_t seed = 3;
    int i, gaps = 0;

    for (i = 0; i < 300; i++) {
        double a = uniform(&seed, 0.05, 0.1), b = uniform(&seed, 0.05, 0.1);
        double c = uniform(&seed, 0.05, 0.1), d = uniform(&seed, 0.05, 0.1);
        double from = uniform(&seed, -360, 360), values[2], end = i % 2 ? from + 360 : from - 360;
        fourlink_results *r =
            opened(four_bar(a, b, c, d,
                            print("[motion]\nspeed = %d rad/s\nfrom = %.17g deg\n"
                                  "[spring N]\nlink = crank\nto = ground\npreload = %d N m\n"
                                  "damping = 0.01 N m s/rad\n[table]\ncolumns = theta2, N.angle\n",
                                  i % 2 ? 3 : -3, from, i % 3 - 1)));

        if (fourlink_results_row(r, FOURLINK_OPEN, 0, values, NULL, NULL) == FOURLINK_OK) {
            double low = fmin(from, end) + values[1] - from, high = low + 360;

            assert_near(extreme_of(r, "N.angle", FOURLINK_OPEN, -1).value, low, 1e-9);
            assert_near(extreme_of(r, "N.angle", FOURLINK_OPEN, 1).value, high, 1e-9);
            gaps += a + d > b + c || fabs(a - d) < fabs(b - c);
        }
        fourlink_results_free(r);
    }
    assert_true(gaps > 50);
}

/* Peaks of a motion that ends in a gap, one of them between the last sample and the gap: by dense samples. */
TEST(test_extremes_of_angles_beside_gaps)
{
    static const struct {
        double a, b, c, d;
        const char *motion;
        double least; /* of theta4, open, deg */
    } cases[] = {{0.218389, 0.075088, 0.363783, 0.117999,
                  "speed = -37 rad/s\nfrom = -90 deg\nto = -450 deg\n", -225.538742},
                 {0.284458, 0.14085, 0.369833, 0.0607668, "speed = 6 rad/s\n", 25.94287}};
    size_t i;
    fourlink_results *r;

    for (i = 0; i < 2; i++) {
        r = opened(four_bar(cases[i].a, cases[i].b, cases[i].c, cases[i].d,
                            print("[motion]\n%s", cases[i].motion)));
        assert_near(extreme_of(r, "theta4", FOURLINK_OPEN, -1).value, cases[i].least, 1e-5);
        fourlink_results_free(r);
    }
    r = opened(slider_crank(0.256, 0.057, 0, "[motion]\nspeed = 27 rad/s\nto = 160 deg\n"));
    assert_near(extreme_of(r, "theta3", FOURLINK_CROSSED, -1).value, 180, 1e-6);
    fourlink_results_free(r);
}

/* A horizontal engine: with s = sin^2(theta2), n = l / r, the speed of the piston is greatest where
** s^3 - n^2 s^2 - n^4 s + n^4 = 0. */
TEST(test_extremes_of_an_engine_in_closed_form)
{
    static const double ratios[] = {1.5, 3, 4, 10, 1000};
    size_t i, j;
    int k;

    for (i = 0; i < COUNT(ratios); i++) {
        double n = ratios[i], length = 0.15, omega = 12, low = 0, high = 1, s, t, v, mu;
        fourlink_results *r = opened(slider_crank(length, n * length, 0, revolution(omega)));

        for (k = 0; k < 200; k++) {
            s = (low + high) / 2;
            if (((s - n * n) * s - pow(n, 4)) * s + pow(n, 4) > 0)
                low = s;
            else
                high = s;
        }
        s = (low + high) / 2;
        t = asin(sqrt(s)) / DEG;
        v = length * omega * (sin(t * DEG) + sin(2 * t * DEG) / (2 * sqrt(n * n - s)));
        mu = acos(1 / n) / DEG;
        for (k = 0; k < 2; k++) {
            const double dead = k ? 180 : 0; /* the inner dead centre */
            const struct {
                const char *column;
                int sign;
                double value, tolerance, angle, turn; /* turn 0: at any angle */
            } cases[] = {{"v", 1, v, 1e-9 * v, dead + t, 360},
                         {"v", -1, -v, 1e-9 * v, dead - t, 360},
                         {"x", 1, 2 * length, 2e-9 * length, dead + 180, 360},
                         {"x", -1, 0, 1e-15, dead, 360},
                         {"a", 1, length * omega * omega * (1 + 1 / n),
                          1e-9 * length * omega * omega * (1 + 1 / n), dead, 360},
                         {"mu", -1, mu, 1e-9 * mu, 0, 0},
                         {"phi", 1, 90 - mu, 1e-9 * (90 - mu), 90, 360},
                         {"phi", -1, mu - 90, 1e-9 * (90 - mu), 270, 360},
                         {"mu", 1, 90, 9e-8, 0, 180},
                         {"x_harmonic", 1, 2 * length, 2e-9 * length, 0, 0},
                         {"v_harmonic", 1, length * omega, 1e-9 * length * omega, 0, 0}};

            for (j = 0; j < COUNT(cases); j++) {
                fourlink_value e = extreme_of(r, cases[j].column, branches[k], cases[j].sign);

                assert_near(e.value, cases[j].value, cases[j].tolerance);
                if (cases[j].turn > 0)
                    check_at(e.angle, cases[j].angle, cases[j].turn);
            }
        }
        fourlink_results_free(r);
    }
}

/* At its dead centre the displacement of the piston is 0, not what rounding leaves of two lengths. */
TEST(test_least_displacement)
{
    int i, k;

    for (i = -10; i <= 10; i++) {
        fourlink_results *r = opened(slider_crank(0.05, 0.0934, 7e-4 * i, revolution(-24)));

        for (k = 0; k < 2; k++)
            assert_true(extreme_of(r, "x", branches[k], -1).value == 0);
        fourlink_results_free(r);
    }
}

/* The limits of a crank-rocker are the extremes of theta4 and mu. */
TEST(test_extremes_and_limits_agree)
{
    uint64_t seed = 4;
    int i, k;

    for (i = 0; i < 10; i++) {
        own o = random_rocker(&seed);
        fourlink_results *r =
            opened(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d, revolution(1)));
        fourlink_problem problem = problem_of(r);
        fourlink_limits limits;

        for (k = 0; k < 2; k++) {
            fourlink_value min = extreme_of(r, "theta4", branches[k], -1),
                           max = extreme_of(r, "theta4", branches[k], 1);

            assert_int_equal(fourlink_limits_of(&problem.mechanism, branches[k], &limits),
                             FOURLINK_OK);
            assert_near(min.value, limits.theta4_min / DEG, 1e-9 * 180);
            assert_near(max.value, limits.theta4_max / DEG, 1e-9 * 180);
            min = extreme_of(r, "mu", branches[k], -1);
            max = extreme_of(r, "mu", branches[k], 1);
            assert_close(min.value, limits.mu_min / DEG, 1e-9);
            assert_close(max.value, limits.mu_max / DEG, 1e-9);
        }
        fourlink_results_free(r);
    }
}

/* ---------------------------------------------------------------------------------------------
** Extremes of other motions
** ------------------------------------------------------------------------------------------- */

TEST(test_extremes_at_the_ends_of_a_range)
{
    static const char *const ranges[] = {"from = 10 deg\nto = 50 deg\n",
                                         "from = 50 deg\nto = 10 deg\n"};
    own o = {0.15L, 0.45L, 0, 0, 1, 0, 12, 0, 0, 0};
    int i;

    for (i = 0; i < 2; i++) {
        part p = {o, 10 * PIL / 180, 50 * PIL / 180};
        char *contents = slider_crank(
            0.15, 0.45, 0, print("[motion]\nspeed = 12 rad/s\ninterval = 40 deg\n%s", ranges[i]));
        fourlink_value e;
        fourlink_results *r;

        check_extremes(contents, of_slider_crank, &p, 1, 0, VALUES | ANGLES);
        r = opened(contents);
        e = extreme_of(r, "x", FOURLINK_OPEN, 1);
        assert_true(e.angle == 50);
        e = extreme_of(r, "x", FOURLINK_OPEN, -1);
        assert_true(e.angle == 10);
        fourlink_results_free(r);
    }
}

/* A minimum of theta4 a little inside the first, or the last, angle of a range. */
TEST(test_extremes_just_inside_an_end)
{
    static const own_entry columns[] = {{"theta4", own_theta4}, {"mu", own_mu}, {NULL, NULL}};
    static const double insets[] = {0.9, 0.3, 0.01, 1e-5, 0};
    own o = {0.020L, 0.066L, 0.056L, 0.080L, 1, 0, 1, 0, 0, 0};
    double at = acos((6400. + 7396 - 3136) / (2 * 80 * 86)) / DEG;
    int i, end;

    for (i = 0; i < 5; i++)
        for (end = 0; end < 2; end++) {
            double from = end ? at - 200 : at - insets[i], to = end ? at + insets[i] : at + 200;
            part p = {o, (long double)from * PIL / 180, (long double)to * PIL / 180};

            check_extremes(
                four_bar(0.020, 0.066, 0.056, 0.080,
                         print("[motion]\nspeed = 1 rad/s\nfrom = %.17g deg\nto = %.17g deg\n",
                               from, to)),
                columns, &p, 1, 0, VALUES);
        }
}

/* From rest: 2 alpha s = omega^2 up to an angle, where alpha jumps to 0, then a revolution. */
TEST(test_extremes_of_a_run_up)
{
    static const double angles_[] = {100, 37.5, 200.25};
    uint64_t seed = 5;
    int i, sign;

    for (i = 0; i < 6; i++)
        for (sign = -1; sign <= 1; sign += 2) {
            own o = i % 2 ? random_engine(&seed, 1) : random_rocker(&seed), after;
            long double end = sign * (long double)angles_[i / 2] * PIL / 180;
            const char *motion =
                print("[motion]\nrun_up = %.17g deg\nacceleration = %d rad/s2\ninterval = 40 deg\n",
                      angles_[i / 2], sign * 30);
            part p[2];

            o.speed = 0;
            o.acceleration = sign * 30;
            after = o;
            after.speed = sign * sqrtl(2 * o.acceleration * end);
            after.acceleration = 0;
            p[0].o = o;
            p[0].from = sign > 0 ? 0 : end;
            p[0].to = sign > 0 ? end : 0;
            p[1].o = after;
            p[1].from = sign > 0 ? end : end - 2 * PIL;
            p[1].to = sign > 0 ? end + 2 * PIL : end;
            if (i % 2)
                check_extremes(slider_crank((double)o.a, (double)o.b, (double)o.d, motion),
                               of_slider_crank, p, 2, 0, VALUES);
            else
                check_extremes(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d, motion),
                               of_four_bar, p, 2, 0, VALUES);
        }
}

TEST(test_extremes_of_accelerated_motion)
{
    uint64_t seed = 6;
    int i;

    for (i = 0; i < 6; i++) {
        own o = i % 2 ? random_engine(&seed, 1) : random_rocker(&seed);
        double to =
            i % 3 ? uniform(&seed, 90, 1000) : 380; /* one revolution, whose ends do not meet */
        part p = {o, 20 * PIL / 180, (long double)to * PIL / 180};
        const char *motion;

        /* slowing down, but not to rest */
        p.o.speed = o.speed = 20;
        p.o.acceleration = o.acceleration = i < 3 ? 7 : -7;
        p.o.start = 20 * PIL / 180;
        motion = print("[motion]\nspeed = 20 rad/s\nacceleration = %d rad/s2\nfrom = 20 deg\n"
                       "to = %.17g deg\ninterval = 40 deg\n",
                       i < 3 ? 7 : -7, to);
        if (i % 2)
            check_extremes(slider_crank((double)o.a, (double)o.b, (double)o.d, motion),
                           of_slider_crank, &p, 1, 0, VALUES);
        else
            check_extremes(four_bar((double)o.a, (double)o.b, (double)o.c, (double)o.d, motion),
                           of_four_bar, &p, 1, 0, VALUES);
    }
}

/* 10 rad/s, -20 rad/s2: the crank comes to rest after 2.5 rad = 143.2 deg, whatever the interval. */
TEST(test_extremes_of_a_crank_that_stops)
{
    static const double intervals[] = {0.1, 1, 40, 143};
    own o = {0.020L, 0.066L, 0.056L, 0.080L, 1, 0, 10, -20, 0, 0};
    part p = {o, 0, 2.5L};
    int i;

    for (i = 0; i < 4; i++)
        check_extremes(four_bar(0.020, 0.066, 0.056, 0.080,
                                print("[motion]\nspeed = 10 rad/s\nacceleration = -20 rad/s2\n"
                                      "interval = %g deg\n",
                                      intervals[i])),
                       of_four_bar, &p, 1, 0, VALUES);
}

TEST(test_extremes_do_not_depend_on_the_interval)
{
    static const char *const names[] = {"theta3", "omega3", "alpha3", "theta4", "omega4",
                                        "alpha4", "mu",     "Ts",     "F12",    "F14x"};
    static const double intervals[] = {360, 40, 7, 1, 0.25};
    fourlink_value first[2 * 10];
    int i, j;

    for (i = 0; i < 5; i++) {
        fourlink_results *r;

        r = opened(
            four_bar(0.020, 0.066, 0.056, 0.080,
                     print("[load]\nlink = rocker\ntorque = 3 N m\n[motion]\nspeed = 10 rad/s\n"
                           "interval = %g deg\n",
                           intervals[i])));
        for (j = 0; j < 20; j++) {
            fourlink_value e = extreme_of(r, names[j / 2], FOURLINK_OPEN, j % 2 ? 1 : -1);

            if (i == 0)
                first[j] = e;
            assert_close(e.value, first[j].value, 1e-9);
            assert_near(turned(e.angle - first[j].angle, 360), 0, 1e-6);
        }
        fourlink_results_free(r);
    }
}

/* Where the crank does not turn fully, columns that stay finite have their extremes at dead positions,
** which they approach as a square root does. */
TEST(test_extremes_towards_dead_positions)
{
    double end = acos((0.09 + 0.5625 - 0.81) / (2 * 0.3 * 0.75));
    fourlink_results *r;
    fourlink_value e;
    int k;

    r = opened(four_bar(0.3, 0.4, 0.5, 0.75, revolution(1)));
    for (k = 0; k < 2; k++) {
        e = extreme_of(r, "mu", branches[k], -1);
        assert_near(e.value, 0, 1e-4);
        assert_near(fabs(turned(e.angle, 360)), end / DEG, 1e-4);
    }
    fourlink_results_free(r);
}

/* r = 400, l = 200 mm: x is least at the inner dead centre; at the ends X = 400 cos(30 deg). */
TEST(test_extremes_towards_dead_positions_of_a_piston)
{
    fourlink_results *r;
    fourlink_value e;

    r = opened(slider_crank(
        0.4, 0.2, 0,
        "[motion]\nspeed = 1 rad/s\nfrom = -100 deg\nto = 80 deg\ninterval = 7 deg\n"));
    e = extreme_of(r, "x", FOURLINK_OPEN, -1);
    assert_near(e.value, 0, 1e-15);
    e = extreme_of(r, "x", FOURLINK_OPEN, 1);
    assert_near(e.value, 0.6 - 0.4 * cos(PI / 6), 1e-6);
    assert_near(fabs(e.angle), 30, 1e-4);
    fourlink_results_free(r);
}

/* A pressure that rises and falls within three degrees, of a card that is else flat. */
TEST(test_extremes_of_a_narrow_card)
{
    fourlink_results *r;
    fourlink_value e;

    r = opened(slider_crank(0.15, 0.45, 0,
                            print("[gas]\nbore = 100 mm\nindicator = 0 deg 1 bar, 12.2 deg 1 bar,\n"
                                  "13.7 deg 60 bar, 15.2 deg 1 bar, 200 deg 1 bar\n%s",
                                  revolution(10))));
    e = extreme_of(r, "gas_force", FOURLINK_OPEN, 1);
    assert_close(e.value, 60e5 * PI / 4 * 0.01, 1e-9);
    assert_near(e.angle, 13.7, 1e-6);
    e = extreme_of(r, "gas_force", FOURLINK_OPEN, -1);
    assert_close(e.value, 1e5 * PI / 4 * 0.01, 1e-9);
    fourlink_results_free(r);
}

TEST(test_extremes_in_the_units_of_the_deck)
{
    fourlink_results *r;
    fourlink_value e;

    r = opened(slider_crank(0.15, 0.45, 0,
                            "[motion]\nspeed = 12 rad/s\n[units]\nlength = mm\nangle = rad\n"));
    e = extreme_of(r, "x", FOURLINK_OPEN, 1);
    assert_near(e.value, 300, 3e-7);
    assert_near(e.angle, PI, 1e-8);
    e = extreme_of(r, "phi", FOURLINK_OPEN, 1);
    assert_close(e.value, asin(1. / 3), 1e-9);
    assert_near(e.angle, PI / 2, 1e-8);
    fourlink_results_free(r);
}

/* One instant is its own maximum and minimum. */
TEST(test_extremes_of_one_instant)
{
    fourlink_results *r;
    fourlink_value e;
    int sign;

    r = opened(slider_crank(0.15, 0.45, 0, "[motion]\nspeed = 12 rad/s\nat = 60 deg\n"));
    for (sign = -1; sign <= 1; sign += 2) {
        e = extreme_of(r, "x", FOURLINK_OPEN, sign);
        assert_near(e.value, 0.6 - 0.15 * 0.5 - sqrt(0.2025 - 0.0225 * 0.75), 1e-15);
        assert_true(e.angle == 60);
    }
    fourlink_results_free(r);
}

/* A linkage whose crank swings between two dead positions: what is infinite there has no largest value,
** angles and transmission angles do. */
TEST(test_extremes_beyond_all_bounds)
{
    static const struct {
        const char *column;
        int sign, unbounded[2]; /* open, crossed */
    } cases[] = {{"omega3", 1, {1, 1}},  {"omega3", -1, {1, 1}},   {"alpha4", 1, {1, 0}},
                 {"alpha4", -1, {0, 1}}, {"mu", 1, {0, 0}},        {"mu", -1, {0, 0}},
                 {"theta4", 1, {0, 0}},  {"theta4", -1, {0, 0}},   {"omega2", 1, {0, 0}},
                 {"omega2", -1, {0, 0}}, {"condition", 1, {1, 1}}, {"condition", -1, {0, 0}}};
    fourlink_results *r = opened(four_bar(0.3, 0.4, 0.5, 0.75, revolution(1)));
    size_t i;
    int k;

    for (i = 0; i < COUNT(cases); i++)
        for (k = 0; k < 2; k++) {
            fourlink_value e = extreme_of(r, cases[i].column, branches[k], cases[i].sign);

            if ((isfinite(e.value) == 0) != cases[i].unbounded[k])
                fail_msg("%s = %g", e.name, e.value);
            if (cases[i].unbounded[k])
                assert_true(e.value == cases[i].sign * HUGE_VAL && !e.has_angle);
        }
    fourlink_results_free(r);
}

TEST(test_extremes_where_the_links_never_reach)
{
    static const char *const names[] = {"max(theta4)", "min(theta4)", "max(omega3)", "min(mu)"};
    fourlink_results *r = opened(four_bar(0.3, 0.4, 0.5, 0.75,
                                          "[motion]\nspeed = 1 rad/s\nfrom = 120 deg\n"
                                          "to = 200 deg\n"));
    size_t i;
    int k;

    for (i = 0; i < COUNT(names); i++)
        for (k = 0; k < 2; k++) {
            fourlink_value e = {0}, before = e;

            assert_int_equal(fourlink_results_value(r, names[i], branches[k], 0, &e),
                             FOURLINK_NOT_REACHED);
            assert_memory_equal(&e, &before, sizeof e);
        }
    fourlink_results_free(r);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
