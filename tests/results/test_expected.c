/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_expected.c - the values that a source printed against those computed.
*/
#include "machines.h"

#define OK FOURLINK_AGREES
#define DIFFERS FOURLINK_DIFFERS

/* The checks of an opened deck, all of them; they are there until its results are freed. */
typedef struct taken {
    unsigned long n;
    fourlink_check list[40];
} taken;

static void take(fourlink_results *r, taken *t)
{
    unsigned long i;

    t->n = problem_of(r).n_expected;
    assert_true(t->n <= 40);
    for (i = 0; i < t->n; i++) {
        fourlink_check *c = &t->list[i];

        assert_int_equal(fourlink_results_check(r, i, c), FOURLINK_OK);
        assert_int_equal(c->message[0] != '\0', c->verdict == FOURLINK_NO_VALUE);
    }
    assert_int_equal(fourlink_results_check(r, t->n, &t->list[0]), FOURLINK_NO_SUCH_ROW);
}

static fourlink_results *checked(const char *contents, taken *t)
{
    fourlink_results *r = opened(contents);

    take(r, t);
    return r;
}

/* A hint is for what differs. */
static void check_hint(const fourlink_check *c)
{
    if (c->hint[0])
        assert_int_equal(c->verdict, FOURLINK_DIFFERS);
}

/* The check of a deck that has a single expectation, which can be compared. */
static fourlink_check one_check(const char *contents)
{
    static char unit_name[100];
    taken t = {0};
    fourlink_results *r = checked(contents, &t);

    assert_int_equal(t.n, 1);
    if (t.list[0].verdict == FOURLINK_NO_VALUE)
        fail_msg("%s\n%s", t.list[0].message, contents);
    assert_true(strlen(t.list[0].unit) < sizeof unit_name);
    t.list[0].unit = strcpy(unit_name, t.list[0].unit); /* it is the deck's */
    t.list[0].file = NULL;
    check_hint(&t.list[0]);
    fourlink_results_free(r);
    return t.list[0];
}

/* An engine of n = l / r, in millimetres; 8 lines. */
static char *engine(double rod, const char *expectations)
{
    return print("mechanism = slider-crank\n[units]\nlength = mm\n[crank]\nlength = 100\n[rod]\n"
                 "length = %.17g\n\n%s",
                 rod, expectations);
}

TEST(test_half_of_the_last_digit)
{
    static const struct {
        double rod; /* mm, with a crank of 100 mm */
        const char *printed;
        double tolerance;
        fourlink_verdict verdict;
    } cases[] = {{250.4, "2.50", 0.005, OK},
                 {250.6, "2.50", 0.005, DIFFERS},
                 {249.6, "2.50", 0.005, OK},
                 {249.4, "2.50", 0.005, DIFFERS},
                 {250.6, "2.5", 0.05, OK},
                 {255.1, "2.5", 0.05, DIFFERS},
                 {254.9, "25e-1", 0.05, OK},
                 {255.1, "25e-1", 0.05, DIFFERS},
                 {250.4, "250e-2", 0.005, OK},
                 {250.6, "250e-2", 0.005, DIFFERS},
                 {254.9, "0.25e1", 0.05, OK},
                 {255.1, "0.25E+1", 0.05, DIFFERS},
                 {250.4, "0.250e1", 0.005, OK},
                 {250.6, "0.250e1", 0.005, DIFFERS},
                 {349.9, "3", 0.5, OK},
                 {250.4, "3", 0.5, OK},
                 {350.1, "3", 0.5, DIFFERS},
                 {350.1, "3.", 0.5, DIFFERS},
                 {250.4, "2", 0.5, DIFFERS},
                 {250.4, "+2.504", 0.0005, OK},
                 {1204, "12.0", 0.05, OK},
                 {1254, "12", 0.5, DIFFERS},
                 {1249, "1.2e1", 0.5, OK},
                 {1251, "1.2e1", 0.5, DIFFERS},
                 {1499, "1e1", 5, OK},
                 {1501, "1e1", 5, DIFFERS},
                 {12400, "1.2e2", 5, OK},
                 {12400, "120", 0.5, DIFFERS},
                 {250.4, "2.5040000000000", 5e-14, OK},
                 {250.4000001, "2.5040000000000", 5e-14, DIFFERS},
                 /* halfway between two digits: printed either way */
                 {250.5, "2.50", 0.005, OK},
                 {250.5, "2.51", 0.005, OK},
                 {250.5, "2.52", 0.005, DIFFERS},
                 {250.5, "2.49", 0.005, DIFFERS},
                 {250, "-2.50", 0.005, DIFFERS}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_check c =
            one_check(engine(cases[i].rod, print("[expect]\nn = %s\n", cases[i].printed)));

        if (c.verdict != cases[i].verdict)
            fail_msg("n = %s with a rod of %g mm: %d, expected %d", cases[i].printed, cases[i].rod,
                     (int)c.verdict, (int)cases[i].verdict);
        assert_close(c.tolerance, cases[i].tolerance, 1e-12);
        assert_close(c.computed, cases[i].rod / 100, 1e-15);
        assert_false(c.has_angle);
        assert_string_equal(c.words, "");
        assert_string_equal(c.name, "n");
        assert_string_equal(c.printed_text, cases[i].printed);
    }
}

