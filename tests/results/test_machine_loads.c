/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_machine_loads.c - decks with springs, dampers, friction, loads over positions and speeds, and
** counterweights: balances, extremes and means against dense scans, and mistakes.
*/
#include "machines.h"

#define MOVING_ROCKER ROCKER "[motion]\nspeed = 10.5 rad/s\n"

#define SPRINGS                                                                                \
    "[spring S]\nlink = rocker\nat = (40, 10) mm\nto = ground\nto_at = (100, 90) mm\n"         \
    "stiffness = 0.8 N/mm\nfree_length = 50 mm\npreload = 3 N\ndamping = 12 N s/m\n"           \
    "[spring T]\nlink = coupler\nat = (50, 20) mm\nto = crank\nto_at = 5 mm\nstiffness = 150 " \
    "N/m\n"                                                                                    \
    "free_length = 30 mm\ndamping = 2.5 N s/m\n"                                               \
    "[spring U]\nlink = rocker\nto = ground\nstiffness = 1.5 N m/rad\nfree_angle = 100 deg\n"  \
    "preload = 0.1 N m\ndamping = 0.02 N m s/rad\n"                                            \
    "[spring V]\nlink = rocker\nto = coupler\nstiffness = 0.4 N m/rad\nfree_angle = 60 deg\n"  \
    "damping = 0.005 N m s/rad\n"

#define PINS                                                                                       \
    "[load L]\nlink = rocker\ntorque = 0.5 N m\n[friction]\nA = 0.1\nB = 0.1\nC = 0.1\nD = 10 %\n" \
    "radius_A = 6 mm\nradius_B = 6 mm\nradius_C = 6 mm\nradius_D = 6 mm\n"

#define LEVER_AT_WORK                                                                              \
    "mechanism = inverted-slider-crank\n[ground]\nlength = 240 mm\n[crank]\nlength = 120 mm\n"     \
    "mass = 0.8 kg\ninertia = 0.0015 kg m2\ncg = (50, 4) mm\n[slider]\nmass = 0.3 kg\n"            \
    "inertia = 0.00012 kg m2\ncg = (2, -1) mm\n[lever]\nmass = 2.5 kg\ninertia = 0.035 kg m2\n"    \
    "cg = (210, 12) mm\n[motion]\nspeed = 10 rad/s\n[load L]\nlink = lever\nforce = (-150, 0) N\n" \
    "at = (450, 0) mm\n"

#define LEVER                                                                                   \
    LEVER_AT_WORK "[friction]\nA = 0.1\nB = 0.1\nD = 0.1\nradius_A = 15 mm\nradius_B = 10 mm\n" \
                  "radius_D = 20 mm\nguide = 0.12\nguide_length = 50 mm\n"

#define GAS "[gas]\nbore = 40 mm\npressure = 3 bar\n"

#define MOVING_PUMP PUMP "[motion]\nspeed = 14 rad/s\n"

#define PUMP_FRICTION                                                                       \
    "[friction]\nguide = 0.1\nguide_length = 60 mm\nA = 0.05\nradius_A = 20 mm\nC = 0.08\n" \
    "radius_C = 10 mm\nB = 0.05\nradius_B = 15 mm\n"

static double value(fourlink_results *r, const char *name, double angle)
{
    return si_value(r, name, FOURLINK_OPEN, angle);
}

/* The shaking moment of springs and friction: the ground's part of all torques about A, by the balance
** of the whole machine, which is at rest and without weight: then forces and moments on the ground are
** those of the loads. */
TEST(test_shaking_moment)
{
    fourlink_results *r = opened(
        "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n[coupler]\n"
        "length = 66 mm\n[rocker]\nlength = 56 mm\n[gravity]\nacceleration = 0\n" SPRINGS PINS);

    assert_near(value(r, "Fs", 50), 0, 1e-13);
    assert_close(value(r, "Ms", 50), 0.5,
                 1e-12); /* the load brings 0.5 N m in, Ts is the ground's */
    fourlink_results_free(r);
    r = opened("mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n"
               "[gravity]\nacceleration = 0\n[load L]\nlink = crank\ntorque = 3 N m\n"
               "[load P]\nlink = piston\nforce = -100 N\n" PUMP_FRICTION);
    assert_close(value(r, "Fsx", 50), -100.0, 1e-12);
    assert_near(value(r, "Fsy", 50), 0, 1e-12);
    assert_close(value(r, "Ms", 50), 3.0, 1e-12);
    fourlink_results_free(r);
}

static double cross(double ax, double ay, double bx, double by)
{
    return ax * by - ay * bx;
}

