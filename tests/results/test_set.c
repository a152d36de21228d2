/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_set.c - numbers that a host sets: all results are those of the deck with these numbers written in.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with glob */

#include <glob.h>

#include "everything.h"

#define MOST_NUMBERS 100

typedef struct trials {
    unsigned long set, mistaken, words;
} trials;

static size_t step = 16; /* one in so many numbers of a deck is tried */

/* A number of a deck: SECTION.KEY, its unit and a value near its own. */
typedef struct number {
    char name[80], assignment[160];
    double value;
} number;

static fourlink_results *open_source(const fourlink_source *source, fourlink_mistake *mistake)
{
    fourlink_results *r = NULL;

    return fourlink_results_open(source, 1, &r, mistake, NULL) == FOURLINK_OK ? r : NULL;
}

/* The results of the deck with the numbers written in; null and the mistake if it has one. */
static fourlink_results *written_in(fourlink_source source, const number *numbers, size_t n,
                                    fourlink_mistake *mistake)
{
    fourlink_change changes[MOST_NUMBERS];
    size_t i;

    for (i = 0; i < n; i++) {
        changes[i].origin = "test";
        changes[i].assignment = numbers[i].assignment;
    }
    source.changes = changes;
    source.n_changes = n;
    return open_source(&source, mistake);
}

static void check_same_lists(fourlink_results *x, fourlink_results *y, const char *what)
{
    const fourlink_value *of_x, *of_y;
    unsigned long n, m, i;
    int k;

    for (k = FOURLINK_COLUMNS; k <= FOURLINK_CONDITIONS; k++) {
        fourlink_results_list(x, k, &of_x, &n);
        fourlink_results_list(y, k, &of_y, &m);
        if (n != m)
            fail_msg("%s: %lu entries, %lu", what, n, m);
        for (i = 0; i < n; i++) {
            assert_string_equal(of_x[i].name, of_y[i].name);
            assert_string_equal(of_x[i].unit, of_y[i].unit);
            assert_int_equal(of_x[i].handle, of_y[i].handle);
        }
    }
}

/* The numbers of a deck, and the size and angle of its vectors. */
static size_t numbers_of(fourlink_results *r, number *numbers)
{
    static const char *const parts[] = {"x", "y", "size", "angle"};
    const fourlink_value *list;
    unsigned long n, i;
    size_t found = 0;
    int k;

    fourlink_results_list(r, FOURLINK_INPUTS, &list, &n);
    for (i = 0; i < n; i++) {
        size_t length = strlen(list[i].name);
        int is_vector = strcmp(list[i].name + length - 2, ".x") == 0;

        for (k = is_vector ? 0 : 3; k < 4 && found < MOST_NUMBERS; k++) {
            number *now = &numbers[found];
            fourlink_value v;

            strcpy(now->name, list[i].name);
            if (is_vector)
                strcpy(now->name + length - 1, parts[k]);
            if (list[i].words || fourlink_results_find(r, now->name, &v) != FOURLINK_OK)
                continue;
            now->value = strtod(
                print("%.6g", v.value == 0 || isnan(v.value) ? 0.01 : 1.003 * v.value), NULL);
            snprintf(now->assignment, sizeof now->assignment, "%s=%.6g %s", now->name, now->value,
                     strcmp(v.unit, "1") ? v.unit : "");
            found++;
        }
    }
    return found;
}

/* A number set alone, or refused with the results as they were. */
static void check_number(const fourlink_source *source, const number *one, trials *done)
{
    fourlink_mistake mistake, expected;
    fourlink_results *r = open_source(source, &mistake),
                     *same = written_in(*source, one, 1, &expected);
    int status = fourlink_results_set(r, one->name, one->value, &mistake);

    if (status == FOURLINK_OK) {
        if (!same)
            fail_msg("%s is a mistake: %s", one->assignment, expected.message);
        check_same_lists(r, same, one->assignment);
        if (exercise(r).hash != exercise(same).hash)
            fail_msg("%s: not the results of the deck with this value", one->assignment);
        done->set++;
    } else {
        fourlink_results *fresh = open_source(source, &mistake);

        if (exercise(r).hash != exercise(fresh).hash)
            fail_msg("%s: refused, but the results have changed", one->assignment);
        if (status == FOURLINK_BAD_DECK) {
            assert_null(same);
            fourlink_results_set(r, one->name, one->value, &mistake);
            assert_string_equal(mistake.message, expected.message);
            done->mistaken++;
        } else {
            if (status != FOURLINK_NOT_A_NUMBER && status != FOURLINK_NO_SUCH_NAME)
                fail_msg("%s: %s", one->assignment, fourlink_status_text(status));
            done->words++;
        }
        fourlink_results_free(fresh);
    }
    fourlink_results_free(r);
    fourlink_results_free(same);
}

