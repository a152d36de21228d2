/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_everything.c - all results of many decks: none takes memory, reaches GSL's error handler, depends on
** the call before, or on what another thread does.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with glob */

#include <glob.h>
#include <pthread.h>
#include <stdlib.h>

#include "everything.h"
#include "memory.h"

/* All columns, by the faster solution; some that differ in kind, by the nine equations; those of the deck. */
static const fourlink_change all[2] = {{"test", "table.columns=all"}, {"test", "solver=dyad"}};
static const fourlink_change some[2] = {
    {"test", "table.columns=theta2,theta3,alpha3,F12,Ts_static,I13x"}, {"test", "solver=matrix"}};

static const fourlink_change usual[2] = {{"test", "solver=dyad"}, {"test", "solver=dyad"}};

static fourlink_source with_columns(const char *contents, const fourlink_change changes[2])
{
    fourlink_source source = deck_source(contents);

    source.changes = changes;
    source.n_changes = 2;
    source.design = FOURLINK_ANY_DESIGN;
    return source;
}

#define ALL_FACTS (FOURLINK_FACTS_LIMITS | FOURLINK_FACTS_TURNING | FOURLINK_FACTS_MOTION)

static digest check_everything(const char *contents, const fourlink_change columns[2],
                               const char *name)
{
    fourlink_source source = with_columns(contents, columns);
    fourlink_results *r = NULL;
    fourlink_mistake mistake;
    digest first, again;
    fourlink_check check;
    unsigned long i;

    if (fourlink_results_open(&source, 1, &r, &mistake, NULL) != FOURLINK_OK)
        fail_msg("%s:%ld: %s", name, mistake.line, mistake.message);
    /* an actual motion is integrated when its branch is first asked for */
    fourlink_results_row(r, FOURLINK_OPEN, 0, NULL, NULL, NULL);
    fourlink_results_row(r, FOURLINK_CROSSED, 0, NULL, NULL, NULL);
    /* the first search takes room for all */
    fourlink_results_crossings(r, "theta2", FOURLINK_OPEN, 0, 0, NULL, &i);
    /* and slips are sought when a value that differs is first compared */
    for (i = 0; fourlink_results_check(r, i, &check) == FOURLINK_OK;)
        i++;
    watch_memory(0, 0);
    first = exercise(r);
    again = exercise(r);
    if (watched_memory())
        fail_msg("%s: %lu pieces of memory taken", name, allocations);
    assert_true(first.hash == again.hash); /* no result depends on the call before */
    assert_true(first.values > 100);
    fourlink_results_free(r);
    return first;
}

#ifdef COUNTS_MEMORY
TEST(test_memory_is_counted)
{
    void *volatile memory;

    watch_memory(0, 0);
    memory = malloc(10);
    watched_memory();
    free(memory);
    assert_int_equal(allocations, 1);
}
#endif

TEST(test_everything_of_the_decks)
{
    static const char *const folders[] = {SOURCE_DIR "/data/*.deck",
                                          SOURCE_DIR "/tests/decks/*.deck"};
    static char text[20000];
    glob_t found;
    size_t i, k;
    int n = 0;

    for (k = 0; k < COUNT(folders); k++) {
        assert_int_equal(glob(folders[k], 0, NULL, &found), 0);
        for (i = 0; i < found.gl_pathc; i++) {
            const char *name = found.gl_pathv[i];

            if (strstr(name, "bad.deck") || strstr(name, "mistakes.deck"))
                continue;
            read_whole(name, text, sizeof text);
            if (n % 4 == 0 || tries_all())
                check_everything(text, all, name);
            if (n % 4 == 2 || tries_all())
                check_everything(text, usual, name);
            n++;
        }
        globfree(&found);
    }
    assert_true(n >= 15);
}

/* The names of facts are those of all decks, described alike, and no others. */
TEST(test_names_of_facts)
{
    static char text[20000];
    glob_t decks;
    unsigned long n, m, k, j;
    size_t i;

    assert_int_equal(glob(SOURCE_DIR "/data/*.deck", 0, NULL, &decks), 0);
    for (i = 0; i < decks.gl_pathc; i++) {
        fourlink_source source = {0};
        fourlink_results *r = NULL, *same = NULL;
        const fourlink_value *names, *facts;
        fourlink_value one;

        read_whole(decks.gl_pathv[i], text, sizeof text);
        source.text = text;
        source.length = strlen(text);
        source.design = FOURLINK_ANY_DESIGN;
        assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_OK);
        assert_int_equal(fourlink_results_open(&source, 0, &same, NULL, NULL), FOURLINK_OK);
        assert_int_equal(fourlink_results_facts(r, 0, FOURLINK_FACTS_NAMES, &names, &n),
                         FOURLINK_OK);
        assert_int_equal(fourlink_results_facts(same, 0, ALL_FACTS, &facts, &m), FOURLINK_OK);
        for (k = 0; k < n; k++) {
            assert_true(names[k].words || isnan(names[k].value));
            assert_int_equal(fourlink_results_find(same, names[k].name, &one), FOURLINK_OK);
            assert_int_equal(one.handle, names[k].handle);
            for (j = 0; j < k; j++)
                assert_string_not_equal(names[k].name, names[j].name);
        }
        for (j = 0; j < m; j++) {
            for (k = 0; k < n && names[k].handle != facts[j].handle; k++)
                ;
            if (k == n)
                fail_msg("%s: %s is no name", decks.gl_pathv[i], facts[j].name);
            assert_string_equal(names[k].name, facts[j].name);
            assert_string_equal(names[k].meaning, facts[j].meaning);
            assert_string_equal(names[k].quantity, facts[j].quantity);
        }
        fourlink_results_free(r);
        fourlink_results_free(same);
    }
    globfree(&decks);
}

