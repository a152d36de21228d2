/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_write.c - decks written with other values: what is changed, what stays, what reads back.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with glob */

#include <ctype.h>
#include <glob.h>

#include "machines.h"

#define TEXT_SIZE 100000

/* The text of a deck, with its values as they are. */
static const char *written(const fourlink_results *r)
{
    static char text[TEXT_SIZE];
    unsigned long length;

    assert_int_equal(fourlink_deck_write(fourlink_results_deck(r), text, sizeof text, &length),
                     FOURLINK_OK);
    assert_true(length < sizeof text && strlen(text) == length);
    return text;
}

static fourlink_results *changed_by(const char *contents, const char *assignment)
{
    fourlink_change change = {"--set", assignment};
    fourlink_source source = deck_source(contents);
    fourlink_results *r = NULL;
    fourlink_mistake mistake;

    source.changes = &change;
    source.n_changes = 1;
    if (fourlink_results_open(&source, 1, &r, &mistake, NULL) != FOURLINK_OK)
        return NULL;
    return r;
}

/* Both have the same inputs, to the last bit. */
static int has_same_inputs(fourlink_results *x, fourlink_results *y)
{
    const fourlink_value *a, *b;
    unsigned long n, m, i;

    fourlink_results_list(x, FOURLINK_INPUTS, &a, &n);
    fourlink_results_list(y, FOURLINK_INPUTS, &b, &m);
    for (i = 0; i < n && i < m; i++)
        if (strcmp(a[i].name, b[i].name) != 0 || a[i].value != b[i].value ||
            (a[i].words && strcmp(a[i].words, b[i].words) != 0))
            return 0;
    return n == m;
}

/* A deck, a change, and the text with it. */
static void check_written(const char *contents, const char *assignment, const char *expected)
{
    fourlink_results *r = changed_by(contents, assignment), *again;

    assert_non_null(r);
    assert_string_equal(written(r), expected);
    again = opened(expected);
    assert_true(has_same_inputs(r, again));
    fourlink_results_free(again);
    fourlink_results_free(r);
}

#define HEAD "# before\n" BEHIND_COMMENT
#define BEHIND_COMMENT                                                            \
    "mechanism = four-bar ; kind\n[ Ground ]\nlength=80 mm # as it is\n[crank]\n" \
    "length =   20 mm\t; short\n  [coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm # end\n"
#define CURVE                                                                               \
    "[load L]\nlink = rocker\n  torque = 0 deg 0 N m, # first\n# within\n 90 deg 1 N m, \n" \
    "  180 deg 0 N m # last\n# after\nframe = ground\n"

