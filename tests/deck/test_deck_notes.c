/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_deck_notes.c - notes on what is probably not meant: each beside a deck that has none.
*/
#include "outcome.h"

/* Nine lines. */
#define FOUR_BAR             \
    "mechanism = four-bar\n" \
    "[ground]\n"             \
    "length = 80 mm\n"       \
    "[crank]\n"              \
    "length = 20 mm\n"       \
    "[rocker]\n"             \
    "length = 56 mm\n"       \
    "[coupler]\n"            \
    "length = 66 mm\n"

/* Seven lines. */
#define ENGINE                   \
    "mechanism = slider-crank\n" \
    "[crank]\n"                  \
    "length = 50 mm\n"           \
    "[rod]\n"                    \
    "length = 200 mm\n"          \
    "[gas]\n"                    \
    "bore = 80 mm\n"

/* Fourteen lines, with a moving mass. */
#define RUN_UP                             \
    FOUR_BAR "mass = 0.3 kg\ncg = 33 mm\n" \
             "[motion]\nmode = run-up\nturns = 10\n"

static void check_none(const char *contents)
{
    check_note(contents, NULL, 0, NULL);
}

/* Bare numbers are in SI units. */
TEST(test_bare_numbers)
{
    static const char lengths[] = "mechanism = four-bar\n[ground]\nlength = 80\n[crank]\n"
                                  "length = 20\n[rocker]\nlength = 56\n[coupler]\nlength = 66\n";
    char with_unit[400];

    check_note(lengths, NULL, 3, "'80' is read as m: write 80 m or 80 mm");
    check_none(strcat(strcpy(with_unit, lengths), "[units]\nlength = mm\n"));
    check_note(FOUR_BAR "cg = -33\n", NULL, 10, "'-33' is read as m: write -33 m or -33 mm");
    check_none(FOUR_BAR "cg = 33 mm\nmass = 400\n");
    check_none("mechanism = slider-crank\n[crank]\nlength = 10\n[rod]\nlength = 10 m\n");
}

TEST(test_bare_pressures)
{
    check_note(ENGINE "pressure = 1.5\n", NULL, 8, "'1.5' is read as Pa: write 1.5 Pa or 1.5 MPa");
    check_note(ENGINE "pressure = 2 MPa\nback_pressure = 1\n", NULL, 9,
               "'1' is read as Pa: write 1 Pa or 1 MPa");
    check_none(ENGINE "pressure = 1500000\nback_pressure = 0\n");
    check_none(ENGINE "pressure = 1.5\n[units]\npressure = MPa\n");
    check_none(ENGINE "pressure = 900 Pa\n");
}

TEST(test_masses)
{
    check_note("mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n"
               "[piston]\nmass = 700\n",
               NULL, 7, "'700' is read as kg: write 700 kg or 700 g");
    check_none("mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n"
               "[piston]\nmass = 700 kg\n");
    check_none("mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n"
               "[piston]\nmass = 700\n[units]\nmass = g\n");
}

TEST(test_bodies)
{
    check_note(FOUR_BAR "mass = 0.3 kg\ncg = 33 mm\ninertia = 120 kg m2\n", NULL, 12,
               "the radius of gyration of the coupler is 20 m, the longest link has 0.08 m: is the "
               "unit right, kg m2 or kg mm2?");
    check_none(FOUR_BAR "mass = 0.3 kg\ncg = 33 mm\ninertia = 120 kg mm2\n");
    check_note(FOUR_BAR "mass = 0.3 kg\ncg = 33 mm\ngyration = 25 m\n", NULL, 12,
               "the radius of gyration of the coupler is 25 m, the longest link has 0.08 m: is the "
               "unit right?");
    check_none(FOUR_BAR "mass = 0.3 kg\ncg = 33 mm\ngyration = 0.7 m\n");
    check_note(FOUR_BAR "mass = 0.3 kg\ncg = 3.3 m\n", NULL, 11,
               "the centre of mass of the coupler is 3.3 m from its origin, the longest link has "
               "0.08 m: is the unit right?");
    check_none(FOUR_BAR "mass = 0.3 kg\ncg = (0.3, -0.6) m\n");
}

