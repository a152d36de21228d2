/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_sweep_lists.c - what a host sees of a sweep: neighbours of a design, conditions of the yield.
*/
#include "machines.h"

static char *linkage(const char *more)
{
    return four_bar(0.020, 0.066, 0.056, 0.080,
                    print("[load Tl]\nlink = rocker\ntorque = 3 N m\n[motion]\nspeed = 10 rad/s\n"
                          "interval = 40 deg\n%s",
                          more));
}

/* The neighbours on the grid: none beyond the ends of a range, in a list, or of a tolerance. */
TEST(test_neighbours)
{
    static const double expected[][3][2] = {{{18, 19}, {100, 100}, {56, 56}},
                                            {{18, 19}, {200, 200}, {56, 56}},
                                            {{18, 20}, {100, 100}, {56, 56}},
                                            {{18, 20}, {200, 200}, {56, 56}},
                                            {{19, 20}, {100, 100}, {56, 56}}};
    fourlink_results *r =
        opened(linkage("[sweep]\ncrank.length = 18 mm to 20 mm step 1 mm\n"
                       "motion.speed = 100 rpm, 200 rpm\nrocker.length = 56 mm +- 1 mm\n"
                       "samples = 1\n[units]\nlength = mm\nangular_speed = rpm\n"));
    double low[3], high[3], values[3];
    size_t i, k;

    for (i = 0; i < COUNT(expected); i++) {
        assert_int_equal(fourlink_results_variables(r, i, 3, values, low, high), FOURLINK_OK);
        for (k = 0; k < 2; k++)
            assert_true(low[k] == expected[i][k][0] && high[k] == expected[i][k][1]);
        assert_true(low[2] == values[2] && high[2] == values[2]);
    }
    high[1] = 5;
    assert_int_equal(fourlink_results_variables(r, 4, 1, values, low, high), FOURLINK_OK);
    assert_true(high[1] == 5);
    fourlink_results_free(r);
}

/* The conditions of a yield: outputs with limits, in the deck's units. */
TEST(test_conditions)
{
    fourlink_results *r = opened(linkage("[sweep]\ncrank.length = 18 mm, 19 mm\noutput = swing\n"
                                         "yield = mu_min > 0.5 rad, swing <= 40\n"));
    const fourlink_value *list;
    unsigned long n;

    assert_true(problem_of(r).has_outputs);
    assert_int_equal(fourlink_results_list(r, FOURLINK_OUTPUTS, &list, &n), FOURLINK_OK);
    assert_int_equal(n, 2);
    assert_string_equal(list[1].name, "mu_min");
    assert_int_equal(fourlink_results_list(r, FOURLINK_CONDITIONS, &list, &n), FOURLINK_OK);
    assert_int_equal(n, 2);
    assert_string_equal(list[0].name, "mu_min");
    assert_string_equal(list[0].unit, "deg");
    assert_string_equal(list[0].meaning, "mu_min > 0.5 rad");
    assert_close(list[0].value, 28.64788975654116, 1e-14);
    assert_int_equal(list[0].flags, FOURLINK_ABOVE);
    assert_string_equal(list[1].name, "swing");
    assert_true(list[1].value == 40);
    assert_int_equal(list[1].flags, FOURLINK_BELOW | FOURLINK_OR_EQUAL);
    fourlink_results_free(r);
}

/* A list of conditions may end with a comma; none may be empty, nor lack a part. */
TEST(test_forms_of_conditions)
{
    static const struct {
        const char *list;
        int is_good;
    } cases[] = {{"mu_min > 0.5 rad, swing <= 40,", 1},
                 {"mu_min > 0.5 rad,, swing <= 40", 0},
                 {", mu_min > 0.5 rad", 0},
                 {"mu_min > , swing <= 40", 0},
                 {"> 0.5 rad", 0},
                 {"mu_min", 0}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        char *deck = linkage(print("[sweep]\ncrank.length = 18 mm, 19 mm\noutput = swing\n"
                                   "yield = %s\n",
                                   cases[i].list));
        fourlink_source source = deck_source(deck);
        fourlink_results *r = NULL;
        fourlink_mistake mistake;

        assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, NULL),
                         cases[i].is_good ? FOURLINK_OK : FOURLINK_BAD_DECK);
        fourlink_results_free(r);
    }
}

/* ------------------------------------------------------------------------------- designs of settings */

