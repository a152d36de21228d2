/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_extreme_cases.c - extremes of decks whose right values are known.
*/
#include "check.h"
#include "fourlink.h"

static fourlink_results *open_results(const char *deck)
{
    fourlink_results *results;
    fourlink_source source;

    memset(&source, 0, sizeof source);
    source.text = deck;
    source.length = strlen(deck);
    assert_int_equal(fourlink_results_open(&source, 0, &results, NULL, NULL), FOURLINK_OK);
    return results;
}

static double extreme(const char *deck, fourlink_branch branch, const char *name, double *angle)
{
    fourlink_results *results = open_results(deck);
    fourlink_value value;

    assert_int_equal(fourlink_results_value(results, name, branch, 0, &value), FOURLINK_OK);
    fourlink_results_free(results);
    if (angle)
        *angle = value.angle;
    return value.value;
}

static void check(const char *deck, fourlink_branch branch, const char *name, double right,
                  double tolerance)
{
    double value = extreme(deck, branch, name, NULL);

    if (!(fabs(value - right) <= tolerance) && value != right)
        fail_msg("%s is %.12g, not %.12g", name, value, right);
}

#define CRANK_ROCKER                                                                     \
    "mechanism = four-bar\n[ground]\nlength = 80 mm\n"                                   \
    "[crank]\nlength = 20 mm\nmass = 0.1 kg\ngyration = 8 mm\ncg = 10 mm\n"              \
    "[coupler]\nlength = 66 mm\nmass = 0.3 kg\ngyration = 25 mm\ncg = 30 mm at 10 deg\n" \
    "[rocker]\nlength = 56 mm\nmass = 0.25 kg\ngyration = 20 mm\ncg = 28 mm at -5 deg\n" \
    "[motion]\ninterval = 40 deg\n"

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

/* The corners of a load move no direction that has nothing to do with it. */
TEST(test_corners)
{
    static const char deck[] = CRANK_ROCKER
        "speed = 10.5 rad/s\n"
        "[load]\nlink = rocker\ntorque = 7 deg 0.5 N m, 178 deg 0.4 N m, 266 deg 0.6 N m\n";

    check(deck, FOURLINK_OPEN, "max(Fi2_dir)", 360, 1e-9);
    check(deck, FOURLINK_OPEN, "min(Fi2_dir)", 0, 1e-9);
}

/* omega3 of a deltoid goes from 2.5 to 7.5 rad/s through its change point; |alpha3| reaches 25 / sqrt(3). */
TEST(test_deltoid)
{
    static const char deck[] =
        "mechanism = four-bar\n[ground]\nlength = 1 m\n[crank]\nlength = 1 m\n"
        "[coupler]\nlength = 2 m\n[rocker]\nlength = 2 m\n"
        "[motion]\nspeed = 10 rad/s\n";

    check(deck, FOURLINK_OPEN, "max(omega3)", 7.5, 7.5e-9);
    check(deck, FOURLINK_OPEN, "min(omega3)", 2.5, 7.5e-9);
    check(deck, FOURLINK_OPEN, "max(alpha3)", 25 / sqrt(3), 2e-8);
}

/* A parallelogram with masses: forces grow without end towards its change points. */
TEST(test_parallelogram)
{
    static const char deck[] =
        "mechanism = four-bar\n[ground]\nlength = 2 m\n[crank]\nlength = 1 m\nmass = 1 kg\n"
        "[coupler]\nlength = 2 m\nmass = 1 kg\ncg = 1 m\n[rocker]\nlength = 1 m\nmass = 1 kg\n"
        "[motion]\nspeed = 10 rad/s\n";

    check(deck, FOURLINK_OPEN, "max(F12x)", INFINITY, 0);
    check(deck, FOURLINK_OPEN, "min(F12x)", -INFINITY, 0);
    check(deck, FOURLINK_OPEN, "max(Ts)", 9.81, 1e-8);
}

