/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_force.c - forces of loads: bare on a piston, as curves over the crank angle; those that are refused.
*/
#include "outcome.h"

/* Ten lines; the load is open. */
#define FOUR_BAR             \
    "mechanism = four-bar\n" \
    "[ground]\n"             \
    "length = 80 mm\n"       \
    "[coupler]\n"            \
    "length = 66 mm\n"       \
    "[rocker]\n"             \
    "length = 56 mm\n"       \
    "[crank]\n"              \
    "length = 20 mm\n"       \
    "[load F]\n"

/* Seven lines; the load on the piston is open. */
#define ENGINE                   \
    "mechanism = slider-crank\n" \
    "[crank]\n"                  \
    "length = 50 mm\n"           \
    "[rod]\n"                    \
    "length = 200 mm\n"          \
    "[load F]\n"                 \
    "link = piston\n"

/* The force at a crank angle. */
static void check_force(const char *contents, const char *file, double degrees, double x, double y)
{
    fourlink_load loads[2];
    deck d;

    print_message("%s\n", contents);
    read_accepted(contents, file, &d);
    assert_int_equal(fourlink_deck_loads(&d, FOURLINK_OPEN, degrees * DEG, loads, NULL),
                     FOURLINK_OK);
    assert_near(loads[0].force.x, x, 1e-12 * (1 + fabs(x)));
    assert_near(loads[0].force.y, y, 1e-12 * (1 + fabs(y)));
    flk_deck_free(&d);
}

TEST(test_bare_on_a_piston)
{
    check_force(ENGINE "force = -100 N\n", NULL, 30, -100, 0);
    check_force(ENGINE "force = -100\n[units]\nforce = kN\n", NULL, 30, -1e5, 0);
    check_force(ENGINE "force = 0 deg 50 N, 90 deg -30 N, 180 deg 20 N\n", NULL, 90, -30, 0);
    check_force(ENGINE "force = 0 deg 50 N, 90 deg -30 N, 180 deg 20 N\n", NULL, 360, 50, 0);
    check_force(ENGINE "force = 0 50, 90 -30, 180 20,\n", NULL, 180, 20, 0);
    check_force(ENGINE "force = file card.txt\n", "# N\n0 50\n90 -30\n", 90, -30, 0);
    /* a part of it varies */
    check_force(ENGINE "force = -100 N\n[sweep]\nload F.force.y = 3 N, 4 N\n", NULL, 0, -100, 3);
    check_force(FOUR_BAR
                "link = coupler\nat = mid\nforce = 5 N\n[sweep]\nload F.force.angle = 90 deg\n",
                NULL, 0, 0, 5);
}

#define LINK "link = coupler\nat = mid\n"

TEST(test_curves)
{
    check_force(FOUR_BAR LINK "force = 30 deg (43, 25) N, 90 deg (3, -4) N\n", NULL, 30, 43, 25);
    check_force(FOUR_BAR LINK "force = 30 deg (43, 25) N, 90 deg (3, -4) N\n", NULL, 90, 3, -4);
    /* components, between two points at half their difference: the slopes of two points are 0 */
    check_force(FOUR_BAR LINK "force = 30 deg (43, 25) N, 90 deg (3, -4) N\n", NULL, 60, 23, 10.5);
    check_force(FOUR_BAR LINK "force = 30 deg 50 N at 90 deg, # up\n   210 deg 50 N at 0 deg\n",
                NULL, 120, 25, 25);
    check_force(FOUR_BAR LINK "force = 30 50 at 90, 210 (1, 2)\n", NULL, 210, 1, 2);
    check_force(FOUR_BAR LINK "force = 30\302\260 50\302\240N at 90\302\260, 210\302\260 "
                              "(\342\210\2221, 2) N\n",
                NULL, 210, -1, 2);
    check_force(FOUR_BAR LINK "force = 0 (1, 2) N, 100 (3, 4) N, 360 deg (1, 2) N\n", NULL, 360, 1,
                2);
    /* within its window */
    check_force(FOUR_BAR LINK "force = 0 (1, 2) N, 90 (3, 4) N\nfrom = 80 deg\nto = 100 deg\n",
                NULL, 90, 3, 4);
    check_force(FOUR_BAR LINK "force = 0 (1, 2) N, 90 (3, 4) N\nfrom = 80 deg\nto = 100 deg\n",
                NULL, 0, 0, 0);
    /* one force, as ever */
    check_force(FOUR_BAR LINK "force = (43, 25) N\n", NULL, 30, 43, 25);
    check_force(FOUR_BAR LINK "force = 50 N at 90 deg\n", NULL, 30, 0, 50);
    check_force(FOUR_BAR LINK "force = 50 at 90\n", NULL, 30, 0, 50);
    check_force(ENGINE "force = (3, 4) N\n", NULL, 30, 3, 4);
}

