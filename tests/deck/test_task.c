/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_task.c - [synthesis]: what its values mean; what a host is given; the deck that is written is the deck
** that is read.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "check.h"
#include "deck/synthesis.h"
#include "deck/found.h"
#include "read.h"
#include "deck/reader.h"

#define FOUR_BAR "mechanism = four-bar\n"
#define GROUND "[ground]\nlength = 100 mm\n"

static int read_task(const char *text_of_deck, unsigned long solution, deck *d)
{
    fourlink_source source = deck_source(text_of_deck);

    source.synthesis = solution;
    return flk_deck_read(&source, d);
}

static void near(double computed, double expected, double tolerance)
{
    if (!(fabs(computed - expected) <= tolerance))
        fail_msg("%.17g, expected %.17g", computed, expected);
}

TEST(test_points)
{
    deck d;
    const fourlink_function_task *t;

    assert_int_equal(
        read_task(FOUR_BAR GROUND
                  "[synthesis]\ntask = function\nfit = angle\nweights = 1, 2, 1, 3\n"
                  "points = 36 deg 64 deg, 75 98, 114\302\260 142\302\260,\n 1.3 rad 100 deg\n",
                  1, &d),
        1);
    t = &d.synthesis->function;
    assert_int_equal(t->n, 4);
    assert_int_equal(t->fit, FOURLINK_FIT_ANGLE);
    near(t->theta2[0], 36 * DEG, 1e-15);
    near(t->output[1], 98 * DEG, 1e-15);
    near(t->output[2], 142 * DEG, 1e-15);
    near(t->theta2[3], 1.3, 0);
    near(t->weight[3], 3, 0);
    near(t->ground, 0.1, 0);
    near(d.synthesis->mu_min, 40 * DEG, 1e-15); /* as fourlink-deck(5) says */
    flk_deck_free(&d);
}

/* The function at the ends of its range, and the error that the header's function gives there. */
TEST(test_function)
{
    deck d;
    const deck_synthesis *t;
    double error;

    assert_int_equal(read_task(FOUR_BAR GROUND
                               "[synthesis]\ntask = function\nfunction = x^1.5\nx = 1 to 4\n"
                               "crank = 30 to 120 deg\nrocker = 60 deg to 150 deg\n",
                               1, &d),
                     1);
    t = d.synthesis;
    assert_int_equal(t->function.n, 3);
    near(t->function.wanted(t->function.host, 30 * DEG), 60 * DEG, 1e-14);
    near(t->function.wanted(t->function.host, 120 * DEG), 150 * DEG, 1e-14);
    near(t->function.wanted(t->function.host, 60 * DEG), (60 + 90 * (sqrt(8) - 1) / 7) * DEG,
         1e-14);
    assert_true(gsl_isnan(t->function.wanted(t->function.host, 20 * DEG)));
    error = flk_synthesis_error(t, t->chosen->max_error_at);
    near(error, t->chosen->max_error, 1e-12);
    near(fabs(error), 1.053501 * DEG, 1e-7);
    flk_deck_free(&d);
}

TEST(test_motion)
{
    deck d;
    const fourlink_motion_task *t;

    assert_int_equal(
        read_task(FOUR_BAR "[synthesis]\ntask = motion\n"
                           "positions = (0, 0) mm 0 deg, (12, 5) mm 18 deg, (21, 16) mm 47 deg\n"
                           "left = fixed (5, 35) mm\nright = rotations 20 deg -50 deg\n",
                  1, &d),
        1);
    t = &d.synthesis->motion;
    near(t->point[2].x, 0.021, 1e-18);
    near(t->point[2].y, 0.016, 1e-18);
    near(t->angle[1], 18 * DEG, 1e-15);
    assert_int_equal(t->left.choice, FOURLINK_FIXED_PIVOT);
    near(t->left.pivot.y, 0.035, 1e-18);
    assert_int_equal(t->right.choice, FOURLINK_ROTATIONS);
    near(t->right.rotation[1], -50 * DEG, 1e-15);
    flk_deck_free(&d);
}

