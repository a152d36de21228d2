/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_failed_memory.c - memory fails in the functions of fourlink.h, each allocation in turn: the status says so, nothing
** is returned, and the results are as they were.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with glob */

#include <glob.h>

#include "everything.h"
#include "memory.h"

#ifdef COUNTS_MEMORY
/* What a function on a branch returns. */
typedef struct answer {
    int status;
    double numbers[MOST_COLUMNS + 16];
    const fourlink_value *list; /* with n_list */
    unsigned long n_list, n;
    fourlink_value value;
    fourlink_instant instant;
    fourlink_turning turning;
    fourlink_load loads[MOST_LOADS];
    fourlink_check check;
} answer;

/* The functions on a branch, by their number; 0: there are no more. */
static int ask(fourlink_results *r, int which, fourlink_branch branch, answer *a)
{
    fourlink_value found = {0};

    switch (which) {
    case 0:
        a->status = fourlink_results_row(r, branch, 1, a->numbers, &a->instant, a->loads);
        return 1;
    case 1:
        a->status = fourlink_results_at(r, branch, 10, a->numbers, &a->instant, a->loads);
        return 1;
    case 2:
        fourlink_results_find(r, "omega2", &found);
        a->status = fourlink_results_rows(r, branch, 0, 2, 1, &found.handle, a->numbers);
        return 1;
    case 3:
        a->status = fourlink_results_facts(r, (int)branch, 15, &a->list, &a->n_list);
        return 1;
    case 4:
        a->status = fourlink_results_value(r, "alpha2", branch, 5, &a->value);
        return 1;
    case 5:
        a->status = fourlink_results_value(r, "max(omega2)", branch, 0, &a->value);
        return 1;
    case 6:
        a->status = fourlink_results_value(r, "run_up_time", branch, 0, &a->value);
        return 1;
    case 7:
        a->status = fourlink_results_end(r, branch, a->numbers);
        return 1;
    case 8:
        a->status = fourlink_results_turning(r, branch, &a->turning);
        return 1;
    case 9:
        a->status = fourlink_results_crossings(r, "omega2", branch, 1, 8, a->numbers, &a->n);
        return 1;
    case 10: /* why it differs is sought on the other branch */
        a->status = fourlink_results_check(r, 0, &a->check);
        return 1;
    case 11:
        a->status = fourlink_results_along(r, branch, 0, a->numbers, &a->instant, a->loads);
        return 1;
    case 13:
        a->status = fourlink_results_motion(r, branch, 1, a->numbers, &a->instant);
        return 1;
    case 12:
        a->status = fourlink_results_facts(r, 0, 15, &a->list, &a->n_list);
        return 1;
    default:
        return 0;
    }
}

static void forget(answer *a)
{
    memset(a, 0x55, sizeof *a);
}

static int is_untouched(const answer *a)
{
    answer none;

    forget(&none);
    none.status = a->status;
    return memcmp(a, &none, sizeof none) == 0;
}

static uint64_t digest_of(const answer *a)
{
    digest d = {0, 0, 0};
    unsigned long i;

    note(&d, a->status);
    note_values(&d, a->numbers, COUNT(a->numbers));
    for (i = 0; a->n_list < 1000 && i < a->n_list; i++)
        note(&d, a->list[i].value);
    note(&d, a->value.value);
    note(&d, a->instant.forces.Ts);
    note(&d, a->turning.mean_torque);
    note(&d, a->check.computed);
    for (i = 0; i < sizeof a->check.hint; i++)
        note(&d, a->check.hint[i]);
    return d.hash;
}

/* Motions that are integrated, and facts of one. */
static const char *const motions[] = {
    "[motor]\nstall_torque = 20 N m\nno_load_speed = 14 rad/s\n[motion]\nmode = run-up\nto = 200 "
    "deg\n",
    "[motor]\ntorque = constant\n[load]\nlink = rocker\ntorque = -1 N m\nover = omega4\nat_speed = "
    "1 rad/s\n"
    "[motion]\nmode = steady\nmean_speed = 10 rad/s\n",
    "[motion]\nmode = free\nspeed = 20 rad/s\nto = 1500 deg\n",
    "[motion]\nmode = free\nspeed = 20 rad/s\nrows = time\ntime_step = 10 ms\nduration = 100 ms\n"};

