/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_link.c - links in decks: uniform bars, centres of mass as parts of the length, point masses, keys that
** are missing.
*/
#include "outcome.h"
#include "elements.h"
#include "deck/reader.h"
#include "deck/schema.h"

/* Eight lines; the coupler is open. */
#define FOUR_BAR             \
    "mechanism = four-bar\n" \
    "[ground]\n"             \
    "length = 80 mm\n"       \
    "[crank]\n"              \
    "length = 20 mm\n"       \
    "[rocker]\n"             \
    "length = 56 mm\n"       \
    "[coupler]\n"

#define LENGTH "length = 66 mm\n"

/* Six lines; the lever is open. */
#define SLOTTED                           \
    "mechanism = inverted-slider-crank\n" \
    "[crank]\n"                           \
    "length = 120 mm\n"                   \
    "[ground]\n"                          \
    "length = 240 mm\n"                   \
    "[lever]\n"

#define SLIDER_CRANK             \
    "mechanism = slider-crank\n" \
    "[crank]\n"                  \
    "stroke = 200 mm\n"          \
    "[rod]\n"                    \
    "length = 400 mm\n"

static void check_body(const char *contents, int link, double mass, double inertia, double x,
                       double y)
{
    deck d;

    print_message("%s\n", contents);
    read_accepted(contents, NULL, &d);
    assert_close(d.machine.mechanism.design.link[link].mass, mass, 1e-15);
    assert_close(d.machine.mechanism.design.link[link].inertia, inertia, 1e-15);
    assert_near(d.machine.mechanism.design.link[link].cg.x, x, 1e-16);
    assert_near(d.machine.mechanism.design.link[link].cg.y, y, 1e-16);
    assert_int_equal(d.notes.count, 0);
    flk_deck_free(&d);
}

TEST(test_uniform_bars)
{
    check_body(FOUR_BAR LENGTH "mass = 0.3 kg\nuniform = yes\n", 3, 0.3, 0.3 * 0.066 * 0.066 / 12,
               0.033, 0);
    check_body(FOUR_BAR "uniform = YES\nmass = 0.3 kg\n" LENGTH, 3, 0.3, 0.3 * 0.066 * 0.066 / 12,
               0.033, 0);
    /* the length of the crank follows from the stroke */
    check_body("mechanism = slider-crank\n[crank]\nstroke = 200 mm\nmass = 2 kg\nuniform = yes\n"
               "[rod]\nlength = 400 mm\n",
               2, 2, 2 * 0.1 * 0.1 / 12, 0.05, 0);
    check_body(SLOTTED "length = 300 mm\nangle = 20 deg\nmass = 3 kg\nuniform = yes\n", 4, 3,
               3 * 0.3 * 0.3 / 12, 0.15, 0);
    check_body(FOUR_BAR LENGTH "mass = 0.3 kg\nuniform = no\ncg = 1 mm\n", 3, 0.3, 0, 0.001, 0);
    check_body(FOUR_BAR LENGTH "mass = 0 kg\nuniform = yes\n", 3, 0, 0, 0.033, 0);
}

/* It is the bar that people describe by hand today. */
TEST(test_uniform_by_hand)
{
    check_body(FOUR_BAR LENGTH "mass = 0.3 kg\ncg = 33 mm\ninertia = 108.9 kg mm2\n", 3, 0.3,
               0.3 * 0.066 * 0.066 / 12, 0.033, 0);
}

TEST(test_parts_of_the_length)
{
    check_body(FOUR_BAR LENGTH "mass = 1 kg\ncg = mid\n", 3, 1, 0, 0.033, 0);
    check_body(FOUR_BAR LENGTH "mass = 1 kg\ncg = 50 %\n", 3, 1, 0, 0.033, 0);
    check_body(FOUR_BAR "cg = 25%\nmass = 1 kg\n" LENGTH, 3, 1, 0, 0.0165, 0);
    check_body(FOUR_BAR LENGTH "mass = 1 kg\ncg = -10 %\n", 3, 1, 0, -0.0066, 0);
    check_body(FOUR_BAR LENGTH "mass = 1 kg\ncg = 50 % at 90 deg\n", 3, 1, 0, 0, 0.033);
    check_body("mechanism = slider-crank\n[crank]\nstroke = 200 mm\nmass = 2 kg\ncg = mid\n"
               "[rod]\nlength = 400 mm\n",
               2, 2, 0, 0.05, 0);
}