/* Linkages that reach in part or nowhere, pass change points, stop, or are far out of proportion. */
TEST(test_everything_of_odd_mechanisms)
{
    static const double bars[][4] = {
        {0.3, 0.4, 0.5, 0.75}, {0.75, 0.4, 0.5, 0.35}, {0.4, 0.5, 0.45, 0.35},
        {0.2, 0.5, 0.2, 0.5},  {0.2, 0.2, 0.5, 0.5},   {0.5, 0.2, 0.2, 0.5},
        {0.3, 0.3, 0.3, 0.3},  {0.2, 0.6, 0.5, 0.9},   {0.1, 0.1, 0.1, 0.2999999},
        {1e-9, 1, 1, 1e-9},    {1e6, 1e6, 1e-3, 1e-3}, {0.2, 0.5, 0.4, 0.5}};
    static const double cranks[][3] = {{0.4, 0.2, 0},     {0.2, 0.2, 0},      {0.3, 0.2, 0.1},
                                       {0.2, 0.3, 0.1},   {0.1, 0.2, 0.2999}, {1e-9, 1, 0},
                                       {0.4, 0.2, -0.25}, {1, 1 + 1e-9, 0}};
    static const char *const motions[] = {
        "speed = 10 rad/s\n", "speed = -3 rad/s\nfrom = 70 deg\nto = -500 deg\n",
        "acceleration = -9 rad/s2\nrun_up = 50 deg\n",
        "speed = 5 rad/s\nacceleration = -4 rad/s2\n", "at = 60 deg\nspeed = 3 rad/s\n"};
    unsigned long refused = 0;
    size_t i, k;

    for (k = 0; k < COUNT(motions); k++) {
        const char *more =
            print("[load]\nlink = crank\ntorque = 5 N m\nfrom = 20 deg\nto = 100 deg\n"
                  "[load curve]\nlink = crank\ntorque = 0 deg 3, 50 deg 9, 200 deg -4\n"
                  "[motion]\n%s[flywheel]\ninertia = 2 kg m2\n[expect]\n"
                  "max(mu) = 80 deg\ntype = rhombus\n[expect]\nat = 60 deg\n"
                  "Ts = 3 N m\ntheta3 = 3 deg\n",
                  motions[k]);

        for (i = tries_all() ? 0 : k % 3; i < COUNT(bars); i += tries_all() ? 1 : 3)
            refused +=
                check_everything(four_bar(bars[i][0], bars[i][1], bars[i][2], bars[i][3], more),
                                 some, "bars")
                    .refused;
        for (i = tries_all() ? 0 : k % 3; i < COUNT(cranks); i += tries_all() ? 1 : 3)
            refused += check_everything(
                           slider_crank(cranks[i][0], cranks[i][1], cranks[i][2],
                                        print("[gas]\nbore = 9 mm\npressure = 8 bar\n%s", more)),
                           some, "cranks")
                           .refused;
    }
    assert_true(refused > (tries_all() ? 1000 : 300));
}

typedef struct work {
    fourlink_source source;
    digest done;
} work;

static void *work_on(void *data)
{
    work *w = data;
    int i;

    for (i = 0; i < 5; i++) {
        fourlink_results *r;

        if (fourlink_results_open(&w->source, 0, &r, NULL, NULL) != FOURLINK_OK)
            return NULL;
        w->done = exercise(r);
        fourlink_results_free(r);
    }
    return NULL;
}

/* Two threads, each with results of its own, of one source. */
TEST(test_two_threads)
{
    char *contents = four_bar(0.020, 0.066, 0.056, 0.080,
                              "[load]\nlink = rocker\ntorque = 3 N m\n[motion]\n"
                              "speed = 10 rad/s\n[flywheel]\nfluctuation = 0.1\n");
    digest alone = check_everything(contents, some, "linkage");
    pthread_t threads[2];
    work w[2];
    int i;

    for (i = 0; i < 2; i++) {
        memset(&w[i], 0, sizeof w[i]);
        w[i].source = with_columns(contents, some);
        assert_int_equal(pthread_create(&threads[i], NULL, work_on, &w[i]), 0);
    }
    for (i = 0; i < 2; i++) {
        pthread_join(threads[i], NULL);
        assert_true(w[i].done.hash == alone.hash && w[i].done.values == alone.values);
    }
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
