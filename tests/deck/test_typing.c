/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_typing.c - values as people type them: each accepted spelling beside one that is refused.
*/
#include "outcome.h"
#include "elements.h"
#include "deck/reader.h"

/* Ten lines; the crank is open. */
#define FOUR_BAR             \
    "mechanism = four-bar\n" \
    "[ground]\n"             \
    "length = 80 mm\n"       \
    "[coupler]\n"            \
    "length = 66 mm\n"       \
    "[rocker]\n"             \
    "length = 56 mm\n"       \
    "[flywheel]\n"           \
    "fluctuation = 1\n"      \
    "[crank]\n"

#define MINUS "\342\210\222"
#define NO_BREAK "\302\240"
#define THIN "\342\200\211"
#define DEGREE "\302\260"
#define TWO "\302\262"
#define DOT "\302\267"
#define TIMES "\303\227"

/* An assignment that is accepted, and what becomes of it; or the reason why not. */
static const struct {
    const char *key, *value;
    double si;
    const char *why;
} cases[] = {
    /* lengths */
    {"crank.length", "15 mm", 0.015, NULL},
    {"crank.length", "1,5 mm", 0, "'1,5 mm': a comma as decimal mark: write 1.5"},
    {"crank.length", "66,5", 0, "'66,5': a comma as decimal mark: write 66.5"},
    {"crank.length", "66,50", 0, "'66,50': a comma as decimal mark: write 66.50"},
    {"crank.length", "1,000", 0, "'1,000': a comma within a number: write 1000 or 1.000"},
    {"crank.length", "0,219 m", 0, "'0,219 m': a comma as decimal mark: write 0.219"},
    {"crank.length", "1,000 mm", 0, "'1,000 mm': a comma within a number: write 1000 or 1.000"},
    {"crank.length", "1,000,000 mm", 0,
     "'1,000,000 mm': a comma within a number: write it without"},
    {"crank.length", "1.000,5 mm", 0, "'1.000,5 mm': a comma within a number: write it without"},
    {"crank.length", "15" NO_BREAK "mm", 0.015, NULL},
    {"crank.length", NO_BREAK "15" THIN "mm" NO_BREAK, 0.015, NULL},
    {"crank.length", "1" THIN "500 mm", 0,
     "'1 500 mm': two numbers in place of one; a blank does not separate thousands"},
    {"crank.length", "1'200 mm", 0, "'1'200 mm': an apostrophe within a number: write it without"},
    {"crank.length",
     "1\342\200\231"
     "200 mm",
     0,
     "'1\342\200\231"
     "200 mm': an apostrophe within a number: write it without"},
    {"crank.length", "6' mm", 0, "unknown unit '' mm' in '6' mm'"},
    {"crank.length", "15 millimetres", 0.015, NULL},
    {"crank.length", "15 Millimetres", 0.015, NULL},
    {"crank.length", "1 Inch", 0.0254, NULL},
    {"crank.length", "5 m m", 0, "'5 m m' is an area; expected a length, such as 80 mm"},
    {"crank.length", "5 MM", 0, "unknown unit 'MM' in '5 MM'; did you mean 'mm'?"},
    {"crank.length", "1/2/3 in", 0, "'1/2/3 in': a fraction: write it as a decimal number"},
    {"crank.length", "1/2 in", 0.0127, NULL},
    {"crank.length", "1.2.3 mm", 0, "'1.2.3 mm': a number with two points"},
    {"crank.length", "15 %", 0, "'15 %': per cent of what? expected a length, such as 80 mm"},
    {"crank.length", "1.5" TIMES "10^1 mm", 0.015, NULL},
    {"crank.length", "1.5 " TIMES " 10" TWO " mm", 0.15, NULL},
    {"crank.length", "1.5*10^-2 m", 0.015, NULL},
    {"crank.length", "1.5" TIMES "10 mm", 0, "unknown unit '*10 mm' in '1.5*10 mm'"},
    {"crank.length", TIMES "10^3 mm", 0, "expected a length, such as 80 mm, not '*10^3 mm'"},
    {"crank.length", "15 gm", 0, "unknown unit 'gm' in '15 gm'; did you mean 'mm'?"},
    /* signs */
    {"crank.cg", MINUS "5 mm", -0.005, NULL},
    {"crank.cg",
     "\342\200\223"
     "5 mm",
     -0.005, NULL},
    {"crank.cg", "--5 mm", 0, "expected a length, such as 80 mm, not '--5 mm': it has two signs"},
    {"crank.cg", MINUS "-5 mm", 0,
     "expected a length, such as 80 mm, not '--5 mm': it has two signs"},
    {"crank.cg", "- 5 mm", 0,
     "expected a length, such as 80 mm, not '- 5 mm': there is a blank after the sign"},
    {"crank.cg", "(" MINUS "5, 3)" NO_BREAK "mm", -0.005, NULL},
    {"crank.cg", "5,5 mm at 3 deg", 0, "'5,5 mm at 3 deg': a comma as decimal mark: write 5.5"},
    {"crank.cg", "(40,5, 25,2) mm", 0,
     "expected two components, such as (10, 5) mm, not '(40,5, 25,2) mm': a comma as decimal mark? "
     "write a point"},
    {"crank.cg", "(1, 2, 3) mm", 0,
     "expected two components, such as (10, 5) mm, not '(1, 2, 3) mm'"},
    {"crank.cg", "5 mm at 180" DEGREE, -0.005, NULL},
    {"crank.cg", "5" NO_BREAK "mm" NO_BREAK "at" NO_BREAK "180" DEGREE, -0.005, NULL},
    {"crank.cg", "5 mm at 180" DEGREE "C", 0,
     "unknown unit 'degC' in '5 mm at 180 degC'; did you mean 'deg'?"},
    /* masses, inertias: a suggestion is of the dimension asked for */
    {"crank.mass", "300 gm", 0, "unknown unit 'gm' in '300 gm'; did you mean 'g'?"},
    {"crank.mass", "3 kilograms", 3, NULL},
    {"crank.mass", "3 Kg", 0, "unknown unit 'Kg' in '3 Kg'; did you mean 'kg'?"},
    {"crank.mass", "3 mn", 0, "unknown unit 'mn' in '3 mn'"},
    {"crank.inertia", "4 kgm2", 4, NULL},
    {"crank.inertia", "4 kgm^2", 4, NULL},
    {"crank.inertia", "4 kgm" TWO, 4, NULL},
    {"crank.inertia", "4 kg" DOT "m" TWO, 4, NULL},
    {"crank.inertia", "4 kgm", 0,
     "'4 kgm' is a mass moment; expected a moment of inertia, such as 0.4 kg m2"},
    {"crank.inertia", "4 kgm3", 0, "'4 kgm3' is not a moment of inertia, such as 0.4 kg m2"},
    {"crank.inertia", "4 kgn2", 0, "unknown unit 'kgn' in '4 kgn2'"},
    {"crank.inertia", "4 Kg m2", 0, "unknown unit 'Kg' in '4 Kg m2'; did you mean 'kg'?"},
    /* speeds */
    {"motion.speed", "60 RPM", 6.283185307179586, NULL},
    {"motion.speed", "60 Rpm", 6.283185307179586, NULL},
    {"motion.speed", "60 rev/min", 6.283185307179586, NULL},
    {"motion.speed", "1 revolution/second", 6.283185307179586, NULL},
    {"motion.speed", "360 degrees/s", 6.283185307179586, NULL},
    {"motion.speed", "360" DEGREE "/s", 6.283185307179586, NULL},
    {"motion.speed", "5 rad s^-1", 5, NULL},
    {"motion.speed", "5 rad s\342\201\273\302\271", 5, NULL},
    {"motion.speed", "60 rmp", 0, "unknown unit 'rmp' in '60 rmp'; did you mean 'rpm'?"},
    {"motion.speed", "60 1/min", 6.283185307179586, NULL},
    {"motion.speed", "60 min^-1", 6.283185307179586, NULL},
    {"motion.speed", "60 min\342\201\273\302\271", 6.283185307179586, NULL},
    {"motion.speed", "60 min-1", 6.283185307179586, NULL},
    {"motion.speed", "60 r.p.m.", 6.283185307179586, NULL},
    {"motion.speed", "60 R.P.M.", 6.283185307179586, NULL},
    {"motion.speed", "60 r.p.m", 6.283185307179586, NULL},
    {"motion.speed", "60 U/min", 6.283185307179586, NULL},
    {"motion.speed", "60 r/min", 6.283185307179586, NULL},
    {"motion.speed", "60 1/s", 0, "'60 1/s' is not an angular speed, such as 1000 rpm"},
    {"motion.speed", "60 1/min/s", 0, "'60 1/min/s' is not an angular speed, such as 1000 rpm"},
    {"motion.speed", "60 1/mm", 0, "'60 1/mm' is not an angular speed, such as 1000 rpm"},
    {"motion.speed", "60 s^-5", 0, "unknown unit 's^-5' in '60 s^-5'"},
    {"motion.speed", "1'500 rpm", 0,
     "'1'500 rpm': an apostrophe within a number: write it without"},
    {"motion.speed", "1,500 rpm", 0, "'1,500 rpm': a comma within a number: write 1500 or 1.500"},
    {"motion.at", "30 degrees", 30, NULL},
    {"motion.at", "30" DEGREE, 30, NULL},
    {"motion.at", "30 Deg", 30, NULL},
    {"motion.at", "30 dge", 0, "unknown unit 'dge' in '30 dge'; did you mean 'deg'?"},
    {"motion.at", "30" DEGREE "15'", 0, "unknown unit 'deg15'' in '30 deg15''"},
    /* torques */
    {"load.torque", "3 Nm", 3, NULL},
    {"load.torque", "3 N" DOT "m", 3, NULL},
    {"load.torque", "3 kNm", 3000, NULL},
    {"load.torque", "3 nm", 0, "unknown unit 'nm' in '3 nm'; did you mean 'N m'?"},
    {"load.torque", "3 Nm2", 0, "'3 Nm2' is not a torque, such as 0.5 N m"},
    {"load.torque", MINUS "3,5 Nm", 0, "'-3,5 Nm': a comma as decimal mark: write -3.5"},
    /* plain numbers */
    {"flywheel.fluctuation", "1 %", 0.01, NULL},
    {"flywheel.fluctuation", "1%", 0.01, NULL},
    {"flywheel.fluctuation", "0.01", 0.01, NULL},
    {"flywheel.fluctuation", "1 %%", 0, "unknown unit '%%' in '1 %%'"},
    {"flywheel.fluctuation", "% 1", 0, "expected a number, such as 0.02, not '% 1'"},
    {"flywheel.fluctuation", "1 percent", 0, "unknown unit 'percent' in '1 percent'"},
    {"table.digits", "6 %", 0, "expected a whole number, not '6 %'"},
};

