/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_extreme_cases.c - extremes of decks whose right values are known.
*/
#include "machines.h"

static fourlink_value extreme(const char *deck, fourlink_branch branch, const char *name)
{
    fourlink_results *results = opened(deck);
    fourlink_value value = named(results, name, branch, 0);

    fourlink_results_free(results);
    return value;
}

static void check(const char *deck, fourlink_branch branch, const char *name, double right,
                  double tolerance)
{
    double value = extreme(deck, branch, name).value;

    if (!(fabs(value - right) <= tolerance) && value != right)
        fail_msg("%s is %.12g, not %.12g", name, value, right);
}

#define CRANK_ROCKER ROCKER "[motion]\ninterval = 40 deg\n"

/* A direction that turns fully goes on to its end. */
TEST(test_full_turns)
{
    static const char slow[] = CRANK_ROCKER "speed = 10.5 rad/s\n"
                                            "[load]\nlink = rocker\ntorque = 0.5 N m\n";
    static const char fast[] = CRANK_ROCKER "speed = 300 rad/s\n"
                                            "[load]\nlink = rocker\ntorque = 0.5 N m\n";

    check(slow, FOURLINK_CROSSED, "max(Fi3_dir)", 342.723876927, 1e-6);
    check(slow, FOURLINK_CROSSED, "min(Fi3_dir)", -17.4174074131, 1e-6);
    check(fast, FOURLINK_OPEN, "max(F23_dir)", 217.914689843, 1e-6);
    check(fast, FOURLINK_OPEN, "min(F23_dir)", -142.085310157, 1e-6);
}

/* Where both cranks turn fully an angle gains a turn in each period, of which most are skipped. */
TEST(test_many_turns)
{
    static const char deck[] = "mechanism = four-bar\n[ground]\nlength = 30 mm\n[crank]\n"
                               "length = 60 mm\n[coupler]\nlength = 70 mm\n[rocker]\n"
                               "length = 65 mm\n[motion]\nspeed = 10 rad/s\nto = 7200 deg\n"
                               "[table]\ncolumns = theta4\n";
    fourlink_results *r = opened(deck);
    double first = value_at(r, "theta4", 0);

    assert_near(value_at(r, "min(theta4)", 0), first, 1e-9);
    assert_near(value_at(r, "max(theta4)", 0), first + 7200, 1e-9);
    fourlink_results_free(r);
}

/* A hundred thousand periods have the extremes and the mean of one. */
TEST(test_many_periods)
{
    static const char *const names[] = {"max(F12)", "min(Ts)", "mean(F12)", "rms(Ts)"};
    fourlink_results *one = opened(CRANK_ROCKER "speed = 10.5 rad/s\n");
    fourlink_results *many = opened(ROCKER "[motion]\nspeed = 10.5 rad/s\nto = 36000000 deg\n"
                                           "interval = 3600 deg\n");
    size_t i;

    for (i = 0; i < COUNT(names); i++)
        assert_close(value_at(many, names[i], 0), value_at(one, names[i], 0), 1e-9);
    fourlink_results_free(one);
    fourlink_results_free(many);
}

/* The extremes of a measure of rounding are those of rows as they are printed. */
TEST(test_measures_of_rounding)
{
    static const char *const names[] = {"residual", "superposition"};
    fourlink_results *r = opened(CRANK_ROCKER "speed = 10.5 rad/s\n");
    size_t i;

    for (i = 0; i < COUNT(names); i++) {
        fourlink_value most = named(r, print("max(%s)", names[i]), FOURLINK_OPEN, 0);

        assert_true(most.value > 0);
        assert_true(value_at(r, names[i], most.angle) == most.value);
    }
    fourlink_results_free(r);
}

/* The corners of a load move no direction that has nothing to do with it. */
TEST(test_corners)
{
    static const char deck[] = CRANK_ROCKER
        "speed = 10.5 rad/s\n"
        "[load]\nlink = rocker\ntorque = 7 deg 0.5 N m, 178 deg 0.4 N m, 266 deg 0.6 N m\n";

    check(deck, FOURLINK_OPEN, "max(Fi2_dir)", 360, 1e-9);
    check(deck, FOURLINK_OPEN, "min(Fi2_dir)", 0, 1e-9);
}

/* The force in a massless coupler has its direction, also where that ends: at a dead position coupler
** and rocker are in one line, from B to D.  Its size does not matter. */
TEST(test_direction_at_dead_position)
{
    static const char *const torques[] = {"1 N m", "1e6 N m", "1e-6 N m"};
    double dead = acos((0.3 * 0.3 + 0.75 * 0.75 - 0.9 * 0.9) / (2 * 0.3 * 0.75));
    double line = atan2(-0.3 * sin(dead), 0.75 - 0.3 * cos(dead)) * 180 / PI;
    size_t i;

    for (i = 0; i < COUNT(torques); i++) {
        char *deck =
            print("mechanism = four-bar\n[crank]\nlength = 0.3\n[coupler]\nlength = 0.4\n"
                  "[rocker]\nlength = 0.5\n[ground]\nlength = 0.75\n[load]\nlink = rocker\n"
                  "torque = %s\n[motion]\nspeed = 2 rad/s\nto = 150 deg\n",
                  torques[i]);

        check(deck, FOURLINK_OPEN, "min(theta3)", line, 1e-9);
        check(deck, FOURLINK_OPEN, "min(F34_dir)", line, 1e-9);
        check(deck, FOURLINK_CROSSED, "max(F34_dir)", line + 180, 1e-9);
    }
}