/* From the centre of mass, which is beside the axis of its link, on either side. */
TEST(test_places_from_the_centre_of_mass)
{
    static const double sides[] = {1, -1};
    char contents[600];
    deck d;
    int i;

    for (i = 0; i < 2; i++) {
        sprintf(contents,
                FOUR_BAR LENGTH "mass = 1 kg\ncg = (30, %g) mm\n"
                                "[load]\nlink = coupler\nforce = (3, 0) N\nat = G\n"
                                "[point P]\nlink = coupler\nat = G + (4, -5) mm\n",
                7 * sides[i]);
        read_accepted(contents, NULL, &d);
        assert_near(given_load(&d, 0)->load.at.x, 0.03, 1e-17);
        assert_near(given_load(&d, 0)->load.at.y, 0.007 * sides[i], 1e-17);
        assert_near(d.points[0].at.x, 0.034, 1e-17);
        assert_near(d.points[0].at.y, 0.007 * sides[i] - 0.005, 1e-17);
        flk_deck_free(&d);
    }
}

TEST(test_places_of_loads)
{
    deck d;

    read_accepted(FOUR_BAR LENGTH "[load]\nlink = rocker\nforce = (3, 0) N\nat = mid\n"
                                  "[point P]\nlink = coupler\nat = 200 %\n",
                  NULL, &d);
    assert_near(given_load(&d, 0)->load.at.x, 0.028, 1e-17);
    assert_near(d.points[0].at.x, 0.132, 1e-16);
    flk_deck_free(&d);
    /* 50 g cm2 about G, 2 s about the end: as with cg = 33 mm and swing_pin = 66 mm */
    check_body(FOUR_BAR LENGTH "mass = 1 kg\ncg = mid\nswing_period = 2 s\nswing_pin = 100 %\n", 3,
               1, 0.033 * (9.81 / (PI * PI) - 0.033), 0.033, 0);
}

TEST(test_refused)
{
    static const char bar[] = "a uniform link has its centre of mass at mid-length and the inertia "
                              "of a bar: give either 'uniform' or the others";

    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\nuniform = yes\ncg = mid\n", NULL, 12, bar);
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\ninertia = 1 kg m2\nuniform = yes\n", NULL, 11, bar);
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\ngyration = 1 mm\nuniform = yes\n", NULL, 11, bar);
    check_mistake(FOUR_BAR LENGTH "uniform = yes\n", NULL, 10, "a uniform link needs a mass");
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\nuniform = 1\n", NULL, 11,
                  "expected no or yes, not '1'");
    check_mistake(SLOTTED "mass = 1 kg\nuniform = yes\n", NULL, 8,
                  "a uniform lever needs a length");
    check_mistake(SLOTTED "mass = 1 kg\nuniform = yes\nlenth = 3 mm\nangle = 30 deg\n", NULL, 9,
                  "unknown key 'lenth' in [lever]; did you mean 'length'?");
    check_mistake(SLOTTED "mass = 1 kg\nuniform = yes\nlength = 3 kg\nangle = 30 deg\n", NULL, 9,
                  "'3 kg' is a mass; expected a length, such as 80 mm");
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\nuniform = yes\nswing_pin = end\n", NULL, 12, bar);
    check_mistake("mechanism = four-bar\n[ground]\nlength = 1e10 m\n[crank]\nlength = 1e10 m\n"
                  "[rocker]\nlength = 1e10 m\n[coupler]\nlength = 1e10 m\nmass = 1e20 kg\n"
                  "uniform = yes\n",
                  NULL, 11, "the resulting moment of inertia is out of range");
    check_mistake(SLOTTED "mass = 1 kg\ncg = mid\n", NULL, 8,
                  "'mid' is a part of the length, and the lever has none: give the point in a unit "
                  "of length");
    check_mistake(SLOTTED "[slider]\nmass = 1 kg\ncg = 50 %\n", NULL, 9,
                  "'50 %' is a part of the length, and the slider has none: give the point in a "
                  "unit of length");
    check_mistake(SLOTTED "[slider]\nmass = 1 kg\nuniform = yes\n", NULL, 9,
                  "unknown key 'uniform' in [slider]; it belongs in a section such as [crank]");
    check_mistake(SLIDER_CRANK "[load]\nlink = piston\nforce = 1 N at 0 deg\nat = mid\n", NULL, 9,
                  "'mid' is a part of the length, and the piston has none: give the point in a "
                  "unit of length");
    check_mistake(FOUR_BAR "length = 50 %\n", NULL, 9,
                  "'50 %': per cent of what? expected a length, such as 80 mm");
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\ncg = 50 % mm\n", NULL, 11,
                  "unknown unit '% mm' in '50 % mm'");
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\ncg = 50 %%\n", NULL, 11,
                  "unknown unit '%%' in '50 %%'");
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\ncg = middle\n", NULL, 11,
                  "expected a length, such as 80 mm, not 'middle'");
    check_mistake(FOUR_BAR LENGTH "[load]\nlink = crank\nforce = 50 % at 3 deg\nat = 0 mm\n", NULL,
                  12, "'50 % at 3 deg': per cent of what? expected a force, such as 50 N");
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\ncg = 1e20 %\n", NULL, 11,
                  "'1e20 %' is out of range");
}