/* In the unit that was printed, whatever that of the deck. */
TEST(test_printed_units)
{
    static const struct {
        const char *printed;
        double value, tolerance;
        fourlink_verdict verdict;
    } table[] = {{"200 mm", 200, 0.5, OK},
                 {"200.4 mm", 200.4, 0.05, DIFFERS},
                 {"0.200 m", 200, 0.5, OK},
                 {"0.2 m", 200, 50, OK},
                 {"0.201 m", 201, 0.5, DIFFERS},
                 {"20.0 cm", 200, 0.5, OK},
                 {"7.874 in", 7.874 * 25.4, 0.0127, OK},
                 {"7.875 in", 7.875 * 25.4, 0.0127, DIFFERS},
                 {"2e2", 200, 50, OK},
                 {"200.0", 200, 0.05, OK},
                 {"249", 249, 0.5, DIFFERS}};
    size_t i;

    for (i = 0; i < COUNT(table); i++) {
        fourlink_check c =
            one_check(engine(300, print("[expect]\nstroke = %s\n", table[i].printed)));

        if (c.verdict != table[i].verdict)
            fail_msg("stroke = %s: %d", table[i].printed, (int)c.verdict);
        assert_close(c.printed, table[i].value, 1e-14);
        assert_close(c.tolerance, table[i].tolerance, 1e-12);
        assert_near(c.computed, 200, 1e-12);
        assert_string_equal(c.unit, "mm");
    }
}

TEST(test_tolerances)
{
    static const struct {
        const char *tolerance;
        double printed; /* mm, of a stroke of 200 */
        fourlink_verdict verdict;
    } cases[] = {{"3 mm", 202.9, OK},
                 {"3 mm", 203.1, DIFFERS},
                 {"3 mm", 197.1, OK},
                 {"3 mm", 196.9, DIFFERS},
                 {"3", 202.9, OK}, /* in the deck's unit */
                 {"3", 203.1, DIFFERS},
                 {"0.3 cm", 202.9, OK},
                 {"0.3 cm", 203.1, DIFFERS},
                 {"0.1 mm", 200.09, OK},
                 {"0.1 mm", 200.11, DIFFERS},
                 {"0 mm", 200, OK},
                 {"0 mm", 200.001, DIFFERS},
                 /* of the printed value */
                 {"2 %", 204, OK},
                 {"2 %", 204.2, DIFFERS},
                 {"2%", 196.1, OK},
                 {"2%", 196, DIFFERS},
                 {"0.01 %", 200.02, OK},
                 {"0.01 %", 200.03, DIFFERS},
                 {"0.05", 200.04, OK}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_check c =
            one_check(engine(300, print("[expect]\ntolerance = %s\nstroke = %.10g mm\n",
                                        cases[i].tolerance, cases[i].printed)));

        if (c.verdict != cases[i].verdict)
            fail_msg("stroke = %g mm, tolerance = %s: %d", cases[i].printed, cases[i].tolerance,
                     (int)c.verdict);
    }
}