TEST(test_friction)
{
    check_note(FOUR_BAR "[friction]\nA = 15\nradius_A = 5 mm\n", NULL, 11,
               "a coefficient of friction of 15 is above 1: write 15 % if per cent are meant");
    check_note(FOUR_BAR "[friction]\nA = 150 %\nradius_A = 5 mm\n", NULL, 11,
               "a coefficient of friction of 150 % is above 100 %");
    check_none(FOUR_BAR "[friction]\nA = 15 %\nradius_A = 5 mm\n");
    check_note(ENGINE "pressure = 1 bar\n[friction]\nguide = 12\n", NULL, 10,
               "a coefficient of friction of 12 is above 1: write 12 % if per cent are meant");
    check_note(FOUR_BAR "[friction]\nD = 0.1\nradius_D = 500 mm\n", NULL, 12,
               "the friction circle of D has a radius of 0.05 m, the crank a length of 0.02 m");
    check_none(FOUR_BAR "[friction]\nD = 0.1\nradius_D = 50 mm\n");
    /* of all pins, once */
    check_note(FOUR_BAR "[friction]\nmu = 15\nradius = 5 mm\n", NULL, 11,
               "a coefficient of friction of 15 is above 1: write 15 % if per cent are meant");
    check_note(FOUR_BAR "[friction]\nmu = 0.1\nradius = 500 mm\n", NULL, 12,
               "the friction circle of A has a radius of 0.05 m, the crank a length of 0.02 m");
    check_none(FOUR_BAR "[friction]\nmu = 15 %\nradius = 5 mm\n");
}

TEST(test_springs)
{
    check_note(FOUR_BAR "[spring S]\nlink = rocker\nto = ground\nstiffness = -5 N m/rad\n", NULL,
               13, "a negative stiffness: the spring drives its ends away from where it is free");
    check_none(FOUR_BAR "[spring S]\nlink = rocker\nto = ground\nstiffness = 5 N m/rad\n");
}

TEST(test_pressures)
{
    check_note(ENGINE "pressure = -50 bar\n", NULL, 8,
               "-50 bar is less than a vacuum, which is -1.01325 bar against the atmosphere");
    check_note(ENGINE "pressure = 1 bar\nback_pressure = -2 bar\n", NULL, 9,
               "-2 bar is less than a vacuum, which is -1.01325 bar against the atmosphere");
    check_none(ENGINE "pressure = -1 bar\n");
    check_none(ENGINE "pressure = -1 atm\n");
}

TEST(test_fluctuations)
{
    check_note(FOUR_BAR "[flywheel]\nfluctuation = 300 %\n", NULL, 11,
               "a fluctuation of 300 % is above 100 %");
    check_note(FOUR_BAR "[flywheel]\nfluctuation = 3\n", NULL, 11,
               "a fluctuation of 3 is above 1: write 3 % if per cent are meant");
    check_none(FOUR_BAR "[flywheel]\nfluctuation = 3 %\n");
}

#define DRIVES(over, link)                                                                 \
    "this torque has the sign of " over ", so it drives the " link ": that of a fan or a " \
    "brake has the opposite sign"

TEST(test_loads_over_speed)
{
    check_note(FOUR_BAR
               "[load]\nlink = crank\nover = omega2\nat_speed = 10 rad/s\ntorque = 5 N m\n",
               NULL, 14, DRIVES("omega2", "crank"));
    check_none(FOUR_BAR "[load]\nlink = crank\nover = omega2\nat_speed = 10 rad/s\n"
                        "torque = -5 N m\n");
    check_note(FOUR_BAR "[load]\nlink = rocker\nover = omega4\n"
                        "torque = -9 rad/s -1 N m, 0 rad/s 0 N m, 9 rad/s 2 N m\n",
               NULL, 13, DRIVES("omega4", "rocker"));
    check_none(FOUR_BAR "[load]\nlink = rocker\nover = omega4\n"
                        "torque = -9 rad/s 1 N m, 0 rad/s 0 N m, 9 rad/s -2 N m\n");
    check_none(FOUR_BAR "[load]\nlink = crank\nover = omega2\n"
                        "torque = 0 1/min 0 N m, 300 1/min -2 N m\n");
    /* a motor and a brake; another link */
    check_none(FOUR_BAR "[load]\nlink = rocker\nover = omega4\n"
                        "torque = -9 rad/s 1 N m, 0 rad/s 0 N m, 9 rad/s 2 N m\n");
    check_none(FOUR_BAR "[load]\nlink = coupler\nover = omega4\nat_speed = 10 rad/s\n"
                        "torque = 5 N m\n");
}

#define ENDS(speed, torque)                          \
    "the curve ends at " speed " rad/s with " torque \
    " N.m, which the motor keeps at higher speeds: " \
    "end it with the speed at which the torque is 0"

TEST(test_motors)
{
    check_note(RUN_UP "[motor]\ncurve = 5 rad/s 10 N m, 20 rad/s 7 N m\n", NULL, 16,
               ENDS("20", "7"));
    check_note(RUN_UP "[motor]\ncurve = -20 rad/s -7 N m, 0 rad/s -10 N m\n", NULL, 16,
               ENDS("-20", "-7"));
    check_note(RUN_UP "[motor]\nratio = -2\ncurve = -20 rad/s -7 N m, 0 rad/s -10 N m\n", NULL, 17,
               ENDS("-20", "-7"));
    check_none(RUN_UP "[motor]\ncurve = 5 rad/s 10 N m, 20 rad/s 0 N m\n");
    check_none(RUN_UP "[motor]\ncurve = 5 rad/s 10 N m, 20 rad/s 7 N m, 30 rad/s -1 N m\n");
    check_none(RUN_UP "[motor]\ncurve = -20 rad/s 0 N m, 0 rad/s -10 N m\n");
}