/* A constant column has its extremes at the first row, though rounding makes it vary. */
TEST(test_constant)
{
    static const char deck[] =
        "mechanism = four-bar\n[ground]\nlength = 1 m\nangle = -14.3 deg\n[crank]\nlength = 2.25 "
        "m\n"
        "mass = 4 kg\n[coupler]\nlength = 1 m\nmass = 3 kg\n[rocker]\nlength = 2.25 m\nmass = 5 "
        "kg\n"
        "inertia = 3 kg m2\n[gravity]\nacceleration = 0\n[motion]\nspeed = 16.7 rad/s\n"
        "acceleration = -40 rad/s2\nfrom = %d deg\nto = 160 deg\ninterval = 7 deg\n";
    static const char *const names[] = {"max(alpha4)", "min(alpha4)", "max(alpha2)", "min(alpha2)"};
    static const int first[] = {0, 10};
    size_t i, k;

    for (k = 0; k < 2; k++)
        for (i = 0; i < 4; i++) {
            char text[sizeof deck];
            fourlink_source source;
            fourlink_results *results;
            fourlink_value value;

            memset(&source, 0, sizeof source);
            sprintf(text, deck, first[k]);
            source.text = text;
            source.length = strlen(text);
            assert_int_equal(fourlink_results_open(&source, 0, &results, NULL, NULL), FOURLINK_OK);
            assert_int_equal(fourlink_results_value(results, names[i], FOURLINK_OPEN, 0, &value),
                             FOURLINK_OK);
            fourlink_results_free(results);
            assert_true(fabs(value.value + 40) <= 1e-6);
            assert_true(value.angle == first[k]);
        }
}

/* Fsy = weight and inertia of the rod, bounded at the dead positions: its limits. */
TEST(test_limits)
{
    static const char deck[] =
        "mechanism = slider-crank\n[crank]\nlength = 500 mm\n"
        "[rod]\nlength = 400 mm\nmass = 1 kg\ncg = 200 mm\ninertia = 0.01 kg m2\n"
        "[piston]\nmass = 1 kg\n[motion]\nspeed = 10 rad/s\n";

    check(deck, FOURLINK_OPEN, "max(Fsy)", 0.38, 4e-8);
    check(deck, FOURLINK_OPEN, "min(Fsy)", -39.62, 4e-8);
}

/* The first reach of this slider-crank is 0.031 deg long.  The crank's mass m at distance x gives
** Fsy = -m x (alpha cos(theta2) - omega2^2 sin(theta2)): at rest -m x alpha; at the constant speed after the run-up it
** is largest at an end of reach, where sin(theta2) = (l + e) / r.  Forces grow without end there. */
TEST(test_short_reach)
{
    static const char deck[] =
        "mechanism = slider-crank\n[ground]\noffset = -0.728924815289952 m\n"
        "[crank]\nlength = 1.4578496305799 m\nmass = 4.6 kg\ninertia = 0.1 kg m2\ncg = 0.6 m\n"
        "[rod]\nlength = 0.729714747386441 m\n[piston]\nmass = 3.5 kg\n[gravity]\nacceleration = 0 "
        "m/s2\n"
        "[motion]\nrun_up = 24 deg\nacceleration = 7 rad/s2\ninterval = 26 deg\n";
    double mx = 4.6 * 0.6, square = 2 * 7 * 24 * acos(-1) / 180;

    check(deck, FOURLINK_OPEN, "min(Fsy)", -mx * 7, 1e-8);
    check(deck, FOURLINK_OPEN, "max(Fsy)",
          mx * square * (0.729714747386441 - 0.728924815289952) / 1.4578496305799, 1e-8);
    check(deck, FOURLINK_OPEN, "max(F34)", HUGE_VAL, 0);
}

/* The lever turns as fast as the crank where I24 is at infinity: here at 270 deg, at a sample of the search. */
TEST(test_pole_at_sample)
{
    static const char deck[] = "mechanism = inverted-slider-crank\n[ground]\nlength = 0.5 m\n"
                               "[crank]\nlength = 1 m\n[lever]\noffset = 0.5 m\n"
                               "[motion]\nspeed = 16 rad/s\ninterval = 14 deg\n";

    check(deck, FOURLINK_CROSSED, "max(I24x)", HUGE_VAL, 0);
    check(deck, FOURLINK_CROSSED, "min(I24x)", -HUGE_VAL, 0);
}