/* Sweeps whose values other keys of their section depend on, or that another design has changed before. */
static const char *const sweeps[] = {
    "[sweep]\ncrank.length = 10 mm to 20 mm in 3\ncoupler.length & motion.speed = 66 mm & 3 rad/s, "
    "1 m & 9 rpm\n",
    "[spring K]\nlink = rocker\nto = ground\nstiffness = 2 N m/rad\npreload = 3 N m\ndamping = 1 N "
    "m s/rad\n"
    "[sweep]\nspring K.stiffness = 1 N m/rad, 2 N m/rad\nspring K.damping = 0 N m s/rad, 2 N m "
    "s/rad\n",
    "[spring K]\nlink = rocker\nto = ground\ndamping = 1 N m s/rad\npreload = 3 N m\n"
    "[sweep]\nspring K.stiffness = 1 N m/rad, 2 N m/rad\n",
    "[load F]\nlink = coupler\nforce = 5 N at 30 deg\nat = 50 %\n[sweep]\nload F.force.angle = 0 "
    "deg to 90 deg in 3\n"
    "load F.force.size = 3 N, 4 N\ncoupler.cg.x = 1 mm, 2 mm\ncoupler.mass = 1 kg, 2 kg\n",
    "[point P]\nlink = coupler\nat = (1, 2) mm\n[sweep]\npoint P.at.x = 5 mm +- 1 mm normal\n"
    "load Tl.torque = -2 N m, 2 N m\nsamples = 3\nseed = 4\n",
    "[load V]\nlink = rocker\ntorque = 0 deg 0 N m, 90 deg 1 N m\nover = theta4\nback = 3 N m\n"
    "[flywheel]\nfluctuation = 0.1\n[expect]\nmax(Ts) = 3\n[sweep]\nground.length = 70 mm to 300 "
    "mm in 4\n"
    "load V.back = 1 N m, 2 N m\n"};

static int is_same(const fourlink_value *x, const fourlink_value *y)
{
    return strcmp(x->name, y->name) == 0 && strcmp(x->unit, y->unit) == 0 &&
           (x->value == y->value || (x->value != x->value && y->value != y->value)) &&
           (x->words ? y->words && strcmp(x->words, y->words) == 0 : !y->words);
}

/* Both have the same inputs, variables, columns, facts, extremes and checks, to the last bit. */
static void check_same(fourlink_results *x, fourlink_results *y)
{
    const fourlink_value *a, *b;
    unsigned long n, m, i;
    fourlink_check check, other;
    int which, branch;

    assert_int_equal(problem_of(x).design, problem_of(y).design);
    for (which = FOURLINK_COLUMNS; which <= FOURLINK_CONDITIONS; which++) {
        fourlink_results_list(x, which, &a, &n);
        fourlink_results_list(y, which, &b, &m);
        assert_int_equal(n, m);
        for (i = 0; i < n; i++)
            assert_true(is_same(&a[i], &b[i]));
    }
    for (branch = FOURLINK_CROSSED; branch <= FOURLINK_OPEN; branch++) {
        fourlink_results_facts(x, branch, 7, &a, &n);
        fourlink_results_facts(y, branch, 7, &b, &m);
        assert_int_equal(n, m);
        for (i = 0; i < n; i++)
            assert_true(is_same(&a[i], &b[i]));
    }
    for (i = 0; i < problem_of(x).n_expected; i++) {
        fourlink_results_check(x, i, &check);
        fourlink_results_check(y, i, &other);
        assert_true(check.verdict == other.verdict && check.line == other.line &&
                    check.computed == other.computed);
    }
}

/* The deck that is written of a design has the same inputs, and no variables. */
static void check_written(fourlink_results *r)
{
    const fourlink_value *a, *b;
    unsigned long n, m, length, i;
    fourlink_results *again;
    char text[4000];

    fourlink_deck_write(fourlink_results_deck(r), text, sizeof text, &length);
    again = opened(text);
    assert_int_equal(problem_of(again).n_designs, 0);
    fourlink_results_list(r, FOURLINK_INPUTS, &a, &n);
    fourlink_results_list(again, FOURLINK_INPUTS, &b, &m);
    assert_int_equal(n, m);
    for (i = 0; i < n; i++)
        assert_true(is_same(&a[i], &b[i]));
    fourlink_results_free(again);
}

/* A design that is built from the settings of another is as if it were read from the text. */
TEST(test_designs_of_settings)
{
    size_t i;

    for (i = 0; i < COUNT(sweeps); i++) {
        fourlink_source source = deck_source(linkage(sweeps[i]));
        fourlink_results *first, *built, *again, *read;
        fourlink_mistake mistake, expected;
        unsigned long n, design, n_mistakes, n_expected;
        int status;

        source.answers = "[expect]\nbranch = open\nmax(theta4) = 3\n";
        source.answers_length = (unsigned long)strlen(source.answers);
        source.design = FOURLINK_ANY_DESIGN;
        assert_int_equal(fourlink_results_open(&source, 1, &first, &mistake, NULL), FOURLINK_OK);
        n = problem_of(first).n_designs;
        assert_int_equal(fourlink_results_design(first, n, 1, &built, &mistake, NULL),
                         FOURLINK_BAD_NUMBER);
        for (design = n; design-- > 0;) {
            if (design % 3 && !tries_all())
                continue;
            source.design = design;
            status = fourlink_results_open(&source, 1, &read, &expected, &n_expected);
            assert_int_equal(
                fourlink_results_design(first, design, 1, &built, &mistake, &n_mistakes), status);
            if (status != FOURLINK_OK) {
                assert_int_equal(n_mistakes, n_expected);
                assert_string_equal(mistake.message, expected.message);
                assert_string_equal(mistake.file, expected.file);
                assert_int_equal(mistake.line, expected.line);
                continue;
            }
            check_same(built, read);
            assert_int_equal(fourlink_results_design(built, design, 0, &again, NULL, NULL),
                             FOURLINK_OK);
            check_same(again, read);
            check_written(built);
            fourlink_results_free(again);
            fourlink_results_free(read);
            fourlink_results_free(built);
        }
        fourlink_results_free(first);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
