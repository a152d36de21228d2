/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_name.c - names that are looked up once: what they are, and that their handles give the same values.
*/
#include <limits.h>

#include "machines.h"

#define ROWS "[motion]\nspeed = 10 rad/s\ninterval = 40 deg\n"
#define POINT "[point P]\nlink = coupler\nat = (20, 10) mm\n"
#define SPRING                                                                       \
    "[spring S]\nlink = rocker\nto = ground\nat = (20, 0) mm\nto_at = (80, 60) mm\n" \
    "stiffness = 200 N/m\nfree_length = 30 mm\n"

static fourlink_value found(fourlink_results *r, const char *name)
{
    fourlink_value v;
    int status = fourlink_results_find(r, name, &v);

    if (status != FOURLINK_OK)
        fail_msg("%s: %s", name, fourlink_status_text(status));
    assert_int_not_equal(v.handle, 0);
    return v;
}

/* 1 if both ways give the same status, and the same in the member of a value if it is there. */
static void check_same(fourlink_results *r, const char *name, int handle)
{
    int k;

    for (k = 0; k < 2; k++) {
        fourlink_value by_name, by_handle;
        int status = fourlink_results_value(r, name, branches[k], 80, &by_name);

        if (fourlink_results_get(r, handle, branches[k], 80, &by_handle) != status)
            fail_msg("%s: another status", name);
        if (status != FOURLINK_OK)
            continue;
        assert_int_equal(by_handle.handle, handle);
        assert_string_equal(by_handle.name, name);
        assert_true(by_name.value == by_handle.value || isnan(by_name.value));
        assert_true(by_name.angle == by_handle.angle && by_name.words == by_handle.words);
        assert_string_equal(by_name.unit, by_handle.unit);
        assert_string_equal(by_name.meaning, by_handle.meaning);
        assert_int_equal(by_name.handle, handle);
    }
}

/* Every name of the lists, and the statistics of every column. */
TEST(test_names_and_handles)
{
    static const char *const functions[] = {"", "max", "min", "mean", "rms"};
    static const char *const decks[] = {
        ROCKER ROWS POINT SPRING,
        PUMP FORCE ROWS "[gas]\nbore = 50 mm\npressure = 9 bar\n[friction]\nA = 0.1\n"
                        "radius_A = 5 mm\n",
        "mechanism = inverted-slider-crank\n[ground]\nlength = 200 mm\n[crank]\nlength = 80 mm\n"
        "[lever]\nmass = 2 kg\n" ROWS,
    };
    size_t i;

    for (i = 0; i < COUNT(decks); i++) {
        fourlink_results *r = opened(decks[i]);
        const fourlink_value *list;
        unsigned long n, k;
        int which;

        for (which = FOURLINK_COLUMNS; which <= FOURLINK_INPUTS; which++) {
            assert_int_equal(fourlink_results_list(r, which, &list, &n), FOURLINK_OK);
            assert_true(n > 5);
            for (k = 0; k < n; k++) {
                fourlink_value v = found(r, list[k].name);

                assert_int_equal(v.handle, list[k].handle);
                assert_string_equal(v.meaning, list[k].meaning);
                assert_string_equal(v.quantity, list[k].quantity);
                assert_int_equal(v.flags, list[k].flags);
                assert_int_equal(v.has_angle, which != FOURLINK_INPUTS);
                check_same(r, list[k].name, v.handle);
            }
        }
        assert_int_equal(fourlink_results_list(r, FOURLINK_COLUMNS, &list, &n), FOURLINK_OK);
        for (k = 0; k < n; k++)
            for (which = FOURLINK_MAX; which <= FOURLINK_RMS; which++) {
                char *name = print("%s(%s)", functions[which], list[k].name);
                fourlink_value v = found(r, name);

                assert_int_equal(v.handle, list[k].handle + which);
                assert_string_equal(v.name, name);
                assert_false(v.has_angle);
                check_same(r, name, v.handle);
            }
        assert_int_equal(fourlink_results_facts(r, FOURLINK_OPEN, 15, &list, &n), FOURLINK_OK);
        while (n-- > 0) {
            fourlink_value fact = list[n]; /* the list changes */

            assert_int_equal(found(r, fact.name).handle, fact.handle);
            assert_string_equal(found(r, fact.name).meaning, strchr(fact.name, '(')
                                                                 ? found(r, fact.name).meaning
                                                                 : fact.meaning);
            check_same(r, fact.name, fact.handle);
            assert_int_equal(fourlink_results_facts(r, FOURLINK_OPEN, 15, &list, &k), FOURLINK_OK);
        }
        fourlink_results_free(r);
    }
}