/* Per cent of a negative value; a tolerance holds for all values of its section alone. */
TEST(test_tolerances_of_sections)
{
    static const fourlink_verdict expected[] = {OK, DIFFERS, OK, DIFFERS, DIFFERS};
    taken t = {0};
    fourlink_results *r;
    unsigned long i;

    r = checked(four_bar(0.020, 0.066, 0.056, 0.080,
                         "[motion]\nspeed = 10.5 rad/s\n[expect]\n"
                         "at = 40 deg\ntolerance = 1 %\n"
                         "omega3 = -3.18 rad/s\n[expect]\nat = 40 deg\n"
                         "tolerance = 1 %\nomega3 = -3.19 rad/s\n"
                         "theta4 = 104.5\n[expect]\nat = 40 deg\n"
                         "tolerance = 1 %\ntheta4 = 105.0\n"
                         "[expect]\nat = 40 deg\nomega3 = -3.18 rad/s\n"),
                &t);
    assert_int_equal(t.n, 5);
    for (i = 0; i < 5; i++)
        assert_int_equal(t.list[i].verdict, expected[i]);
    assert_true(t.list[0].has_angle);
    assert_int_equal(t.list[0].line, 15);
    assert_true(t.list[0].tolerance > 0);
    fourlink_results_free(r);
}

/* A tolerance below 0 is a mistake in both of its forms. */
TEST(test_negative_tolerances)
{
    static const char *const forms[] = {"-3 mm", "-2 %"};
    int outcome[2], i;

    for (i = 0; i < 2; i++) {
        taken t = {0};

        fourlink_results_free(checked(
            engine(300, print("[expect]\ntolerance = %s\nstroke = 201 mm\n", forms[i])), &t));
        outcome[i] = (int)t.list[0].verdict;
    }
    assert_int_equal(outcome[0], outcome[1]);
    assert_int_equal(outcome[0], FOURLINK_NO_VALUE);
}

/* Expectations with what comes of each. */
typedef struct verdict_of {
    const char *expectation; /* the end of a deck */
    fourlink_verdict verdict;
} verdict_of;

static void check_verdicts(char *deck_with(const char *), const verdict_of *cases, size_t n)
{
    size_t i;

    for (i = 0; i < n; i++) {
        fourlink_check c = one_check(deck_with(cases[i].expectation));

        if (c.verdict != cases[i].verdict)
            fail_msg("%d, expected %d: %s", (int)c.verdict, (int)cases[i].verdict,
                     cases[i].expectation);
    }
}

static char *engine_of_300(const char *expectations)
{
    return engine(300, expectations);
}

static char *alvi(const char *expectations)
{
    return four_bar(0.020, 0.066, 0.056, 0.080,
                    print("[motion]\nspeed = 10.5 rad/s\n%s", expectations));
}

TEST(test_misprints)
{
    static const verdict_of cases[] = {
        {"[expect]\nstroke = 200 mm\n", OK},
        {"[expect]\nstroke = 210 mm\n", DIFFERS},
        {"[misprint]\nstroke = 210 mm\n", FOURLINK_MISPRINT},
        {"[misprint]\nstroke = 200 mm\n", FOURLINK_NO_MISPRINT},
        /* a misprint is outside its tolerance */
        {"[misprint]\ntolerance = 11 mm\nstroke = 210 mm\n", FOURLINK_NO_MISPRINT},
        {"[misprint]\ntolerance = 4 %\nstroke = 210 mm\n", FOURLINK_MISPRINT},
        {"[misprint]\ntype = double rocker\n", FOURLINK_MISPRINT},
        {"[misprint]\ntype = slider-crank, the crank turns fully\n", FOURLINK_NO_MISPRINT}};

    check_verdicts(engine_of_300, cases, COUNT(cases));
}

