/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_like.c - a deck opened like another has its own results, whether its motion is that of the other or not: each digit
** of a deck is changed, then what has no part in the motion.
*/
#include "machines.h"

#define MOST 6000

/* A machine with everything that has a part in its motion. */
static const char machine[] =
    "mechanism = slider-crank\n[crank]\nlength = 50 mm\nmass = 1.5 kg\ninertia = 0.002 kg m2\n"
    "cg = (12, 3) mm\n[rod]\nlength = 200 mm\nmass = 0.8 kg\ngyration = 65 mm\ncg = 70 mm\n"
    "[ground]\noffset = 10 mm\nangle = 20 deg\n[piston]\nmass = 1.2 kg\n[gravity]\n"
    "acceleration = 9.8 m/s2\n[gas]\nbore = 40 mm\nindicator = file card.csv deg bar\n[load P]\n"
    "link = rod\nforce = (11, 32) N\nat = (53, 14) mm\nfrom = 21 deg\nto = 132 deg\n[load Q]\n"
    "link = crank\ntorque = 0 deg 1.1 N m, 121 deg 2.3 N m, 242 deg 1.2 N m\n[load F]\n"
    "link = crank\ntorque = -2.1 N m\nover = omega2\nat_speed = 13 rad/s\nexponent = 2\n"
    "[spring S]\nlink = crank\nto = ground\nstiffness = 1.2 N m/rad\ndamping = 0.012 N m s/rad\n"
    "[balance]\ncrank = yes\nfraction = 0.3\nradius = 40 mm\napply = yes\n[motor]\n"
    "curve = 0 rad/s 51 N m, 12 rad/s 42 N m, 31 rad/s 0 N m\ninertia = 0.13 kg m2\nratio = 1.2\n"
    "[flywheel]\ninertia = 0.55 kg m2\n[friction]\nmu = 0.11\nradius = 12 mm\nguide = 0.13\n"
    "[motion]\n";
static const char by_angle[] = "mode = free\nspeed = 9 rad/s\nfrom = 31 deg\nto = 152 deg\n"
                               "interval = 13 deg\n[table]\nbranch = open\n";
static const char card[] = "0;2\n90;5\n180;3\n270;1\n",
                  other_card[] = "0;2\n90;5.1\n180;3\n270;1\n";
static const char *the_card = card;

static const char *load_card(void *host, const char *name, unsigned long *length)
{
    (void)host;
    (void)name;
    *length = (unsigned long)strlen(the_card);
    return the_card;
}

/* Open a deck, like another if that is not null; null if it has mistakes. */
static fourlink_results *opened_like(const char *contents, fourlink_results *like)
{
    fourlink_source source = deck_source(contents);
    fourlink_results *r = NULL;
    int status;

    source.load = load_card;
    status = fourlink_results_open_like(&source, like, 0, &r, NULL, NULL);
    assert_true(status == FOURLINK_OK || status == FOURLINK_BAD_DECK);
    return r;
}

/* All rows of the usual columns, and the facts of the motion; their number. */
static size_t take(fourlink_results *r, double values[MOST])
{
    const fourlink_value *columns, *facts;
    fourlink_problem p = problem_of(r);
    unsigned long n_columns, n_facts, i;
    size_t n = 0;

    fourlink_results_list(r, FOURLINK_COLUMNS, &columns, &n_columns);
    for (i = 0; i < p.n_rows && n + n_columns < MOST; i++, n += n_columns)
        fourlink_results_row(r, p.open ? FOURLINK_OPEN : FOURLINK_CROSSED, i, values + n, NULL,
                             NULL);
    fourlink_results_facts(r, 0, FOURLINK_FACTS_MOTION, &facts, &n_facts);
    for (i = 0; i < n_facts && n < MOST; i++)
        values[n++] = facts[i].value;
    assert_true(n < MOST);
    return n;
}

