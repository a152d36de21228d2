/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_hint.c - answers for a deck of one branch, and why a value may differ.
*/
#include "machines.h"

#define OK FOURLINK_AGREES
#define DIFFERS FOURLINK_DIFFERS

/* An engine of n = l / r, in millimetres; 8 lines. */
static char *engine(double rod, const char *expectations)
{
    return print("mechanism = slider-crank\n[units]\nlength = mm\n[crank]\nlength = 100\n[rod]\n"
                 "length = %.17g\n\n%s",
                 rod, expectations);
}

static char *alvi(const char *expectations)
{
    return four_bar(0.020, 0.066, 0.056, 0.080,
                    print("[motion]\nspeed = 10.5 rad/s\n%s", expectations));
}

/* A deck that asks for one branch is checked on that one. */
TEST(test_answers_for_one_branch)
{
    static const struct {
        const char *answers, *branch;
        unsigned long n;
        fourlink_branch on;
        fourlink_verdict verdict; /* of the first */
    } cases[] = {
        {"[expect]\nat = 40 deg\nbranch = open\ntheta4 = 103.8 deg\n"
         "[expect]\nat = 40 deg\nbranch = crossed\ntheta4 = -125.2 deg\n",
         "open", 1, FOURLINK_OPEN, OK},
        {"[expect]\nat = 40 deg\nbranch = open\ntheta4 = 103.8 deg\n"
         "[expect]\nat = 40 deg\nbranch = crossed\ntheta4 = 103.8 deg\n",
         "crossed", 1, FOURLINK_CROSSED, DIFFERS},
        {"[expect]\nat = 40 deg\nbranch = open\ntheta4 = 103.8 deg\nomega4 = 1 rad/s\n", "crossed",
         2, FOURLINK_CROSSED, DIFFERS},
        {"[expect]\nat = 40 deg\ntheta4 = 103.8 deg\n", "crossed", 1, FOURLINK_CROSSED, DIFFERS},
        {"[expect]\nat = 40 deg\nbranch = open\ntheta4 = 103.8 deg\n"
         "[expect]\nat = 40 deg\nbranch = crossed\ntheta4 = 103.8 deg\n",
         "both", 2, FOURLINK_OPEN, OK}};
    fourlink_mistake mistake;
    fourlink_results *r;
    fourlink_check check;
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        assert_int_equal(open_with_answers(alvi(print("[table]\nbranch = %s\n", cases[i].branch)),
                                           cases[i].answers, &r, &mistake),
                         FOURLINK_OK);
        assert_int_equal(problem_of(r).n_expected, cases[i].n);
        assert_int_equal(fourlink_results_check(r, 0, &check), FOURLINK_OK);
        assert_int_equal(check.branch, cases[i].on);
        assert_int_equal(check.verdict, cases[i].verdict);
        if (cases[i].verdict == DIFFERS)
            assert_string_equal(check.hint, "103.8 deg is the open branch's value");
        fourlink_results_free(r);
    }
}

TEST(test_hints)
{
    static const struct {
        const char *expectation, *hint;
    } cases[] = {{"[expect]\nn = -3.0\n", "the sign is the opposite"},
                 {"[expect]\nstroke = 200 m\n",
                  "the computed value is 1/1000 of this one: a unit such as mm for m?"},
                 {"[expect]\nstroke = 0.200 mm\n",
                  "the computed value is 1000 times this one: a unit such as m for mm?"},
                 {"[expect]\ntolerance = 0.1 mm\nstroke = 0.25 mm\n",
                  "the computed value is 1000 times this one: a unit such as m for mm?"},
                 {"[expect]\ntolerance = 0.1 mm\nstroke = 0.2 mm\n",
                  ""},                                /* so rough a value agrees with many */
                 {"[expect]\nstroke = 0.0 mm\n", ""}, /* half of its digit holds a thousandth */
                 {"[expect]\nstroke = 210 mm\n", ""},
                 {"[misprint]\nn = -3.0\n", ""},
                 {"[expect]\nn = 3.0\n", ""},
                 {"[expect]\ntype = double rocker\n", ""}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_results *r = opened(engine(300, cases[i].expectation));
        fourlink_check check;

        assert_int_equal(fourlink_results_check(r, 0, &check), FOURLINK_OK);
        assert_string_equal(check.hint, cases[i].hint);
        fourlink_results_free(r);
    }
}