/* 12 h times the slope of a column, with an error of h^5. */
static double slope_at(fourlink_results *r, const char *name, fourlink_branch branch, double angle)
{
    const double h = 0.04;

    return 8 * (named(r, name, branch, angle + h).value - named(r, name, branch, angle - h).value) -
           (named(r, name, branch, angle + 2 * h).value -
            named(r, name, branch, angle - 2 * h).value);
}

/* The place of a flat extreme is where the slope is 0, by bisection. */
TEST(test_place_of_a_flat_extreme)
{
    fourlink_results *r = opened(
        "mechanism = four-bar\n[crank]\nlength = 0.314\nmass = 1 kg\nuniform = yes\n[coupler]\n"
        "length = 0.873\nmass = 2 kg\nuniform = yes\n[rocker]\nlength = 1.049\nmass = 1 kg\n"
        "uniform = yes\n[ground]\nlength = 0.816\n[motion]\nspeed = 1 rad/s\nfrom = -1 deg\n"
        "to = 359 deg\n");
    fourlink_value least = named(r, "min(Fs)", FOURLINK_CROSSED, 0);
    double low = least.angle - 0.01, high = least.angle + 0.01;

    while (high - low > 1e-9) {
        double middle = (low + high) / 2;

        if (slope_at(r, "Fs", FOURLINK_CROSSED, middle) < 0)
            low = middle;
        else
            high = middle;
    }
    assert_near(least.angle, low, 5e-7);
    fourlink_results_free(r);
}

/* The centre of mass of the rod is at the crank pin: F_C has no moment about I but that of the rod's moment of inertia,
** and IY = -I theta3'' / (m r) on the side where theta3' > 0, with theta3' = -lambda cos(theta2) / cos(theta3) and
** lambda = r / l.  At 90 deg it is 0 / 0, and jumps from -IY to IY = I / (m l sqrt(1 - lambda^2)). */
TEST(test_jump_where_a_quotient_is_undefined)
{
    static const double ratios[] = {3, 20, 200, 547, 5000};
    size_t i;

    for (i = 0; i < COUNT(ratios); i++) {
        double expected = 0.005 / sqrt(1 - 1 / (ratios[i] * ratios[i]));
        char *deck = print("mechanism = slider-crank\n[crank]\nlength = %.17g mm\n[rod]\n"
                           "length = 200 mm\nmass = 1 kg\ninertia = 0.001 kg m2\n[piston]\n"
                           "[motion]\nspeed = 10 rad/s\n",
                           200 / ratios[i]);

        check(deck, FOURLINK_OPEN, "max(klein_IY)", expected, 1e-9 * expected);
        check(deck, FOURLINK_OPEN, "min(klein_IY)", -expected, 1e-9 * expected);
    }
}

/* With a rod as long as the crank x = 2 a cos(theta2): at 90 deg the piston's acceleration turns over. */
TEST(test_direction_of_vanishing_force)
{
    static const char deck[] =
        "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 50 mm\n"
        "[piston]\nmass = 1 kg\n[motion]\nspeed = 10 rad/s\n";
    fourlink_value v = extreme(deck, FOURLINK_OPEN, "max(Fi4_dir)");

    assert_near(v.value, 180, 1e-9);
    assert_near(v.angle, 90, 1e-9);
}

/* A constant column has its extremes at the first row, though rounding makes it vary. */
TEST(test_constant)
{
    static const char *const names[] = {"max(alpha4)", "min(alpha4)", "max(alpha2)", "min(alpha2)"};
    static const int first[] = {0, 10};
    size_t i, k;

    for (k = 0; k < 2; k++)
        for (i = 0; i < 4; i++) {
            fourlink_value v = extreme(
                print("mechanism = four-bar\n[ground]\nlength = 1 m\nangle = -14.3 deg\n[crank]\n"
                      "length = 2.25 m\nmass = 4 kg\n[coupler]\nlength = 1 m\nmass = 3 kg\n"
                      "[rocker]\nlength = 2.25 m\nmass = 5 kg\ninertia = 3 kg m2\n[gravity]\n"
                      "acceleration = 0\n[motion]\nspeed = 16.7 rad/s\nacceleration = -40 rad/s2\n"
                      "from = %d deg\nto = 160 deg\ninterval = 7 deg\n",
                      first[k]),
                FOURLINK_OPEN, names[i]);

            assert_near(v.value, -40, 1e-6);
            assert_true(v.angle == first[k]);
        }
}

/* No row is beyond the extremes of its column. */
#define COLUMNS 8