/* F34 is all that the slider exerts on the lever, but for the gas: the lever and the slider are in
** balance with the table's own columns, and the guide loses what friction takes. */
static void check_contact(fourlink_results *r, double angle, double gas)
{
    static const double d = 0.24, g = 9.81, m3 = 0.3, I3 = 0.00012, m4 = 2.5, I4 = 0.035, L = -150;
    double F34x = value(r, "F34x", angle), F34y = value(r, "F34y", angle);
    double M34 = value(r, "M34", angle), t = value(r, "theta4", angle);
    double slide = value(r, "theta3", angle), ux = cos(slide), uy = sin(slide);
    double Bx = value(r, "B.x", angle), By = value(r, "B.y", angle);
    double rx = value(r, "G4.x", angle) - d, ry = value(r, "G4.y", angle);
    double m4ax = m4 * value(r, "G4.ax", angle), m4ay = m4 * (value(r, "G4.ay", angle) + g);
    double sx = value(r, "G3.x", angle) - Bx, sy = value(r, "G3.y", angle) - By;
    double m3ax = m3 * value(r, "G3.ax", angle), m3ay = m3 * (value(r, "G3.ay", angle) + g);
    double w2 = value(r, "omega2", angle), w3 = value(r, "omega3", angle);
    double w4 = value(r, "omega4", angle), v = value(r, "slide_v", angle), size, lost;

    size = 1e-11 * (hypot(F34x, F34y) + value(r, "F14", angle) + fabs(L) + fabs(gas));
    assert_near(F34x - gas * ux + value(r, "F14x", angle) + L, m4ax, size);
    assert_near(F34y - gas * uy + value(r, "F14y", angle), m4ay, size);
    assert_near(value(r, "F23x", angle) - F34x + gas * ux, m3ax, size);
    assert_near(value(r, "F23y", angle) - F34y + gas * uy, m3ay, size);
    assert_near(cross(Bx - d, By, F34x - gas * ux, F34y - gas * uy) + M34 -
                    copysign(value(r, "friction_D", angle), w4) +
                    cross(0.45 * cos(t), 0.45 * sin(t), L, 0),
                I4 * value(r, "alpha4", angle) + cross(rx, ry, m4ax, m4ay), size);
    assert_near(-M34 - copysign(value(r, "friction_B", angle), w3 - w2),
                I3 * value(r, "alpha3", angle) + cross(sx, sy, m3ax, m3ay), size);
    /* the normal force and the friction are its parts */
    assert_near(F34y * ux - F34x * uy, value(r, "N34", angle), size);
    lost = value(r, "friction_guide", angle) * fabs(v);
    assert_near((F34x * ux + F34y * uy) * v, lost, size);
    lost += value(r, "friction_A", angle) * fabs(w2) +
            value(r, "friction_B", angle) * fabs(w3 - w2) +
            value(r, "friction_D", angle) * fabs(w4);
    assert_near(value(r, "power_friction", angle), lost, 1e-11 * lost);
    assert_near(value(r, "residual", angle), 0, 1e-12);
    assert_near(value(r, "superposition", angle), 0, 1e-12);
    /* its other columns */
    assert_near(value(r, "F34", angle), hypot(F34x, F34y), size);
    assert_near(cos(value(r, "F34_dir", angle)) * hypot(F34x, F34y), F34x, size);
    assert_near(sin(value(r, "F34_dir", angle)) * hypot(F34x, F34y), F34y, size);
    assert_near(value(r, "F34_along", angle), F34x * cos(t) + F34y * sin(t), size);
    assert_near(value(r, "F34_across", angle), F34y * cos(t) - F34x * sin(t), size);
    assert_near(value(r, "F43_along", angle), -F34x * ux - F34y * uy, size);
    assert_near(value(r, "F43_across", angle), -F34y * ux + F34x * uy, size);
}

TEST(test_contact)
{
    static const char *const decks[] = {LEVER, "solver = dyad\n" LEVER, LEVER GAS};
    size_t i;
    int angle;

    for (i = 0; i < 3; i++) {
        fourlink_results *r = opened(decks[i]);

        for (angle = 5; angle < 360; angle += 10)
            check_contact(r, angle, i < 2 ? 0 : value(r, "gas_force", angle));
        fourlink_results_free(r);
    }
    for (i = 0; i < 2;
         i++) { /* of a piston N is without friction, and both parts make the whole too */
        fourlink_results *r =
            opened(i ? "solver = dyad\n" MOVING_PUMP PUMP_FRICTION : MOVING_PUMP PUMP_FRICTION);

        for (angle = 5; angle < 360; angle += 10)
            assert_near(value(r, "superposition", angle), 0, 1e-12);
        fourlink_results_free(r);
    }
}

/* ---------------------------------------------------------------------------------------------
** Over the motion
** ------------------------------------------------------------------------------------------- */

#define SCAN 7200
#define MOST_COLUMNS 10