/* The text of the linkage found, read again, is the same linkage; the lengths of the solution are those of
** the deck. */
TEST(test_written)
{
    static const char task[] =
        FOUR_BAR "[synthesis]\ntask = path\npositions = (0, 0) mm, (12, 5) mm, (21, 16) mm\n"
                 "timing = 40 deg, 85 deg\nright = moving (30, 10) mm\n[crank]\nmass = 1 kg\n"
                 "uniform = yes\n";
    static fourlink_solution solutions[10];
    char text_of_deck[20000];
    unsigned long length, chosen, n, i;
    deck d, again;

    assert_int_equal(read_task(task, 2, &d), 1);
    assert_int_equal(fourlink_deck_solutions(&d, 10, solutions, &chosen, &n), FOURLINK_OK);
    assert_int_equal(chosen, 1);
    assert_true(n >= 2);
    for (i = 1; i <= 4; i++)
        near(d.machine.mechanism.design.link[i].length, solutions[1].design.link[i].length,
             1e-15 * d.machine.mechanism.design.link[i].length);
    assert_int_equal(fourlink_deck_write(&d, text_of_deck, sizeof text_of_deck, &length),
                     FOURLINK_OK);
    assert_true(length < sizeof text_of_deck);
    assert_int_equal(read_task(text_of_deck, 0, &again), 1);
    assert_null(again.synthesis);
    for (i = 1; i <= 4; i++)
        near(again.machine.mechanism.design.link[i].length,
             d.machine.mechanism.design.link[i].length, 0);
    near(again.machine.mechanism.design.link[2].inertia, d.machine.mechanism.design.link[2].inertia,
         0);
    near(again.points[0].at.x, d.points[0].at.x, 0);
    near(again.motion.from, d.motion.from, 0);
    assert_int_equal(again.n_expectations, 9);
    assert_int_equal(fourlink_deck_solutions(&again, 0, NULL, &chosen, &n), FOURLINK_NO_SUCH_LIST);
    assert_int_equal(fourlink_deck_defects(&again, 0, NULL, &n), FOURLINK_OK);
    assert_int_equal(n, 0);
    flk_deck_free(&again);
    flk_deck_free(&d);
}

/* A solution of a task that was solved before is the one that is found anew: the same deck, the same
** defects, the same status where it has a mistake. */
static int check_solutions(const char *task, unsigned long most)
{
    static char text_of_deck[2][20000];
    fourlink_source source = deck_source(task);
    fourlink_results *all = NULL, *found[2];
    unsigned long chosen, n = 0, length, k;
    int i;

    source.synthesis = most;
    while (fourlink_results_open(&source, 0, &all, NULL, NULL) == FOURLINK_BAD_DECK &&
           source.synthesis > 1)
        source.synthesis--; /* there are fewer */
    if (!all)
        return 0;
    assert_int_equal(fourlink_deck_solutions(fourlink_results_deck(all), 0, NULL, &chosen, &n),
                     FOURLINK_OK);
    n = n < source.synthesis ? n : source.synthesis;
    for (k = 0; k < n; k++) {
        int status = fourlink_results_design(all, k, 0, &found[0], NULL, NULL);

        source.synthesis = k + 1;
        assert_int_equal(fourlink_results_open(&source, 0, &found[1], NULL, NULL), status);
        for (i = 0; i < 2 && status == FOURLINK_OK; i++) {
            fourlink_mistake defects[4];
            const fourlink_deck *d = fourlink_results_deck(found[i]);

            assert_int_equal(fourlink_deck_write(d, text_of_deck[i], 16000, &length), FOURLINK_OK);
            assert_true(length < 16000);
            assert_int_equal(fourlink_deck_solutions(d, 0, NULL, &chosen, &length), FOURLINK_OK);
            assert_int_equal(chosen, k);
            assert_int_equal(fourlink_deck_defects(d, 4, defects, &length), FOURLINK_OK);
            if (length)
                strcat(text_of_deck[i], defects[0].message);
        }
        if (status != FOURLINK_OK)
            continue;
        assert_string_equal(text_of_deck[0], text_of_deck[1]);
        fourlink_results_free(found[0]);
        fourlink_results_free(found[1]);
    }
    assert_int_equal(fourlink_results_design(all, 1000, 0, &found[0], NULL, NULL),
                     FOURLINK_BAD_NUMBER);
    fourlink_results_free(all);
    return (int)n;
}