static void check_rows(const char *deck, fourlink_branch branch)
{
    fourlink_results *results = opened(deck);
    const fourlink_value *columns;
    fourlink_value max[COLUMNS], min[COLUMNS];
    double values[COLUMNS];
    unsigned long n, rows = 0, step = tries_all() ? 1 : 4, i, c;

    assert_int_equal(fourlink_results_list(results, FOURLINK_COLUMNS, &columns, &n), FOURLINK_OK);
    assert_true(n <= COLUMNS);
    for (c = 0; c < n; c++) {
        max[c] = named(results, print("max(%s)", columns[c].name), branch, 0);
        min[c] = named(results, print("min(%s)", columns[c].name), branch, 0);
    }
    for (i = 0; i <= 36000; i += step) {
        if (fourlink_results_row(results, branch, i, values, NULL, NULL) != FOURLINK_OK)
            continue;
        rows++;
        for (c = 0; c < n; c++) {
            double close = 1e-10 * fabs(values[c]);

            if (!(values[c] <= max[c].value + close && values[c] >= min[c].value - close))
                fail_msg("row %lu: %.12g of %s is not within %.12g and %.12g", i, values[c],
                         columns[c].name, min[c].value, max[c].value);
        }
    }
    assert_in_range(rows, 1000 / step, 35000 / step); /* the mechanism locks */
    fourlink_results_free(results);
}

static double angle_of(const char *deck, const char *name)
{
    return extreme(deck, FOURLINK_OPEN, name).angle;
}

#define PISTON                                                                    \
    "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n" \
    "[load P]\nlink = piston\nforce = 500 N\n[motion]\nspeed = 10 rad/s\n"        \
    "interval = 0.01 deg\n[table]\ncolumns = Ts, N, friction_guide, power_friction\n"

/* Friction in the guide locks the engine where tan(phi) = 1 / mu; towards that angle forces are unbounded. */
TEST(test_lock)
{
    static const char deck[] = PISTON "[friction]\nguide = 5\n";
    static const char narrow[] = PISTON "[friction]\nguide = 3.8731\n";
    static const char *const unbounded[] = {"max(Ts)", "max(friction_guide)",
                                            "max(power_friction)"};
    double right = asin(4 / sqrt(26)) * 45 / atan(1);
    size_t i;

    for (i = 0; i < 3; i++) {
        check(deck, FOURLINK_OPEN, unbounded[i], HUGE_VAL, 0);
        assert_true(fabs(angle_of(deck, unbounded[i]) - right) < 1e-6);
    }
    check(deck, FOURLINK_OPEN, "min(N)", -HUGE_VAL, 0);
    check(deck, FOURLINK_OPEN, "max(N)", 56.3508326897, 1e-9);
    check_rows(deck, FOURLINK_OPEN);
    check(narrow, FOURLINK_OPEN, "max(Ts)", HUGE_VAL, 0); /* from 89.7 to 90.3 deg */
}

/* Where the friction of pins locks a linkage forces end at a finite value, with an infinite slope. */
TEST(test_lock_of_pins)
{
    static const char deck[] =
        "mechanism = four-bar\n[crank]\nlength = 20 mm\n"
        "[coupler]\nlength = 66 mm\nmass = 0.3 kg\ngyration = 25 mm\ncg = 30 mm\n"
        "[rocker]\nlength = 56 mm\nmass = 0.25 kg\nuniform = yes\n[ground]\nlength = 80 mm\n"
        "[friction]\nB = 1\nC = 1\nD = 1\n"
        "radius_B = 30 mm\nradius_C = 30 mm\nradius_D = 30 mm\n"
        "[motion]\nspeed = 10 rad/s\ninterval = 0.01 deg\n"
        "[table]\ncolumns = Ts, F23, F34, F14, power_friction\n";

    check(deck, FOURLINK_OPEN, "max(Ts)", 0.3277405, 2e-6);
    assert_true(fabs(angle_of(deck, "max(Ts)") - 14.52918) < 1e-4);
    check_rows(deck, FOURLINK_OPEN);
}

/* The crank angle towards which a linkage is free, between one at which it is and one at which friction
** locks it. */
static double lock_of(fourlink_results *results, double is_free, double is_locked)
{
    double values[COLUMNS];
    int i;

    for (i = 0; i < 60; i++) {
        double middle = 0.5 * (is_free + is_locked);

        if (fourlink_results_at(results, FOURLINK_OPEN, middle, values, NULL, NULL) == FOURLINK_OK)
            is_free = middle;
        else
            is_locked = middle;
    }
    return is_free;
}