static double value_of(const char *key, const deck *d)
{
    return strcmp(key, "crank.length") == 0    ? d->machine.mechanism.design.link[2].length
           : strcmp(key, "crank.cg") == 0      ? d->machine.mechanism.design.link[2].cg.x
           : strcmp(key, "crank.mass") == 0    ? d->machine.mechanism.design.link[2].mass
           : strcmp(key, "crank.inertia") == 0 ? d->machine.mechanism.design.link[2].inertia
           : strcmp(key, "motion.speed") == 0  ? d->motion.speed
           : strcmp(key, "motion.at") == 0     ? d->motion.from
           : strcmp(key, "load.torque") == 0   ? given_load(d, 0)->values.torque
                                               : d->flywheel_fluctuation;
}

TEST(test_values)
{
    size_t i, failed = 0;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_source source =
            deck_source(FOUR_BAR "length = 20 mm\n[load]\nlink = crank\ntorque = 1 N m\n");
        fourlink_change change = {"--set", NULL};
        char assignment[100];
        const char *message = NULL;
        deck d;

        sprintf(assignment, "%s=%s", cases[i].key, cases[i].value);
        change.assignment = assignment;
        source.changes = &change;
        source.n_changes = 1;
        if (flk_deck_read(&source, &d) == 1) {
            if (cases[i].why ||
                !(fabs(value_of(cases[i].key, &d) - cases[i].si) <= 1e-15 * fabs(cases[i].si)))
                message = "accepted";
        } else if (!cases[i].why || strcmp(d.mistakes.list[0].message, cases[i].why) != 0) {
            message = d.mistakes.list[0].message;
        }
        if (message) {
            print_error("%s: %s\n", assignment, message);
            failed++;
        }
        flk_deck_free(&d);
    }
    assert_int_equal(failed, 0);
}