/* A mass that is a point is probably an oversight. */
TEST(test_point_masses)
{
    check_note(
        FOUR_BAR LENGTH "mass = 0.3 kg\n", NULL, 10,
        "[coupler] is a point mass at B: write uniform = yes for a uniform bar, cg = 0 mm if "
        "this is meant");
    check_note("mechanism = slider-crank\n[crank]\nmass = 1 kg\nlength = 100 mm\n"
               "[rod]\nlength = 400 mm\n[piston]\nmass = 3 kg\n",
               NULL, 3,
               "[crank] is a point mass at A: write uniform = yes for a uniform bar, cg = 0 mm if "
               "this is meant");
    check_note(SLOTTED "mass = 1 kg\n[slider]\nmass = 1 kg\n", NULL, 7,
               "[lever] is a point mass at D: write cg = 0 mm if this is meant");
    check_note(
        FOUR_BAR LENGTH "mass = 0.3 kg\nuniform = no\n", NULL, 10,
        "[coupler] is a point mass at B: write uniform = yes for a uniform bar, cg = 0 mm if "
        "this is meant");
    check_note(FOUR_BAR LENGTH "mass = 0.3 kg\ncg = 0 mm\n", NULL, 0, NULL);
    check_note(FOUR_BAR LENGTH "mass = 0.3 kg\ngyration = 5 mm\n", NULL, 0, NULL);
    check_note(FOUR_BAR LENGTH "mass = 0.3 kg\ninertia = 0 kg m2\n", NULL, 0, NULL);
    check_note(FOUR_BAR LENGTH "mass = 0 kg\n", NULL, 0, NULL);
    check_note(FOUR_BAR LENGTH "mass = 0.3 kg\nuniform = yes\n", NULL, 0, NULL);
}

/* A part of the length goes with a length that varies; its own parts do not. */
TEST(test_sweep)
{
    fourlink_source source = deck_source(FOUR_BAR "mass = 1 kg\ncg = mid\n" LENGTH
                                                  "[sweep]\ncoupler.length = 60 mm, 70 mm\n");
    deck d;

    source.design = 1;
    assert_int_equal(flk_deck_read(&source, &d), 1);
    assert_near(d.machine.mechanism.design.link[3].cg.x, 0.035, 1e-16);
    flk_deck_free(&d);
    check_mistake(FOUR_BAR "mass = 1 kg\ncg = mid\n" LENGTH "[sweep]\ncoupler.cg.y = 1 mm, 2 mm\n",
                  NULL, 13,
                  "'mid' is a part of the length of the link: give the point in a unit of length "
                  "before you vary a part of it");
}