TEST(test_angles_modulo_a_turn)
{
    static const char *const right[] = {"103.820765 deg",  "463.820765 deg",  "-256.179235 deg",
                                        "3703.820765 deg", "1.812014178 rad", "0.28839101 rev",
                                        "-0.71160899 rev"};
    static const char *const wrong[] = {"103.820775 deg", "463.820775 deg",  "-256.179225 deg",
                                        "283.820765 deg", "-103.820765 deg", "1.28839104 rev"};
    static const verdict_of cases[] = {
        /* on either side of the turn, in a unit whose turn is not 360 */
        {"[expect]\ntheta2_from = 360 deg\n", OK},
        {"[expect]\ntheta2_from = 359.9 deg\n", DIFFERS},
        {"[expect]\ntolerance = 0.2 deg\ntheta2_from = 359.9 deg\n", OK},
        {"[units]\nangle = rev\n[expect]\nat = 40 deg\ntheta4 = 1.288391\n", OK},
        {"[units]\nangle = rev\n[expect]\nat = 40 deg\ntheta4 = 1.288393\n", DIFFERS},
        /* what is no angle does not come round */
        {"[expect]\nat = 40 deg\nomega3 = 356.845 rad/s\n", DIFFERS},
        /* `at` counts on past a turn */
        {"[expect]\nat = 400 deg\ntheta4 = 103.820765 deg\n", OK},
        {"[expect]\nat = 0.69813170 rad\ntheta4 = 103.82076 deg\n", OK}};
    fourlink_check c;
    int i;

    for (i = 0; i < 7; i++) {
        c = one_check(alvi(print("[expect]\nat = 40 deg\ntheta4 = %s\n", right[i])));
        if (c.verdict != FOURLINK_AGREES)
            fail_msg("theta4 = %s: %d", right[i], (int)c.verdict);
        assert_near(c.computed, 103.82076481271876, 1e-9);
    }
    for (i = 0; i < 6; i++) {
        c = one_check(alvi(print("[expect]\nat = 40 deg\ntheta4 = %s\n", wrong[i])));
        if (c.verdict != FOURLINK_DIFFERS)
            fail_msg("theta4 = %s: %d", wrong[i], (int)c.verdict);
    }
    check_verdicts(alvi, cases, COUNT(cases));
}

TEST(test_facts_in_words)
{
    static const verdict_of cases[] = {
        {"[expect]\ntype = crank-rocker\n", OK},       {"[expect]\ntype = Crank-Rocker\n", OK},
        {"[expect]\ntype = crank rocker\n", OK},       {"[expect]\ntype = crank_rocker\n", OK},
        {"[expect]\ntype = crank  rocker\n", DIFFERS}, {"[expect]\ntype = crankrocker\n", DIFFERS},
        {"[expect]\ntype = rocker crank\n", DIFFERS},  {"[expect]\ntype = rocker-crank\n", DIFFERS},
        {"[expect]\ntype = crank\n", DIFFERS},         {"[expect]\ntype = 5 mm\n", DIFFERS}};
    static const verdict_of double_cranks[] = {{"[expect]\ntype = double crank (drag link)\n", OK},
                                               {"[expect]\ntype = double-crank\n", OK},
                                               {"[expect]\ntype = Double crank\n", OK},
                                               {"[expect]\ntype = double crank (drag\n", DIFFERS},
                                               {"[expect]\ntype = double\n", DIFFERS}};
    size_t i;

    check_verdicts(alvi, cases, COUNT(cases));
    for (i = 0; i < COUNT(double_cranks); i++) {
        fourlink_check c =
            one_check(four_bar(0.06, 0.06, 0.06, 0.04, double_cranks[i].expectation));

        assert_string_equal(c.words, "double crank (drag link)");
        assert_int_equal(c.verdict, double_cranks[i].verdict);
    }
    for (i = 0; i < COUNT(cases); i++) {
        fourlink_check c = one_check(alvi(cases[i].expectation));

        assert_string_equal(c.words, "crank-rocker");
        assert_string_equal(c.unit, "");
    }
}

TEST(test_branches_of_expectations)
{
    static const verdict_of cases[] = {
        {"[expect]\nat = 40 deg\ntheta4 = 103.820765 deg\n", OK}, /* open where it does not say */
        {"[expect]\nat = 40 deg\nbranch = crossed\ntheta4 = -126.30 deg\n", OK},
        {"[expect]\nat = 40 deg\nbranch = open\ntheta4 = -126.30 deg\n", DIFFERS},
        {"[expect]\nbranch = crossed\ntheta4_max = -103.818044198 deg\n", OK},
        {"[table]\nbranch = crossed\n[expect]\nat = 40 deg\ntheta4 = -126.30 deg\n", OK},
        {"[table]\nbranch = open\n[expect]\nat = 40 deg\nbranch = crossed\n"
         "theta4 = -126.30 deg\n",
         OK}};

    check_verdicts(alvi, cases, COUNT(cases));
}

/* The branches of the table are a matter of what is printed, for facts as for columns. */
TEST(test_fact_of_a_branch_not_printed)
{
    static const verdict_of cases[] = {{"[table]\nbranch = open\n[expect]\nbranch = crossed\n"
                                        "theta4_max = -103.818044198 deg\n",
                                        OK}};

    check_verdicts(alvi, cases, COUNT(cases));
}