/* In the lines of a deck: blanks of typography anywhere, and comments after them. */
TEST(test_lines)
{
    deck d;

    read_accepted(NO_BREAK "title = 30" DEGREE " " MINUS " K\303\266nig\n" FOUR_BAR
                           "length" NO_BREAK "=" NO_BREAK "20" NO_BREAK "mm" NO_BREAK
                           "# the crank\n"
                           "[load" NO_BREAK "F" TWO "]\nlink = crank\ntorque = 1 Nm\n"
                           "[point P" TWO "]\nlink = crank\n"
                           "[table]\ncolumns = theta2," NO_BREAK "P" TWO ".x\n"
                           "[units]\nangle = " DEGREE "\ninertia = kg" DOT "m" TWO "\n",
                  NULL, &d);
    assert_string_equal(d.title, "30" DEGREE " " MINUS " K\303\266nig");
    assert_true(d.machine.mechanism.design.link[2].length == 0.02);
    assert_string_equal(flk_machine_find(&d.machine, &flk_given_load_type, 0)->name, "F" TWO);
    assert_string_equal(d.points[0].name, "P" TWO);
    assert_int_equal(d.columns.names.length, strlen("theta2," NO_BREAK "P" TWO ".x"));
    assert_string_equal(d.units[QUANTITY_ANGLE].name, "deg");
    flk_deck_free(&d);
    check_mistake(FOUR_BAR "length = 20 mm\342\200\213# the crank\n", NULL, 11, /* no blank */
                  "unknown unit 'mm\342\200\213' in '20 mm\342\200\213# the crank'");
    check_mistake(FOUR_BAR "length = 20 mm\n[units]\nlength = 1 mm\n", NULL, 13,
                  "unknown unit '1' in '1 mm'");
}