/* A fact in words, an input in words, an input with a number. */
TEST(test_words_and_inputs)
{
    fourlink_results *r = opened(ROCKER ROWS SPRING);
    fourlink_value v;

    assert_int_equal(fourlink_results_get(r, found(r, "type").handle, FOURLINK_OPEN, 0, &v),
                     FOURLINK_OK);
    assert_string_equal(v.words, "crank-rocker");
    assert_int_equal(fourlink_results_value(r, "spring S.link", FOURLINK_OPEN, 0, &v), FOURLINK_OK);
    assert_string_equal(v.words, "rocker");
    v = named(r, "crank.length", FOURLINK_CROSSED, 0);
    assert_close(v.value * v.to_si, 0.020, 1e-15);
    assert_int_equal(fourlink_results_find(r, "crank.offset", &v), FOURLINK_NO_SUCH_NAME);
    fourlink_results_free(r);
}

TEST(test_unknown_names_and_handles)
{
    static const char *const names[] = {
        "", "xyzzy", "max(xyzzy)", "max(mu", "max()", "max(max(mu))", "mu ", "Mu", "crank"};
    static const int handles[] = {0, INT_MAX, INT_MIN, -999, -100000, 1000000};
    fourlink_results *r = opened(ROCKER ROWS);
    fourlink_value v, before;
    size_t i;

    memset(&v, 5, sizeof v);
    before = v;
    for (i = 0; i < COUNT(names); i++)
        if (fourlink_results_find(r, names[i], &v) != FOURLINK_NO_SUCH_NAME)
            fail_msg("'%s' is a name", names[i]);
    for (i = 0; i < COUNT(handles); i++)
        if (fourlink_results_get(r, handles[i], FOURLINK_OPEN, 0, &v) != FOURLINK_NO_SUCH_NAME)
            fail_msg("%d is a handle", handles[i]);
    assert_int_equal(fourlink_results_find(NULL, "mu", &v), FOURLINK_NULL);
    assert_int_equal(fourlink_results_find(r, NULL, &v), FOURLINK_NULL);
    assert_int_equal(fourlink_results_find(r, "mu", NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_get(NULL, 1, FOURLINK_OPEN, 0, &v), FOURLINK_NULL);
    assert_int_equal(fourlink_results_get(r, 1, FOURLINK_OPEN, 0, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_results_get(r, 1, (fourlink_branch)0, 0, &v), FOURLINK_BAD_BRANCH);
    assert_memory_equal(&v, &before, sizeof v);
    assert_int_equal(fourlink_results_get(r, found(r, "stroke").handle, FOURLINK_OPEN, 0, &v),
                     FOURLINK_NO_SUCH_FACT);
    fourlink_results_free(r);
}

/* Beside the last column and the last fact there is nothing; the opposite forces are behind those that are listed. */
TEST(test_first_and_last_handles)
{
    fourlink_results *r = opened(ROCKER ROWS SPRING);
    const fourlink_value *list;
    fourlink_value v;
    unsigned long n;
    int last;

    assert_int_equal(fourlink_results_list(r, FOURLINK_ALL_COLUMNS, &list, &n), FOURLINK_OK);
    assert_int_equal(fourlink_results_get(r, list[0].handle - 1, FOURLINK_OPEN, 0, &v),
                     FOURLINK_NO_SUCH_NAME);
    last = list[n - 1].handle + FOURLINK_RMS;
    assert_int_equal(fourlink_results_get(r, last, FOURLINK_OPEN, 0, &v), FOURLINK_OK);
    assert_string_equal(v.name, "rms(S.power)");
    assert_int_equal(fourlink_results_get(r, last + 1, FOURLINK_OPEN, 0, &v), FOURLINK_OK);
    assert_string_equal(v.name, "F21x");
    last = found(r, "rms(F41_dir)").handle;
    assert_int_equal(fourlink_results_get(r, last + 1, FOURLINK_OPEN, 0, &v),
                     FOURLINK_NO_SUCH_NAME);
    last = found(r, "motor_torque").handle;
    assert_int_equal(fourlink_results_get(r, last, FOURLINK_OPEN, 0, &v), FOURLINK_NO_SUCH_FACT);
    assert_int_equal(fourlink_results_get(r, last - 1, FOURLINK_OPEN, 0, &v),
                     FOURLINK_NO_SUCH_NAME);
    fourlink_results_free(r);
}

/* NAME at ANGLE by name and by handle, in designs, and after numbers were set. */
TEST(test_names_at_angles)
{
    static const char *const names[] = {
        "Ts at 30 deg",          "Ts at 30",        "theta4 at 1/3 rev", "P.vx at pi/6",
        "S.force at -40.25 deg", "F32x at 750 deg", "omega2 at 0deg"};
    static const double at[] = {30, 30, 120, 30, -40.25, 750, 0};
    static const char *const columns[] = {"Ts",      "Ts",   "theta4", "P.vx",
                                          "S.force", "F32x", "omega2"};
    fourlink_source source = deck_source(
        four_bar(0.020, 0.066, 0.056, 0.080,
                 ROWS POINT SPRING
                 "[sweep]\ncrank.length = 20 mm, 22 mm\noutput = Ts at 30 deg, mu at 3\n"));
    fourlink_results *r, *design;
    const fourlink_value *list;
    fourlink_value v, w;
    unsigned long n;
    double angle;
    size_t i;
    int k;

    assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_OK);
    for (i = 0; i < COUNT(names); i++) {
        v = found(r, names[i]);
        assert_string_equal(v.name, names[i]);
        assert_close(v.angle, at[i], 1e-14);
        angle = v.angle;
        assert_false(v.has_angle);
        assert_int_equal(v.handle, found(r, names[i]).handle);
        check_same(r, names[i], v.handle);
        for (k = 0; k < 2; k++) {
            assert_int_equal(fourlink_results_value(r, names[i], branches[k], 77, &v), FOURLINK_OK);
            w = named(r, columns[i], branches[k], angle);
            assert_true(v.value == w.value && v.angle == w.angle && v.has_angle);
        }
    }
    assert_int_equal(fourlink_results_design(r, 1, 0, &design, NULL, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_results_list(design, FOURLINK_OUTPUTS, &list, &n), FOURLINK_OK);
    assert_int_equal(list[0].handle, found(r, "Ts at 30 deg").handle);
    for (i = 0; i < COUNT(names); i++)
        check_same(design, names[i], found(r, names[i]).handle);
    assert_int_equal(fourlink_results_set(r, "coupler.length", 0.070, NULL), FOURLINK_OK);
    for (i = 0; i < COUNT(names); i++)
        check_same(r, names[i], found(design, names[i]).handle);
    k = found(r, "mu at 100 deg").handle; /* kept when numbers are set again */
    assert_int_equal(fourlink_results_set(r, "coupler.length", 0.066, NULL), FOURLINK_OK);
    check_same(r, "mu at 100 deg", k);
    assert_int_equal(found(r, "mu at 100 deg").handle, k);
    fourlink_results_free(design);
    fourlink_results_free(r);
}

/* What is no NAME at ANGLE, and more of them than there is room for. */
TEST(test_no_names_at_angles)
{
    static const char *const names[] = {"mu at",          "mu at ",         "mu at noon",
                                        "mu at drawn",    "xx at 30",       "mu_min at 30",
                                        "max(mu) at 30",  "max(mu at 30)",  "mu at 30 mm",
                                        "mu at 30 deg x", "mu at 30 at 40", "crank.length at 3"};
    fourlink_results *r = opened(ROCKER ROWS POINT);
    fourlink_value v, before;
    char name[100];
    size_t i;
    int n;

    memset(&v, 5, sizeof v);
    before = v;
    for (i = 0; i < COUNT(names); i++) {
        if (fourlink_results_find(r, names[i], &v) != FOURLINK_NO_SUCH_NAME)
            fail_msg("'%s' is a name", names[i]);
        assert_int_equal(fourlink_results_value(r, names[i], FOURLINK_OPEN, 0, &v),
                         FOURLINK_NO_SUCH_NAME);
    }
    snprintf(name, sizeof name, "mu at %060d deg", 30);
    assert_int_equal(fourlink_results_find(r, name, &v), FOURLINK_NO_SUCH_NAME);
    assert_memory_equal(&v, &before, sizeof v);
    assert_int_equal(fourlink_results_value(r, name, FOURLINK_OPEN, 0, &v), FOURLINK_OK);
    for (n = 0; n < 1000; n++) {
        snprintf(name, sizeof name, "mu at %d deg", n);
        if (fourlink_results_find(r, name, &v) != FOURLINK_OK)
            break;
    }
    assert_int_equal(n, 256);
    assert_int_equal(fourlink_results_value(r, name, FOURLINK_OPEN, 0, &v), FOURLINK_OK);
    assert_true(v.value == named(r, "mu", FOURLINK_OPEN, 256).value);
    check_same(r, "mu at 255 deg", found(r, "mu at 255 deg").handle);
    assert_int_equal(
        fourlink_results_get(r, found(r, "mu at 255 deg").handle + 1, FOURLINK_OPEN, 0, &v),
        FOURLINK_NO_SUCH_NAME);
    fourlink_results_free(r);
}

/* Handles of one design are those of another, though they have not the same columns. */
TEST(test_handles_of_a_sweep)
{
    static const char *const names[] = {"mu",     "max(mu)",   "P.vx",         "S.length",
                                        "mu_min", "rms(P.vy)", "crank.length", "coupler.mass"};
    fourlink_source source = deck_source(
        four_bar(0.020, 0.066, 0.056, 0.080,
                 ROWS POINT SPRING "[sweep]\ncrank.length = 20 mm, 22 mm\n"
                                   "coupler.mass = 0 kg, 1 kg\noutput = max(mu), mu_min\n"
                                   "yield = mu_min > 10 deg, rms(mu) < 90 deg\n"));
    fourlink_results *designs[4];
    const fourlink_value *list;
    fourlink_value v;
    unsigned long n;
    size_t i, k;

    for (k = 0; k < 4; k++) {
        source.design = k;
        assert_int_equal(fourlink_results_open(&source, 0, &designs[k], NULL, NULL), FOURLINK_OK);
        assert_int_equal(fourlink_results_list(designs[k], FOURLINK_OUTPUTS, &list, &n),
                         FOURLINK_OK);
        assert_int_equal(n, 3);
        assert_int_equal(list[0].handle, found(designs[0], "max(mu)").handle);
        assert_int_equal(list[1].handle, found(designs[0], "mu_min").handle);
        assert_int_equal(list[2].handle, found(designs[0], "rms(mu)").handle);
        assert_int_equal(fourlink_results_list(designs[k], FOURLINK_CONDITIONS, &list, &n),
                         FOURLINK_OK);
        assert_int_equal(list[0].handle, found(designs[0], "mu_min").handle);
    }
    for (i = 0; i < COUNT(names); i++)
        for (k = 0; k < 4; k++) {
            assert_int_equal(found(designs[k], names[i]).handle,
                             found(designs[0], names[i]).handle);
            check_same(designs[k], names[i], found(designs[0], names[i]).handle);
        }
    assert_int_equal(fourlink_results_get(designs[3], found(designs[0], "coupler.mass").handle,
                                          FOURLINK_OPEN, 0, &v),
                     FOURLINK_OK);
    assert_true(v.value == 1);
    assert_int_equal(fourlink_results_list(designs[3], FOURLINK_INPUTS, &list, &n), FOURLINK_OK);
    for (i = 0; i < n; i++) {
        assert_int_equal(fourlink_results_get(designs[3], list[i].handle, FOURLINK_OPEN, 0, &v),
                         FOURLINK_OK);
        assert_string_equal(v.name, list[i].name);
        assert_string_equal(v.meaning, list[i].meaning);
    }
    for (k = 0; k < 4; k++)
        fourlink_results_free(designs[k]);
}

/* Results without a column say so, whatever deck the handle is from. */
TEST(test_columns_that_are_lacking)
{
    fourlink_results *with = opened(ROCKER ROWS), *without = opened(slider_crank(1, 3, 0, ROWS));
    fourlink_value v, before;

    memset(&v, 5, sizeof v);
    before = v;
    assert_int_equal(
        fourlink_results_get(without, found(with, "max(Ts)").handle, FOURLINK_OPEN, 0, &v),
        FOURLINK_NO_SUCH_NAME);
    assert_int_equal(fourlink_results_get(with, found(without, "x").handle, FOURLINK_OPEN, 0, &v),
                     FOURLINK_NO_SUCH_NAME);
    assert_memory_equal(&v, &before, sizeof v);
    fourlink_results_free(with);
    fourlink_results_free(without);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