/* A direction that is 0 or 180 deg leaps by half a turn and adds up to no more. */
TEST(test_half_turns)
{
    static const char deck[] = "mechanism = slider-crank\n[crank]\nlength = 1\n[rod]\nlength = 3\n"
                               "[piston]\nmass = 1 kg\n[motion]\nspeed = 10 rad/s\n";

    check(deck, FOURLINK_OPEN, "max(Fi4_dir)", 180, 1e-9);
    check(deck, FOURLINK_OPEN, "min(Fi4_dir)", 0, 1e-9);
}

/* Time has extremes, and a point's beside an edge of reach. */
TEST(test_time_and_edge)
{
    static const char turn[] = CRANK_ROCKER "speed = 10.5 rad/s\n";
    static const char edge[] =
        "mechanism = four-bar\n[ground]\nlength = 2\n[crank]\nlength = 1\n[coupler]\nlength = 1\n"
        "[rocker]\nlength = 0.204\n[point P]\nlink = coupler\nat = (-0.02, -0.38)\n"
        "[motion]\nspeed = -10 rad/s\nfrom = 134 deg\nto = -143 deg\n";

    check(turn, FOURLINK_OPEN, "max(time)", 2 * 3.14159265358979323846 / 10.5, 1e-12);
    check(turn, FOURLINK_OPEN, "min(time)", 0, 0);
    check(edge, FOURLINK_CROSSED, "min(P.y)", -0.820561910932, 1e-9);
}