TEST(test_run_up)
{
    static const char running[] = FOUR_BAR "mass = 0.3 kg\ncg = 33 mm\n"
                                           "[motor]\ntorque = 5 N m\n[motion]\nmode = run-up\n"
                                           "interval = 36 deg\n";
    char contents[600];

    sprintf(contents, "%sturns = 1000\n", running);
    check_note(contents, NULL, 13,
               "nothing opposes this torque, so the crank turns faster and faster: give a load, or "
               "a motor whose torque falls with the speed");
    sprintf(contents, "%sturns = 90\n", running);
    check_none(contents);
    sprintf(contents, "%sto = %d deg\n", running, 101 * 360);
    check_note(contents, NULL, 13,
               "nothing opposes this torque, so the crank turns faster and faster: give a load, or "
               "a motor whose torque falls with the speed");
    sprintf(contents, "%sto = %d deg\n", running, 99 * 360);
    check_none(contents);
    sprintf(contents, "%sturns = 1000\n[load]\nlink = crank\ntorque = -5 N m\n", running);
    check_none(contents);
    sprintf(contents, "%sturns = 1000\n[friction]\nA = 0.1\nradius_A = 5 mm\n", running);
    check_none(contents);
}

#define INSTANT                                                                                   \
    "the speed is that at 70 deg; in the rows of an interval it is that of the first, at 0 deg, " \
    "and "                                                                                        \
    "%s: write hold = yes if this instant is meant"

TEST(test_instants)
{
    char note[400];

    sprintf(note, INSTANT, "the one here has 14.06195 rad/s");
    check_note(FOUR_BAR "[motion]\nspeed = 10 rad/s\nacceleration = 40 rad/s2\nat = 70 deg\n", NULL,
               13, note);
    sprintf(note, INSTANT, "there is none here, as the crank comes to rest before");
    check_note(FOUR_BAR "[motion]\nspeed = 10 rad/s\nacceleration = -41 rad/s2\nat = 70 deg\n",
               NULL, 13, note);
    check_none(FOUR_BAR "[motion]\nspeed = 10 rad/s\nacceleration = 40 rad/s2\nat = 0 deg\n");
    check_none(FOUR_BAR
               "[motion]\nspeed = 10 rad/s\nacceleration = 40 rad/s2\ninterval = 70 deg\n");
    check_none(FOUR_BAR "[motion]\nspeed = 10 rad/s\nat = 70 deg\n");
    check_none(FOUR_BAR
               "[motion]\nspeed = 10 rad/s\nacceleration = 40 rad/s2\nat = 70 deg\nhold = yes\n");
}

/* The speed of the row at 10 `k` deg of a motion with an interval of 10 deg; NaN if there is no such row. */
static double speed_of_row(const fourlink_motion *motion, int k)
{
    fourlink_range range;
    fourlink_row row;
    unsigned long i;

    assert_int_equal(fourlink_motion_range(motion, &range), FOURLINK_OK);
    for (i = 0; i < range.n_rows; i++) {
        assert_int_equal(fourlink_motion_row(motion, &range, i, &row), FOURLINK_OK);
        if (fabs(remainder(row.angle - 10 * k, 360)) < 1e-9)
            return row.crank.omega2;
    }
    return NAN;
}

/* What the note says of the row is so, on motions of any sense that run up or down. */
TEST(test_instants_and_rows)
{
    uint64_t seed = 5;
    int i, k, n_none = 0, n = some_of(3000);
    char motion[200], contents[600];
    double speed, told;
    const char *has;
    deck d;

    for (i = 0; i < n; i++) {
        k = 1 + (int)uniform(&seed, 0, 35);
        sprintf(motion, FOUR_BAR "[motion]\nspeed = %.3f rad/s\nacceleration = %.3f rad/s2\n",
                i % 7 ? uniform(&seed, -20, 20) : 0, uniform(&seed, -30, 30));
        sprintf(contents, "%sinterval = 10 deg\n", motion);
        read_accepted(contents, NULL, &d);
        speed = speed_of_row(&d.motion, k);
        flk_deck_free(&d);
        sprintf(contents, "%sat = %d deg\n", motion, 10 * k);
        read_accepted(contents, NULL, &d);
        assert_int_equal(d.notes.count, 1);
        has = strstr(d.notes.list[0].message, "the one here has ");
        n_none += !has;
        assert_int_equal(has != NULL, !isnan(speed));
        if (has && sscanf(has, "the one here has %lf", &told) == 1)
            assert_near(told, speed, 1e-8 * (1 + fabs(speed)));
        flk_deck_free(&d);
    }
    assert_true(n_none > n / 20 && n_none < n / 2);
}

int main(void)
{
    return run_all_tests(NULL);
}