/* Where friction locks within 0.0005 deg of a dead position, or less, Ts grows as the inverse of the
** distance, and the torque without friction ends at the value of the last row. */
TEST(test_lock_near_dead)
{
    static const double parts[] = {1, 0.5, 0.25, 0.17, 0.1, 0.03};
    static const char *const names[] = {"max(Ts)", "max(F12y)", "max(F34)"};
    double last[COLUMNS], near[COLUMNS], nearer[COLUMNS], lock;
    fourlink_results *results;
    char deck[1000];
    size_t i, k;

    for (i = 0; i < COUNT(parts); i++) {
        snprintf(deck, sizeof deck,
                 "solver = dyad\nmechanism = four-bar\n[ground]\nlength = 0.71\n"
                 "[crank]\nlength = 0.75\n[coupler]\nlength = 0.69\n"
                 "[rocker]\nlength = 0.11\ninertia = 0.00016\n[gravity]\n"
                 "[friction]\nA = %g\nradius_A = 0.0096\nB = %g\nradius_B = 0.0073\n"
                 "C = %g\nradius_C = 0.024\nD = %g\nradius_D = 0.0027\n"
                 "[load L0]\nlink = rocker\nforce = (280, 140)\nat = (0.27, -0.3)\n"
                 "[load L1]\nlink = rocker\nforce = (170, -29)\nat = (0.024, 0.14)\n"
                 "[motion]\nspeed = 17 rad/s\n[table]\ncolumns = Ts, F12y, F34, Ts0\n",
                 0.25 * parts[i], 0.062 * parts[i], 0.029 * parts[i], 0.096 * parts[i]);
        results = opened(deck);
        lock = lock_of(results, 313, 313.28547255);
        fourlink_results_at(results, FOURLINK_OPEN, lock - 4e-8, near, NULL, NULL);
        fourlink_results_at(results, FOURLINK_OPEN, lock - 1e-8, nearer, NULL, NULL);
        fourlink_results_at(results, FOURLINK_OPEN, lock, last, NULL, NULL);
        fourlink_results_free(results);
        assert_true(nearer[0] > 3 * near[0] && nearer[3] < 1.2 * near[3]);
        for (k = 0; k < COUNT(names); k++) {
            check(deck, FOURLINK_OPEN, names[k], HUGE_VAL, 0);
            check(deck, FOURLINK_CROSSED, names[k], HUGE_VAL, 0);
        }
        if (parts[i] == 1)
            check(deck, FOURLINK_OPEN, "max(Ts0)", last[3], 1e-6 * last[3]);
    }
}

/* A free motion that repeats itself has its extremes in its first turn, though the integration makes a
** later one larger by its error.  Below, 3 kg m2 have fallen 7 kg m: 3/2 (omega2^2 - 1) = 7 g. */
TEST(test_free_turns)
{
    static const char deck[] =
        "mechanism = four-bar\n[ground]\nlength = 1\n[crank]\nlength = 1\nmass = 1\nuniform = yes\n"
        "[coupler]\nlength = 1\nmass = 2\nuniform = yes\n[rocker]\nlength = 1\nmass = 2\n"
        "uniform = yes\n[motion]\nmode = free\nspeed = -1\nfrom = 90\nturns = -6\ninterval = 4\n";

    check(deck, FOURLINK_OPEN, "max(omega2)", -1, 1e-10);
    assert_true(angle_of(deck, "max(omega2)") == 90);
    check(deck, FOURLINK_OPEN, "min(omega2)", -sqrt(1 + 14 * 9.81 / 3), 1e-10);
    assert_true(fabs(angle_of(deck, "min(omega2)") + 90) < 1e-3);
}

/* Beyond the locked range small extremes are found as ever. */
TEST(test_behind_lock)
{
    static const char deck[] =
        "mechanism = slider-crank\n[crank]\nlength = 44.34 mm\nmass = 0.193 kg\ncg = 41.71 mm\n"
        "[rod]\nlength = 127.11 mm\nmass = 0.153 kg\ngyration = 16.54 mm\ncg = 19 mm\n"
        "[piston]\nmass = 0.424 kg\n[load P]\nlink = piston\nforce = 629.6 N\n"
        "[friction]\nguide = 2.771\nB = 0.59\nradius_B = 12.84 mm\nC = 0.64\n"
        "radius_C = 7.17 mm\n[motion]\nspeed = -2.2 rad/s\ninterval = 0.01 deg\n"
        "[table]\ncolumns = Ts, N, F34, Fsx, power_friction\n";

    check(deck, FOURLINK_CROSSED, "max(power_friction)", HUGE_VAL, 0);
    check_rows(deck, FOURLINK_OPEN);
    check_rows(deck, FOURLINK_CROSSED);
}

/* Of values that are equal within rounding error of their quantity the first stays: x of a piston is 0 at its dead
** centre, in each turn. */
TEST(test_first_of_equal)
{
    static const double rods[] = {60, 123, 200, 331};
    fourlink_value least;
    char deck[400];
    size_t i;

    for (i = 0; i < COUNT(rods); i++) {
        snprintf(deck, sizeof deck,
                 "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = %g mm\n"
                 "[motion]\nspeed = 10 rad/s\nfrom = 10 deg\nto = 740 deg\n",
                 rods[i]);
        least = extreme(deck, FOURLINK_CROSSED, "min(x)");
        assert_near(least.value, 0, 1e-15);
        assert_near(least.angle, 180, 1e-12);
    }
}

/* The extreme among those of all columns, which are found in one search. */
static fourlink_value among_all(fourlink_results *results, fourlink_branch branch, const char *name)
{
    const fourlink_value *facts;
    unsigned long n, i = 0;

    assert_int_equal(
        fourlink_results_facts(results, (int)branch, FOURLINK_FACTS_EXTREMES, &facts, &n),
        FOURLINK_OK);
    while (i + 1 < n && strcmp(facts[i].name, name) != 0)
        i++;
    assert_string_equal(facts[i].name, name);
    return facts[i];
}