TEST(test_extremes_expected)
{
    static const verdict_of cases[] = {
        {"[expect]\nmax(theta4) = 145.906609 deg\n", OK},
        {"[expect]\nmin( theta4 ) = 103.818044 deg\n", OK},
        {"[expect]\nmin(theta4) = 145.906609 deg\n", DIFFERS},
        {"[expect]\nbranch = crossed\nmax(theta4) = -103.818044 deg\n", OK}};

    check_verdicts(alvi, cases, COUNT(cases));
    assert_false(one_check(alvi(cases[0].expectation)).has_angle);
    assert_int_equal(
        one_check(engine(300, "[motion]\nspeed = 1 rad/s\n[expect]\nmax(x) = 200.0 mm\n")).verdict,
        OK);
}

/* Each of two ranges of the crank has facts by the same names. */
TEST(test_expectations_of_the_second_range)
{
    fourlink_check c = one_check(slider_crank(0.4, 0.2, 0, "[expect]\ntheta2_to = 30.0 deg\n"));

    assert_int_equal(c.verdict, OK);
    c = one_check(slider_crank(0.4, 0.2, 0, "[expect]\ntheta2_to = 210.0 deg\n"));
    assert_int_equal(c.verdict, OK);
    c = one_check(slider_crank(0.4, 0.2, 0, "[expect]\ntheta2_to = 40.0 deg\n"));
    assert_int_equal(c.verdict, DIFFERS);
}

TEST(test_expectations_at_one_instant)
{
    fourlink_check c = one_check(four_bar(0.020, 0.066, 0.056, 0.080,
                                          "[motion]\nspeed = 100 rpm\nat = 40 deg\n[expect]\n"
                                          "theta4 = 103.820765 deg\n"));

    assert_int_equal(c.verdict, OK);
    assert_true(c.has_angle);
    c = one_check(four_bar(0.020, 0.066, 0.056, 0.080,
                           "[motion]\nspeed = 100 rpm\nat = 40 deg\n[expect]\n"
                           "omega2 = 10.472 rad/s\n"));
    assert_int_equal(c.verdict, OK);
    c = one_check(four_bar(0.020, 0.066, 0.056, 0.080,
                           "[motion]\nspeed = 100 rpm\nat = 40 deg\n[expect]\n"
                           "omega2 = 100 rpm\nat = 400 deg\n"));
    assert_int_equal(c.verdict, OK);
}

/* ------------------------------------------------------------------------------- mistakes */

/* A single mistake of a deck: of its text, or of the last value that it expects. */
static void check_mistake(const char *contents, long line, const char *message)
{
    fourlink_source source = deck_source(contents);
    const char *found, *file;
    fourlink_mistake mistake;
    fourlink_results *r = NULL;
    unsigned long n, i;
    long at;
    taken t = {0};

    if (fourlink_results_open(&source, 1, &r, &mistake, &n) == FOURLINK_OK) {
        take(r, &t);
        assert_true(t.n > 0);
        for (n = 0, i = 0; i < t.n; i++)
            n += t.list[i].verdict == FOURLINK_NO_VALUE;
        assert_int_equal(t.list[t.n - 1].verdict, FOURLINK_NO_VALUE);
        found = t.list[t.n - 1].message;
        file = t.list[t.n - 1].file;
        at = t.list[t.n - 1].message_line;
    } else {
        found = mistake.message;
        file = mistake.file;
        at = mistake.line;
    }
    if (n != 1)
        fail_msg("%lu mistakes in\n%s", n, contents);
    if (strcmp(found, message) != 0 || at != line)
        fail_msg("x.deck:%ld: %s\nexpected at %ld: %s", at, found, line, message);
    assert_string_equal(file, "x.deck");
    fourlink_results_free(r);
}

TEST(test_mistakes_of_names)
{
    check_mistake(engine(300, "[expect]\nn = 3\nstrok = 200 mm\n"), 11,
                  "'strok' is neither a column nor a fact of this deck; did you mean 'stroke'?");
}