/* Sweeps and printed values are typed by people too. */
TEST(test_elsewhere)
{
    deck d;

    read_accepted(FOUR_BAR "length = 20 mm\n[sweep]\ncrank.cg.x = " MINUS "5 mm to 5 mm in 3\n"
                           "crank.cg.y = 1 mm\302\240\302\261\302\2400.5\302\240mm\nsamples = 2\n"
                           "[expect]\nswing = 40" DEGREE "\ntolerance = 1" NO_BREAK "%\n",
                  NULL, &d);
    assert_int_equal(d.sweep.n_designs, 6);
    assert_true(d.sweep.variables[0].value == -0.005);
    assert_int_equal(d.expectations[0].value.length, strlen("40 deg"));
    flk_deck_free(&d);
}

/* A curve has commas of its own. */
TEST(test_curves)
{
    deck d;

    read_accepted(FOUR_BAR "length = 20 mm\n[load]\nlink = crank\n"
                           "torque = 0" DEGREE " 1 Nm, 90" DEGREE " " MINUS "3 Nm,180 1 N" DOT
                           "m\n",
                  NULL, &d);
    assert_int_equal(given_load(&d, 0)->values.torque_curve.n, 3);
    assert_near(flk_curve_piece(&given_load(&d, 0)->values.torque_curve, 90 * DEG, 90 * DEG), -3,
                1e-12);
    flk_deck_free(&d);
    check_mistake(
        FOUR_BAR "length = 20 mm\n[load]\nlink = crank\ntorque = 0 deg 1,5 N m, 90 deg 3 N m\n",
        NULL, 14,
        "'0 deg 1,5 N m, 90 deg 3 N m': a comma as decimal mark? write a point, and a blank "
        "after the comma between two points of a curve");
}

int main(void)
{
    return run_all_tests(NULL);
}