/* Columns that are found together have the extremes that each has alone: others' samples do not disturb
** them. */
TEST(test_together)
{
    static const char *const names[] = {"max(a)", "max(klein_ON)", "min(omega3)", "max(Ts)"};
    static const char deck[] =
        "mechanism = slider-crank\n[ground]\noffset = -7 mm\n[crank]\nlength = 50 mm\n[rod]\n"
        "length = 123 mm\nmass = 3 kg\ngyration = 53 mm\n[gravity]\nacceleration = 0\n"
        "[motion]\nspeed = 135 rad/s\nfrom = 43 deg\nto = 403 deg\n[table]\ncolumns = ";
    fourlink_results *together = opened(print("%sall\n", deck));
    size_t i;
    int k;

    for (k = 0; k < 2; k++)
        for (i = 0; i < COUNT(names); i++) {
            const char *alone = print("%s%.*s\n", deck, (int)strlen(names[i]) - 5, names[i] + 4);
            fourlink_value found = among_all(together, branches[k], names[i]);

            check(alone, branches[k], names[i], found.value, 1e-11 * fabs(found.value));
        }
    fourlink_results_free(together);
}

/* A column jumps by little close to its peak, which is flat: a torque on the crank, added to Ts, begins or ends
** there. */
TEST(test_small_jump)
{
    const char *deck = CRANK_ROCKER "speed = 10.5 rad/s\n[table]\ncolumns = Ts\n";
    const char *load =
        "[load J]\nlink = crank\ntorque = %.17g N m\nfrom = %.17g deg\nto = %.17g deg\n";
    fourlink_value peak = extreme(deck, FOURLINK_OPEN, "max(Ts)"), found;
    fourlink_results *r = opened(deck);
    uint64_t seed = 7;
    int i, begins;

    for (i = 0; i < some_of(2000); i++) {
        double jump = peak.value * pow(10, uniform(&seed, -9, -3));
        double at = pow(10, uniform(&seed, -5, 0)) * (uniform(&seed, -1, 1) < 0 ? -1 : 1);
        double right = peak.value + jump, angle = peak.angle;

        begins = uniform(&seed, -1, 1) < 0;
        at += peak.angle;
        if (begins == (at > peak.angle)) { /* the peak is outside */
            double beside = value_at(r, "Ts", at) + jump;

            right = beside > peak.value ? beside : peak.value;
            angle = beside > peak.value ? at : peak.angle;
        }
        found = extreme(
            print("%s%s", deck, print(load, -jump, begins ? at : at - 60, begins ? at + 60 : at)),
            FOURLINK_OPEN, "max(Ts)");
        if (!(fabs(found.value - right) <= 1e-11 * right && fabs(found.angle - angle) <= 1e-3))
            fail_msg("case %d: max(Ts) is %.17g at %.12g, not %.17g at %.12g", i, found.value,
                     found.angle, right, angle);
    }
    fourlink_results_free(r);
}

/* The yoke ends its stroke where the crank is at right angles to the slot: samples that friction needs beside
** that place do not move it. */
TEST(test_place_beside_narrow_peaks)
{
    static const char deck[] =
        "mechanism = scotch-yoke\n[ground]\noffset = 25 mm\n[crank]\nlength = 50 mm\nmass = 0.5 "
        "kg\n"
        "inertia = 0.0006 kg m2\ncg = (10, 2) mm\n[slider]\nmass = 0.3 kg\n[yoke]\nangle = 60 deg\n"
        "mass = 1.6 kg\ncg = (-50, 20) mm\n[motion]\nspeed = 12 rad/s\n[load P]\nlink = yoke\n"
        "force = (-150, 60) N\nat = (100, 20) mm\n[load T]\nlink = yoke\ntorque = 5 N "
        "m\n[friction]\n"
        "A = 0.06\nradius_A = 10 mm\nB = 0.05\nradius_B = 10 mm\nslot = 0.1\nslot_length = 40 mm\n"
        "guide = 0.12\nguide_length = 200 mm\n[point P]\nlink = yoke\nat = (60, 30) mm\n[table]\n"
        "columns = all\n";

    fourlink_results *r = opened(deck);

    assert_near(among_all(r, FOURLINK_OPEN, "max(P.x)").angle, 330, 1e-5);
    assert_near(among_all(r, FOURLINK_OPEN, "min(P.x)").angle, 150, 1e-5);
    fourlink_results_free(r);
}

/* Inertia forces have the same extremes under a load that is a billion times as large as they are. */
TEST(test_small_beside_pin_forces)
{
    static const char *const names[] = {"max(Fi3)", "min(Fi3)", "max(Ci3)", "min(Ci3)",
                                        "max(Fi4)", "min(Fi4)", "max(Ci4)", "min(Ci4)"};
    uint64_t seed = 3;
    size_t k;
    int i;

    for (i = 0; i < some_of(1000); i++) {
        const char *deck = print(CRANK_ROCKER "speed = %.17g rad/s\nfrom = %.17g deg\n",
                                 pow(10, uniform(&seed, -1, 2)), uniform(&seed, 0, 360));
        const char *load =
            print("[load]\nlink = rocker\nforce = (%.17g, %.17g) N\nat = (30, 5) mm\n",
                  pow(10, uniform(&seed, 2, 8)), pow(10, uniform(&seed, 2, 8)));
        fourlink_results *alone = opened(print("%s[table]\ncolumns = all\n", deck));
        fourlink_results *loaded = opened(print("%s%s[table]\ncolumns = all\n", deck, load));

        for (k = 0; k < COUNT(names); k++) {
            fourlink_value right = among_all(alone, FOURLINK_OPEN, names[k]);
            fourlink_value found = among_all(loaded, FOURLINK_OPEN, names[k]);

            if (!(fabs(found.value - right.value) <= 1e-12 * fabs(right.value) &&
                  fabs(found.angle - right.angle) <= 1e-5))
                fail_msg("case %d: %s is %.17g at %.12g, not %.17g at %.12g", i, names[k],
                         found.value, found.angle, right.value, right.angle);
        }
        fourlink_results_free(alone);
        fourlink_results_free(loaded);
    }
}