/* Extremes and means of columns against rows at every 0.05 deg; an extreme may be beside a jump or between rows. */
static void compare_rows(const char *contents, const char *const *names, size_t n)
{
    double high[MOST_COLUMNS], low[MOST_COLUMNS], sum[MOST_COLUMNS] = {0}, row[MOST_COLUMNS];
    char deck[5000], text[80];
    const fourlink_value *columns;
    fourlink_results *r;
    unsigned long listed;
    size_t i, k;

    strcat(strcpy(deck, contents), "[table]\ncolumns =");
    for (k = 0; k < n; k++)
        strcat(strcat(deck, " "), names[k]);
    r = opened(strcat(deck, "\n"));
    fourlink_results_list(r, FOURLINK_COLUMNS, &columns, &listed);
    assert_int_equal(listed, n);
    for (i = 0; i < SCAN; i++)
        for (k = 0; k < n; k++) {
            double angle = ((double)i + 0.5) * 360 / SCAN, x;

            if (k == 0)
                assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, angle, row, NULL, NULL),
                                 FOURLINK_OK);
            x = row[k] * columns[k].to_si;
            high[k] = i ? fmax(high[k], x) : x;
            low[k] = i ? fmin(low[k], x) : x;
            sum[k] += x;
        }
    for (k = 0; k < n; k++) {
        double size = fmax(fabs(high[k]), fabs(low[k])), found;

        sprintf(text, "max(%s)", names[k]);
        found = value(r, text, 0);
        if (!(found >= high[k] - 1e-9 * size && found <= high[k] + 2e-3 * size))
            fail_msg("%s = %.12g, rows %.12g\n%s", text, found, high[k], contents);
        sprintf(text, "min(%s)", names[k]);
        found = value(r, text, 0);
        if (!(found <= low[k] + 1e-9 * size && found >= low[k] - 2e-3 * size))
            fail_msg("%s = %.12g, rows %.12g\n%s", text, found, low[k], contents);
        sprintf(text, "mean(%s)", names[k]);
        assert_near(value(r, text, 0), sum[k] / SCAN, 1e-5 * size);
    }
    fourlink_results_free(r);
}

TEST(test_scans)
{
    static const char *const columns[] = {"Ts",         "Ts0",        "power_friction",
                                          "friction_A", "friction_B", "F12x",
                                          "F34",        "Fs",         "efficiency"};
    static const char *const linear[] = {"S.force", "S.length"};
    static const char *const torsional[] = {"T.power", "U.angle", "V.torque", "V.energy"};
    static const char *const loads[] = {
        MOVING_PUMP
        "[load P]\nlink = piston\nover = x\nforce = 0 mm -100 N, 50 mm -300 N, 90 mm -900 N\n"
        "back = -50 N\n",
        MOVING_PUMP
        "[load P]\nlink = piston\nover = v\nforce = -300 N\nat_speed = 0.5 m/s\nexponent = 2\n",
        MOVING_ROCKER
        "[load L]\nlink = rocker\nover = omega4\ntorque = -5 rad/s 1 N m, 0 rad/s 0.1 N m, "
        "5 rad/s -2 N m\n",
        MOVING_ROCKER
        "[load L]\nlink = rocker\nover = theta4\ntorque = 110 deg 1 N m, 130 deg 2 N m, "
        "150 deg 1 N m\n",
        LEVER "[load K]\nlink = slider\nover = slide\nback = 20 N at 45 deg\n"
              "force = 150 mm 10 N at 30 deg, 250 mm 40 N at 90 deg, 300 mm (0, 0) N\n"};
    size_t i;

    compare_rows(MOVING_ROCKER PINS, columns, COUNT(columns));
    compare_rows(LEVER, columns, COUNT(columns));
    compare_rows(MOVING_PUMP PUMP_FRICTION, columns, COUNT(columns));
    compare_rows(MOVING_ROCKER SPRINGS PINS, linear, COUNT(linear));
    compare_rows(MOVING_ROCKER SPRINGS, torsional, COUNT(torsional));
    for (i = 0; i < COUNT(loads); i++)
        compare_rows(loads[i], columns, 1);
}

/* Work of a cycle: what the crank puts in, friction and dampers take; loads without a law of their own
** give it back. */
TEST(test_work)
{
    fourlink_results *r = opened(MOVING_ROCKER SPRINGS PINS);
    double Ts = value(r, "mean(Ts)", 0) * 10.5, Ts0 = value(r, "mean(Ts0)", 0) * 10.5;
    double lost = value(r, "mean(power_friction)", 0);
    double dampers = value(r, "mean(S.power)", 0) + value(r, "mean(T.power)", 0) +
                     value(r, "mean(U.power)", 0) + value(r, "mean(V.power)", 0);

    assert_true(lost > 0 && dampers < 0);
    assert_near(Ts, lost - dampers, 1e-6 * Ts);
    assert_near(Ts0, -dampers, 1e-6 * Ts);
    assert_close(value(r, "efficiency_cycle", 0), Ts0 / Ts, 1e-6);
    assert_close(value(r, "mean_torque", 0), -Ts / 10.5, 1e-6);
    assert_true(fabs(value(r, "max(residual)", 0)) < 1e-13);
    assert_true(fabs(value(r, "min(residual)", 0)) < 1e-13);
    fourlink_results_free(r);
}