TEST(test_refused)
{
    static const char bare[] = "expected a force with its direction, such as 50 N at 30 deg or "
                               "(43, 25) N, not '%s'";
    char message[200];

    sprintf(message, bare, "-100 N");
    check_mistake(FOUR_BAR LINK "force = -100 N\n", NULL, 13, message);
    sprintf(message, bare, "0 deg 5 N, 90 deg (3, 4) N");
    check_mistake(FOUR_BAR LINK "force = 0 deg 5 N, 90 deg (3, 4) N\n", NULL, 13, message);
    sprintf(message, bare, "file card.txt");
    check_mistake(FOUR_BAR LINK "force = file card.txt\n", "0 5\n90 6\n", 13, message);
    check_mistake(FOUR_BAR LINK "force = 50 foo\n", NULL, 13, "unknown unit 'foo' in '50 foo'");
    check_mistake("mechanism = inverted-slider-crank\n[crank]\nlength = 120 mm\n[ground]\n"
                  "length = 240 mm\n[load]\nlink = slider\nforce = 3 N\n",
                  NULL, 8,
                  "expected a force with its direction, such as 50 N at 30 deg or (43, 25) N, not "
                  "'3 N'");
    check_mistake(ENGINE "force = 5 m\n", NULL, 8,
                  "'5 m' is a length; expected a force, such as 50 N");
    check_mistake(ENGINE "force = 5 %\n", NULL, 8,
                  "'5 %': per cent of what? expected a force, such as 50 N");
    check_mistake(ENGINE "force = mid\n", NULL, 8, "expected a force, such as 50 N, not 'mid'");
    check_mistake(ENGINE "force = 5,5 N\n", NULL, 8, "'5,5 N': a comma as decimal mark: write 5.5");
    check_mistake(ENGINE "force = 0 deg 5,5 N, 90 deg 3 N\n", NULL, 8,
                  "'0 deg 5,5 N, 90 deg 3 N': a comma as decimal mark? write a point, and a blank "
                  "after the comma between two points of a curve");
    check_mistake(ENGINE "force = 5 N, 6 N\n", NULL, 8,
                  "expected an angle and a value, such as 20 deg (43, 25) N, not '5 N, 6 N'");
    check_mistake(ENGINE "force = 0 deg 5 kN, 90 deg 6\n", NULL, 8,
                  "either all values of a curve have a unit or none has");
    check_mistake(ENGINE "force = 0 deg (5, 6) kN, 90 deg (6, 7)\n", NULL, 8,
                  "either all values of a curve have a unit or none has");
    check_mistake(ENGINE "force = 0 deg (5, 6) N, 90 deg (6, 7 N\n", NULL, 8,
                  "expected two components, such as (43, 25) N, not '0 deg (5, 6) N, 90 deg (6, 7 "
                  "N'");
    check_mistake(ENGINE "force = 0 deg (5, 6) N, 90 deg (6, 7, 8) N\n", NULL, 8,
                  "expected two components, such as (43, 25) N, not '0 deg (5, 6) N, 90 deg (6, 7, "
                  "8) N'");
    check_mistake(ENGINE "force = 0 deg (5, 6) N, 90 deg (6, 7) mm\n", NULL, 8,
                  "'0 deg (5, 6) N, 90 deg (6, 7) mm' is a length; expected a force, such as 50 N");
    check_mistake(ENGINE "force = 0 deg (5, 6) N\n", NULL, 8, "a curve needs at least two points");
    check_mistake(ENGINE "force = 90 deg (5, 6) N, 80 deg (1, 2) N\n", NULL, 8,
                  "the angles of a curve must increase");
    check_mistake(
        ENGINE "force = 0 deg (5, 6) N, 80 deg (1, 2) N, 360 deg (5, 7) N\n", NULL, 8,
        "the curve is not periodic: one cycle after its first point it has another value");
    check_mistake(FOUR_BAR "link = coupler\nforce = 0 deg (5, 6) N, 80 deg (1, 2) N\n", NULL, 10,
                  "the force needs 'at', the point of the link where it acts");
    check_mistake(FOUR_BAR "link = coupler\ntorque = 0 deg (5, 6) N m, 80 deg (1, 2) N m\n", NULL,
                  12,
                  "expected a torque, such as 0.5 N m, not '0 deg (5, 6) N m, 80 deg (1, 2) N m'");
    check_mistake(ENGINE "force = 0 deg 3 N, 80 deg 4 N\n[sweep]\nload F.force.x = 1 N, 2 N\n",
                  NULL, 10, "a curve has no parts that can be varied");
}

/* A curve over theta4 has the period of a turn, whatever the cycle. */
TEST(test_longer_than_a_turn)
{
#define CURVE(angle) \
    FOUR_BAR "link = rocker\nover = theta4\ntorque = 0 deg 5 N m, " angle " deg 7 N m\n"
    static const char longer[] = "the curve is longer than a turn of theta4, 360 deg";

    check_mistake(CURVE("400"), NULL, 13, longer);
    check_mistake(CURVE("400") "[motion]\ncycle = 720 deg\n", NULL, 13, longer);
    check_mistake(CURVE("360"), NULL, 13,
                  "the curve is not periodic: one turn after its first point it has another value");
    check_mistake(
        FOUR_BAR "link = rocker\ntorque = 0 deg 5 N m, 400 deg 7 N m\n", NULL, 12,
        "the curve is longer than the cycle; give [motion] a cycle of 720 deg if it is one "
        "of four strokes");
#undef CURVE
}