/* The energy and the power of a spring between crank and ground, by its length: of n steps of a turn the extremes. */
static void find_by_length(double a, double b, double k, double free_length, double speed,
                           double most[2], double least[2])
{
    int n = 20000, i, j;

    for (i = 0; i <= n; i++) {
        double psi = 2 * PI * i / n, length = sqrt(a * a + b * b - 2 * a * b * cos(psi));
        double past = length - free_length, value[2];

        value[0] = k * past * past / 2;
        value[1] = -k * past * speed * a * b * sin(psi) / length;
        for (j = 0; j < 2; j++) {
            most[j] = i ? fmax(most[j], value[j]) : value[j];
            least[j] = i ? fmin(least[j], value[j]) : value[j];
        }
    }
}

/* The extremes of a spring do not depend on how large the machine is, nor on its masses. */
TEST(test_weak_spring_of_a_large_machine)
{
    static const char *const names[] = {"S.energy", "S.power"};
    uint64_t seed = 5;
    int i, j;

    for (i = 0; i < some_of(1000); i++) {
        double R = pow(10, uniform(&seed, -1, 4)), a = pow(10, uniform(&seed, -2, -1)),
               b = a * uniform(&seed, 1.2, 3), k = pow(10, uniform(&seed, -4, 3)),
               speed = pow(10, uniform(&seed, -1, 3)) * (i % 2 ? 1 : -1),
               free_length = uniform(&seed, 0.1, 1.2) * (a + b), most[2], least[2], size;
        fourlink_instant now;
        fourlink_value found;
        fourlink_results *r = opened(print(
            "%s[piston]\nmass = %.17g kg\n[spring S]\nlink = crank\nat = (%.17g, 0) m\nto = "
            "ground\nto_at = (%.17g, 0) m\nstiffness = %.17g N/m\nfree_length = %.17g m\n"
            "[motion]\nspeed = %.17g rad/s\nfrom = %.17g deg\n[table]\ncolumns = S.energy, "
            "S.power, Ts\n",
            slider_crank(R, R * uniform(&seed, 1.5, 4), 0, ""), pow(10, uniform(&seed, -1, 6)), a,
            b, k, free_length, speed, uniform(&seed, 0, 360)));

        find_by_length(a, b, k, free_length, speed, most, least);
        for (j = 0; j < 2; j++) {
            double width = fmax(fabs(most[j]), fabs(least[j]));
            double above = named(r, print("max(%s)", names[j]), FOURLINK_OPEN, 0).value - most[j];
            double below = least[j] - named(r, print("min(%s)", names[j]), FOURLINK_OPEN, 0).value;

            if (!(above >= -1e-12 * width && above <= 1e-6 * width && below >= -1e-12 * width &&
                  below <= 1e-6 * width))
                fail_msg("case %d: the extremes of %s are %.3g above and %.3g below %.12g, %.12g",
                         i, names[j], above, below, most[j], least[j]);
            assert_int_equal(fourlink_results_row(r, FOURLINK_OPEN, 1, NULL, &now, NULL),
                             FOURLINK_OK);
            assert_int_equal(fourlink_results_find(r, names[j], &found), FOURLINK_OK);
            assert_int_equal(fourlink_results_size(r, found.handle, &now, &size), FOURLINK_OK);
            assert_true(size > 0 && 1e-9 * size < width);
        }
        assert_int_equal(fourlink_results_find(r, "Ts", &found), FOURLINK_OK);
        assert_int_equal(fourlink_results_size(r, found.handle, &now, &size),
                         FOURLINK_NO_SUCH_NAME);
        fourlink_results_free(r);
    }
}

/* 1 if a row at the angle of an extreme has its value or, where there is none, one just beside it nearly. */
static int is_attained(fourlink_results *r, fourlink_branch branch, const fourlink_value *x)
{
    static const double beside[] = {0, -1e-8, 1e-8}, close[] = {1e-5, 1e-2, 1e-2};
    double value;
    size_t i;

    for (i = 0; i < COUNT(beside); i++)
        if (fourlink_results_at(r, branch, x->angle + beside[i], &value, NULL, NULL) ==
                FOURLINK_OK &&
            !isnan(value))
            return fabs(value - x->value) <= close[i];
    return 0;
}