TEST(test_mistakes_of_columns)
{
    check_mistake(engine(300, "[expect]\nat = 40 deg\nomga3 = 3 rad/s\n"), 11,
                  "'omga3' is neither a column nor a fact of this deck; did you mean 'omega3'?");
    check_mistake(engine(300, "[expect]\nxyzzy = 3 rad/s\n"), 10,
                  "'xyzzy' is neither a column nor a fact of this deck; see --list");
    check_mistake(engine(300, "[expect]\nmax(omga3) = 3 rad/s\n"), 10,
                  "'omga3' is neither a column nor a fact of this deck; did you mean 'omega3'?");
    check_mistake(engine(300, "[misprint]\nn = 2\nxyzzy = 3\n"), 11,
                  "'xyzzy' is neither a column nor a fact of this deck; see --list");
    /* what people call them */
    check_mistake(engine(300, "[expect]\nat = 40 deg\nw3 = 3 rad/s\n"), 11,
                  "'w3' is neither a column nor a fact of this deck; did you mean 'omega3'?");
    check_mistake(engine(300, "[expect]\nmax(a3) = 3 rad/s2\n"), 10,
                  "'a3' is neither a column nor a fact of this deck; did you mean 'alpha3'?");
    check_mistake(engine(300, "[expect]\nVelocity = 3 rad/s2\n"), 10,
                  "'Velocity' is neither a column nor a fact of this deck; did you mean 'v'?");
    /* of the other mechanism, or of a deck with forces */
    check_mistake(engine(300, "[expect]\nswing = 30 deg\n"), 10,
                  "'swing' is neither a column nor a fact of this deck; see --list");
    check_mistake(engine(300, "[expect]\nmean_torque = 30 N m\n"), 10,
                  "'mean_torque' is neither a column nor a fact of this deck; see --list");
    check_mistake(engine(300, "[expect]\nat = 40 deg\nx = 30 mm\nv = 1\nspeed = 1 rpm\n"), 13,
                  "'speed' is neither a column nor a fact of this deck; see --list");
}

TEST(test_mistakes_of_units)
{
    check_mistake(engine(300, "[expect]\nstroke = 200 deg\n"), 10,
                  "'200 deg' is an angle; expected a length, such as 80 mm");
    check_mistake(engine(300, "[expect]\nn = 3 mm\n"), 10,
                  "'3 mm' is a length; expected a number, such as 0.02");
    check_mistake(engine(300, "[expect]\nat = 40 deg\nv = 3 mm\n"), 11,
                  "'3 mm' is a length; expected a speed, such as 2 m/s");
    check_mistake(engine(300, "[expect]\nmax(x) = 3 s\n"), 10,
                  "'3 s' is a time; expected a length, such as 80 mm");
    check_mistake(engine(300, "[expect]\nstroke = 200 xyzzy\n"), 10,
                  "unknown unit 'xyzzy' in '200 xyzzy'");
    check_mistake(engine(300, "[expect]\nstroke = long\n"), 10,
                  "expected a length, such as 80 mm, not 'long'");
    check_mistake(engine(300, "[expect]\nstroke = 0,2 m\n"), 10,
                  "'0,2 m': a comma as decimal mark: write 0.2");
    check_mistake(engine(300, "[expect]\nstroke = nan mm\n"), 10,
                  "'nan mm' is not a finite number");
}

TEST(test_mistakes_of_tolerances)
{
    check_mistake(engine(300, "[expect]\ntolerance = 1 kg\nstroke = 200 mm\n"), 10,
                  "'1 kg' is a mass; expected a length, such as 80 mm");
    check_mistake(engine(300, "[expect]\ntolerance = 1 mm\nn = 3\n"), 10,
                  "'1 mm' is a length; expected a number, such as 0.02");
    check_mistake(engine(300, "[expect]\ntolerance = none\nn = 3\n"), 10,
                  "expected a number, such as 0.02, not 'none'");
}

TEST(test_mistakes_of_places)
{
    check_mistake(engine(300, "[expect]\nx = 20 mm\n"), 10,
                  "x has no 'at' above it: a column needs a crank angle");
    check_mistake(engine(300, "[expect]\nn = 3\nat = 40 mm\n"), 11,
                  "'40 mm' is a length; expected an angle, such as 40 deg");
    check_mistake(four_bar(0.3, 0.4, 0.5, 0.75,
                           "[expect]\nat = 120 deg\nbranch = crossed\ntheta4 = 100 deg\n"),
                  13,
                  "no value at theta2 = 120 deg, crossed: cannot be assembled: B and D are too "
                  "far apart");
    check_mistake(slider_crank(0.4, 0.2, 0, "[expect]\nat = 90 deg\nx = 0.1 m\n"), 10,
                  "no value at theta2 = 90 deg, open: the rod does not reach the line of stroke");
    check_mistake(four_bar(0.3, 0.4, 0.5, 0.75,
                           "[motion]\nspeed = 1 rad/s\nfrom = 120 deg\nto = 200 deg\n[expect]\n"
                           "max(theta4) = 100 deg\n"),
                  15, "the linkage cannot be assembled at any angle of the motion");
}