/* Dips and peaks that are narrow, or end at a corner. */
TEST(test_narrow)
{
    static const char reach[] = "mechanism = four-bar\n"
                                "[ground]\n"
                                "angle = -6.726812605020285 deg\n"
                                "length = 1.0320965500849555 m\n"
                                "[crank]\n"
                                "mass = 2.570515835766012 kg\n"
                                "length = 0.764685789204601 m\n"
                                "inertia = 0.1491458283064716 kg m2\n"
                                "cg = (0.5390892708412428, -0.0) m\n"
                                "[coupler]\n"
                                "mass = 0.5557117208371162 kg\n"
                                "length = 0.4535513727408943 m\n"
                                "inertia = 0.004727266227977656 kg m2\n"
                                "cg = (0.4345463880379983, 0.0) m\n"
                                "[rocker]\n"
                                "mass = 1.3237426997854962 kg\n"
                                "length = 0.7210593716166235 m\n"
                                "inertia = 0.013011288697305376 kg m2\n"
                                "cg = (0.13063466333940577, 0.0) m\n"
                                "[load L0]\n"
                                "link = coupler\n"
                                "force = (188.95193064728397, 29.716140891333907) N\n"
                                "frame = link\n"
                                "at = (0.26182027905910865, -0.0009757484535074019) m\n"
                                "[load L1]\n"
                                "link = coupler\n"
                                "force = (-30.648814243170705, 241.8378804741011) N\n"
                                "frame = link\n"
                                "at = (-0.026098878592215533, 0.26030021844664775) m\n"
                                "torque = 49.9721459608884 N m\n"
                                "from = 282.3614960363529 deg\n"
                                "to = 465.09605162692276 deg\n"
                                "[gravity]\n"
                                "acceleration = 9.81 m/s2\n"
                                "direction = 103.02789512960692 deg\n"
                                "[motion]\n"
                                "speed = 3.61906961867345 rad/s\n"
                                "acceleration = 0.0 rad/s2\n"
                                "from = 0.0 deg\n"
                                "cycle = 360.0 deg\n"
                                "interval = 7.0 deg\n"
                                "[point P]\n"
                                "link = coupler\n"
                                "at = (0.2984467596219258, 0.8451151811896607) m\n"
                                "[flywheel]\n"
                                "fluctuation = 0.015490975306669486\n";
    static const char gas[] =
        "mechanism = slider-crank\n"
        "[ground]\n"
        "angle = -170.78519543292037 deg\n"
        "offset = 0.06914374696733616 m\n"
        "[crank]\n"
        "mass = 4.292412073257868 kg\n"
        "length = 0.12386927548697044 m\n"
        "inertia = 0.0031769707008368854 kg m2\n"
        "cg = (0.023276104537238045, -0.01299981693621622) m\n"
        "[rod]\n"
        "mass = 2.1180715059865616 kg\n"
        "length = 0.27299751626362356 m\n"
        "inertia = 0.013276796325834948 kg m2\n"
        "cg = (0.24135202091227353, 0.011113596643165252) m\n"
        "[piston]\n"
        "mass = 1.6892417584944353 kg\n"
        "[gas]\n"
        "bore = 0.04994834258465638 m\n"
        "indicator = 26.0 deg 716216.1260691661 Pa, 100.0 deg 2412640.400004365 Pa, 103.0 deg "
        "1877951.9900782926 Pa, 107.0 deg 2711187.406172421 Pa, 112.0 deg 741769.3855575718 Pa, "
        "122.0 deg 205591.21365967736 Pa, 214.0 deg 2206371.2997827632 Pa, 218.0 deg "
        "27079.981173698365 Pa, 263.0 deg 256886.35590783693 Pa, 283.0 deg 163268.15471524614 Pa, "
        "326.0 deg 771138.9792603072 Pa\n"
        "[gravity]\n"
        "acceleration = 9.81 m/s2\n"
        "direction = -90.0 deg\n"
        "[motion]\n"
        "speed = -25.144504814052397 rad/s\n"
        "acceleration = 0.0 rad/s2\n"
        "from = 0.0 deg\n"
        "cycle = 360.0 deg\n"
        "interval = 7.0 deg\n";
    static const char tracer[] = "mechanism = four-bar\n"
                                 "[ground]\n"
                                 "angle = -29.958244742325093 deg\n"
                                 "length = 0.3403878587281983 m\n"
                                 "[crank]\n"
                                 "mass = 0.6009539169842786 kg\n"
                                 "length = 0.6722222443670659 m\n"
                                 "inertia = 0.0583726703547865 kg m2\n"
                                 "cg = (0.4549897310869442, -0.048149882007173045) m\n"
                                 "[coupler]\n"
                                 "mass = 4.28764189654826 kg\n"
                                 "length = 0.8084188327462166 m\n"
                                 "inertia = 0.6745832514535792 kg m2\n"
                                 "cg = (0.27723552038155586, 0.06277057958367287) m\n"
                                 "[rocker]\n"
                                 "mass = 2.571727510186647 kg\n"
                                 "length = 0.4765817929047379 m\n"
                                 "inertia = 0.07308283473385263 kg m2\n"
                                 "cg = (0.3409790596145616, -0.0) m\n"
                                 "[load L0]\n"
                                 "link = crank\n"
                                 "force = (37.1773187372217, -67.35946296385669) N\n"
                                 "frame = ground\n"
                                 "at = (0.6437915553952994, -0.0011717114863213454) m\n"
                                 "torque = -7.126751410891707 N m\n"
                                 "[gravity]\n"
                                 "acceleration = 0.0 m/s2\n"
                                 "direction = -90.0 deg\n"
                                 "[motion]\n"
                                 "speed = -16.142402803881097 rad/s\n"
                                 "acceleration = -6.7827815583347695 rad/s2\n"
                                 "from = 0.0 deg\n"
                                 "cycle = 360.0 deg\n"
                                 "interval = 30.0 deg\n"
                                 "to = -187.55514505904898 deg\n"
                                 "[point P]\n"
                                 "link = coupler\n"
                                 "at = (0.33890783768366717, 0.6604693051180925) m\n"
                                 "[flywheel]\n"
                                 "inertia = 22.435025296873096 kg m2\n";

    check(reach, FOURLINK_OPEN, "min(F34)", 16.3785567558, 2e-7);
    check(gas, FOURLINK_CROSSED, "min(F12)", 27.6747598507, 1e-6);
    check(tracer, FOURLINK_OPEN, "max(P.x)", 0.330205256025, 1e-9);
}

/* No row is beyond the extremes of its column. */
#define COLUMNS 8