/* What follows from a mistake of a key is no mistake of its own. */
TEST(test_alone)
{
    static const char comma[] = "a load over a speed needs 'at_speed', the speed at which it has "
                                "its value, or a curve";
    static const char bare[] = "expected a force with its direction, such as 50 N at 30 deg or "
                               "(43, 25) N, not '-10 N'";

    check_mistake(ENGINE "over = x\nforce = 20 deg -100 N, 50 deg -300 N\n", NULL, 9,
                  "'20 deg -100 N, 50 deg -300 N' is an angle; expected a length, such as 80 mm");
    check_mistake(ENGINE "over = x\nforce = file none.csv mm N\n", NULL, 9,
                  "cannot read the file 'none.csv'");
    check_mistake(ENGINE "over = x\nforce = file card.csv mm N\n", "1 2\n2 three\n", 2,
                  "expected points of an argument and a value, such as 20 mm (43, 25) N, not "
                  "'2 three'");
    check_mistake(FOUR_BAR "link = rocker\nover = omega4\ntorque = file none.csv rpm N m\n", NULL,
                  13, "cannot read the file 'none.csv'");
    check_mistake(FOUR_BAR "link = rocker\nover = omega4\ntorque = 3 N m\n", NULL, 12, comma);
    check_mistake(FOUR_BAR "link = rocker\nover = omega5\ntorque = 1 rpm 3 N m, 9 rpm 1 N m\n"
                           "at_speed = 3 rpm\n",
                  NULL, 12,
                  "expected theta2, theta4, x, slide, omega2, omega4, v or slide_v, not 'omega5'; "
                  "did you mean 'omega2'?");
    check_mistake(FOUR_BAR "link = rocker\ntorque = - 2 N m\n", NULL, 12,
                  "expected a torque, such as 0.5 N m, not '- 2 N m': there is a blank after the "
                  "sign");
    check_mistake(FOUR_BAR "link = rocker\ntorque = t.txt\n", NULL, 12,
                  "expected a torque or a curve, not 't.txt'; did you mean 'file t.txt'?");
    check_mistake(ENGINE "force = - 2 N\n", NULL, 8,
                  "expected a force, such as 50 N, not '- 2 N': there is a blank after the sign");
    check_mistake(ENGINE "back = 10 N\n", NULL, 6, "[load] has neither a force nor a torque");
    check_mistake(ENGINE "force = 3 N\ntorque = 3 N m\nback = 10 N m\n", NULL, 10,
                  "'back' of a force or of a torque? give them in two loads");
    check_mistake(ENGINE "force = -10 N\nat_speed = 2 m/s\n", NULL, 9,
                  "'at_speed' needs 'over', the speed that the load follows");
    check_mistake(ENGINE "force = -10 N\novr = v\nat_speed = 2 m/s\n", NULL, 9,
                  "unknown key 'ovr' in [load]; did you mean 'over'?");
    check_mistake(ENGINE "force = 3 N\nfrom = 20 foo\nto = -5 deg\n", NULL, 9,
                  "unknown unit 'foo' in '20 foo'");
    check_mistake(FOUR_BAR "link = piston\nforce = -10 N\n", NULL, 11,
                  "a four-bar linkage has no piston: its links are crank, coupler and rocker");
    check_mistake(FOUR_BAR "link = rocker\nat = mid\nforce = -10 N\n", NULL, 13, bare);
}

/* The same of a spring. */
TEST(test_springs_alone)
{
#define INVERTED                                                                           \
    "mechanism = inverted-slider-crank\n[ground]\nlength = 240 mm\n[crank]\nlength = 120 " \
    "mm\n[spring S]\n"

    check_mistake(
        INVERTED "link = piston\nto = lever\nstiffness = 9 N/m\nat = 5 mm\nto_at = 9 mm\n", NULL, 7,
        "an inverted slider-crank has no piston: its links are crank, slider and lever");
    check_mistake(INVERTED "link = piston\nto = lever\nstiffness = 9 N/m\nto_at = 9 mm\n", NULL, 7,
                  "an inverted slider-crank has no piston: its links are crank, slider and lever");
    check_mistake(INVERTED "link = lever\nto = lever\nstiffness = 9 N/m\n", NULL, 8,
                  "a spring from the lever to itself does nothing");
    check_mistake(INVERTED "link = lever\nto = ground\nstiffness = 9\npreload = 3 N m\n", NULL, 9,
                  "the stiffness of a spring needs a unit: N/m, or N m/rad of a torsional spring");
    check_mistake(INVERTED "link = lever\nto = ground\nstifness = 9 N m/rad\nfree_angle = 5 deg\n",
                  NULL, 9, "unknown key 'stifness' in [spring]; did you mean 'stiffness'?");
#undef INVERTED
}

int main(void)
{
    return run_all_tests(NULL);
}