/* The structural error of function generators over a motion that is longer than their range: no row within it,
** nor at its ends, is better. */
TEST(test_structural_errors)
{
    enum { ROWS = 2000 };
    static const char *const functions[] = {"log10", "exp", "sin", "sqrt"};
    uint64_t seed = 5;
    int i, j, tried = 0;

    for (i = 0; i < some_of(3000); i++) {
        double crank = uniform(&seed, -180, 180), range = uniform(&seed, 20, 150);
        double rocker = uniform(&seed, 0, 360), swing = uniform(&seed, -100, 100);
        double x = uniform(&seed, 0.1, 0.7), from = uniform(&seed, -200, 200), angle;
        double right[2] = {-INFINITY, INFINITY}, value;
        const char *deck =
            print("mechanism = four-bar\n[ground]\nlength = 100 mm\n[synthesis]\ntask = function\n"
                  "function = %s\nx = %.17g to %.17g\ncrank = %.17g to %.17g deg\n"
                  "rocker = %.17g to %.17g deg\n[motion]\nspeed = 1 rad/s\nfrom = %.17g deg\n"
                  "to = %.17g deg\n[table]\ncolumns = structural_error\n",
                  functions[i % 4], x, x + uniform(&seed, 0.2, 0.8), crank, crank + range, rocker,
                  rocker + swing, from, from + 400);
        fourlink_source source = deck_source(deck);
        fourlink_value most, least;
        fourlink_branch branch;
        fourlink_results *r;

        source.synthesis = 1;
        if (fourlink_results_open(&source, 0, &r, NULL, NULL) != FOURLINK_OK)
            continue;
        branch = fourlink_results_value(r, "max(structural_error)", FOURLINK_OPEN, 0, &most) ==
                         FOURLINK_OK
                     ? FOURLINK_OPEN
                     : FOURLINK_CROSSED; /* of the linkage found */
        if (fourlink_results_value(r, "max(structural_error)", branch, 0, &most) == FOURLINK_OK &&
            fourlink_results_value(r, "min(structural_error)", branch, 0, &least) == FOURLINK_OK) {
            for (j = 0; j < 4 * ROWS + 4; j++) {
                angle = j < 4 * ROWS ? from + j * 0.05 : crank + j % 2 * range + j / 2 % 2 * 180;
                angle += 360 * ceil((from - angle) / 360);
                if (fourlink_results_at(r, branch, angle, &value, NULL, NULL) != FOURLINK_OK)
                    continue;
                right[0] = value > right[0] ? value : right[0];
                right[1] = value < right[1] ? value : right[1];
            }
            if (right[0] > 170 || right[1] < -170) { /* an angle goes on beyond 180 deg */
                fourlink_results_free(r);
                continue;
            }
            if (!(most.value >= right[0] - 1e-9 && least.value <= right[1] + 1e-9 &&
                  is_attained(r, branch, &most) && is_attained(r, branch, &least)))
                fail_msg("case %d: from %.12g to %.12g, not %.12g to %.12g\n%s", i, least.value,
                         most.value, right[1], right[0], deck);
            tried++;
        }
        fourlink_results_free(r);
    }
    assert_true(tried > i / 4);
}

/* A direction can make nearly a whole turn between two samples, where its vector goes around the origin.  Beside the outer
** dead centre a piston's force K and a torque T on the rod, without masses, give
**
**    F34 = (-K, (T / l - K sin(theta3)) / cos(theta3)),   K = k0 + (k1 - k0) x / x1,   T = t v / v1
**
** where K passes through 0 ever closer to the dead centre.  Against dense places, closer and closer to that. */
typedef struct turning {
    double r, l, k0, k1, t; /* m, N, N m */
} turning;

static double direction_of(const turning *m, double theta)
{
    double s = m->r / m->l * sin(theta), c = sqrt(1 - s * s);
    double x = 2 * m->r * pow(sin(theta / 2), 2) + m->l * s * s / (1 + c);
    double v = m->r * sin(theta) + m->l * s * (m->r / m->l) * cos(theta) / c; /* at 1 rad/s */
    double K = m->k0 + (m->k1 - m->k0) * x;

    return atan2((m->t * v / m->l + K * s) / c, -K) * 180 / PI;
}

static double range_of_direction(const turning *m, double from, double to)
{
    double angle = 0, last = 0, least = 0, most = 0, theta, now;
    int i;

    for (i = -4000; i <= 4000; i++) {
        theta = (i < 0 ? from : to) * pow(10, -7 + 7 * abs(i) / 4000.0) * (i != 0);
        now = direction_of(m, theta);
        angle += i > -4000 ? remainder(now - last, 360) : 0;
        last = now;
        least = fmin(least, angle);
        most = fmax(most, angle);
    }
    return most - least;
}

TEST(test_whole_turns_of_a_direction)
{
    uint64_t seed = 8;
    int i, turns = 0;

    for (i = 0; i < some_of(4000); i++) {
        turning m;
        double from = uniform(&seed, -90, -10), to = uniform(&seed, 10, 90), right, found;
        fourlink_results *r;

        m.r = uniform(&seed, 0.02, 0.2);
        m.l = m.r * uniform(&seed, 1.2, 6);
        m.k0 = pow(10, uniform(&seed, -6, 0)) * (uniform(&seed, -1, 1) < 0 ? -1 : 1);
        m.k1 = (m.k0 < 0 ? 10 : -10) * uniform(&seed, 0.1, 1);
        m.t = pow(10, uniform(&seed, -3, 0)) * (uniform(&seed, -1, 1) < 0 ? -1 : 1);
        r = opened(print("mechanism = slider-crank\n[crank]\nlength = %.17g m\n[rod]\n"
                         "length = %.17g m\n[load T]\nlink = rod\nover = v\ntorque = %.17g N m\n"
                         "at_speed = 1 m/s\nexponent = 1\n[load K]\nlink = piston\nover = x\n"
                         "force = 0 m %.17g N, 1 m %.17g N\n[gravity]\nacceleration = 0\n[motion]\n"
                         "speed = 1 rad/s\nfrom = %.17g deg\nto = %.17g deg\n[table]\n"
                         "columns = F34_dir\n",
                         m.r, m.l, m.t, m.k0, m.k1, from, to));
        right = range_of_direction(&m, from * PI / 180, to * PI / 180);
        found = value_at(r, "max(F34_dir)", 0) - value_at(r, "min(F34_dir)", 0);
        turns += right > 300;
        if (!(fabs(found - right) <= 0.05))
            fail_msg("case %d: a range of %.12g deg, not %.12g", i, found, right);
        fourlink_results_free(r);
    }
    assert_true(turns > i / 20);
}