/* One coefficient and one radius for all pins that a mechanism has; a pin's own override them; the guide
** has its own. */
TEST(test_all_pins)
{
    static const struct {
        const char *machine, *all, *each;
    } cases[] = {
        {MOVING_ROCKER, "mu = 0.1\nradius = 6 mm\n",
         "A = 0.1\nB = 0.1\nC = 0.1\nD = 10 %\nradius_A = 6 mm\nradius_B = 6 mm\n"
         "radius_C = 6 mm\nradius_D = 6 mm\n"},
        {MOVING_ROCKER, "mu = 0.1\nradius = 6 mm\nA = 0.2\nradius_B = 5 mm\nC = 0\n",
         "A = 0.2\nB = 0.1\nD = 0.1\nradius_A = 6 mm\nradius_B = 5 mm\nradius_D = 6 mm\n"},
        {MOVING_ROCKER, "radius = 6 mm\nB = 0.2\n", "B = 0.2\nradius_B = 6 mm\n"},
        {MOVING_PUMP, "mu = 0.05\nradius = 10 mm\nguide = 0.2\n",
         "A = 0.05\nB = 0.05\nC = 0.05\nradius_A = 10 mm\nradius_B = 10 mm\nradius_C = 10 mm\n"
         "guide = 0.2\n"},
        {MOVING_PUMP, "mu = 0.05\nradius = 10 mm\n",
         "A = 0.05\nB = 0.05\nC = 0.05\nradius_A = 10 mm\nradius_B = 10 mm\nradius_C = 10 mm\n"},
        {LEVER_AT_WORK, "mu = 0.1\nradius = 10 mm\nguide = 0.2\n",
         "A = 0.1\nB = 0.1\nD = 0.1\nradius_A = 10 mm\nradius_B = 10 mm\nradius_D = 10 mm\n"
         "guide = 0.2\n"}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_results *all = opened(print("%s[friction]\n%s", cases[i].machine, cases[i].all));
        fourlink_results *each = opened(print("%s[friction]\n%s", cases[i].machine, cases[i].each));
        double angle;

        for (angle = 0; angle < 360; angle += 30) {
            assert_true(value(all, "Ts", angle) == value(each, "Ts", angle));
            assert_true(value(all, "power_friction", angle) ==
                        value(each, "power_friction", angle));
        }
        assert_true(value(all, "Ts", 30) != value(all, "Ts0", 30));
        fourlink_results_free(each);
        fourlink_results_free(all);
    }
}

/* Where no power is transmitted there is no efficiency. */
TEST(test_no_efficiency)
{
    fourlink_results *r = opened("mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\n"
                                 "length = 20 mm\n[coupler]\nlength = 66 mm\n[rocker]\n"
                                 "length = 56 mm\n[motion]\nspeed = 9 rad/s\n[friction]\n"
                                 "mu = 0.1\nradius = 5 mm\n[gravity]\nacceleration = 0\n[load]\n"
                                 "link = crank\ntorque = 0 N m\n");
    fourlink_value v;

    assert_true(isnan(value(r, "efficiency", 30)));
    assert_int_equal(fourlink_results_value(r, "efficiency_cycle", FOURLINK_OPEN, 0, &v),
                     FOURLINK_NO_SUCH_FACT);
    fourlink_results_free(r);
}

/* A crank at rest: impending motion, in either direction. */
TEST(test_at_rest)
{
    fourlink_results *r = opened(
        MOVING_ROCKER PINS "[load K]\nlink = rocker\ntorque = 1 N m\nover = theta4\nback = 2 N m\n"
                           "[table]\ncolumns = Ts\n");
    fourlink_load loads[16];

    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 110, NULL, NULL, loads), FOURLINK_OK);
    assert_true(loads[1].torque == 1); /* omega4 > 0 */
    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 290, NULL, NULL, loads), FOURLINK_OK);
    assert_true(loads[1].torque == 2);
    fourlink_results_free(r);
}

TEST(test_power_law)
{
    fourlink_results *r =
        opened(MOVING_ROCKER "[load fan]\nlink = crank\ntorque = -2 N m\nover = omega2\n"
                             "at_speed = 21 rad/s\nexponent = 2\n");
    fourlink_load load;
    fourlink_load_info info;

    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 30, NULL, NULL, &load), FOURLINK_OK);
    assert_close(load.torque, -0.5, 1e-14);
    assert_int_equal(fourlink_deck_loads(fourlink_results_deck(r), FOURLINK_OPEN, 0, &load, NULL),
                     FOURLINK_OK);
    assert_true(load.torque == 0);
    assert_int_equal(fourlink_deck_load(fourlink_results_deck(r), 0, &info), FOURLINK_OK);
    assert_string_equal(info.name, "fan");
    fourlink_results_free(r);
}