/* A deck with motion i, which requests the open branch. */
static const char *deck_of(size_t i)
{
    return print(ROCKER FLYWHEEL "%s[table]\nbranch = open\n[expect]\n%s\nomega4 = 7.77 rad/s\n",
                 motions[i], strstr(motions[i], "rows") ? "at = 20 ms" : "at = 10 deg");
}

/* Let each allocation fail that a function takes for the motion; returns how many there are. */
static unsigned long try_function(const char *contents, int which, fourlink_branch branch)
{
    fourlink_results *r = opened(contents);
    unsigned long n, k;
    uint64_t expected;
    answer a;
    int on;

    forget(&a);
    watch_memory(0, 0);
    ask(r, which, branch, &a);
    n = watched_memory();
    expected = digest_of(&a);
    fourlink_results_free(r);
    for (k = 1; k <= n; k++)
        for (on = 0; on < 2; on++) {
            r = opened(contents);
            forget(&a);
            watch_memory(k, on);
            ask(r, which, branch, &a);
            watched_memory();
            if (a.status != FOURLINK_NO_MEMORY || !is_untouched(&a))
                fail_msg("%s, function %d, allocation %lu of %lu: %s", contents, which, k, n,
                         fourlink_status_text(a.status));
            ask(r, which, branch, &a); /* there is memory again */
            if (digest_of(&a) != expected)
                fail_msg("%s, function %d, allocation %lu: other results", contents, which, k);
            fourlink_results_free(r);
        }
    return n;
}

/* The motion of a branch is found when a function asks for it. */
TEST(test_failed_memory_of_a_motion)
{
    unsigned long tried = 0;
    answer none;
    int which;
    size_t i;

    for (i = 0; i < COUNT(motions); i++)
        for (which = 0; ask(NULL, which, FOURLINK_OPEN, &none); which++)
            tried += try_function(deck_of(i), which, FOURLINK_OPEN) +
                     try_function(deck_of(i), which, FOURLINK_CROSSED);
    print_message("%lu allocations failed\n", tried);
    assert_true(tried > 100);
}

/* The memory that a question takes. */
static unsigned long memory_for(fourlink_results *r, const char *name)
{
    fourlink_value v;

    watch_memory(0, 0);
    fourlink_results_value(r, name, FOURLINK_OPEN, 0, &v);
    return watched_memory();
}

/* A motion is integrated when it is asked for, once; the steady motion that a run-up approaches, for its facts. */
TEST(test_motion_that_nobody_asked_for)
{
    static const char *const still[] = {"crank.length", "motion.speed", "mu_min",
                                        "type",         "stroke",       "mass",
                                        "theta4_max",   "no name",      "rotatability"};
    const fourlink_value *list;
    unsigned long n;
    size_t i, k;
    int which;

    for (i = 0; i < COUNT(motions); i++) {
        fourlink_results *r = opened(deck_of(i));

        for (k = 0; k < COUNT(still); k++)
            assert_int_equal(memory_for(r, still[k]), 0);
        watch_memory(0, 0);
        for (which = FOURLINK_COLUMNS; which <= FOURLINK_CONDITIONS; which++)
            assert_int_equal(fourlink_results_list(r, which, &list, &n), FOURLINK_OK);
        assert_int_equal(fourlink_results_facts(r, 0, FOURLINK_FACTS_LIMITS, &list, &n),
                         FOURLINK_OK);
        assert_int_equal(fourlink_results_facts(r, 0, FOURLINK_FACTS_NAMES, &list, &n),
                         FOURLINK_OK);
        assert_int_equal(watched_memory(), 0);
        assert_true(memory_for(r, "omega4") > 0);
        assert_int_equal(memory_for(r, "omega4"), 0);
        assert_true(memory_for(r, "max(alpha2)") > 0); /* room for a search */
        assert_int_equal(memory_for(r, "mean(alpha2)") + memory_for(r, "min(omega4)"), 0);
        assert_int_equal(memory_for(r, "mean_speed") > 0, strstr(motions[i], "run-up") != NULL);
        assert_int_equal(memory_for(r, "mean_speed") + memory_for(r, "run_up_time"), 0);
        fourlink_results_free(r);
    }
}