TEST(test_places_of_values)
{
    static const struct {
        const char *before, *assignment, *after;
    } cases[] = {
        {HEAD "[motion]\nspeed = 1 rad/s\n", "motion.speed = 2 rad/s",
         HEAD "[motion]\nspeed = 2 rad/s\n"},
        {"mechanism = four-bar\n[ground]\nlength=80 mm # a\n[crank]\nlength =   20 mm\t; "
         "b\n[coupler]\n"
         "length = 66 mm\n[rocker]\nlength = 56 mm",
         "crank.length=1 in",
         "mechanism = four-bar\n[ground]\nlength=80 mm # a\n[crank]\nlength =   1 in\t; "
         "b\n[coupler]\n"
         "length = 66 mm\n[rocker]\nlength = 56 mm"},
        {HEAD, "GROUND.LENGTH = 0.081", /* a bare number */
         "# before\nmechanism = four-bar ; kind\n[ Ground ]\nlength=0.081 # as it is\n[crank]\n"
         "length =   20 mm\t; short\n  [coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm # "
         "end\n"},
        /* keys and sections that it does not have */
        {HEAD, "rocker.mass=2 kg",
         "# before\nmechanism = four-bar ; kind\n[ Ground ]\nlength=80 mm # as it is\n[crank]\n"
         "length =   20 mm\t; short\n  [coupler]\nlength = 66 mm\n[rocker]\nmass = 2 kg\nlength = "
         "56 mm # end\n"},
        {HEAD, "solver=dyad", "# before\nsolver = dyad\n" BEHIND_COMMENT},
        {HEAD, "motion.interval = 5 deg", HEAD "\n[motion]\ninterval = 5 deg\n"},
        {HEAD "[table]\ndigits = 4", "motion.from=3 deg",
         HEAD "[table]\ndigits = 4\n\n[motion]\nfrom = 3 deg\n"},
        {HEAD "[table]", "table.digits=3", HEAD "[table]\ndigits = 3\n"},
        /* lines that go on */
        {HEAD CURVE, "load L.torque=3 N m",
         HEAD "[load L]\nlink = rocker\n  torque = 3 N m # first\n# after\nframe = ground\n"},
        {HEAD CURVE, "load.frame=link",
         HEAD
         "[load L]\nlink = rocker\n  torque = 0 deg 0 N m, # first\n# within\n 90 deg 1 N m, \n"
         "  180 deg 0 N m # last\n# after\nframe = link\n"},
        /* parts of vectors, in the unit of a part */
        {HEAD "[point P]\nlink = coupler\nat = (20, 10) mm # P\n", "point P.at.x = 2.5 cm",
         HEAD "[point P]\nlink = coupler\nat = (2.5, 1) cm # P\n"},
        {HEAD "[point P]\nlink = coupler\nat = 3 mm\n", "point p.at.angle = 90 deg",
         HEAD "[point P]\nlink = coupler\nat = (0, 3) mm\n"},
        {HEAD "[point P]\nlink = coupler\nat = origin\n", "point P.at.x = 3 mm",
         HEAD "[point P]\nlink = coupler\nat = (3, 0) mm\n"},
        {HEAD, "coupler.cg.y=5 mm",
         "# before\nmechanism = four-bar ; kind\n[ Ground ]\nlength=80 mm # as it is\n[crank]\n"
         "length =   20 mm\t; short\n  [coupler]\ncg = (0, 5) mm\nlength = 66 mm\n[rocker]\nlength "
         "= 56 mm # end\n"},
        /* texts and names */
        {"title = \"A; B\" ; C\n" HEAD, "title=D # E", "title = \"D # E\" ; C\n" HEAD},
        {HEAD "[expect]\nmu_min = 3\nswing = 4 # deg\n", "expect.swing=5",
         HEAD "[expect]\nmu_min = 3\nswing = 5 # deg\n"},
        {HEAD "[expect]\nmu_min = 3\n", "expect.swing=5", HEAD "[expect]\nswing = 5\nmu_min = 3\n"},
        /* ends of lines */
        {"\357\273\277mechanism = four-bar\r\n[ground]\r\nlength = 8 cm\r\n[crank]\r\nlength = 2 "
         "cm\r\n[coupler]\r\n"
         "length = 6 cm\r\n[rocker]\r\nlength = 5 cm",
         "solver=matrix",
         "\357\273\277solver = matrix\r\nmechanism = four-bar\r\n[ground]\r\nlength = 8 "
         "cm\r\n[crank]\r\nlength = 2 cm\r\n"
         "[coupler]\r\nlength = 6 cm\r\n[rocker]\r\nlength = 5 cm"},
        {"mechanism = four-bar\r[ground]\rlength = 8 cm\r[crank]\rlength = 2 cm # "
         "c\r[coupler]\rlength = 6 cm\r[rocker]\r"
         "length = 5 cm\r",
         "crank.length = 3 cm",
         "mechanism = four-bar\r[ground]\rlength = 8 cm\r[crank]\rlength = 3 cm # "
         "c\r[coupler]\rlength = 6 cm\r[rocker]\r"
         "length = 5 cm\r"}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++)
        check_written(cases[i].before, cases[i].assignment, cases[i].after);
}

/* Two values for one section that the deck does not have; the last change of a key counts. */
TEST(test_several_changes)
{
    fourlink_change changes[] = {{"--set", "gravity.direction=0 deg"},
                                 {"--set", "crank.length=3 mm"},
                                 {"--set", "gravity.acceleration=5 m/s2"},
                                 {"--set", "crank.length=30 mm"}};
    fourlink_source source = deck_source(HEAD);
    fourlink_results *r = NULL;

    source.changes = changes;
    source.n_changes = COUNT(changes);
    assert_int_equal(fourlink_results_open(&source, 0, &r, NULL, NULL), FOURLINK_OK);
    assert_string_equal(
        written(r),
        "# before\nmechanism = four-bar ; kind\n[ Ground ]\nlength=80 mm # as it is\n[crank]\n"
        "length =   30 mm\t; short\n  [coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm # end\n"
        "\n[gravity]\nacceleration = 5 m/s2\ndirection = 0 deg\n");
    fourlink_results_free(r);
}