/* Several numbers, one after the other and at once. */
static void check_together(const fourlink_source *source, const number *numbers, size_t n)
{
    fourlink_mistake mistake;
    fourlink_results *one = open_source(source, &mistake), *all = open_source(source, &mistake),
                     *same;
    number taken[MOST_NUMBERS];
    int handles[MOST_NUMBERS];
    double values[MOST_NUMBERS];
    size_t i, k = 0;

    for (i = 0; i < n; i++) {
        fourlink_value v;

        fourlink_results_find(one, numbers[i].name, &v);
        if (fourlink_results_put(one, 1, &v.handle, &numbers[i].value, NULL) != FOURLINK_OK)
            continue;
        handles[k] = v.handle;
        values[k] = numbers[i].value;
        taken[k++] = numbers[i];
    }
    assert_int_equal(fourlink_results_put(all, k, handles, values, &mistake), FOURLINK_OK);
    same = written_in(*source, taken, k, &mistake);
    if (!same)
        fail_msg("%s", mistake.message);
    assert_true(exercise(one).hash == exercise(same).hash);
    assert_true(exercise(all).hash == exercise(same).hash);
    fourlink_results_free(one);
    fourlink_results_free(all);
    fourlink_results_free(same);
}

TEST(test_all_numbers_of_the_decks)
{
    static char text[20000];
    trials done = {0, 0, 0};
    glob_t found;
    size_t i, k;

    assert_int_equal(glob(SOURCE_DIR "/data/*.deck", 0, NULL, &found), 0);
    for (i = 0; i < found.gl_pathc; i++) {
        number numbers[MOST_NUMBERS];
        fourlink_source source;
        fourlink_results *r;
        size_t n;

        read_whole(found.gl_pathv[i], text, sizeof text);
        source = deck_source(text);
        r = opened(text);
        n = numbers_of(r, numbers);
        fourlink_results_free(r);
        for (k = i % step; k < n; k += step)
            check_number(&source, &numbers[k], &done);
        if (i % step == 0)
            check_together(&source, numbers, n);
    }
    print_message("%lu set, %lu mistakes, %lu words or curves\n", done.set, done.mistaken,
                  done.words);
    assert_true(done.set > 300 / step);
    globfree(&found);
}

#define LOADS "[load P]\nlink = rocker\nforce = 10 N at 30 deg\nat = 50 %\n[load T]\nlink = crank\n"

/* What depends on a number follows it: uniform links, points in per cent, counterweights. */
TEST(test_what_depends_on_a_number)
{
    fourlink_results *r = opened("mechanism = four-bar\n[units]\nlength = mm\n[ground]\n"
                                 "length = 80\n[crank]\nlength = 20\nmass = 0.2 kg\nuniform = yes\n"
                                 "[coupler]\nlength = 66\n[rocker]\nlength = 56\nmass = 0.3 kg\n"
                                 "cg = 25 %\n" LOADS "torque = 1 N m\n[motion]\n"
                                 "speed = 10 rad/s\n");

    assert_int_equal(fourlink_results_set(r, "crank.length", 24, NULL), FOURLINK_OK);
    assert_close(named(r, "crank.inertia", FOURLINK_OPEN, 0).value, 0.2 * 0.024 * 0.024 / 12,
                 1e-15);
    assert_close(named(r, "crank.cg.x", FOURLINK_OPEN, 0).value, 12.0, 1e-15);
    assert_int_equal(fourlink_results_set(r, "rocker.length", 60, NULL), FOURLINK_OK);
    assert_close(named(r, "rocker.cg.x", FOURLINK_OPEN, 0).value, 15.0, 1e-15);
    assert_close(named(r, "load P.at.x", FOURLINK_OPEN, 0).value, 30.0, 1e-15);
    assert_close(named(r, "crank.length", FOURLINK_OPEN, 0).value, 24.0, 1e-15);
    assert_int_equal(fourlink_results_set(r, "load P.force.size", 20, NULL), FOURLINK_OK);
    assert_close(named(r, "load P.force.x", FOURLINK_OPEN, 0).value, 20 * cos(PI / 6), 1e-15);
    assert_close(named(r, "load P.force.angle", FOURLINK_OPEN, 0).value, 30.0, 1e-14);
    fourlink_results_free(r);
}