#define FUNCTIONS 5

/* The functions that need memory, by their number: they return a status and, some of them, results. */
static void take(fourlink_results *r, const fourlink_source *source, int which,
                 fourlink_results **taken, int *status)
{
    const double longer = 21;
    fourlink_value length;

    switch (which) {
    case 0:
        *status = fourlink_results_open(source, 0, taken, NULL, NULL);
        break;
    case 1:
        *status = fourlink_results_design(r, 0, 0, taken, NULL, NULL);
        break;
    case 2:
        *status = fourlink_results_set(r, "crank.length", longer, NULL);
        break;
    case 3:
        *status = fourlink_results_find(r, "crank.length", &length);
        if (*status == FOURLINK_OK)
            *status = fourlink_results_put(r, 1, &length.handle, &longer, NULL);
        break;
    default:
        *status = fourlink_results_set_text(r, "crank.length = 21 mm", NULL);
    }
}

/* Try a function with each stride-th allocation failing. */
static unsigned long try_deck(const char *name, const fourlink_source *source, int which,
                              unsigned long stride)
{
    fourlink_results *r = NULL, *taken = NULL;
    digest before = {0, 0, 0}, expected = {0, 0, 0};
    unsigned long n, k, tried = 0;
    int on, status, expected_status;

    fourlink_results_open(source, 0, &r, NULL, NULL);
    if (!r && which)
        return 0; /* a deck with mistakes */
    if (r)
        before = exercise(r);
    watch_memory(0, 0);
    take(r, source, which, &taken, &expected_status);
    n = watched_memory();
    if (taken || r)
        expected = exercise(taken ? taken : r);
    fourlink_results_free(taken);
    fourlink_results_free(r);
    for (k = 1; k <= n; k += stride)
        for (on = 0; on < 2; on++) {
            r = taken = NULL;
            if (which)
                fourlink_results_open(source, 0, &r, NULL, NULL);
            watch_memory(k, on);
            take(r, source, which, &taken, &status);
            watched_memory();
            tried++;
            if (status == FOURLINK_NO_MEMORY && !taken &&
                (k != 1 || !r || exercise(r).hash == before.hash)) {
                fourlink_results_free(r); /* as it was */
                continue;
            }
            if (status != expected_status ||
                ((taken || r) && exercise(taken ? taken : r).hash != expected.hash))
                fail_msg("%s, function %d, allocation %lu of %lu: %s", name, which, k, n,
                         fourlink_status_text(status));
            fourlink_results_free(taken);
            fourlink_results_free(r);
        }
    return tried;
}

/* The seeds of the fuzzers have all that decks can have. */
TEST(test_failed_memory_of_decks)
{
    static const char *const folders[] = {SOURCE_DIR "/tests/fuzz/decks/*.deck",
                                          SOURCE_DIR "/tests/decks/*.deck"};
    static char text[20000];
    unsigned long tried = 0, stride = tries_all() ? 1 : 17;
    fourlink_source source;
    glob_t found;
    size_t i, k;
    int which;

    for (k = 0; k < COUNT(folders); k++) {
        assert_int_equal(glob(folders[k], 0, NULL, &found), 0);
        for (i = 0; i < found.gl_pathc; i++) {
            const char *name = found.gl_pathv[i];

            if (strstr(name, "motor.deck") || strstr(name, "free.deck")) /* some seconds for each */
                continue;
            read_whole(name, text, sizeof text);
            source = deck_source(text);
            source.design = FOURLINK_ANY_DESIGN;
            source.synthesis = 1;
            for (which = 0; which < FUNCTIONS; which++)
                tried += try_deck(name, &source, which, stride);
        }
        globfree(&found);
    }
    print_message("%lu allocations failed\n", tried);
    assert_true(tried > (tries_all() ? 5000 : 400));
}
#else
TEST(test_failed_memory)
{
    skip(); /* a sanitizer has its own malloc */
}
#endif

int main(void)
{
    return run_all_tests(watch_gsl);
}