/* A deck has the same results whether or not it is opened like another; 1 if they differ from the other's. */
static int check_deck(const char *contents, fourlink_results *like)
{
    static double alone[MOST], beside[MOST], of_like[MOST];
    fourlink_results *a = opened_like(contents, NULL), *b = opened_like(contents, like);
    size_t n, n_like = take(like, of_like);
    int differs;

    assert_true(!a == !b);
    if (!a)
        return 0;
    n = take(a, alone);
    assert_int_equal(take(b, beside), n);
    if (memcmp(alone, beside, n * sizeof *alone) != 0)
        fail_msg("other results:\n%s", contents);
    differs = n != n_like || memcmp(alone, of_like, n * sizeof *alone) != 0;
    fourlink_results_free(b);
    fourlink_results_free(a);
    n = take(like, alone); /* it is not disturbed */
    assert_memory_equal(alone, of_like, n * sizeof *alone);
    return differs;
}

TEST(test_every_digit)
{
    char *contents = print("%s%s", machine, by_angle);
    fourlink_results *like;
    int differing = 0, tried = 0;
    size_t i, length;

    like = opened_like(contents, NULL);
    assert_non_null(like);
    length = strlen(contents);
    for (i = 0; i < length; i++) {
        char digit = contents[i];

        if (digit < '0' || digit > '9')
            continue;
        tried++;
        contents[i] = (char)(digit < '9' ? digit + 1 : '1');
        differing += check_deck(contents, like);
        contents[i] = digit;
    }
    assert_true(differing > tried / 2);
    fourlink_results_free(like);
}

TEST(test_files)
{
    char *contents = print("%s%s", machine, by_angle);
    fourlink_results *like = opened_like(contents, NULL);

    assert_non_null(like);
    the_card = other_card;
    assert_true(check_deck(contents, like));
    the_card = card;
    assert_false(check_deck(contents, like));
    fourlink_results_free(like);
}

/* Columns, branches, steps and units may differ, and the motion be the same or not. */
TEST(test_what_is_shown)
{
    static const char rows[] = "mode = free\nspeed = 9 rad/s\nfrom = 31 deg\nto = 152 deg\n",
                      times[] = "mode = free\nspeed = 9 rad/s\nrows = time\nduration = 0.5 s\n";
    static const char *const shown[] = {
        "interval = 13 deg\n[table]\nbranch = open\n",
        "interval = 7 deg\n[table]\nbranch = open\ncolumns = omega2, Ts, F12\n",
        "interval = 13 deg\n[table]\nbranch = crossed\n",
        "interval = 13 deg\n",
        "interval = 13 deg\n[table]\nbranch = open\ncolumns = energy, alpha2\ndigits = "
        "9\n[expect]\n"
        "at = 40 deg\nomega2 = 3 rad/s\n[grading]\ntolerance = 1 %\n",
        "interval = 13 deg\n[table]\nbranch = open\n[units]\nlength = in\n",
        "interval = 0.2 rad\n[table]\nbranch = open\n[units]\nangle = rad\n"};
    static const char *const timed[] = {"time_step = 0.01 s",
                                        "time_step = 0.05 s\n[table]\ncolumns = omega2",
                                        "time_step = 0.05 s\n[gravity]\nacceleration = 0 m/s2"};
    char *frictionless = print("%s", machine); /* rows by time have no friction */
    fourlink_results *like;
    size_t i, k;

    for (i = 0; i < COUNT(shown); i++) {
        like = opened_like(print("%s%s%s", machine, rows, shown[i]), NULL);
        assert_non_null(like);
        for (k = 0; k < COUNT(shown); k++)
            check_deck(print("%s%s%s", machine, rows, shown[k]), like);
        fourlink_results_free(like);
    }
    *strstr(frictionless, "[gravity]") = '\0';
    like = opened_like(print("%s[motion]\n%stime_step = 0.05 s\n", frictionless, times), NULL);
    assert_non_null(like);
    for (i = 0; i < COUNT(timed); i++)
        assert_true(check_deck(print("%s[motion]\n%s%s\n", frictionless, times, timed[i]), like));
    fourlink_results_free(like);
}

/* Numbers that are set count. */
TEST(test_set_numbers)
{
    char *contents = print("%s%s", machine, by_angle);
    fourlink_results *like = opened_like(contents, NULL);

    assert_int_equal(fourlink_results_set(like, "flywheel.inertia", 0.7, NULL), FOURLINK_OK);
    assert_true(check_deck(contents, like));
    memcpy(strstr(contents, "0.55"), "0.70", 4);
    check_deck(contents, like);
    fourlink_results_free(like);
}

int main(void)
{
    return run_all_tests(watch_gsl);
}