/* A design has its values in the units of the deck's own, and no [sweep]. */
TEST(test_designs)
{
    static const struct {
        const char *before, *sweep, *after, *expected;
    } cases[] = {
        {HEAD, "[sweep]\ncrank.length = 1 in, 2.1 cm\n# of the sweep\n", "[table]\ndigits = 4\n",
         "# before\nsolver = dyad\nmechanism = four-bar ; kind\n[ Ground ]\nlength=80 mm # as it "
         "is\n[crank]\n"
         "length =   21 mm\t; short\n  [coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm # end\n"
         "[table]\ndigits = 4\n"},
        {HEAD, "[sweep]\nload W.torque & load W.at.x = 1 N m & 2 mm, -2 N m & 1 cm",
         "\n[load W]\nlink = rocker\nforce = 0.1 N at 0 deg\nat = (3, 4) mm\ntorque = 1 N cm # T\n",
         "# before\nsolver = dyad\n" BEHIND_COMMENT
         "[load W]\nlink = rocker\nforce = 0.1 N at 0 deg\nat = (10, 4) mm\ntorque = -200 N "
         "cm # T\n"},
        {HEAD "[motion]\nspeed = 3 rad/s\n",
         "[sweep]\nmotion.speed = 30 rpm, 60 rpm\nmotion.interval = 1 deg, 10 deg\ncoupler.cg.x = "
         "1 mm, 2 mm\n",
         "",
         "# before\nsolver = dyad\nmechanism = four-bar ; kind\n[ Ground ]\nlength=80 mm # as it "
         "is\n[crank]\n"
         "length =   20 mm\t; short\n  [coupler]\ncg = (2, 0) mm\nlength = 66 mm\n[rocker]\n"
         "length = 56 mm # end\n[motion]\ninterval = 10 deg\nspeed = 6.283185307179585 rad/s\n"}};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_results *first =
            opened(print("%s%s%s", cases[i].before, cases[i].sweep, cases[i].after));
        fourlink_results *last, *again;

        assert_int_equal(
            fourlink_results_design(first, problem_of(first).n_designs - 1, 0, &last, NULL, NULL),
            FOURLINK_OK);
        assert_string_equal(written(last), cases[i].expected);
        again = opened(cases[i].expected);
        assert_true(has_same_inputs(last, again));
        fourlink_results_free(again);
        fourlink_results_free(last);
        fourlink_results_free(first);
    }
}

#define REST "[coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm\n[ground]\nlength = 80 mm\n"

/* A bare number, or one that is none of the quantity, gives way to the value as [sweep] has it. */
TEST(test_values_without_a_unit)
{
    static const char *const values[] = {"0.02", "20 kg"};
    size_t i;

    for (i = 0; i < COUNT(values); i++) {
        fourlink_results *r = opened(print("mechanism = four-bar\n[crank]\nlength = %s # C\n" REST
                                           "[sweep]\ncrank.length = 2.5 cm, 3 cm\n",
                                           values[i]));

        assert_string_equal(
            written(r), "solver = dyad\nmechanism = four-bar\n[crank]\nlength = 2.5 cm # C\n" REST);
        fourlink_results_free(r);
    }
}

/* At 4 deg no number of mm is the very x of the point: it is written in m. */
/* A point by steps, of which a part is set, is one pair. */
TEST(test_points_by_steps)
{
    static const char deck[] =
        "mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n"
        "[coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm\n";
    char before[500], after[500];

    snprintf(before, sizeof before, "%smass = 1 kg\ncg = (1, 2) mm + (3, 4) cm\n", deck);
    snprintf(after, sizeof after, "%smass = 1 kg\ncg = (10, 42) mm\n", deck);
    check_written(before, "rocker.cg.x = 0.01", after);
    check_written(before, "rocker.cg.x = 10 mm", after);
    snprintf(before, sizeof before, "%smass = 1 kg\ncg = 1 mm + (3, 4) cm\n", deck);
    snprintf(after, sizeof after, "%smass = 1 kg\ncg = (10, 40) mm\n", deck);
    check_written(before, "rocker.cg.x = 0.01", after);
    snprintf(before, sizeof before, "%smass = 1 kg\ncg = origin + (1, 2) mm\n", deck);
    snprintf(after, sizeof after, "%smass = 1 kg\ncg = (10, 2) mm\n", deck);
    check_written(before, "rocker.cg.x = 0.01", after);
}

TEST(test_exact_vectors)
{
    int angle;

    for (angle = 1; angle < 90; angle++) {
        fourlink_results *r =
            changed_by("mechanism = four-bar\n[crank]\nlength = 20 mm\n" REST
                       "[load F]\nlink = coupler\nforce = 1 N at 0 deg\nat = 3 mm\n",
                       print("load F.at.angle=%d deg", angle));
        fourlink_results *again = opened(written(r));

        assert_true(has_same_inputs(r, again));
        fourlink_results_free(again);
        fourlink_results_free(r);
    }
}