/* At 90 deg the slide of an inverted slider-crank has the length sqrt(a^2 + d^2) and the speed a d
** omega2 / sqrt(a^2 + d^2), and the lever turns at omega4 = omega2 a^2 / (a^2 + d^2): at a point of its
** curve a load has its value T, and Ts is -T omega4 / omega2. */
TEST(test_over_the_slide)
{
    static const double a = 0.12, d = 0.24, omega2 = 10;
    double square = a * a + d * d, slide = sqrt(square);
    const char *lever = print("mechanism = inverted-slider-crank\n[ground]\nlength = 240 mm\n"
                              "[crank]\nlength = 120 mm\n[motion]\nspeed = 10 rad/s\n[load L]\n"
                              "link = lever\n");
    fourlink_results *r = opened(
        print("%sover = slide\ntorque = 0.1 m 1 N m, %.17g m 7 N m, 0.4 m 2 N m\n", lever, slide));

    assert_close(value(r, "Ts", 90), -7 * a * a / square, 1e-12);
    fourlink_results_free(r);
    r = opened(print("%sover = slide_v\ntorque = -9 m/s 1 N m, %.17g m/s 7 N m, 9 m/s 2 N m\n",
                     lever, a * d * omega2 / slide));
    assert_close(value(r, "Ts", 90), -7 * a * a / square, 1e-12);
    fourlink_results_free(r);
}

/* Beyond the ends of a curve that is not periodic its values hold. */
TEST(test_ends_of_curves)
{
    fourlink_results *r = opened(
        MOVING_PUMP
        "[load P]\nlink = piston\nover = x\nforce = 20 mm -100 N, 50 mm -300 N, 60 mm -900 N\n");
    fourlink_load load;

    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 2, NULL, NULL, &load), FOURLINK_OK);
    assert_true(load.force.x == -100);
    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 180, NULL, NULL, &load), FOURLINK_OK);
    assert_true(load.force.x == -900);
    fourlink_results_free(r);
}

/* ---------------------------------------------------------------------------------------------
** Springs, friction and loads for a host; counterweights; sweeps
** ------------------------------------------------------------------------------------------- */

/* What each load is, by hand, and what it does at one crank angle: its link, its torque, and of friction
** the moment of the pin or the force of the guide, which fourlink_losses has by joint. */
TEST(test_sorts_of_loads)
{
    enum { A, B, C, D, OWN = FOURLINK_LOAD_OWN, SPRING, FRICTION, GAS_LOAD };
    static const struct {
        const char *deck;
        unsigned long n;
        fourlink_load_info loads[13];
    } cases[] = {{MOVING_ROCKER SPRINGS PINS,
                  13,
                  {{"L", OWN, 0, 4, 1},
                   {"S", SPRING, 0, 4, 0},
                   {"T", SPRING, 1, 3, 0},
                   {"T", SPRING, 1, 2, 0},
                   {"U", SPRING, 2, 4, 1},
                   {"V", SPRING, 3, 4, 1},
                   {"V", SPRING, 3, 3, 1},
                   {"friction", FRICTION, B, 3, 1},
                   {"friction", FRICTION, B, 2, 1},
                   {"friction", FRICTION, C, 4, 1},
                   {"friction", FRICTION, C, 3, 1},
                   {"friction", FRICTION, D, 4, 1},
                   {"friction", FRICTION, A, 2, 1}}},
                 {MOVING_PUMP "[spring S]\nlink = ground\nto = piston\nstiffness = 2 N/mm\n"
                              "at = 400 mm\n" PUMP_FRICTION GAS,
                  8,
                  {{"S", SPRING, 0, 4, 0},
                   {"gas", GAS_LOAD, 0, 4, 0},
                   {"friction", FRICTION, B, 3, 1},
                   {"friction", FRICTION, B, 2, 1},
                   {"friction", FRICTION, C, 4, 1},
                   {"friction", FRICTION, C, 3, 1},
                   {"friction", FRICTION, D, 4, 0},
                   {"friction", FRICTION, A, 2, 1}}},
                 {LEVER GAS,
                  9,
                  {{"L", OWN, 0, 4, 0},
                   {"gas", GAS_LOAD, 0, 3, 0},
                   {"gas", GAS_LOAD, 0, 4, 0},
                   {"friction", FRICTION, B, 3, 1},
                   {"friction", FRICTION, B, 2, 1},
                   {"friction", FRICTION, C, 3, 0},
                   {"friction", FRICTION, C, 4, 0},
                   {"friction", FRICTION, D, 4, 1},
                   {"friction", FRICTION, A, 2, 1}}}};
    fourlink_load_info info;
    fourlink_load loads[13];
    fourlink_instant at;
    unsigned long i, k;

    for (k = 0; k < COUNT(cases); k++) {
        fourlink_results *r = opened(cases[k].deck);
        const fourlink_deck *deck = fourlink_results_deck(r);

        assert_int_equal(problem_of(r).n_loads, cases[k].n);
        assert_int_equal(fourlink_deck_load(deck, cases[k].n, &info), FOURLINK_BAD_LINK);
        assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 70, NULL, &at, loads), FOURLINK_OK);
        for (i = 0; i < cases[k].n; i++) {
            const fourlink_load_info *wanted = &cases[k].loads[i];

            assert_int_equal(fourlink_deck_load(deck, i, &info), FOURLINK_OK);
            assert_string_equal(info.name, wanted->name);
            assert_int_equal(info.sort, wanted->sort);
            assert_int_equal(info.element, wanted->element);
            assert_int_equal(info.link, wanted->link);
            assert_int_equal(info.has_torque, wanted->has_torque);
            assert_int_equal(loads[i].link, wanted->link);
            assert_int_equal(loads[i].torque != 0, wanted->has_torque);
            if (info.sort == FRICTION && info.has_torque)
                assert_near(fabs(loads[i].torque), at.losses.pin[info.element], 0);
            else if (info.sort == FRICTION)
                assert_close(hypot(loads[i].force.x, loads[i].force.y), at.losses.guide, 1e-14);
        }
        fourlink_results_free(r);
    }
}