/* Each reason for which a number is refused; the results stay as they were. */
TEST(test_refused_numbers)
{
    static const struct {
        const char *name;
        double value;
        int status;
        const char *message;
    } cases[] = {
        {"crank.length", -20, FOURLINK_BAD_DECK, "the length must be positive, not -20 mm"},
        {"crank.length", NAN, FOURLINK_BAD_NUMBER, ""},
        {"crank.length", INFINITY, FOURLINK_BAD_NUMBER, ""},
        {"crank.lenght", 20, FOURLINK_NO_SUCH_NAME, ""},
        {"crank", 20, FOURLINK_NO_SUCH_NAME, ""},
        {"gas.bore", 20, FOURLINK_NO_SUCH_NAME, ""},
        {"load Q.torque", 20, FOURLINK_NO_SUCH_NAME, ""},
        {"Ts", 20, FOURLINK_NO_SUCH_NAME, ""},
        {"load.torque", 20, FOURLINK_NO_SUCH_NAME, ""}, /* there are two */
        {"load P.at.x", 20, FOURLINK_NOT_A_NUMBER, ""}, /* per cent */
        {"load P.force", 20, FOURLINK_NOT_A_NUMBER, ""},
        {"load P.link", 20, FOURLINK_NOT_A_NUMBER, ""},
        {"load T.torque", 20, FOURLINK_NOT_A_NUMBER, ""},  /* a curve */
        {"load T.force.x", 20, FOURLINK_NOT_A_NUMBER, ""}, /* no force in the deck */
        {"table.columns", 20, FOURLINK_NOT_A_NUMBER, ""},
        {"motion.interval", 1e-9, FOURLINK_BAD_DECK, NULL}};
    fourlink_results *r =
        opened(four_bar(0.020, 0.066, 0.056, 0.080,
                        LOADS "torque = 0 deg 0 N m, 90 deg 1 N m\n[units]\nlength = mm\n[motion]\n"
                              "speed = 10 rad/s\ninterval = 30 deg\n[table]\ncolumns = Ts\n"));
    digest before = exercise(r);
    fourlink_mistake mistake;
    fourlink_value v;
    size_t i;
    int fact;

    for (i = 0; i < COUNT(cases); i++) {
        mistake.message[0] = '\0';
        assert_int_equal(fourlink_results_set(r, cases[i].name, cases[i].value, &mistake),
                         cases[i].status);
        if (cases[i].message)
            assert_string_equal(mistake.message, cases[i].message);
    }
    assert_int_equal(fourlink_results_find(r, "mu_min", &v), FOURLINK_OK);
    fact = v.handle;
    assert_int_equal(fourlink_results_put(r, 1, &fact, &v.value, NULL), FOURLINK_NO_SUCH_NAME);
    assert_int_equal(fourlink_results_put(r, 1, NULL, &v.value, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_set(NULL, "crank.length", 20, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_set(r, NULL, 20, NULL), FOURLINK_NULL);
    assert_true(exercise(r).hash == before.hash);
    fourlink_results_free(r);
}

/* A number set back gives the first results; the deck that is written has the numbers in it. */
TEST(test_numbers_in_the_deck)
{
    char *contents =
        four_bar(0.020, 0.066, 0.056, 0.080,
                 "[motion]\nspeed = 100 rpm\ninterval = 30 deg\n[sweep]\n"
                 "crank.length = 20 mm, 21 mm\nmotion.speed = 100 rpm to 300 rpm in 3\n");
    fourlink_results *r = opened(contents), *again;
    digest first = exercise(r);
    const fourlink_value *list;
    char text[2000];
    unsigned long n;
    double low, value, high;

    assert_int_equal(fourlink_results_set(r, "crank.length", 0.0225, NULL), FOURLINK_OK);
    fourlink_results_list(r, FOURLINK_VARIABLES, &list, &n);
    assert_true(list[0].value == 0.0225);
    assert_int_equal(fourlink_deck_write(fourlink_results_deck(r), text, sizeof text, &n),
                     FOURLINK_OK);
    assert_non_null(strstr(text, "length = 0.0225 m\n"));
    again = opened(text);
    assert_close(named(again, "max(omega4)", FOURLINK_OPEN, 0).value,
                 named(r, "max(omega4)", FOURLINK_OPEN, 0).value, 1e-15);
    assert_int_equal(fourlink_results_set(r, "crank.length", 0.02, NULL), FOURLINK_OK);
    assert_true(exercise(r).hash == first.hash);
    /* the sweep is that of the deck */
    assert_int_equal(fourlink_results_variables(r, 4, 1, &value, &low, &high), FOURLINK_OK);
    assert_close(value, 0.021, 1e-15);
    fourlink_results_free(again);
    fourlink_results_free(r);
}

int main(int argc, char **argv)
{
    step = argc > 1 ? strtoul(argv[1], NULL, 10) : step;
    return run_all_tests(watch_gsl);
}