/* A key that may only be misspelt is not reported as missing too. */
TEST(test_misspelt_keys)
{
    check_mistake(FOUR_BAR "lenght = 66 mm\n", NULL, 9,
                  "unknown key 'lenght' in [coupler]; did you mean 'length'?");
    check_mistake("mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n"
                  "[rockr]\nlength = 56 mm\n[coupler]\n" LENGTH,
                  NULL, 6, "unknown section 'rockr'; did you mean 'rocker'?");
    check_mistake(FOUR_BAR LENGTH "mas = 1 kg\ngyration = 3 mm\n", NULL, 10,
                  "unknown key 'mas' in [coupler]; did you mean 'mass'?");
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\nswing_periode = 3 s\nswing_pin = end\n", NULL, 11,
                  "unknown key 'swing_periode' in [coupler]; did you mean 'swing_period'?");
    check_mistake(FOUR_BAR LENGTH "mass = 1 kg\nswing_period = 3 s\nswingpin = end\n", NULL, 12,
                  "unknown key 'swingpin' in [coupler]; did you mean 'swing_pin'?");
    check_mistake(SLIDER_CRANK "[gas]\nbor = 3 mm\npressure = 1 bar\n", NULL, 7,
                  "unknown key 'bor' in [gas]; did you mean 'bore'?");
    check_mistake(SLIDER_CRANK "[gas]\nbore = 3 mm\npresure = 1 bar\n", NULL, 8,
                  "unknown key 'presure' in [gas]; did you mean 'pressure'?");
    check_mistake(SLIDER_CRANK "[load]\nlnk = rod\ntorque = 1 N m\n", NULL, 7,
                  "unknown key 'lnk' in [load]; did you mean 'link'?");
    check_mistake(SLIDER_CRANK "[load]\nlink = rod\ntorq = 1 N m\n", NULL, 8,
                  "unknown key 'torq' in [load]; did you mean 'torque'?");
    check_mistake(SLIDER_CRANK "[load]\nlink = rod\nforce = 1 N at 0 deg\natt = 0 mm\n", NULL, 9,
                  "unknown key 'att' in [load]; did you mean 'at'?");
    check_mistake(SLIDER_CRANK "[motion]\nrun_up = 90 deg\nacelleration = 1 rad/s2\n", NULL, 8,
                  "unknown key 'acelleration' in [motion]; did you mean 'acceleration'?");
    /* in another section it is */
    {
        deck d;

        assert_int_equal(read_outcome(FOUR_BAR "[motion]\nsped = 1 rpm\n", NULL, &d), 0);
        assert_int_equal(d.mistakes.count, 2);
        assert_string_equal(d.mistakes.list[0].message, "[coupler] has no length");
        flk_deck_free(&d);
    }
}

/* The notes as a host gets them. */
TEST(test_notes_of_results)
{
    fourlink_source source = deck_source("mechanism = four-bar\n[ground]\nlength = 80 mm\n"
                                         "[crank]\nlength = 20 mm\n"
                                         "[coupler]\nlength = 66 mm\nmass = 1 kg\n"
                                         "[rocker]\nlength = 56 mm\nmass = 1 kg\n");
    fourlink_results *results;
    fourlink_mistake notes[2];
    unsigned long n = 0;

    assert_int_equal(fourlink_results_open(&source, 0, &results, NULL, NULL), FOURLINK_OK);
    assert_int_equal(fourlink_results_notes(NULL, 0, NULL, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_notes(results, 1, NULL, &n), FOURLINK_NULL);
    assert_int_equal(fourlink_results_notes(results, 0, NULL, &n), FOURLINK_OK);
    assert_int_equal(n, 2);
    notes[1].line = -1;
    assert_int_equal(fourlink_results_notes(results, 1, notes, NULL), FOURLINK_OK);
    assert_int_equal(notes[0].line, 8);
    assert_int_equal(notes[1].line, -1);
    assert_int_equal(fourlink_results_notes(results, 2, notes, &n), FOURLINK_OK);
    assert_int_equal(notes[1].line, 11);
    assert_string_equal(notes[1].file, "x.deck");
    fourlink_results_free(results);
}

/* A link has the section that has its name, which its kind has. */
TEST(test_sections_of_links)
{
    static const fourlink_kind kinds[] = {FOURLINK_FOUR_BAR, FOURLINK_SLIDER_CRANK,
                                          FOURLINK_INVERTED_SLIDER_CRANK};
    size_t k;
    int link;

    for (k = 0; k < sizeof kinds / sizeof kinds[0]; k++)
        for (link = FOURLINK_GROUND; link <= FOURLINK_FOLLOWER; link++) {
            section_code section = flk_section_of_link(kinds[k], link);

            assert_true(section < SECTION_COUNT);
            assert_true(flk_section_table[section].kinds & (int)kinds[k]);
        }
}

int main(void)
{
    return run_all_tests(NULL);
}