TEST(test_host)
{
    fourlink_results *r = opened(MOVING_ROCKER SPRINGS PINS);
    const fourlink_deck *deck = fourlink_results_deck(r);
    fourlink_problem p = problem_of(r);
    fourlink_load loads[20];
    fourlink_instant at;
    fourlink_spring spring;
    fourlink_friction friction;
    double A[9][9], b[9], x[9];
    const char *name;
    int i, j;

    assert_int_equal(p.n_springs, 4);
    assert_true(p.has_friction && !p.has_gas);
    assert_int_equal(p.n_loads, 1 + 6 + 6);
    assert_int_equal(fourlink_deck_spring(deck, 2, &name, &spring), FOURLINK_OK);
    assert_string_equal(name, "U");
    assert_true(spring.is_torsional && spring.stiffness == 1.5);
    assert_int_equal(fourlink_deck_spring(deck, 4, &name, &spring), FOURLINK_NO_SUCH_POINT);
    assert_int_equal(fourlink_deck_spring(NULL, 0, &name, &spring), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_friction(deck, &friction), FOURLINK_OK);
    assert_close(friction.circle[3], 0.0006, 1e-14);
    assert_int_equal(fourlink_deck_friction(deck, NULL), FOURLINK_NULL);
    /* the forces solve the nine equations with these loads */
    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, 70, NULL, &at, loads), FOURLINK_OK);
    assert_int_equal(fourlink_system(&p.mechanism, &at.state, loads, p.n_loads, A, b), FOURLINK_OK);
    assert_int_equal(fourlink_unknowns(&p.mechanism, &at.forces, x), FOURLINK_OK);
    for (i = 0; i < 9; i++) {
        for (j = 0; j < 9; j++)
            b[i] -= A[i][j] * x[j];
        assert_near(b[i], 0, 1e-12);
    }
    assert_true(at.losses.power > 0);
    fourlink_results_free(r);
}

TEST(test_balance)
{
    const char *weightless = "[gravity]\nacceleration = 0\n[balance]\ncrank = yes\nrocker = yes\n"
                             "radius = 40 mm\n";
    fourlink_results *r = opened(print("%s%s", MOVING_ROCKER, weightless));

    assert_true(value(r, "max(Fs)", 0) > 0.5);
    /* -[m2 z2 + m3 a (1 - z3 / b)] */
    assert_close(value(r, "balance_crank", 0) * cos(value(r, "balance_crank_angle", 0)),
                 -(0.1 * 0.010 + 0.3 * 0.020 * (1 - 0.030 * cos(10 * DEG) / 0.066)), 1e-12);
    assert_close(value(r, "balance_mass", 0), value(r, "balance_crank", 0) / 0.040, 1e-12);
    assert_close(value(r, "balance_rocker_mass", 0), value(r, "balance_rocker", 0) / 0.040, 1e-12);
    fourlink_results_free(r);
    r = opened(print("%s%sapply = yes\n", MOVING_ROCKER, weightless));
    assert_true(value(r, "max(Fs)", 0) < 1e-13 * value(r, "max(F12)", 0));
    fourlink_results_free(r);
    r = opened(print("%s%s%s", MOVING_PUMP, "[balance]\nfraction = 0.5\nradius = 60 mm\n",
                     "[gravity]\nacceleration = 0\n"));
    assert_close(value(r, "Fs_primary", 60), (1.2 + 0.8 * 0.35) * 0.05 * 14 * 14 * 0.5, 1e-12);
    assert_close(value(r, "Fs_secondary", 60), -(1.2 + 0.8 * 0.35) * 0.05 * 14 * 14 * 0.5 / 4,
                 1e-12);
    fourlink_results_free(r);
}