/* What does not fit is cut off; the length is told in any case. */
TEST(test_room)
{
    fourlink_results *r = opened(HEAD);
    const fourlink_deck *deck = fourlink_results_deck(r);
    char text[11] = "?";
    unsigned long length = 0;

    assert_int_equal(fourlink_deck_write(NULL, text, 1, &length), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_write(deck, NULL, 1, &length), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_write(deck, text, 1, NULL), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_write(deck, NULL, 0, &length), FOURLINK_OK);
    assert_int_equal(length, strlen(HEAD));
    assert_string_equal(text, "?");
    length = 0;
    assert_int_equal(fourlink_deck_write(deck, text, sizeof text, &length), FOURLINK_OK);
    assert_int_equal(length, strlen(HEAD));
    assert_string_equal(text, "# before\nm");
    length = 0;
    assert_int_equal(fourlink_deck_write_pins(NULL, 1, text, 1, &length), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_write_pins(deck, 1, NULL, 1, &length), FOURLINK_NULL);
    assert_int_equal(fourlink_deck_write_pins(deck, NAN, text, 1, &length), FOURLINK_BAD_NUMBER);
    assert_int_equal(length, 0);
    fourlink_results_free(r);
}

/* ------------------------------------------------------------------------------ the decks of the project */

static const char *read_file(const char *name)
{
    static char contents[TEXT_SIZE];
    FILE *in = fopen(name, "rb");
    size_t n;

    assert_non_null(in);
    n = fread(contents, 1, sizeof contents - 1, in);
    fclose(in);
    contents[n] = '\0';
    return contents;
}

static int step = 20; /* every twentieth value, or each */

/* Change values that are numbers, in the units of their lines: nothing else in the text changes, and what is
** written reads back as what was changed.  The number of such values. */
static int check_changes(const char *contents)
{
    char section[200] = "";
    const char *line, *end;
    int n = 0;

    for (line = contents; *line; line = *end ? end + 1 : end) {
        const char *value = strchr(line, '=');
        char assignment[400], expected[TEXT_SIZE], *unit;
        fourlink_results *r, *again;
        double number;

        end = line + strcspn(line, "\n");
        if (*line == '[')
            snprintf(section, sizeof section, "%.*s.", (int)strcspn(line + 1, "]"), line + 1);
        if (!isalpha((unsigned char)*line) || !value || value > end || end - line > 100 ||
            memchr(line, ',', (size_t)(end - line)))
            continue;
        value += 1 + strspn(value + 1, " ");
        number = strtod(value, &unit);
        if (unit == value || unit > end || (end - contents) % step)
            continue;
        snprintf(assignment, sizeof assignment, "%s%.*s=%.17g%.*s", section,
                 (int)strcspn(line, " ="), line, number * 1.03125, (int)strcspn(unit, "#;\n"),
                 unit);
        r = changed_by(contents, assignment);
        if (!r)
            continue; /* several sections of one name; a count */
        snprintf(expected, sizeof expected, "%.*s%.17g%s", (int)(value - contents), contents,
                 number * 1.03125, unit);
        assert_string_equal(written(r), expected);
        again = opened(written(r));
        assert_true(has_same_inputs(r, again));
        fourlink_results_free(again);
        fourlink_results_free(r);
        n++;
    }
    return n;
}

TEST(test_decks_of_the_project)
{
    glob_t files;
    size_t i;
    int n_decks = 0, n_changes = 0;

    assert_int_equal(glob(SOURCE_DIR "/data/*.deck", 0, NULL, &files), 0);
    assert_int_equal(glob(SOURCE_DIR "/tests/decks/*.deck", GLOB_APPEND, NULL, &files), 0);
    assert_int_equal(glob(SOURCE_DIR "/tests/expect/*.deck", GLOB_APPEND, NULL, &files), 0);
    for (i = 0; i < files.gl_pathc; i++) {
        const char *contents = read_file(files.gl_pathv[i]);
        fourlink_source source = deck_source(contents);
        fourlink_results *r = NULL;

        if (fourlink_results_open(&source, 0, &r, NULL, NULL) != FOURLINK_OK)
            continue;
        assert_int_equal(problem_of(r).n_designs, 0);
        assert_string_equal(written(r), contents);
        fourlink_results_free(r);
        n_changes += check_changes(contents);
        n_decks++;
    }
    globfree(&files);
    print_message("%d decks, %d changes\n", n_decks, n_changes);
    assert_true(n_decks > 50 && n_changes > 600 / step);
}

int main(int argc, char **argv)
{
    step = argc > 1 ? atoi(argv[1]) : step;
    return run_all_tests(NULL);
}