TEST(test_solutions)
{
    static const char *const rest[] = {"", "right = fixed (50, -10) mm\n",
                                       "left = moving (3, 4) mm\n"};
    static const char *const others[] = {
        FOUR_BAR GROUND "[synthesis]\ntask = function\npoints = 36 deg 64 deg, 75 98, 114 142\n",
        FOUR_BAR "[crank]\nlength = 30 mm\n[synthesis]\ntask = function\n" /* it is scaled */
                 "points = 36 deg 64 deg, 75 98, 114 142\n",
        FOUR_BAR GROUND "[synthesis]\ntask = quick-return\ntime_ratio = 1.2\nswing = 50 deg\n",
        FOUR_BAR "[synthesis]\ntask = motion\npositions = (0, 0) m 0 deg, (1.2, 0.5) m 18 deg, "
                 "(2.1, 1.6) m 47 deg\nleft = fixed (0.5, 3.5) m\nright = fixed (0.5, -1) m\n"};
    uint64_t seed = 52;
    int n_tried = tries_all() ? 120 : 2, n_tasks = 0, n_solutions = 0, i;

    for (i = 0; i < n_tried; i++) {
        double x = uniform(&seed, 5, 30), y = uniform(&seed, -20, 20);
        char task[1000];
        int n;

        sprintf(task,
                FOUR_BAR "[synthesis]\ntask = path\npositions = (0, 0) mm, (%.4g, %.4g) mm, "
                         "(%.4g, %.4g) mm\ntiming = %.4g deg, %.4g deg\n%s",
                x, y, x + uniform(&seed, -20, 30), y + uniform(&seed, -20, 30),
                uniform(&seed, 20, 60), uniform(&seed, 61, 160), rest[i % 3]);
        n = check_solutions(task, 12);
        n_tasks += n > 0;
        n_solutions += n;
    }
    for (i = 0; i < (int)COUNT(others); i++) {
        int n = check_solutions(others[i], 3);

        assert_int_equal(n, 1);
        n_solutions += n;
    }
    print_message("%d tasks, %d of them solved, %d solutions\n", n_tried + (int)COUNT(others),
                  n_tasks, n_solutions);
    assert_true(n_tasks > n_tried / 5 && n_solutions > 2 * n_tasks);
}

/* Designs of a sweep find their own linkages, whatever those before have found. */
TEST(test_designs)
{
    static const char task[] =
        FOUR_BAR GROUND "[synthesis]\ntask = quick-return\ntime_ratio = 1.2\nswing = 50 deg\n"
                        "[sweep]\nsynthesis.time_ratio = 1.2, 1.1, 1.2, 9\noutput = swing\n";
    deck d, first, second, third, none;

    assert_int_equal(read_task(task, 1, &d), 1);
    assert_int_equal(flk_deck_design(&d, 0, NULL, 0, &first), 1);
    assert_int_equal(flk_deck_design(&d, 1, NULL, 0, &second), 1);
    assert_int_equal(flk_deck_design(&d, 2, NULL, 0, &third), 1);
    assert_int_equal(flk_deck_design(&d, 3, NULL, 0, &none), 0);
    assert_true(first.machine.mechanism.design.link[2].length !=
                second.machine.mechanism.design.link[2].length);
    near(first.machine.mechanism.design.link[2].length,
         third.machine.mechanism.design.link[2].length, 0);
    flk_deck_free(&first);
    flk_deck_free(&second);
    flk_deck_free(&third);
    flk_deck_free(&none);
    flk_deck_free(&d);
}

/* Why there is no linkage is the status of opening. */
TEST(test_status)
{
    fourlink_source source =
        deck_source(FOUR_BAR GROUND "[synthesis]\ntask = function\n"
                                    "points = 1 deg 2 deg, 1 deg 2 deg, 5 deg 9 deg\n");
    fourlink_results *r = NULL;
    fourlink_mistake mistake;
    unsigned long n;

    assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, &n), FOURLINK_BAD_DECK);
    source.synthesis = 1;
    assert_int_equal(fourlink_results_open(&source, 1, &r, &mistake, &n), FOURLINK_DEPENDENT);
    assert_int_equal(mistake.line, 4);
    assert_null(r);
}

int main(void)
{
    return run_all_tests(NULL);
}