TEST(test_sweep)
{
    static const char *const sweeps[] = {"spring U.stiffness = 0.5 N m/rad, 2.5 N m/rad\n",
                                         "spring S.stiffness = 100 N/m, 900 N/m\n",
                                         "spring V.damping = 0.001 N m s/rad, 0.02 N m s/rad\n",
                                         "friction.D = 0.05, 0.2\n"};
    size_t i;

    for (i = 0; i < 4; i++) {
        fourlink_source source = deck_source(
            print("%s[sweep]\noutput = max(Ts)\n%s", MOVING_ROCKER SPRINGS PINS, sweeps[i]));
        fourlink_results *r[2];
        unsigned long k;

        for (k = 0; k < 2; k++) {
            source.design = k;
            assert_int_equal(fourlink_results_open(&source, 0, &r[k], NULL, NULL), FOURLINK_OK);
        }
        assert_true(fabs(value(r[0], "max(Ts)", 0) - value(r[1], "max(Ts)", 0)) > 1e-3);
        fourlink_results_free(r[0]);
        fourlink_results_free(r[1]);
    }
}

/* ---------------------------------------------------------------------------------------------
** Mistakes
** ------------------------------------------------------------------------------------------- */

/* Eight lines. */
#define BARE                                                                               \
    "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n[coupler]\n" \
    "length = 66 mm\n[rocker]\nlength = 56 mm\n"

TEST(test_mistakes)
{
    static const struct {
        const char *more;
        long line;
        const char *message;
    } cases[] = {
        {"[friction]\nA = -0.1\nradius_A = 5 mm\n", 11,
         "the coefficient of friction A must not be negative: -0.1"},
        {"[friction]\nA = 0.1\n", 11, "the friction of A needs 'radius_A', that of its pin"},
        {"[friction]\nmu = 0.1\n", 11, "'mu' needs 'radius', that of the pins"},
        {"[friction]\nmu = 0.1\nradius_A = 5 mm\n", 11, "'mu' needs 'radius', that of the pins"},
        {"[friction]\nmu = -0.1\nradius = 5 mm\n", 11,
         "the coefficient of friction mu must not be negative: -0.1"},
        {"[friction]\nmu = 0.1\nradius = 0 mm\n", 12, "the radius must be positive, not 0 mm"},
        {"[friction]\nradius = 5 mm\n", 11, "'radius' needs 'mu', the coefficient of friction"},
        {"[friction]\nA = 0.1\nradius = 5 mm\nradius_B = 6 mm\n", 13,
         "'radius_B' needs 'B', the coefficient of friction"},
        {"[friction]\nguide = 0.1\n", 11, "the friction of a four-bar linkage has no guide"},
        {"[friction]\n", 10, "[friction] has no coefficient of friction"},
        {"[spring S]\nlink = rocker\nto = rocker\nat = 10 mm\nto_at = 5 mm\nstiffness = 9 N/m\n",
         12, "a spring from the rocker to itself does nothing"},
        {"[spring S]\nlink = crank\nto = coupler\nat = 20 mm\nto_at = 0 mm\nstiffness = 9 N/m\n",
         10, "the spring has no length: its ends are the same point at every crank angle"},
        {"[spring S]\nlink = crank\nto = coupler\nat = 20 mm\nto_at = 1 mm\ndamping = 10\n", 15,
         "the damping of a spring needs a unit: N s/m, or N m s/rad of a torsional spring"},
        {"[spring S]\nlink = crank\nto = coupler\nat = 20 mm\nto_at = 1 mm\ndamping = -1 N s/m\n",
         15, "the damping must not be negative: -1 N s/m"},
        {"[spring S]\nlink = crank\nto = coupler\nfree_angle = 20 deg\nstiffness = 10 N/m\n", 13,
         "a free_angle needs a torsional spring, with its stiffness in N m/rad, not '10 N/m'"},
        {"[spring S]\nlink = crank\nto = coupler\nfree_angle = 2 deg\nstiffness = 9 N m/rad\n"
         "damping = 3 N s/m\n",
         15, "'3 N s/m' is a damping; expected a torsional damping, such as 0.02 N m s/rad"},
        {"[spring S]\nlink = crank\nto = coupler\nat = 3 mm\nstiffness = 9 N m/rad\n", 13,
         "a torsional spring has no at"},
        {"[spring S]\nlink = crank\nto = coupler\nto_at = 3 mm\nstiffness = 9 N m/rad\n", 13,
         "a torsional spring has no to_at"},
        {"[spring S]\nlink = crank\nto = coupler\nat = 5 mm\nto_at = 3 mm\n", 10,
         "[spring] has neither a stiffness nor a damping nor a preload"},
        {"[spring S]\nlink = crank\nto = coupler\nat = 5 mm\nto_at = 3 mm\npreload = 3 N\n"
         "free_length = 9 mm\n",
         16, "'free_length' needs a stiffness"},
        {"[spring S]\nlink = crank\nto = coupler\nat = 5 mm\nto_at = 3 mm\npreload = 3 N\n"
         "only = pushes\n",
         16, "a spring that only pushes needs a free_length, below which it acts"},
        {"[spring S]\nlink = crank\nto = ground\nat = 5 mm\nstiffness = 10 N/m\n", 10,
         "the spring needs 'to_at', its end on the ground"},
        {"[spring]\nlink = crank\nto = ground\nstiffness = 10 N m/rad\n", 10,
         "a spring needs a name: [spring S]"},
        {"[spring S]\nlink = crank\nto = piston\nstiffness = 10 N m/rad\n", 12,
         "a four-bar linkage has no piston: its links are crank, coupler and rocker"},
        {"[spring S]\nlink = crank\nstiffness = 10 N m/rad\n", 10,
         "[spring] has no 'to': the ground or another link"},
        {"[load L]\nlink = crank\ntorque = 0 mm 1 N m, 5 mm 2 N m\nover = slide\n", 13,
         "a four-bar linkage has no slide"},
        {"[load L]\nlink = crank\ntorque = 2 N m\nover = omega4\n", 13,
         "a load over a speed needs 'at_speed', the speed at which it has its value, or a curve"},
        {"[load L]\nlink = crank\ntorque = 2 N m\nexponent = 2\n", 13,
         "'exponent' needs 'over', the speed that the load follows"},
        {"[load L]\nlink = crank\ntorque = 0 deg 1 N m, 5 deg 2 N m\nover = omega4\n", 12,
         "'0 deg 1 N m, 5 deg 2 N m' is an angle; expected an angular speed, such as 1000 rpm"},
        {"[load L]\nlink = crank\ntorque = 5 rpm 1 N m, 5 rpm 2 N m\nover = omega2\n", 12,
         "the arguments of a curve must increase"},
        {"[load L]\nlink = crank\ntorque = 5 N m\nback = 3 N m\nfrom = 3 deg\n", 14,
         "'from' is a crank angle: a load with 'over' or 'back' has none"},
        {"[load L]\nlink = crank\ntorque = 5 N m\nback = 3 N\n", 13,
         "'3 N' is a force; expected a torque, such as 0.5 N m"},
        {"[balance]\nradius = 3 mm\n", 10, "[balance] needs 'crank = yes', 'rocker = yes' or both"},
        {"[balance]\ncrank = yes\napply = yes\n", 12,
         "'apply' needs a radius, at which the counterweights are"},
        {"[balance]\nfraction = 0.5\n", 11, "the balance of a four-bar linkage has no fraction"},
    };
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_source source = deck_source(print("%s%s", BARE, cases[i].more));
        fourlink_results *r;
        fourlink_mistake mistakes[4];
        unsigned long n = 0, k;

        assert_int_equal(fourlink_results_open(&source, 4, &r, mistakes, &n), FOURLINK_BAD_DECK);
        for (k = 0; k < n && k < 4; k++)
            if (mistakes[k].line == cases[i].line &&
                strcmp(mistakes[k].message, cases[i].message) == 0)
                break;
        if (k == n)
            fail_msg("%s: line %ld, %s", cases[i].more, mistakes[0].line, mistakes[0].message);
    }
    {
        fourlink_source source = deck_source(MOVING_PUMP "[load L]\nlink = crank\nover = slide\n"
                                                         "torque = 0 mm 1 N m, 5 mm 2 N m\n");
        fourlink_results *r;
        fourlink_mistake mistake;

        assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, NULL), FOURLINK_BAD_DECK);
        assert_string_equal(mistake.message, "a slider-crank has no slide");
    }
}

