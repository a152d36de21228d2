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
            if (list[i].words || fourlink_results_input(r, now->name, &v) != FOURLINK_OK)
                continue;
            if (isnan(v.value) && !is_vector) /* a default */
                v.value = list[i].value * list[i].to_si / v.to_si;
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
        assert_int_not_equal(fourlink_results_set(r, "crank.length", -1, NULL), FOURLINK_OK);
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
    } cases[] = {{"crank.length", -20, FOURLINK_BAD_DECK, "the length must be positive, not -20 m"},
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

/* ------------------------------------------------------------------------------------ units of lines */

typedef struct unit_name {
    const char *name;
    double si;
} unit_name;

/* Exact by definition of the units. */
static const unit_name lengths[] = {{"m", 1},
                                    {"mm", 1e-3},
                                    {"cm", 1e-2},
                                    {"in", 0.0254},
                                    {"ft", 0.3048}},
                       speeds[] = {{"rad/s", 1}, {"rpm", 2 * M_PI / 60}, {"deg/s", M_PI / 180}},
                       forces[] = {{"N", 1}, {"kN", 1e3}, {"lbf", 4.4482216152605}},
                       turns[] = {{"deg", M_PI / 180}, {"rad", 1}};

/* A number of the deck that is written below: its value, and the unit of its line, bare or not. */
typedef struct written {
    const char *name;
    const unit_name *units;
    size_t n_units;
    const unit_name *of_line;
    int is_bare;
    double number;
} written;

static const unit_name *any_of(const unit_name *units, size_t n, uint64_t *seed)
{
    return &units[(size_t)uniform(seed, 0, (double)n)];
}

static const char *as_written(const written *w)
{
    return print("%.17g %s", w->number, w->is_bare ? "" : w->of_line->name);
}

/* The value in SI units that the results have, by the unit in which they give it. */
static double si_of(fourlink_results *r, const char *name)
{
    fourlink_value v = named(r, name, FOURLINK_OPEN, 0);

    return v.value * v.to_si;
}

/* A number is told and set in the unit of its line, whatever has been set with another unit before. */
static void check_line_unit(fourlink_results *r, const written *w, uint64_t *seed)
{
    double factor = uniform(seed, 0.9, 1.1);
    const unit_name *other = any_of(w->units, w->n_units, seed);
    fourlink_mistake mistake;
    fourlink_value v, found;

    assert_int_equal(fourlink_results_input(r, w->name, &v), FOURLINK_OK);
    assert_string_equal(v.unit, w->of_line->name);
    assert_close(v.value, w->number, 1e-14);
    assert_close(v.to_si, w->of_line->si, 1e-14);
    assert_int_equal(fourlink_results_find(r, w->name, &found), FOURLINK_OK);
    assert_string_equal(found.line_unit, w->of_line->name);
    if (uniform(seed, 0, 1) < 0.5) {
        char *words = print("%s = %.17g %s", w->name, 1.05 * w->number * w->of_line->si / other->si,
                            other->name);

        assert_int_equal(fourlink_results_set_text(r, words, &mistake), FOURLINK_OK);
        assert_close(si_of(r, w->name), 1.05 * w->number * w->of_line->si, 1e-14);
        assert_int_equal(fourlink_results_input(r, w->name, &v), FOURLINK_OK);
        assert_string_equal(v.unit, w->of_line->name);
        assert_int_equal(fourlink_results_find(r, w->name, &v), FOURLINK_OK);
        assert_string_equal(v.line_unit, w->of_line->name);
    }
    factor *= w->number;
    switch ((int)uniform(seed, 0, 3)) {
    case 0:
        assert_int_equal(fourlink_results_set(r, w->name, factor, &mistake), FOURLINK_OK);
        break;
    case 1:
        assert_int_equal(fourlink_results_put(r, 1, &found.handle, &factor, &mistake), FOURLINK_OK);
        break;
    default:
        assert_int_equal(fourlink_results_set_text(r, print("%s=%.17g", w->name, factor), &mistake),
                         FOURLINK_OK);
    }
    assert_close(si_of(r, w->name), factor * w->of_line->si, 1e-14);
    assert_int_equal(fourlink_results_input(r, w->name, &v), FOURLINK_OK);
    assert_close(v.value, factor, 1e-14);
}

/* The list of inputs tells for each number the unit in which it is set. */
static void check_listed_units(fourlink_results *r, const written *list, size_t n)
{
    const fourlink_value *inputs;
    unsigned long n_inputs, i;
    size_t k, found = 0;

    assert_int_equal(fourlink_results_list(r, FOURLINK_INPUTS, &inputs, &n_inputs), FOURLINK_OK);
    for (i = 0; i < n_inputs; i++)
        for (k = 0; k < n; k++)
            if (strcmp(inputs[i].name, list[k].name) == 0) {
                assert_string_equal(inputs[i].line_unit, list[k].of_line->name);
                found++;
            }
    assert_int_equal(found, n - 2); /* a polar force is listed by its components */
}

TEST(test_units_of_lines)
{
    enum { NUMBERS = 9 };
    static const written kinds[NUMBERS] = {
        {"crank.length", lengths, COUNT(lengths), NULL, 0, 0.020},
        {"coupler.length", lengths, COUNT(lengths), NULL, 0, 0.066},
        {"rocker.length", lengths, COUNT(lengths), NULL, 0, 0.056},
        {"ground.length", lengths, COUNT(lengths), NULL, 0, 0.080},
        {"motion.speed", speeds, COUNT(speeds), NULL, 0, 7},
        {"load P.at.x", lengths, COUNT(lengths), NULL, 0, 0.03},
        {"rocker.mass", NULL, 0, NULL, 0, 0},
        {"load P.force.size", forces, COUNT(forces), NULL, 0, 12},
        {"load P.force.angle", turns, COUNT(turns), NULL, 0, 0.6}};
    static const unit_name masses[] = {{"kg", 1}, {"g", 1e-3}, {"lb", 0.45359237}};
    uint64_t seed = 49;
    int n_decks = some_of(300), checked = 0, i, k;

    for (i = 0; i < n_decks; i++) {
        const unit_name *usual = any_of(lengths, COUNT(lengths), &seed), *rest = &lengths[0];
        int has_units = uniform(&seed, 0, 1) < 0.5;
        written list[NUMBERS];
        fourlink_results *r, *again;
        char deck[1500], text[2000];
        unsigned long n;

        memcpy(list, kinds, sizeof list);
        list[6].units = masses;
        list[6].n_units = COUNT(masses);
        list[6].number = 0.4;
        for (k = 0; k < NUMBERS; k++) {
            list[k].of_line = any_of(list[k].units, list[k].n_units, &seed);
            list[k].is_bare = k < 4 && uniform(&seed, 0, 1) < 0.3;
            if (list[k].is_bare)
                list[k].of_line = has_units ? usual : rest;
            list[k].number /= list[k].of_line->si;
        }
        sprintf(deck, "mechanism = four-bar\n%s%s\n[crank]\nlength = %s\n",
                has_units ? "[units]\nlength = " : "", has_units ? usual->name : "",
                as_written(&list[0]));
        sprintf(deck + strlen(deck), "[coupler]\nlength = %s # of the rod\n", as_written(&list[1]));
        sprintf(deck + strlen(deck), "[rocker]\nlength = %s\n", as_written(&list[2]));
        sprintf(deck + strlen(deck), "mass = %s\n", as_written(&list[6]));
        sprintf(deck + strlen(deck), "[ground]\nlength = %s\n", as_written(&list[3]));
        sprintf(deck + strlen(deck), "[motion]\nspeed = %s\n[load P]\nlink = rocker\n",
                as_written(&list[4]));
        sprintf(deck + strlen(deck), "at = (%.17g, 0) %s\n", list[5].number, list[5].of_line->name);
        sprintf(deck + strlen(deck), "force = %.17g %s at %.17g %s\n", list[7].number,
                list[7].of_line->name, list[8].number, list[8].of_line->name);
        r = opened(deck);
        check_listed_units(r, list, NUMBERS);
        for (k = 0; k < NUMBERS; k++, checked++)
            if (k != 8 ||
                i % 2) /* angle after size; its rows are left as they are in half of the decks */
                check_line_unit(r, &list[k], &seed);
        assert_int_equal(fourlink_deck_write(fourlink_results_deck(r), text, sizeof text, &n),
                         FOURLINK_OK);
        again = opened(text);
        for (k = 0; k < NUMBERS - 2; k++) {
            fourlink_value v;

            assert_close(si_of(again, list[k].name), si_of(r, list[k].name), 1e-14);
            assert_int_equal(fourlink_results_input(again, list[k].name, &v), FOURLINK_OK);
            assert_string_equal(v.unit, list[k].of_line->name); /* the line keeps its unit */
        }
        fourlink_results_free(again);
        fourlink_results_free(r);
    }
    print_message("%d numbers in the units of their lines\n", checked);
}

/* Words that set nothing leave the results as they are, and say why. */
TEST(test_refused_words)
{
    static const struct {
        const char *words;
        int status;
        const char *message;
    } cases[] = {
        {"crank.length = 45 kg", FOURLINK_BAD_NUMBER, "kg"},
        {"crank.length = long", FOURLINK_BAD_NUMBER, "long"},
        {"crank.length", FOURLINK_NO_SUCH_NAME, "expected NAME = NUMBER UNIT, not 'crank.length'"},
        {"crank.lenght = 45 mm", FOURLINK_NO_SUCH_NAME, "'crank.lenght' is no number of this deck"},
        {"table.columns = 3", FOURLINK_NOT_A_NUMBER, "'table.columns' is not a number"},
        {"ground.length = 800 mm", FOURLINK_BAD_DECK,
         "the ground, 800 mm, is longer than the other three together, 142 mm: the linkage cannot "
         "be "
         "assembled"}};
    fourlink_results *r =
        opened(four_bar(0.020, 0.066, 0.056, 0.080, "[table]\ncolumns = theta4\n"));
    digest before = exercise(r);
    fourlink_mistake mistake;
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        assert_int_equal(fourlink_results_set_text(r, cases[i].words, NULL), cases[i].status);
        mistake.message[0] = '\0';
        assert_int_equal(fourlink_results_set_text(r, cases[i].words, &mistake), cases[i].status);
        if (!strstr(mistake.message, cases[i].message))
            fail_msg("%s: %s", cases[i].words, mistake.message);
    }
    /* a linkage without any position: the status, and the mistake */
    assert_int_equal(fourlink_results_set(r, "ground.length", 0.8, &mistake), FOURLINK_BAD_DECK);
    assert_non_null(strstr(mistake.message, "the linkage cannot be assembled"));
    assert_int_equal(fourlink_results_set_text(NULL, "crank.length = 1", NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_set_text(r, NULL, NULL), FOURLINK_NULL);
    assert_true(exercise(r).hash == before.hash);
    fourlink_results_free(r);
}

int main(int argc, char **argv)
{
    step = argc > 1 ? strtoul(argv[1], NULL, 10) : step;
    return run_all_tests(watch_gsl);
}