/* The rocker of a drag link goes on and on: theta4 has no largest value, but the links reach. */
TEST(test_mistake_of_an_angle_without_extremes)
{
    taken t = {0};
    fourlink_results *r = checked(four_bar(0.50, 0.45, 0.60, 0.20,
                                           "[motion]\nspeed = 1 rad/s\n[expect]\n"
                                           "max(theta4) = 180 deg\n"),
                                  &t);

    if (t.list[0].verdict == FOURLINK_NO_VALUE) {
        assert_int_equal(t.list[0].message_line, 13);
        assert_string_not_equal(t.list[0].message,
                                "the linkage cannot be assembled at any angle of the motion");
    }
    fourlink_results_free(r);
}

/* The crank comes to rest after 143.2 deg: at 150 deg there is nothing to compare with. */
TEST(test_mistake_beyond_the_end_of_a_motion)
{
    check_mistake(four_bar(0.020, 0.066, 0.056, 0.080,
                           "[motion]\nspeed = 10 rad/s\nacceleration = -20 rad/s2\n[expect]\n"
                           "at = 150 deg\nomega4 = 0 rad/s\n"),
                  15, "the motion does not reach theta2 = 150 deg");
}

/* Each value has a mistake of its own, where it stands. */
TEST(test_all_mistakes_in_one_run)
{
    static const long lines[] = {11, 12, 14, 17};
    taken t = {0};
    fourlink_results *r = checked(engine(300, "[expect]\nn = 3\nxyzzy = 1\nstroke = 1 kg\n"
                                              "[expect]\nx = 20 mm\n[expect]\nat = 0\nv = 1 mm\n"),
                                  &t);
    int i;

    assert_int_equal(t.n, 5); /* the first is in order, the others have no value */
    assert_int_equal(t.list[0].verdict, FOURLINK_AGREES);
    for (i = 0; i < 4; i++) {
        assert_int_equal(t.list[i + 1].verdict, FOURLINK_NO_VALUE);
        assert_int_equal(t.list[i + 1].message_line, lines[i]);
    }
    fourlink_results_free(r);
}

/* A file of its own takes the place of the deck's expectations; its mistakes have its name and lines. */
TEST(test_expectations_of_another_file)
{
    fourlink_mistake mistake;
    fourlink_results *r;
    unsigned long n;
    taken t = {0};

    assert_int_equal(open_with_answers(engine(300, "[expect]\nn = 3\n"),
                                       "[misprint]\nn = 4\n[expect]\nstroke = 20 cm\n", &r,
                                       &mistake),
                     FOURLINK_OK);
    take(r, &t);
    assert_int_equal(t.n, 2);
    assert_int_equal(t.list[0].verdict, FOURLINK_MISPRINT);
    assert_string_equal(t.list[0].file, "y.expect");
    assert_int_equal(t.list[0].line, 2);
    assert_int_equal(t.list[1].verdict, FOURLINK_AGREES);
    fourlink_results_free(r);

    assert_int_equal(open_with_answers(engine(300, ""), "[expect]\n\nxyzzy = 4\n", &r, &mistake),
                     FOURLINK_OK);
    take(r, &t);
    assert_int_equal(t.list[0].verdict, FOURLINK_NO_VALUE);
    assert_string_equal(t.list[0].file, "y.expect");
    assert_int_equal(t.list[0].message_line, 3);
    fourlink_results_free(r);

    assert_int_equal(open_with_answers(engine(300, ""), "[expect]\n[ground]\n", &r, &mistake),
                     FOURLINK_OK);
    assert_int_equal(fourlink_results_slips(r, 1, &mistake, &n), FOURLINK_OK);
    assert_int_equal(n, 1);
    assert_string_equal(mistake.file, "y.expect");
    assert_int_equal(mistake.line, 2);
    fourlink_results_free(r);
}

TEST(test_nothing_expected)
{
    taken t = {0};
    fourlink_results *r = checked(engine(300, ""), &t);

    assert_int_equal(t.n, 0);
    fourlink_results_free(r);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