/* The angle that the book calls the transmission angle. */
TEST(test_other_transmission_angle)
{
#define BOTH ": mu is acute, gamma is the angle from 0 to 180 deg"
    static const struct {
        const char *expectation, *hint;
    } cases[] = {{"[expect]\nmu_max = 91.79 deg\n", "91.79 deg is gamma_max" BOTH},
                 {"[expect]\nmax(mu) = 91.79 deg\n", "91.79 deg is max(gamma)" BOTH},
                 {"[expect]\nat = 180 deg\nmu = 91.79 deg\n", "91.79 deg is gamma" BOTH},
                 {"[expect]\nat = 180 deg\ngamma = 88.21 deg\n", "88.21 deg is mu" BOTH},
                 {"[expect]\ngamma_max = 90.00 deg\n", "90.00 deg is mu_max" BOTH},
                 {"[expect]\nmu_max = 91 deg\n", ""},
                 {"[expect]\nmu_min = 29.69 deg\n", ""},
                 {"[expect]\ngamma_min = 29.69 deg\n", ""}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_results *r = opened(four_bar(0.04, 0.1, 0.08, 0.09, cases[i].expectation));
        fourlink_check check;

        assert_int_equal(fourlink_results_check(r, 0, &check), FOURLINK_OK);
        assert_string_equal(check.hint, cases[i].hint);
        fourlink_results_free(r);
    }
    /* an engine has no coupler */
    {
        fourlink_results *r = opened(engine(300, "[expect]\nmu_max = 91 deg\n"));
        fourlink_check check;

        assert_int_equal(fourlink_results_check(r, 0, &check), FOURLINK_OK);
        assert_string_equal(check.hint, "");
        fourlink_results_free(r);
    }
}

/* A value of the deck with another line is told by that line. */
TEST(test_slips)
{
    static const struct {
        const char *line, *name, *hint;
    } cases[] = {
        {"gravity.acceleration=0 m/s2", "F23x", "without the weights"},
        {"gravity.acceleration=10 m/s2", "Ts", "with gravity 10 m/s2"},
        {"gravity.acceleration=9.8 m/s2", "F23_dir", "with gravity 9.8 m/s2"},
        {"gravity.acceleration=32.2 ft/s2", "F12", "with gravity 32.2 ft/s2"},
        {"motion.speed=95.492965855137204 rad/s", "Ts", "with the speed in rpm read as rad/s"},
        {"motion.speed=1.0471975511965976 rad/s", "F23x", "with the speed in rad/s read as rpm"},
        {"axes=page", "theta3", "with angles and directions from the horizontal of the page"},
        {"axes=page", "omega4", "with angles and directions from the horizontal of the page"}};
    static const char machine[] =
        "mechanism = four-bar\n[ground]\nlength = 80 mm\nangle = 20 deg\n[crank]\nlength = 20 mm\n"
        "[coupler]\nlength = 66 mm\nmass = 3 kg\nuniform = yes\n[rocker]\nlength = 56 mm\n"
        "[motion]\nspeed = 10 rad/s\n[grading]\ntolerance = 1e-6 %\n";
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_change change = {"test", cases[i].line};
        fourlink_source source = deck_source(machine);
        fourlink_results *r;
        fourlink_value v = {0};
        fourlink_check check;
        char printed[100];

        source.changes = &change;
        source.n_changes = 1;
        assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_OK);
        assert_int_equal(fourlink_results_value(r, cases[i].name, FOURLINK_OPEN, 40, &v),
                         FOURLINK_OK);
        sprintf(printed, "%.15g %s", v.value, v.unit);
        fourlink_results_free(r);
        r = opened(print("%s[expect]\nat = 40 deg\n%s = %s\n", machine, cases[i].name, printed));
        assert_int_equal(fourlink_results_check(r, 0, &check), FOURLINK_OK);
        assert_int_equal(check.verdict, DIFFERS);
        assert_string_equal(check.hint,
                            print("%s is the value %s", check.printed_text, cases[i].hint));
        fourlink_results_free(r);
    }
}

/* Angles to whole degrees, and what follows from them: by Alvi eqs. 4.1 and 4.2, computed by hand. */
TEST(test_carried_on)
{
    static const struct {
        const char *more, *hint;
    } cases[] = {
        {"theta3 = 39 deg\ntheta4 = 104 deg\nomega4 = 0.0722122 rad/s\n",
         "it follows from theta3 = 39 deg, theta4 = 104 deg as written"},
        {"omega4 = 0.0722122 rad/s\ntheta3 = 39 deg\ntheta4 = 104 deg\n", ""}, /* below it */
        {"theta3 = 39 deg\n[expect]\nat = 41 deg\ntheta4 = 104 deg\n[expect]\nat = 40 deg\n"
         "omega4 = 0.0722122 rad/s\n",
         ""}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_results *r =
            opened(alvi(print("[expect]\nat = 40 deg\n%s[grading]\ntolerance = 1 deg\n"
                              "omega4 = 0.0001 %%\n",
                              cases[i].more)));
        fourlink_check check = {0};
        unsigned long k;

        for (k = 0; strcmp(check.name, "omega4") != 0; k++)
            assert_int_equal(fourlink_results_check(r, k, &check), FOURLINK_OK);
        assert_int_equal(check.verdict, DIFFERS);
        assert_string_equal(check.hint, cases[i].hint);
        fourlink_results_free(r);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