/* A load over a speed has its greatest value at the speed that its curve says, however narrow that is and however the
** crank's speed changes. */
TEST(test_corners_of_a_speed)
{
    static const char *const motions[] = {
        "speed = 10 rad/s\nacceleration = %.17g rad/s2\nfrom = %.17g deg\nto = %.17g deg\n",
        "acceleration = %.17g rad/s2\nfrom = %.17g deg\nrun_up = %.17g deg\n"};
    uint64_t seed = 9;
    int i;

    for (i = 0; i < some_of(2000); i++) {
        double from = uniform(&seed, -180, 180), to = from + uniform(&seed, 300, 720);
        double width = pow(10, uniform(&seed, -6, -1)), most = uniform(&seed, 1, 100), v;
        const char *machine = "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\n"
                              "length = 170 mm\n[motion]\n";
        const char *motion =
            print(motions[i % 2], uniform(&seed, 1, i % 2 ? 90 : 9), from, i % 2 ? to - from : to);
        fourlink_results *r = opened(print("%s%s", machine, motion));
        double angle = from + (to - from) * uniform(&seed, 0.05, 0.95), found;

        v = value_at(r, "v", angle);
        fourlink_results_free(r);
        r = opened(print("%s%s[load K]\nlink = piston\nover = v\nforce = %.17g m/s %.17g N, "
                         "%.17g m/s %.17g N, %.17g m/s %.17g N\n",
                         machine, motion, v - width, 0.5 * most, v, most, v + 2 * width,
                         0.2 * most));
        found = value_at(r, "min(F34x)", 0);
        if (!(fabs(found + most) <= 1e-9 * most))
            fail_msg("case %d: min(F34x) is %.12g, not %.12g: at %.12g m/s", i, found, -most, v);
        fourlink_results_free(r);
    }
}

/* The shaking force of a crank alone is m e omega2^2 at each angle, also beside a place where friction locks the machine and
** the pin forces, of which it is the sum, grow without bound: that must not be rounding error. */
TEST(test_shaking_force_beside_locks)
{
    uint64_t seed = 10;
    int i, k, locked = 0;

    for (i = 0; i < some_of(1500); i++) {
        double d = uniform(&seed, 40, 60), a = i % 3 ? uniform(&seed, 5, 30) : d;
        double b = i % 3 ? uniform(&seed, 20, 80) : uniform(&seed, 20, 60), right;
        double c = i % 3 ? uniform(&seed, fmax(5, fabs(b - d)), b + d) : b,
               speed = uniform(&seed, 1, 20);
        double mass = uniform(&seed, 0.1, 3), cg = uniform(&seed, 0.5, 5);
        fourlink_branch branch = i % 2 ? FOURLINK_OPEN : FOURLINK_CROSSED;
        fourlink_value most, least, force;
        fourlink_results *r;
        const char *deck =
            print("mechanism = four-bar\n[ground]\nlength = %.17g mm\n[crank]\nlength = %.17g "
                  "mm\nmass = %.17g kg\ninertia = 0.001 kg m2\ncg = %.17g mm\n[coupler]\n"
                  "length = %.17g mm\n[rocker]\nlength = %.17g mm\n[gravity]\n"
                  "acceleration = 0\n[motion]\nspeed = %.17g rad/s\nfrom = %.17g deg\nto = "
                  "400 deg\n[load T]\nlink = rocker\ntorque = %.17g N m\n[friction]\n"
                  "mu = %.17g\nradius = %.17g mm\n[table]\ncolumns = Fs, F34\n",
                  d, a, mass, cg, b, c, speed, uniform(&seed, 0, 40), uniform(&seed, -9, 9),
                  uniform(&seed, 0.05, 0.6), uniform(&seed, 3, 20));

        r = opened(deck);
        right = mass * cg / 1000 * speed * speed;
        if (fourlink_results_value(r, "max(F34)", branch, 0, &force) == FOURLINK_OK) {
            locked += isinf(force.value);
            most = named(r, "max(Fs)", branch, 0);
            least = named(r, "min(Fs)", branch, 0);
            for (k = 0; k < 2; k++)
                if (!(fabs((k ? most : least).value - right) <= 1e-6 * right))
                    fail_msg("case %d: an extreme of Fs is %.12g at %.12g, not %.12g\n%s", i,
                             (k ? most : least).value, (k ? most : least).angle, right, deck);
        }
        fourlink_results_free(r);
    }
    assert_true(locked > i / 10);
}

int main(void)
{
    return run_all_tests(NULL);
}