/* A spring is not said to have no length where the crank has 13 deg only. */
TEST(test_spring_in_a_narrow_range)
{
    fourlink_results *r =
        opened("mechanism = four-bar\n[crank]\nlength = 1 m\n[coupler]\nlength = 1 m\n"
               "[rocker]\nlength = 1 m\n[ground]\nlength = 2.99 m\n[spring S]\nlink = crank\n"
               "at = (0, 0) m\nto = ground\nto_at = (3, 4) m\nstiffness = 5 N/m\n");

    assert_near(value(r, "theta2_to", 0), acos((1 + 2.99 * 2.99 - 4) / (2 * 2.99)), 1e-13);
    assert_near(value(r, "S.length", 0), 5, 1e-15);
    fourlink_results_free(r);
}

/* A position at which friction locks the machine is a row with its reason. */
TEST(test_locked)
{
    fourlink_results *r = opened("mechanism = slider-crank\n[crank]\nlength = 100 mm\n[rod]\n"
                                 "length = 120 mm\n[load P]\nlink = piston\nforce = -100 N\n"
                                 "[motion]\nspeed = -1 rad/s\n[friction]\nguide = 1.25\n"
                                 "[table]\ncolumns = theta2 Ts\n");
    double values[2];

    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, -300, values, NULL, NULL),
                     FOURLINK_LOCKED);
    assert_true(isnan(values[1]));
    assert_int_equal(fourlink_results_at(r, FOURLINK_OPEN, -340, values, NULL, NULL), FOURLINK_OK);
    fourlink_results_free(r);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