static void check_rows(const char *deck, fourlink_branch branch)
{
    fourlink_results *results = open_results(deck);
    const fourlink_value *columns;
    fourlink_value max[COLUMNS], min[COLUMNS];
    double values[COLUMNS];
    unsigned long n, rows = 0, i, c;
    char name[64];

    assert_int_equal(fourlink_results_list(results, FOURLINK_COLUMNS, &columns, &n), FOURLINK_OK);
    assert_true(n <= COLUMNS);
    for (c = 0; c < n; c++) {
        snprintf(name, sizeof name, "max(%s)", columns[c].name);
        assert_int_equal(fourlink_results_value(results, name, branch, 0, &max[c]), FOURLINK_OK);
        memcpy(name, "min", 3);
        assert_int_equal(fourlink_results_value(results, name, branch, 0, &min[c]), FOURLINK_OK);
    }
    for (i = 0; i <= 36000; i++) {
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
    assert_in_range(rows, 1000, 35000); /* the mechanism locks */
    fourlink_results_free(results);
}

static double angle_of(const char *deck, const char *name)
{
    double angle;

    extreme(deck, FOURLINK_OPEN, name, &angle);
    return angle;
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

/* The crank angle towards which a linkage is free, between one at which it is and one at which friction locks it. */
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

/* Where friction locks within 0.0005 deg of a dead position, or less, Ts grows as the inverse of the distance, and the
** torque without friction ends at the value of the last row. */
TEST(test_lock_near_dead)
{
    static const double parts[] = {1, 0.5, 0.25, 0.17, 0.1, 0.03};
    static const char *const names[] = {"max(Ts)", "max(F12y)", "max(F34)"};
    double last[COLUMNS], near[COLUMNS], nearer[COLUMNS], lock;
    fourlink_results *results;
    char deck[1000];
    size_t i, k;

    for (i = 0; i < sizeof parts / sizeof *parts; i++) {
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
        results = open_results(deck);
        lock = lock_of(results, 313, 313.28547255);
        fourlink_results_at(results, FOURLINK_OPEN, lock - 4e-8, near, NULL, NULL);
        fourlink_results_at(results, FOURLINK_OPEN, lock - 1e-8, nearer, NULL, NULL);
        fourlink_results_at(results, FOURLINK_OPEN, lock, last, NULL, NULL);
        fourlink_results_free(results);
        assert_true(nearer[0] > 3 * near[0] && nearer[3] < 1.2 * near[3]);
        for (k = 0; k < sizeof names / sizeof *names; k++) {
            check(deck, FOURLINK_OPEN, names[k], HUGE_VAL, 0);
            check(deck, FOURLINK_CROSSED, names[k], HUGE_VAL, 0);
        }
        if (parts[i] == 1)
            check(deck, FOURLINK_OPEN, "max(Ts0)", last[3], 1e-6 * last[3]);
    }
}

/* Towards such a range a piston stays where it is, beside the dead position: C is at most r + l from A. */
TEST(test_stroke_to_lock)
{
    static const char deck[] =
        "solver = dyad\nmechanism = slider-crank\n[crank]\nlength = 0.467\n"
        "[rod]\nlength = 0.229\nmass = 1.49\ngyration = 0.0414\n[piston]\nmass = 0.477\n"
        "[gravity]\n[friction]\nA = 0.333\nradius_A = 0.00089\nB = 0.14\nradius_B = 0.0023\n"
        "C = 0.209\nradius_C = 0.00091\n[load P]\nlink = piston\nforce = -146.6\n"
        "[motion]\nspeed = 18.8\n[table]\ncolumns = x, C.x, Ts, efficiency\n";

    check(deck, FOURLINK_OPEN, "min(x)", 0, 1e-9);
    check(deck, FOURLINK_OPEN, "max(C.x)", 0.467 + 0.229, 1e-9);
    check(deck, FOURLINK_OPEN, "min(C.x)", -sqrt(0.467 * 0.467 - 0.229 * 0.229), 1e-6);
    check(deck, FOURLINK_OPEN, "min(efficiency)", 0, 1e-6);
    check(deck, FOURLINK_OPEN, "max(Ts)", HUGE_VAL, 0);
}

/* A free motion that repeats itself has its extremes in its first turn, though the integration makes a later one
** larger by its error.  Below, 3 kg m2 have fallen 7 kg m: 3/2 (omega2^2 - 1) = 7 g. */
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

int main(void)
{
    return run_all_tests(NULL);
}
