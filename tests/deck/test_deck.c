/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_deck.c - decks read into SI values; their mistakes, each with its line; hostile decks.
*/
#include <stdlib.h>

#include "check.h"
#include "elements.h"
#include "read.h"
#include "deck/reader.h"

/* Nine lines each: what a test adds stands at line 10. */
#define FOUR_BAR             \
    "mechanism = four-bar\n" \
    "[ground]\n"             \
    "length = 80 mm\n"       \
    "[coupler]\n"            \
    "length = 66 mm\n"       \
    "[rocker]\n"             \
    "length = 56 mm\n"       \
    "[crank]\n"              \
    "length = 20 mm\n"

/* Five lines to the end of [ground]; the lever is open. */
#define YOKE "mechanism = scotch-yoke\n[crank]\nlength = 40 mm\n"
#define INVERTED                          \
    "mechanism = inverted-slider-crank\n" \
    "[crank]\n"                           \
    "length = 120 mm\n"                   \
    "[ground]\n"                          \
    "length = 240 mm\n"                   \
    "[lever]\n"

#define SLIDER_CRANK             \
    "mechanism = slider-crank\n" \
    "\n"                         \
    "[rod]\n"                    \
    "length = 1.2 m\n"           \
    "[piston]\n"                 \
    "mass = 50 kg\n"             \
    "\n"                         \
    "[crank]\n"                  \
    "length = 300 mm\n"

/* The files that the decks may name. */
static const char *const files[][2] = {
    {"card.txt", "# crank angle, pressure\n0 1\r\n\n 90.5\t32 # at the top\n180, 4e0\n270 ,2"},
    {"two words.txt", "0 5\n100 6\n"},
    {"empty.txt", "# nothing\n"},
    {"wrong.txt", "0 1\n90 2\nlate 3\n"},
    {"falling.txt", "0 1\n90 2\n45 3\n"},
};

static const char *load_file(void *host, const char *file_name, unsigned long *length)
{
    static char *copy; /* the last one: it has to last until the next call */
    size_t i;

    assert_ptr_equal(host, files);
    free(copy);
    copy = NULL;
    for (i = 0; i < COUNT(files); i++)
        if (strcmp(file_name, files[i][0]) == 0) {
            *length = strlen(files[i][1]);
            copy = malloc(*length); /* without a null character, as the loader promises none */
            assert_non_null(copy);
            return memcpy(copy, files[i][1], *length);
        }
    return NULL;
}

static int read_text(text contents, const fourlink_change *changes, size_t n, deck *d)
{
    fourlink_source source = deck_source("");

    source.text = contents.start;
    source.length = (unsigned long)contents.length;
    source.load = load_file;
    source.host = (void *)files;
    source.changes = changes;
    source.n_changes = (unsigned long)n;
    return flk_deck_read(&source, d);
}

static int read_changed(const char *contents, const fourlink_change *changes, size_t n, deck *d)
{
    int status = read_text(flk_text_of(contents), changes, n, d);
    size_t i;

    assert_int_equal(status, d->mistakes.count == 0);
    for (i = 0; i < d->mistakes.count && i < 8; i++)
        print_message("%s:%ld: %s\n", d->mistakes.list[i].place.source,
                      d->mistakes.list[i].place.line, d->mistakes.list[i].message);
    return status;
}

/* Read a deck that is in order. */
static void read_good(const char *contents, deck *d)
{
    if (read_changed(contents, NULL, 0, d) != 1)
        fail_msg("mistakes in\n%s", contents);
}

/* Read a deck that is in order with one change, which may be null. */
static void read_with(const char *contents, const char *assignment, deck *d)
{
    fourlink_change change = {"--set", NULL};

    change.assignment = assignment;
    print_message("%s\n", assignment);
    if (read_changed(contents, &change, 1, d) != 1)
        fail_msg("mistakes with %s", assignment);
}

/* ---------------------------------------------------------------------------------- the mistakes
 */

typedef struct mistaken {
    const char *contents;
    long line;
    const char *message;
} mistaken;

static const mistaken all_mistaken[] = {
    /* sections and keys */
    {FOUR_BAR "[grond]\nlength = 1\n", 10, "unknown section 'grond'; did you mean 'ground'?"},
    {FOUR_BAR "[xyzzy]\n", 10, "unknown section 'xyzzy'"},
    {FOUR_BAR "[]\n", 10, "unknown section ''"},
    {FOUR_BAR "[crank]\n", 10, "[crank] is given twice; first at line 8"},
    {FOUR_BAR "[motion\n", 10, "expected ']' at the end of the section's name"},
    {FOUR_BAR "[motion fast]\n", 10, "[motion] takes no name: remove 'fast'"},
    {FOUR_BAR "masss = 1 kg\n", 10, "unknown key 'masss' in [crank]; did you mean 'mass'?"},
    {FOUR_BAR "lenght = 1 m\n", 10, "unknown key 'lenght' in [crank]; did you mean 'length'?"},
    {FOUR_BAR "temperature = 1\n", 10, "unknown key 'temperature' in [crank]"},
    {"speed = 3 rpm\n" FOUR_BAR, 1,
     "unknown key 'speed' before the first section; it belongs in a section such as [motion]"},
    {"titel = x\n" FOUR_BAR, 1,
     "unknown key 'titel' before the first section; did you mean 'title'?"},
    {FOUR_BAR "LENGTH = 1 m\n", 10, "'LENGTH' is given twice; first at line 9"},
    {FOUR_BAR "mass\n", 10, "expected 'key = value' or '[section]', not 'mass'"},
    {FOUR_BAR "mass 1 kg # none\n", 10,
     "expected 'key = value' or '[section]', not 'mass 1 kg'; did you mean 'mass = 1 kg'?"},
    {FOUR_BAR "Mass:\t1 kg\n", 10,
     "expected 'key = value' or '[section]', not 'Mass: 1 kg'; did you mean 'Mass = 1 kg'?"},
    {FOUR_BAR "motion\n", 10,
     "expected 'key = value' or '[section]', not 'motion'; did you mean '[motion]'?"},
    {FOUR_BAR "Motion:\n", 10,
     "expected 'key = value' or '[section]', not 'Motion:'; did you mean '[Motion]'?"},
    {FOUR_BAR "load L\n", 10,
     "expected 'key = value' or '[section]', not 'load L'; did you mean '[load L]'?"},
    {FOUR_BAR "[expect]\nmu_min 30 deg\n", 11,
     "expected 'key = value' or '[section]', not 'mu_min 30 deg'; did you mean 'mu_min = 30 "
     "deg'?"},
    {FOUR_BAR "[expect]\ntype crank\n", 11,
     "expected 'key = value' or '[section]', not 'type crank'"},
    {FOUR_BAR "a crank of 20 mm\n", 10,
     "expected 'key = value' or '[section]', not 'a crank of 20 mm'"},
    {FOUR_BAR "mass = # none\n", 10, "expected a value after 'mass ='"},
    {FOUR_BAR "[rod]\nlength = 1 m\n", 10,
     "a four-bar linkage has no [rod]; its link 3 is the [coupler]"},
    {SLIDER_CRANK "[coupler]\nlength = 1 m\n", 10,
     "a slider-crank has no [coupler]; its link 3 is the [rod]"},
    {SLIDER_CRANK "[rocker]\n", 10, "a slider-crank has no [rocker]"},
    {FOUR_BAR "[piston]\nmass = 1 kg\n", 10, "a four-bar linkage has no [piston]"},
    {SLIDER_CRANK "[ground]\nlength = 1 m\n", 11, "the ground of a slider-crank has no length"},

    /* the inverted slider-crank */
    {INVERTED "offset = 1 mm\nangle = 30 deg\n", 7,
     "give the lever either an offset, or a length and an angle, not both"},
    {INVERTED "length = 1 m\noffset = 1 mm\n", 8,
     "give the lever either an offset, or a length and an angle, not both"},
    {INVERTED "length = 1 m\n", 7,
     "a lever with a length needs an angle, that of the slide from the line D-C"},
    {INVERTED "angle = 30 deg\n", 7,
     "a lever with an angle needs a length, from D to C on the slide"},
    {INVERTED "offset = -361 mm\n", 7,
     "the offset, -361 mm, is larger than ground and crank together, 360 mm: the linkage cannot be "
     "assembled"},
    {INVERTED "length = 800 mm\nangle = 30 deg\n", 8,
     "the slide passes D at 400 mm, farther than ground and crank together, 360 mm: the linkage "
     "cannot be assembled"},
    {INVERTED "[rocker]\nlength = 1 m\n", 7, "an inverted slider-crank has no [rocker]"},
    {INVERTED "[rod]\nlength = 1 m\n", 7,
     "an inverted slider-crank has no [rod]; its link 3 is the [slider]"},
    {INVERTED "[load]\nlink = piston\ntorque = 1 N m\n", 8,
     "an inverted slider-crank has no piston: its links are crank, slider and lever"},
    {INVERTED "[slider]\nlength = 1 m\n", 8,
     "unknown key 'length' in [slider]; it belongs in a section such as [ground]"},
    {FOUR_BAR "[slider]\nmass = 1 kg\n", 10,
     "a four-bar linkage has no [slider]; its link 3 is the [coupler]"},
    {SLIDER_CRANK "[lever]\nmass = 1 kg\n", 10, "a slider-crank has no [lever]"},
    {INVERTED "[ground]\n", 7, "[ground] is given twice; first at line 4"},
    {"series = all\n" INVERTED, 1, "an inverted slider-crank has no series"},

    /* the mechanism */
    {"[ground]\nlength = 1 m\n", 1,
     "expected 'mechanism = four-bar', 'mechanism = slider-crank', 'mechanism = "
     "inverted-slider-crank' or 'mechanism = scotch-yoke' before the first section"},
    {"", 1,
     "expected 'mechanism = four-bar', 'mechanism = slider-crank', 'mechanism = "
     "inverted-slider-crank' or 'mechanism = scotch-yoke' before the first section"},
    {"title = x\nmechanism = fourbars\n", 2,
     "expected four-bar, slider-crank, inverted-slider-crank or scotch-yoke, not 'fourbars'; did "
     "you mean "
     "'four-bar'?"},
    {"mechanism = scotch yokes\n", 1,
     "expected four-bar, slider-crank, inverted-slider-crank or scotch-yoke, not 'scotch yokes'; "
     "did you mean 'scotch-yoke'?"},
    {YOKE "[table]\nbranch = crossed\n", 5, "a Scotch yoke has one assembly mode: open"},
    {YOKE "[table]\nbranch = both\n", 5, "a Scotch yoke has one assembly mode: open"},
    {YOKE "[expect]\nbranch = crossed\nx = 1 mm\n", 5, "a Scotch yoke has one assembly mode: open"},
    {YOKE "[yoke]\nangle = 0\n", 5,
     "the slot's angle from the guide must be between 0 and 180 deg, not 0"},
    {YOKE "[yoke]\nangle = 180 deg\n", 5,
     "the slot's angle from the guide must be between 0 and 180 deg, not 180 deg"},
    {YOKE "[yoke]\nlength = 1 m\n", 5,
     "unknown key 'length' in [yoke]; it belongs in a section such as [ground]"},
    {YOKE "[lever]\nmass = 1 kg\n", 4, "a Scotch yoke has no [lever]"},
    {YOKE "[rod]\nlength = 1 m\n", 4, "a Scotch yoke has no [rod]; its link 3 is the [slider]"},
    {YOKE "[ground]\nlength = 1 m\n", 5, "the ground of a Scotch yoke has no length"},
    {YOKE "[friction]\nslot_length = 9 mm\nguide = 0.1\n", 5,
     "'slot_length' needs 'slot', the coefficient of friction"},
    {YOKE "[friction]\nC = 0.1\n", 5, "the friction of a Scotch yoke has no C"},
    {YOKE "[load]\nlink = rocker\ntorque = 1 N m\n", 5,
     "a Scotch yoke has no rocker: its links are crank, slider and yoke"},
    {YOKE "[load]\nlink = yoke\nover = theta4\ntorque = 0 deg 1 N m, 9 deg 2 N m\n", 6,
     "a Scotch yoke has no theta4"},
    {"mechanism = scotch-yoke\n[crank]\nstroke = 80 mm\n[yoke]\nangle = 60 deg\n", 3,
     "a stroke is for a slot at 90 deg; with this angle give the crank's length"},
    {"mechanism = scotch-yoke\n[crank]\nmass = 1 kg\n", 2, "[crank] has no length, and no stroke"},
    {"mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n[coupler]\n"
     "length = 66 mm\n[rocker]\nmass = 1 kg\n",
     8, "[rocker] has no length"},
    {"mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n[coupler]\n"
     "length = 66 mm\n",
     7, "there is no [rocker] with a length"},
    {"mechanism = slider-crank\n[crank]\nlength = 20 mm\n", 3, "there is no [rod] with a length"},
    {"mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = 20 mm\n[coupler]\n"
     "length = 300 mm\n[rocker]\nlength = 56 mm\n",
     7,
     "the coupler, 300 mm, is longer than the other three together, 156 mm: the linkage cannot be "
     "assembled"},
    {"mechanism = four-bar\n[ground]\nlength = 900\n[crank]\nlength = 20 mm\n[coupler]\n"
     "length = 100 mm\n[rocker]\nlength = 100 mm\n",
     3,
     "the ground, 900 m, is longer than the other three together, 0.22 m: the linkage cannot be "
     "assembled"},
    {"mechanism = four-bar\n[ground]\nlength = 900\n[crank]\nlength = 20\n[coupler]\n"
     "length = 100\n[rocker]\nlength = 100\n[units]\nlength = mm\n",
     3,
     "the ground, 900 mm, is longer than the other three together, 220 mm: the linkage cannot be "
     "assembled"},
    {SLIDER_CRANK "[ground]\noffset = -2\n", 11,
     "the offset, -2 m, is larger than crank and rod together, 1.5 m: the linkage cannot be "
     "assembled"},
    {SLIDER_CRANK "[ground]\noffset = -2 m\n", 11,
     "the offset, -2 m, is larger than crank and rod together, 1.5 m: the linkage cannot be "
     "assembled"},

    /* numbers and units */
    {FOUR_BAR "mass = heavy\n", 10, "expected a mass, such as 0.3 kg, not 'heavy'"},
    {FOUR_BAR "mass = kg 3\n", 10, "expected a mass, such as 0.3 kg, not 'kg 3'"},
    {FOUR_BAR "mass = 3 kgg\n", 10, "unknown unit 'kgg' in '3 kgg'; did you mean 'kg'?"},
    {FOUR_BAR "mass = 3 KG\n", 10, "unknown unit 'KG' in '3 KG'; did you mean 'kg'?"},
    {FOUR_BAR "mass = 3 furlong\n", 10, "unknown unit 'furlong' in '3 furlong'"},
    {FOUR_BAR "inertia = 3 kg m2 wobbly\n", 10, "unknown unit 'wobbly' in '3 kg m2 wobbly'"},
    {FOUR_BAR "mass = 3 mm\n", 10, "'3 mm' is a length; expected a mass, such as 0.3 kg"},
    {FOUR_BAR "mass = 3 N\n", 10, "'3 N' is a force; expected a mass, such as 0.3 kg"},
    {FOUR_BAR "mass = 3 kg2\n", 10, "'3 kg2' is not a mass, such as 0.3 kg"},
    {FOUR_BAR "mass = 1,5 kg\n", 10, "'1,5 kg': a comma as decimal mark: write 1.5"},
    {FOUR_BAR "mass = inf\n", 10, "'inf' is not a finite number"},
    {FOUR_BAR "mass = nan kg\n", 10, "'nan kg' is not a finite number"},
    {FOUR_BAR "mass = 1e999 kg\n", 10, "'1e999 kg' is not a finite number"},
    {FOUR_BAR "mass = 0x10 kg\n", 10, "'0x10 kg' is not a decimal number"},
    {FOUR_BAR "[table]\ndigits = 18\n", 11, "digits must be 1 to 17, not 18"},
    {FOUR_BAR "mass = 1e31 kg\n", 10, "'1e31 kg' is out of range"},
    {FOUR_BAR "mass = 1e300 t\n", 10, "'1e300 t' is out of range"},
    {FOUR_BAR "[motion]\nspeed = 25 Hz\n", 11, "'25 Hz' is not an angular speed, such as 1000 rpm"},
    {FOUR_BAR "[motion]\nspeed = 25 1/s\n", 11,
     "'25 1/s' is not an angular speed, such as 1000 rpm"},
    {FOUR_BAR "[motion]\nspeed = 3 N m/s\n", 11,
     "'3 N m/s' is a power; expected an angular speed, such as 1000 rpm"},
    {FOUR_BAR "[motion]\nspeed = 3 m/s\n", 11,
     "'3 m/s' is a speed; expected an angular speed, such as 1000 rpm"},
    {FOUR_BAR "[motion]\nspeed = 3 rad\n", 11,
     "'3 rad' is an angle; expected an angular speed, such as 1000 rpm"},
    {FOUR_BAR "[motion]\nacceleration = 3 rad/s\n", 11,
     "'3 rad/s' is an angular speed; expected an angular acceleration, such as 5 rad/s2"},
    {FOUR_BAR "[units]\nlength = mmm\n", 11, "unknown unit 'mmm' in 'mmm'; did you mean 'mm'?"},

    /* signs and sizes */
    {"mechanism = slider-crank\n[rod]\nlength = -1 m\n[crank]\nlength = 1 m\n", 3,
     "the length must be positive, not -1 m"},
    {"mechanism = slider-crank\n[rod]\nlength = 0\n[crank]\nlength = 1 m\n", 3,
     "the length must be positive, not 0"},
    {"mechanism = slider-crank\n[rod]\nlength = 1e-16 m\n[crank]\nlength = 1 m\n", 3,
     "'1e-16 m' is out of range"},
    {"mechanism = slider-crank\n[rod]\nlength = 1.01e15 m\n[crank]\nlength = 1 m\n", 3,
     "'1.01e15 m' is out of range"},
    {FOUR_BAR "mass = -1 g\n", 10, "the mass must not be negative: -1 g"},
    {FOUR_BAR "inertia = -1 kg m2\n", 10, "the inertia must not be negative: -1 kg m2"},
    {FOUR_BAR "mass = 1 kg\ngyration = -1 mm\n", 11, "the gyration must not be negative: -1 mm"},
    {FOUR_BAR "[motion]\ninterval = 0\n", 11, "the interval must be positive, not 0"},
    {FOUR_BAR "[motion]\ninterval = -5 deg\n", 11, "the interval must be positive, not -5 deg"},
    {FOUR_BAR "[motion]\ninterval = 1e-30 deg\n", 11,
     "more than 10,000,000 rows by angle: give a larger interval or a shorter range"},
    {FOUR_BAR "[motion]\ninterval = 1e-12 deg\n", 11,
     "more than 10,000,000 rows by angle (3.6e14): give a larger interval or a shorter range"},
    {FOUR_BAR "[motion]\nto = 10000000 deg\ninterval = 1 deg\n", 12,
     "more than 10,000,000 rows by angle (10000001): give a larger interval or a shorter range"},
    {FOUR_BAR "[motion]\ninterval = 1 deg\nto = 1e8 deg\n", 11,
     "more than 10,000,000 rows by angle (100000001): give a larger interval or a shorter range"},
    {FOUR_BAR "[motion]\nfrom = -4e8 deg\nto = -2e8 deg\n", 12,
     "more than 10,000,000 rows by angle (20000001): give a larger interval or a shorter range"},
    {FOUR_BAR "[motion]\nturns = -1e6\n", 11,
     "more than 10,000,000 rows by angle (36000001): give a larger interval or a shorter range"},
    {FOUR_BAR "[motion]\ncycle = 4e8 deg\n", 11,
     "more than 10,000,000 rows by angle (40000001): give a larger interval or a shorter range"},
    {FOUR_BAR "[motion]\nacceleration = 1 rad/s2\nrun_up = 4e8 deg\n", 12,
     "more than 10,000,000 rows by angle (40000037): give a larger interval or a shorter range"},
    {FOUR_BAR "[motion]\ncycle = 0 deg\n", 11, "the cycle must be positive, not 0 deg"},
    {FOUR_BAR "[gravity]\nacceleration = -9.81 m/s2\n", 11,
     "the acceleration must not be negative: -9.81 m/s2"},
    {FOUR_BAR "[table]\ndigits = 0\n", 11, "the digits must be positive, not 0"},
    {FOUR_BAR "[table]\ndigits = 18\n", 11, "digits must be 1 to 17, not 18"},
    {FOUR_BAR "[table]\ndigits = 4.5\n", 11, "expected a whole number, not '4.5'"},
    {FOUR_BAR "[table]\ndigits = 4 mm\n", 11, "expected a whole number, not '4 mm'"},

    /* links, loads, motion */
    {FOUR_BAR "gyration = 8 mm\n", 10, "the radius of gyration needs a mass"},
    {FOUR_BAR "mass = 1 kg\ngyration = 8 mm\ninertia = 1 kg m2\n", 11,
     "give only one of gyration, inertia and swing_period"},
    {FOUR_BAR "mass = 1 kg\ncg = (1 mm, 2 mm)\n", 11,
     "expected two components, such as (10, 5) mm, not '(1 mm, 2 mm)'"},
    {FOUR_BAR "mass = 1 kg\ncg = (1, 2 mm\n", 11,
     "expected two components, such as (10, 5) mm, not '(1, 2 mm'"},
    {FOUR_BAR "mass = 1 kg\ncg = 5 mm at 3 mm\n", 11,
     "'5 mm at 3 mm' is a length; expected an angle, such as 40 deg"},
    {FOUR_BAR "mass = 1 kg\ncg = 5 kg at 3 deg\n", 11,
     "'5 kg at 3 deg' is a mass; expected a length, such as 80 mm"},
    {FOUR_BAR "[load]\nlink = coupler\nforce = 50 N\n", 12,
     "expected a force with its direction, such as 50 N at 30 deg or (43, 25) N, not '50 N'"},
    {FOUR_BAR "[load]\nlink = coupler\nforce = (3, 4) mm\n", 12,
     "'(3, 4) mm' is a length; expected a force, such as 50 N"},
    {FOUR_BAR "[load]\ntorque = 1 N m\n", 10, "[load] has no link: crank, coupler or rocker"},
    {SLIDER_CRANK "[load]\ntorque = 1 N m\n", 10, "[load] has no link: crank, rod or piston"},
    {FOUR_BAR "[load]\nlink = rod\ntorque = 1 N m\n", 11,
     "a four-bar linkage has no rod: its links are crank, coupler and rocker"},
    {SLIDER_CRANK "[load]\nlink = rocker\ntorque = 1 N m\n", 11,
     "a slider-crank has no rocker: its links are crank, rod and piston"},
    {FOUR_BAR "[load]\nlink = rocker\n", 10, "[load] has neither a force nor a torque"},
    {FOUR_BAR "[load]\nlink = rocker\ntorque = 1 N m\nat = 3 mm\n", 13, "'at' needs a force"},
    {FOUR_BAR "[motion]\nspeed = 1 rad/s\nacceleration = 1 rad/s2\nto = -90 deg\n", 13,
     "the range runs against the rotation of an accelerated crank: swap 'from' and 'to', or set "
     "'hold = yes'"},
    {FOUR_BAR "[motion]\nrun_up = 90 deg\n", 11, "a run-up from rest needs an acceleration"},
    {FOUR_BAR "[motion]\nrun_up = 90 deg\nacceleration = 1 rad/s2\nspeed = 1 rpm\n", 13,
     "a run-up starts from rest: give an acceleration, not a speed"},
    {FOUR_BAR "[motion]\nrun_up = 90 deg\nacceleration = 1 rad/s2\nto = 1 rev\n", 13,
     "a run-up ends one revolution after its angle: 'to' is not allowed"},
    {FOUR_BAR "mass = 1 kg\nswing_period = 2 s\n", 11,
     "a swing_period needs a swing_pin: origin, end or a point of the link"},
    {FOUR_BAR "mass = 1e20 kg\nswing_pin = end\nswing_period = 1e10 s\n", 12,
     "the resulting moment of inertia is out of range"},
    {FOUR_BAR "mass = 1 kg\nswing_pin = end\n", 11, "a swing_pin needs a swing_period"},
    {FOUR_BAR "swing_pin = end\nswing_period = 2 s\n", 11, "the swing_period needs a mass"},
    {FOUR_BAR "mass = 1 kg\nswing_pin = end\nswing_period = 0.1 s\n", 12,
     "a swing_period of 0.1 s is too short: a point mass 0.02 m from the pin swings more slowly"},
    {FOUR_BAR "mass = 1 kg\ncg = 10 mm\nswing_pin = (10, 0) mm\nswing_period = 1 s\n", 12,
     "the swing_pin is at the centre of mass: the link does not swing there"},
    {FOUR_BAR "stroke = 1 m\n", 10, "the crank of a four-bar linkage has no stroke"},
    {"mechanism = slider-crank\n[rod]\nlength = 100 mm\n[crank]\nstroke = 250 mm\n", 5,
     "this stroke is impossible: the crank would be longer than the rod"},
    /* the longest is 2 sqrt(100 (100 - 50)) mm = 141.42 mm */
    {"mechanism = slider-crank\n[ground]\noffset = -50 mm\n[rod]\nlength = 100 mm\n[crank]\n"
     "stroke = 141.43 mm\n",
     7, "this stroke is impossible with this rod and offset"},
    {SLIDER_CRANK "stroke = 1 m\n", 10, "give either the length or the stroke, not both"},
    {FOUR_BAR "[gas]\nbore = 1 m\npressure = 1 bar\n", 10, "a four-bar linkage has no [gas]"},
    {SLIDER_CRANK "[gas]\npressure = 1 bar\n", 10, "[gas] has no bore"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\n", 10, "[gas] has neither a pressure nor an indicator"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = 0 1, 90 2\npressure = 1 bar\n", 13,
     "give either the pressure or the indicator, not both"},
    {SLIDER_CRANK "[gas]\nbore = 1 cm\npressure = 1 bar\npiston_rod = 11 mm\n", 13,
     "the piston_rod, 11 mm, is not thinner than the bore"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = 0 1 bar, 90 2 kg\n", 12,
     "'0 1 bar, 90 2 kg' is a mass; expected a pressure, such as 2 N/mm2"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = 0 mm 1 bar, 90 2\n", 12,
     "'0 mm 1 bar, 90 2' is a length; expected an angle, such as 40 deg"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = 0 1, 90 2, 80 3\n", 12,
     "the angles of a curve must increase"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = 0 1, 90 2, 90 3\n", 12,
     "the angles of a curve must increase"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = 0 1,\n", 12, "a curve needs at least two points"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = 0 1, 90 2, 400 3\n", 12,
     "the curve is longer than the cycle; give [motion] a cycle of 720 deg if it is one of four "
     "strokes"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = 0 1, 90 2, 360 3\n", 12,
     "the curve is not periodic: one cycle after its first point it has another value"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = file missing.txt\n", 12,
     "cannot read the file 'missing.txt'"},
    {SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = file empty.txt\n", 12,
     "a curve needs at least two points"},
    {"mechanism = four-bar\nseries = all\n[ground]\nlength = 80 mm\n[coupler]\nlength = 66 mm\n"
     "[rocker]\nlength = 56 mm\n[crank]\nlength = 20 mm\n",
     2, "a four-bar linkage has no series"},
    {"series = xyzzy\n" SLIDER_CRANK, 1, "expected none, piston or all, not 'xyzzy'"},
    {SLIDER_CRANK "[flywheel]\ninertia = 1 kg m2\nfluctuation = 0.02\n", 11,
     "give either the fluctuation or the inertia: the other follows"},
    {SLIDER_CRANK "[flywheel]\nfluctuation = 0\n", 11, "the fluctuation must be positive, not 0"},
    {FOUR_BAR "[motion]\nhold = perhaps\n", 11, "expected no or yes, not 'perhaps'"},
    {FOUR_BAR "[table]\nbranch = opened\n", 11,
     "expected open, crossed or both, not 'opened'; did you mean 'open'?"},
};

TEST(test_every_mistake)
{
    size_t i, failed = 0;

    for (i = 0; i < COUNT(all_mistaken); i++) {
        const mistaken *x = &all_mistaken[i];
        const struct mistake *first;
        deck d;

        read_changed(x->contents, NULL, 0, &d);
        first = d.mistakes.list;
        if (d.mistakes.count != 1 || strcmp(first->message, x->message) != 0 ||
            first->place.line != x->line || strcmp(first->place.source, "x.deck") != 0) {
            print_error("expected x.deck:%ld: %s\nand nothing else of\n%s\n", x->line, x->message,
                        x->contents);
            failed++;
        }
        flk_deck_free(&d);
    }
    assert_int_equal(failed, 0);
}

/* Decks that are wrong, whatever the message; the line that is to blame. */
static const struct {
    const char *contents;
    long line;
} blamed[] = {
    /* a blank between digits is a slip of the hand, not 2 times "1 mm" */
    {"mechanism = slider-crank\n[rod]\nlength = 2 1 mm\n[crank]\nlength = 1 mm\n", 3},
    {FOUR_BAR "mass = 3 kg 1\n", 10},
    {FOUR_BAR "mass = 3 kg^\n", 10},
    {FOUR_BAR "mass = 1 kg\ncg = 1 mm at\n", 11},
    {FOUR_BAR "mass = 3 kg/\n", 10},
    {FOUR_BAR "mass = 1 kg\ncg = 1e20 m\n", 11},
    {FOUR_BAR "mass = 1 kg\ncg = (0, 1e20) m\n", 11},
    {FOUR_BAR "mass = 1e20 kg\ngyration = 1e14 m\n", 11},
    {FOUR_BAR "[load]\nlink = rocker\nforce = 1 N at 0 deg\nat = 1e20 m\n", 13},
    {FOUR_BAR "[motion]\nat = 1e30 rad\n", 11},
    {FOUR_BAR "[motion]\nfrom = 1e30 rad\n", 11},
    {SLIDER_CRANK "[ground]\noffset = 1e16 m\n", 11},
    {FOUR_BAR "[load]\nlink = crank\ntorque = 0,5 N m\n", 12},
    /* the end of a crank that is given by its stroke is at half of it: 0.1 s is too short */
    {"mechanism = slider-crank\n[rod]\nlength = 1 m\n[crank]\nstroke = 600 mm\nmass = 1 kg\n"
     "swing_pin = end\nswing_period = 0.1 s\n",
     8},
};

TEST(test_blamed_line)
{
    size_t i, failed = 0;

    for (i = 0; i < COUNT(blamed); i++) {
        deck d;

        if (read_changed(blamed[i].contents, NULL, 0, &d) != 0 ||
            d.mistakes.list[0].place.line != blamed[i].line) {
            print_error("no mistake at line %ld of\n%s\n", blamed[i].line, blamed[i].contents);
            failed++;
        }
        flk_deck_free(&d);
    }
    assert_int_equal(failed, 0);
}

TEST(test_all_in_one_run)
{
    static const char contents[] = "title = many mistakes\n"
                                   "mechanism = four-bar\n"
                                   "[motion]\n"
                                   "interval = 0\n" /* 4 */
                                   "speed = 3 parsec\n"
                                   "[ground]\n"
                                   "[crank]\n"
                                   "length = -1 mm\n"
                                   "colour = red\n"
                                   "[rod]\n" /* 10 */
                                   "length = 1 m\n"
                                   "[coupler]\n"
                                   "mass = 1,5 kg\n"
                                   "length = 1 m\n"
                                   "length = 2 m\n"
                                   "[craank]\n"
                                   "whatever = 1\n"
                                   "[rocker]\n"
                                   "nonsense\n" /* 19 */
                                   "length = 1 N\n";
    static const long lines[] = {4, 5, 6, 8, 9, 10, 13, 15, 16, 19, 20};
    static const char *const words[] = {"interval", "parsec", "[ground]", "positive",
                                        "colour",   "[rod]",  "comma",    "twice",
                                        "craank",   "key",    "force"};
    deck d;
    size_t i;

    assert_int_equal(read_changed(contents, NULL, 0, &d), 0);
    assert_int_equal(d.mistakes.count, COUNT(lines));
    for (i = 0; i < d.mistakes.count; i++) {
        assert_int_equal(d.mistakes.list[i].place.line, lines[i]);
        assert_non_null(strstr(d.mistakes.list[i].message, words[i]));
    }
    flk_deck_free(&d);
}

/* ------------------------------------------------------------------------------- decks in order */

static void check_link(const fourlink_link *link, double length, double mass, double inertia,
                       double x, double y)
{
    assert_true(link->length == length);
    assert_true(link->mass == mass);
    assert_close(link->inertia, inertia, 1e-15);
    assert_close(link->cg.x, x, 1e-15);
    assert_close(link->cg.y, y, 1e-15);
}

TEST(test_four_bar)
{
    static const char contents[] = "title = Every key\n"
                                   "mechanism = four-bar\n"
                                   "[ground]\nlength = 80 mm\nangle = 90 deg\n"
                                   "[crank]\nlength = 2 cm\nmass = 100 g\ngyration = 8 mm\n"
                                   "cg = 10 mm\n"
                                   "[coupler]\nlength = 0.066\nmass = 0.3\ninertia = 2 kg.mm2\n"
                                   "cg = 30 mm at 10 deg\n"
                                   "[rocker]\nlength = 56 mm\nmass = 1 lb\ngyration = 1 in\n"
                                   "cg = (28, -5) mm\n"
                                   "[motion]\nspeed = 1000 rpm\nacceleration = -30 deg/s2\n"
                                   "from = 20\nto = 0.5 rev\ninterval = 2.5 deg\n"
                                   "[gravity]\nacceleration = 9.8 m/s2\n"
                                   "[load F1]\nlink = coupler\nforce = 50 N at 30 deg\n"
                                   "at = 20 mm at 90 deg\n"
                                   "[load]\nlink = rocker\ntorque = 2 lbf.in\n"
                                   "force = (3, -4) kN\nat = 0 mm\n"
                                   "[table]\nbranch = crossed\ncolumns = theta2, mu\n"
                                   "digits = 9\n";
    deck d;

    read_good(contents, &d);
    assert_string_equal(d.title, "Every key");
    assert_int_equal(d.machine.mechanism.design.kind, FOURLINK_FOUR_BAR);
    assert_true(d.machine.mechanism.design.link[1].length == 0.08);
    check_link(&d.machine.mechanism.design.link[2], 0.02, 0.1, 0.1 * 0.008 * 0.008, 0.01, 0);
    check_link(&d.machine.mechanism.design.link[3], 0.066, 0.3, 2e-6, 0.03 * cos(10 * DEG),
               0.03 * sin(10 * DEG));
    check_link(&d.machine.mechanism.design.link[4], 0.056, 0.45359237, 0.45359237 * 0.0254 * 0.0254,
               0.028, -0.005);
    assert_true(d.machine.mechanism.design.gravity.x == -9.8); /* the line A-D points upwards */
    assert_true(d.machine.mechanism.design.gravity.y == 0);
    assert_close(d.motion.speed, 104.71975511965977, 1e-15);
    assert_close(d.motion.acceleration, -0.52359877559829887, 1e-15);
    assert_true(d.motion.from == 20 && d.motion.interval == 2.5);
    assert_close(d.motion.to, 180.0, 1e-15);
    assert_close(d.motion.angle_unit, DEG, 1e-15);
    assert_true(d.motion.run_up == 0 && d.motion.hold == 0);
    assert_int_equal(d.one_instant, 0);
    assert_int_equal(d.one_revolution, 0);
    assert_int_equal(given_loads(&d), 2);
    assert_int_equal(given_load(&d, 0)->load.link, 3);
    assert_int_equal(given_load(&d, 0)->load.frame, FOURLINK_FRAME_GROUND);
    assert_close(given_load(&d, 0)->values.force.x, 50 * cos(30 * DEG), 1e-15);
    assert_close(given_load(&d, 0)->values.force.y, 25.0, 1e-15);
    assert_true(given_load(&d, 0)->load.at.x == 0 && given_load(&d, 0)->load.at.y == 0.02 &&
                given_load(&d, 0)->values.torque == 0);
    assert_int_equal(given_load(&d, 1)->load.link, 4);
    assert_true(given_load(&d, 1)->values.force.x == 3000 &&
                given_load(&d, 1)->values.force.y == -4000);
    assert_close(given_load(&d, 1)->values.torque, 0.2259696580552334, 1e-15);
    assert_int_equal(d.has_forces, 1);
    assert_int_equal(d.open, 0);
    assert_int_equal(d.crossed, 1);
    assert_int_equal(d.digits, 9);
    assert_int_equal(d.columns.names.length, strlen("theta2, mu"));
    assert_memory_equal(d.columns.names.start, "theta2, mu", strlen("theta2, mu"));
    assert_true(d.machine.mechanism.design.link[4].length == 0.056);
    flk_deck_free(&d);
}

TEST(test_slider_crank)
{
    deck d;

    read_good(SLIDER_CRANK "mass = 4 kg\ninertia = 1.5 kg m2\ncg = (-0.1, 0)\n"
                           "[ground]\noffset = -50 mm\n[load]\nlink = piston\n"
                           "force = 1 kN at 180 deg\n[load]\nlink = rod\ntorque = -3 N m\n"
                           "[motion]\nat = 1 rad\nhold = yes\nacceleration = 7 rad/s2\n",
              &d);
    assert_int_equal(d.machine.mechanism.design.kind, FOURLINK_SLIDER_CRANK);
    check_link(&d.machine.mechanism.design.link[2], 0.3, 4, 1.5, -0.1, 0);
    check_link(&d.machine.mechanism.design.link[3], 1.2, 0, 0, 0, 0);
    assert_true(d.machine.mechanism.design.link[4].mass == 50);
    assert_true(d.machine.mechanism.design.offset == -0.05);
    assert_int_equal(given_loads(&d), 2);
    assert_int_equal(given_load(&d, 0)->load.link, 4);
    assert_true(given_load(&d, 0)->values.force.x == -1000 &&
                given_load(&d, 0)->values.force.y == 0);
    assert_int_equal(given_load(&d, 1)->load.link, 3);
    assert_true(given_load(&d, 1)->values.torque == -3);
    assert_int_equal(d.one_instant, 1);
    assert_int_equal(d.motion.hold, 1);
    assert_true(d.motion.acceleration == 7);
    assert_close(d.motion.from * d.motion.angle_unit, 1.0, 1e-15);
    assert_true(d.motion.to == d.motion.from);
    flk_deck_free(&d);
}

#define ENGINE                                                                     \
    "mechanism = slider-crank\nseries = piston\n[crank]\nstroke = 600 mm\n"        \
    "[rod]\nlength = 1.2 m\nmass = 50 kg\ncg = 500 mm\nswing_period = 2 s\n"       \
    "swing_pin = origin\n[piston]\nmass = 30 kg\n[units]\npressure = bar\n"        \
    "[gas]\nbore = 200 mm\nindicator = 0 deg 1 bar, 0.25 rev 32, # top\n"          \
    "  180 400 kPa, 270 -.5\nback_pressure = 1 bar\npiston_rod = 4 cm\n"           \
    "[load T]\nlink = crank\ntorque = 0 0 N m, 90 10 N m, 180 deg -3 N m, 360 0\n" \
    "[flywheel]\nfluctuation = 0.02\n"

static void check_curve(const curve *c, const double points[][2], size_t n)
{
    size_t i;
    int turns;

    assert_true(c->n > 0);
    for (i = 0; i < n; i++)
        for (turns = -2; turns <= 2; turns++)
            assert_near(flk_curve_piece(c, (points[i][0] + 360 * turns) * DEG,
                                        (points[i][0] + 360 * turns) * DEG),
                        points[i][1], 1e-9 * (1 + fabs(points[i][1])));
}

TEST(test_engine)
{
    static const double card[][2] = {{0, 1e5}, {90, 32e5}, {180, 4e5}, {270, -0.5e5}};
    static const double torque[][2] = {{0, 0}, {90, 10}, {180, -3}};
    static const double card_file[][2] = {{0, 1e5}, {90.5, 32e5}, {180, 4e5}, {270, 2e5}};
    double turns = 2 / (2 * PI), L = 9.81 * turns * turns;
    deck d;
    int i;

    read_good(ENGINE, &d);
    assert_int_equal(d.approximation, FOURLINK_SERIES_PISTON);
    assert_true(d.machine.mechanism.design.link[2].length == 0.3);
    assert_close(d.machine.mechanism.design.link[3].inertia, 50 * 0.5 * (L - 0.5), 1e-14);
    assert_close(gas_of(&d)->area, 0.031415926535897932, 1e-15);
    assert_close(gas_of(&d)->back_area, 0.031415926535897932 * (1 - 0.04), 1e-15);
    assert_true(gas_of(&d)->back_pressure == 1e5);
    check_curve(&gas_of(&d)->indicator, card, 4);
    for (i = -720; i < 720; i++) { /* between the points it stays between their values */
        double p = flk_curve_piece(&gas_of(&d)->indicator, i * DEG, i * DEG);

        assert_true(p >= -0.5e5 - 1e-6 && p <= 32e5 + 1e-6);
    }
    check_curve(&given_load(&d, 0)->values.torque_curve, torque, 3);
    assert_true(d.flywheel_fluctuation == 0.02 && d.machine.flywheel == 0);
    assert_int_equal(d.has_forces, 1);
    flk_deck_free(&d);

    read_with(ENGINE, "gas.indicator=file card.txt", &d);
    check_curve(&gas_of(&d)->indicator, card_file, 4);
    flk_deck_free(&d);
    read_with(ENGINE, "gas.indicator=file \"two words.txt\"", &d);
    assert_near(flk_curve_piece(&gas_of(&d)->indicator, 100 * DEG, 100 * DEG), 6e5, 1e-3);
    flk_deck_free(&d);
    read_with(ENGINE, "load T.torque=-7 N m", &d);
    assert_true(given_load(&d, 0)->values.torque == -7);
    assert_int_equal(given_load(&d, 0)->values.torque_curve.n, 0);
    flk_deck_free(&d);
    read_with(FOUR_BAR "[friction]\nA = 0.1\nradius_A = 1 mm\n", "friction.direction=backward", &d);
    assert_int_equal(d.machine.friction.direction, -1);
    flk_deck_free(&d);
    read_with(FOUR_BAR "[friction]\nA = 0.1\nradius_A = 1 mm\n", "friction.direction=forward", &d);
    assert_int_equal(d.machine.friction.direction, 1);
    /* a crank at rest is about to turn the way of its motion, which decides whether a load begins there */
    flk_deck_free(&d);
    read_good(FOUR_BAR "[motion]\nrun_up = 90 deg\nacceleration = -5 rad/s2\n", &d);
    assert_int_equal(d.machine.friction.direction, -1);
    flk_deck_free(&d);
    read_good(
        FOUR_BAR
        "[motion]\nat = 90 deg\nacceleration = -5 rad/s2\n[friction]\nA = 0.1\nradius_A = 1 mm\n",
        &d);
    assert_int_equal(d.machine.friction.direction, -1);
    flk_deck_free(&d);
    read_with(
        FOUR_BAR
        "[motion]\nat = 90 deg\nacceleration = -5 rad/s2\n[friction]\nA = 0.1\nradius_A = 1 mm\n",
        "friction.direction=forward", &d);
    assert_int_equal(d.machine.friction.direction, 1);
    flk_deck_free(&d);
    read_with(ENGINE, "rod.swing_pin=end", &d);
    assert_close(d.machine.mechanism.design.link[3].inertia, 50 * 0.7 * (L - 0.7), 1e-14);
    flk_deck_free(&d);
    read_with(ENGINE, "rod.swing_pin=(500, -300) mm", &d);
    assert_close(d.machine.mechanism.design.link[3].inertia, 50 * 0.3 * (L - 0.3), 1e-14);
    flk_deck_free(&d);
    read_with(ENGINE, "gravity.acceleration=0", &d); /* not where the rod was swung */
    assert_close(d.machine.mechanism.design.link[3].inertia, 50 * 0.5 * (L - 0.5), 1e-14);
    flk_deck_free(&d);
    read_with("mechanism = slider-crank\n[ground]\noffset = 300 mm\n[crank]\nstroke = 600 mm\n"
              "[rod]\nlength = 1.2 m\n[flywheel]\ninertia = 3 kg m2\n",
              "title=offset", &d);
    assert_true(d.machine.flywheel == 3);
    { /* the dead centres are the stroke apart */
        double r = d.machine.mechanism.design.link[2].length, e = 0.3;

        assert_close(sqrt((1.2 + r) * (1.2 + r) - e * e) - sqrt((1.2 - r) * (1.2 - r) - e * e), 0.6,
                     1e-14);
    }
    flk_deck_free(&d);
    read_with("mechanism = slider-crank\n[ground]\noffset = 50 mm\n[crank]\nstroke = 141.42 mm\n"
              "[rod]\nlength = 100 mm\n",
              "title=longest", &d);
    assert_true(d.machine.mechanism.design.link[2].length < 0.05 &&
                d.machine.mechanism.design.link[2].length > 0.0495);
    flk_deck_free(&d);
}

/* All mistakes of a deck in one run, wherever they stand; and none that only follows from another. */
TEST(test_all_mistakes)
{
    static const long lines[] = {3, 6, 10, 11, 14, 15};
    const char *contents = "mechanism = slider-crank\n[ground]\noffset = 300 mm\n" /* 3 */
                           "[crank]\nlength = 50 mm\nspeeed = 1\n"                 /* 6 */
                           "[rod]\nlength = 200 mm\n[gas]\nbore = -1 cm\n"         /* 10 */
                           "indicator = 0 1, 90 2, 80 3\n"                         /* 11 */
                           "[motion]\nrun_up = 90 deg\nspeed = 1 kg\n"             /* 14 */
                           "interval = 0\n";                                       /* 15 */
    size_t i;
    deck d;

    assert_int_equal(read_deck(contents, &d), 0);
    flk_mistakes_sort(&d.mistakes);
    assert_int_equal(d.mistakes.count, COUNT(lines));
    for (i = 0; i < d.mistakes.count; i++)
        assert_int_equal(d.mistakes.list[i].place.line, lines[i]);
    flk_deck_free(&d);
}

TEST(test_mistakes_of_files)
{
    static const struct {
        const char *name;
        long line;
        const char *message;
    } cases[] = {{"wrong.txt", 3, "expected an angle, such as 40 deg, not 'late 3'"},
                 {"falling.txt", 3, "the angles of a curve must increase"}};
    char contents[500];
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        deck d;

        sprintf(contents, SLIDER_CRANK "[gas]\nbore = 1 m\nindicator = file %s\n", cases[i].name);
        assert_int_equal(read_changed(contents, NULL, 0, &d), 0);
        assert_int_equal(d.mistakes.count, 1);
        assert_string_equal(d.mistakes.list[0].place.source, cases[i].name);
        assert_int_equal(d.mistakes.list[0].place.line, cases[i].line);
        assert_string_equal(d.mistakes.list[0].message, cases[i].message);
        flk_deck_free(&d);
    }
}

/* Curves that the interpolation could not take: it must not be asked.  In order, or a mistake. */
TEST(test_odd_curves)
{
    static const char *const curves[] = {
        "gas.indicator=0 deg 1 bar, 360 deg 1 bar",
        "gas.indicator=10 1, 370 1",
        "gas.indicator=0 1, 1e-300 2",
        "gas.indicator=0 1, 1e-200 2, 180 3",
        "gas.indicator=0 1, 1e-18 2e9, 180 3",
        "gas.indicator=1e16 rad 1 bar, 1.0000000000000006e16 rad 2 bar",
        "gas.indicator=1e29 rad 1 bar, 1.0000000000000001e29 rad 2 bar",
        "gas.indicator=0 1, 359.99999999999994 2",
        "gas.indicator=0 1e24, 1e-9 -1e24",
        "load T.torque=0 1, 359.99999999 2, 360 1",
        "motion.cycle=1e-12 rad",
    };
    fourlink_change change = {"--set", NULL};
    size_t i;

    for (i = 0; i < COUNT(curves); i++) {
        deck d;
        int k;

        print_message("%s\n", curves[i]);
        change.assignment = curves[i];
        if (read_changed(ENGINE, &change, 1, &d))
            for (k = -100; k < 100; k++) {
                assert_true(fabs(flk_curve_piece(&gas_of(&d)->indicator, k * 0.1, k * 0.1)) <=
                            FOURLINK_NUMBER_MAX);
                assert_true(fabs(flk_curve_piece(&given_load(&d, 0)->values.torque_curve, k * 0.1,
                                                 k * 0.1)) <= FOURLINK_NUMBER_MAX);
            }
        flk_deck_free(&d);
    }
}

TEST(test_defaults)
{
    deck d;

    read_good(FOUR_BAR, &d);
    assert_string_equal(d.title, "");
    assert_true(d.machine.mechanism.design.gravity.x == 0 &&
                d.machine.mechanism.design.gravity.y == -9.81);
    assert_true(d.motion.from == 0 && d.motion.to == 360 && d.motion.interval == 10);
    assert_true(d.motion.speed == 0 && d.motion.acceleration == 0);
    assert_true(d.one_revolution == 1 && d.one_instant == 0);
    assert_true(d.open == 1 && d.crossed == 1);
    assert_int_equal(d.digits, 6);
    assert_int_equal(d.has_forces, 0);
    assert_int_equal(given_loads(&d), 0);
    assert_null(d.columns.names.start);
    flk_deck_free(&d);

    read_good(FOUR_BAR "[motion]\nspeed = -5 rad/s\n", &d);
    assert_true(d.motion.to == -360); /* one cycle, in the direction of rotation */
    flk_deck_free(&d);
    read_good(FOUR_BAR "[motion]\nspeed = 5 rad/s\ncycle = 720 deg\nfrom = 30 deg\n", &d);
    assert_true(d.motion.from == 30 && d.motion.to == 750);
    assert_int_equal(d.one_revolution, 0);
    flk_deck_free(&d);
    /* the shortest cycle is one interval */
    read_good(FOUR_BAR "[motion]\nspeed = 5 rad/s\ncycle = 10 deg\ninterval = 10 deg\n", &d);
    assert_close(d.machine.cycle, 10 * DEG, 1e-15);
    flk_deck_free(&d);
    read_good(FOUR_BAR "[motion]\nacceleration = -5 rad/s2\n", &d);
    assert_true(d.motion.to == -360);
    flk_deck_free(&d);
    flk_deck_free(&d);
    read_good(FOUR_BAR "[motion]\nrun_up = 90 deg\nacceleration = 5 rad/s2\n", &d);
    assert_true(d.motion.run_up == 90);
    assert_int_equal(d.one_revolution, 1);
    flk_deck_free(&d);
    read_good(FOUR_BAR "mass = 1 g\n", &d);
    assert_int_equal(d.has_forces, 1);
    flk_deck_free(&d);
}

/* The smallest and the largest length are in range. */
TEST(test_range_of_lengths)
{
    deck d;

    read_good("mechanism = slider-crank\n[rod]\nlength = 1e15 m\n[crank]\nlength = 1e-15 m\n", &d);
    assert_true(d.machine.mechanism.design.link[3].length == FOURLINK_LENGTH_MAX);
    assert_true(d.machine.mechanism.design.link[2].length == FOURLINK_LENGTH_MIN);
    flk_deck_free(&d);
}

/* Bare numbers take the units of [units], wherever in the deck that stands. */
TEST(test_units)
{
    deck d;

    read_good("mechanism = four-bar\n[ground]\nlength = 80\n[crank]\nlength = 2 cm\nmass = 3\n"
              "inertia = 4\ncg = (1, 2)\n[coupler]\nlength = 66\nmass = 1\ngyration = 5\n[rocker]\n"
              "length = 56\n[motion]\nspeed = 30\nacceleration = 2\nfrom = 1\nto = 3\n"
              "interval = 0.25\n"
              "[load]\nlink = crank\nforce = 2 at 1\ntorque = 7\nat = 4 at 90 deg\n"
              "[gravity]\nacceleration = 386\ndirection = 0\n"
              "[units]\nlength = mm\nmass = g\nangle = rad\nangular_speed = rpm\n"
              "angular_acceleration = deg/s2\ninertia = g cm2\nforce = kN\ntorque = N mm\n"
              "acceleration = in/s2\npressure = bar\ntime = ms\nspeed = km/h\npower = hp\n"
              "energy = kJ\n",
              &d);
    assert_true(d.machine.mechanism.design.link[1].length == 0.08);
    check_link(&d.machine.mechanism.design.link[2], 0.02, 0.003, 4e-7, 0.001, 0.002);
    check_link(&d.machine.mechanism.design.link[3], 0.066, 0.001, 0.001 * 0.005 * 0.005, 0, 0);
    assert_close(d.motion.speed, 3.1415926535897932, 1e-15);
    assert_close(d.motion.acceleration, 2 * DEG, 1e-15);
    assert_true(d.motion.angle_unit == 1);
    assert_true(d.motion.from == 1 && d.motion.to == 3 && d.motion.interval == 0.25);
    assert_close(given_load(&d, 0)->values.force.x, 2000 * cos(1), 1e-15);
    assert_close(given_load(&d, 0)->values.force.y, 2000 * sin(1), 1e-15);
    assert_true(given_load(&d, 0)->values.torque == 0.007);
    assert_true(given_load(&d, 0)->load.at.x == 0 && given_load(&d, 0)->load.at.y == 0.004);
    assert_close(d.machine.mechanism.design.gravity.x, 386 * 0.0254, 1e-15);
    assert_true(d.machine.mechanism.design.gravity.y == 0);
    assert_string_equal(d.units[QUANTITY_LENGTH].name, "mm");
    assert_string_equal(d.units[QUANTITY_INERTIA].name, "g.cm2");
    assert_string_equal(d.units[QUANTITY_POWER].name, "hp");
    assert_close(flk_unit_to_si(1, d.units[QUANTITY_SPEED].unit), 1 / 3.6, 1e-15);
    assert_close(flk_unit_to_si(1, d.units[QUANTITY_PRESSURE].unit), 1e5, 1e-15);
    assert_close(flk_unit_to_si(1, d.units[QUANTITY_ENERGY].unit), 1e3, 1e-15);
    assert_close(flk_unit_to_si(1, d.units[QUANTITY_TIME].unit), 1e-3, 1e-15);
    flk_deck_free(&d);

    read_good(FOUR_BAR "[units]\nangle = rad\n", &d); /* 10 deg and a revolution, in radians */
    assert_close(d.motion.interval, 10 * DEG, 1e-9);
    assert_close(d.motion.to, 360 * DEG, 1e-9);
    assert_int_equal(d.one_revolution, 1);
    flk_deck_free(&d);
}

/* Units are named without blanks, those between two words being points. */
TEST(test_names_of_units)
{
    static const struct {
        const char *written, *name;
    } names[] = {{"kg m2", "kg.m2"},  {"kg  m2", "kg.m2"},  {"kg* m2", "kg*m2"},
                 {"kg *m2", "kg*m2"}, {"kg * m2", "kg*m2"}, {"kg.m2", "kg.m2"},
                 {"N m s2", "N.m.s2"}};
    char contents[600];
    size_t i;
    deck d;

    for (i = 0; i < COUNT(names); i++) {
        sprintf(contents, FOUR_BAR "[units]\ninertia = %s\n", names[i].written);
        read_good(contents, &d);
        assert_string_equal(d.units[QUANTITY_INERTIA].name, names[i].name);
        flk_deck_free(&d);
    }
}

static void check_title(const char *contents, const char *title)
{
    deck d;

    print_message("----\n%s\n", contents);
    read_good(contents, &d);
    assert_string_equal(d.title, title);
    assert_true(d.machine.mechanism.design.link[2].length == 0.02);
    flk_deck_free(&d);
}

TEST(test_layout)
{
    check_title("# comment\n; comment\n\ntitle = A title # comment\n" FOUR_BAR, "A title");
    check_title("title = A ; comment\n" FOUR_BAR, "A");
    check_title("title = A#1;2\n" FOUR_BAR, "A#1;2");
    check_title("title = \"Motor # 3 ; new\" # comment\n" FOUR_BAR, "Motor # 3 ; new");
    check_title("title = \"  blanks  \"\n" FOUR_BAR, "  blanks  ");
    check_title("title = a = b\n" FOUR_BAR, "a = b");
    check_title("title = K\303\266nig \342\202\254\n" FOUR_BAR, "K\303\266nig \342\202\254");
    check_title("title=tight\n" FOUR_BAR, "tight");
    check_title("\357\273\277title = mark\n" FOUR_BAR, "mark");
    check_title("\357\273\277" FOUR_BAR, "");
    check_title("TITLE = upper\nMECHANISM = Four-Bar\n[GROUND] # 1\nLENGTH = 80 mm\n"
                "\t[ Crank ]\n\t\tLength\t=\t20\tmm\t; 2\n[cOUPLER]\nlength = 66mm\n[ROCKER]\n"
                "   length=56 mm",
                "upper");
    check_title("title = windows\r\nmechanism = four-bar\r\n\r\n[ground]\r\nlength = 80 mm\r\n"
                "[crank] # 2\r\nlength = 20 mm # x\r\n[coupler]\r\nlength = 66 mm\r\n[rocker]\r\n"
                "length = 56 mm\r\n",
                "windows");
    check_title("title = ends in a comma,\n" FOUR_BAR, "ends in a comma,");
}

/* A line that ends in a comma goes on in the next. */
TEST(test_joined_lines)
{
    deck d;
    size_t i, n = 0;
    char names[200];

    read_good(FOUR_BAR "[table]\ncolumns = theta2,   # the crank\n# a comment between\n\n"
                       "  theta3,\r\n\tmu\ndigits = 3\n",
              &d);
    for (i = 0; i < d.columns.names.length; i++)
        if (d.columns.names.start[i] != ' ')
            names[n++] = d.columns.names.start[i];
    names[n] = '\0';
    assert_string_equal(names, "theta2,theta3,mu");
    assert_int_equal(d.columns.place.line, 11);
    assert_int_equal(d.digits, 3);
    flk_deck_free(&d);
}

TEST(test_long_title)
{
    static char contents[2000];
    deck d;
    size_t i;

    strcpy(contents, "title = ");
    for (i = 0; i < 300; i++)
        strcat(contents, "\303\266");
    strcat(contents, "\n" FOUR_BAR);
    read_good(contents, &d);
    assert_in_range(strlen(d.title), sizeof d.title - 5, sizeof d.title - 1);
    assert_string_equal(d.title + strlen(d.title) - 5, "\303\266...");
    flk_deck_free(&d);
}

static void check_vector(const char *assignment, double x, double y, double tolerance)
{
    deck d;
    fourlink_vector v;

    read_with(FOUR_BAR "[load]\nlink = crank\nforce = 1 N at 0 deg\nat = 0 mm\n", assignment, &d);
    v = strncmp(assignment, "load.force", 10) == 0 ? given_load(&d, 0)->values.force
                                                   : d.machine.mechanism.design.link[2].cg;
    assert_near(v.x, x, tolerance);
    assert_near(v.y, y, tolerance);
    flk_deck_free(&d);
}

TEST(test_vectors)
{
    static const struct {
        const char *angle;
        double x, y;
    } quarters[] = {
        {"0", 1, 0},        {"90 deg", 0, 1},    {"180 deg", -1, 0},  {"270 deg", 0, -1},
        {"-90 deg", 0, -1}, {"-180 deg", -1, 0}, {"-270", 0, 1},      {"360 deg", 1, 0},
        {"450", 0, 1},      {"0.25 rev", 0, 1},  {"-0.5 rev", -1, 0}, {"-450 deg", 0, -1},
        {"1 rev", 1, 0},    {"-360 deg", 1, 0},
    };
    char assignment[100];
    size_t i;

    for (i = 0; i < COUNT(quarters); i++) {
        sprintf(assignment, "crank.cg=10 mm at %s", quarters[i].angle);
        check_vector(assignment, 0.01 * quarters[i].x, 0.01 * quarters[i].y, 0);
        sprintf(assignment, "load.force=-3 N at %s", quarters[i].angle);
        check_vector(assignment, -3 * quarters[i].x, -3 * quarters[i].y, 0);
    }
    check_vector("crank.cg=10 mm", 0.01, 0, 0);
    check_vector("crank.cg=-10 mm", -0.01, 0, 0);
    check_vector("crank.cg=(1, -2) cm", 0.01, -0.02, 0);
    check_vector("crank.cg=(1,-2) cm", 0.01, -0.02, 0);
    check_vector("crank.cg=( 1.5 , 2e-3 )", 1.5, 0.002, 0);
    check_vector("crank.cg=(1 ,2)in", 0.0254, 0.0508, 0);
    check_vector("crank.cg=1 in at 30 deg", 0.0254 * sqrt(3) / 2, 0.0127, 1e-17);
    check_vector("crank.cg=2 m at -45 deg", sqrt(2), -sqrt(2), 4e-16);
    check_vector("load.force=(3, 4) N", 3, 4, 0);
    check_vector("load.force=2 N at 60 deg", 1, sqrt(3), 4e-16);
    check_vector("load.force=2 N at 1 rad", 2 * cos(1), 2 * sin(1), 4e-16);
    check_vector("load.force=2 N  at  150", -sqrt(3), 1, 8e-16);
    check_vector("load.force=2 N\tat\t90 deg", 0, 2, 0);
}

TEST(test_gravity)
{
    deck d;

    read_good(FOUR_BAR "[gravity]\nacceleration = 0\n", &d);
    assert_true(d.machine.mechanism.design.gravity.x == 0 &&
                d.machine.mechanism.design.gravity.y == 0);
    flk_deck_free(&d);
    read_good(FOUR_BAR "[gravity]\ndirection = 30 deg\nacceleration = 10 m/s2\n", &d);
    assert_near(d.machine.mechanism.design.gravity.x, 10 * cos(30 * DEG), 1e-14);
    assert_near(d.machine.mechanism.design.gravity.y, 5, 1e-14);
    flk_deck_free(&d);

    /* The inclination of the line A-D turns gravity against itself, and nothing else. */
    read_with(FOUR_BAR "[load]\nlink = crank\nforce = 2 N at 90 deg\nat = 0 mm\n",
              "ground.angle=30 deg", &d);
    assert_near(d.machine.mechanism.design.gravity.x, -9.81 / 2, 1e-14);
    assert_near(d.machine.mechanism.design.gravity.y, -9.81 * sqrt(3) / 2, 1e-14);
    assert_true(given_load(&d, 0)->values.force.x == 0 && given_load(&d, 0)->values.force.y == 2);
    assert_true(d.motion.from == 0 && d.motion.to == 360);
    flk_deck_free(&d);
    read_with(SLIDER_CRANK, "ground.angle=90 deg", &d); /* a vertical engine, piston on top */
    assert_true(d.machine.mechanism.design.gravity.x == -9.81 &&
                d.machine.mechanism.design.gravity.y == 0);
    flk_deck_free(&d);
    read_with(SLIDER_CRANK, "ground.angle=-90 deg", &d);
    assert_true(d.machine.mechanism.design.gravity.x == 9.81 &&
                d.machine.mechanism.design.gravity.y == 0);
    flk_deck_free(&d);
}

/* ---------------------------------------------------------------------- changes from the outside */

#define LOADS                                                           \
    "[load F1]\nlink = coupler\nforce = (1, 0) N\nat = 0 mm\n" /* 10 */ \
    "[load F2]\nlink = coupler\nforce = (2, 0) N\nat = 0 mm\n"

TEST(test_changes)
{
    static const fourlink_change several[] = {{"--set", "crank.length=21 mm"},
                                              {"--interval", "motion.interval=5 deg"},
                                              {"--set", "crank.length=22 mm"},
                                              {"--branch", "table.branch=open"}};
    deck d;

    read_with(FOUR_BAR, "crank.length=30 mm", &d);
    assert_true(d.machine.mechanism.design.link[2].length == 0.03);
    flk_deck_free(&d);
    read_with(FOUR_BAR, "crank.mass=2 kg", &d);
    assert_true(d.machine.mechanism.design.link[2].mass == 2 && d.has_forces == 1);
    flk_deck_free(&d);
    read_with(FOUR_BAR, "motion.speed = 3 rad/s", &d); /* a section that the deck has not */
    assert_true(d.motion.speed == 3);
    flk_deck_free(&d);
    read_with(FOUR_BAR, " Motion . Speed=3 rad/s ", &d);
    assert_true(d.motion.speed == 3);
    flk_deck_free(&d);
    read_with(FOUR_BAR, "title=New = old", &d);
    assert_string_equal(d.title, "New = old");
    flk_deck_free(&d);
    read_with(FOUR_BAR "[units]\nlength = m\n", "units.length=in", &d);
    assert_true(d.machine.mechanism.design.link[2].length == 0.02);
    assert_string_equal(d.units[QUANTITY_LENGTH].name, "in");
    flk_deck_free(&d);
    read_with(FOUR_BAR LOADS, "load F2.force=5 N at 90 deg", &d);
    assert_true(given_load(&d, 0)->values.force.x == 1 && given_load(&d, 0)->values.force.y == 0);
    assert_true(given_load(&d, 1)->values.force.x == 0 && given_load(&d, 1)->values.force.y == 5);
    flk_deck_free(&d);
    read_with(FOUR_BAR LOADS, "LOAD f1.torque=5 N m", &d);
    assert_true(given_load(&d, 0)->values.torque == 5 && given_load(&d, 1)->values.torque == 0);
    flk_deck_free(&d);
    /* unless two names differ in that alone */
    read_with(FOUR_BAR LOADS "[load f1]\nlink = crank\ntorque = 1 N m\n", "load f1.torque=5 N m",
              &d);
    assert_true(given_load(&d, 0)->values.torque == 0 && given_load(&d, 2)->values.torque == 5);
    flk_deck_free(&d);
    read_with("mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\nlength = nonsense\n"
              "[coupler]\nlength = 66 mm\n[rocker]\nlength = 56 mm\n",
              "crank.length=20 mm", &d); /* what is replaced is not judged */
    flk_deck_free(&d);

    assert_int_equal(read_changed(FOUR_BAR, several, 4, &d), 1);
    assert_true(d.machine.mechanism.design.link[2].length == 0.022); /* the last one counts */
    assert_true(d.motion.interval == 5);
    assert_true(d.open == 1 && d.crossed == 0);
    flk_deck_free(&d);
}

/* A part of a force or a point; the others stay. */
TEST(test_changed_parts)
{
    static const struct {
        const char *first, *second;
        double x, y;
    } cases[] = {
        {"load F1.force.x=3 N", NULL, 3, 4},
        {"load F1.force.y=3 kN", NULL, 3, 3000},
        {"load f1.force.size=10 N", NULL, 6, 8},
        {"load F1.force.angle=180 deg", NULL, -5, 0},
        {"load F1.force.angle=-90 deg", "load F1.force.size=2 N", 0, -2},
        {"load F1.force.x=1 N", "load F1.force.x=2 N", 2, 4},
        {"load F1.force.x=1 N", "load F1.force=(7, 8) N", 7, 8},
        {"load F1.force=(7, 8) N", "load F1.force.x=1 N", 1, 8},
    };
    size_t i;
    deck d;

    for (i = 0; i < COUNT(cases); i++) {
        fourlink_change changes[2] = {{"--set", NULL}, {"--set", NULL}};

        changes[0].assignment = cases[i].first;
        changes[1].assignment = cases[i].second;
        assert_int_equal(read_changed(FOUR_BAR "[load F1]\nlink = coupler\nforce = (3, 4) N\n"
                                               "at = 0 mm\n",
                                      changes, cases[i].second ? 2 : 1, &d),
                         1);
        assert_near(given_load(&d, 0)->values.force.x, cases[i].x, 1e-14);
        assert_near(given_load(&d, 0)->values.force.y, cases[i].y, 1e-14);
        flk_deck_free(&d);
    }
    read_with(FOUR_BAR, "coupler.cg.y=5 mm", &d); /* not given: the link's origin */
    assert_true(d.machine.mechanism.design.link[3].cg.x == 0 &&
                d.machine.mechanism.design.link[3].cg.y == 0.005);
    flk_deck_free(&d);
}

/* Time that rises with the square of their number would be noticed. */
TEST(test_many_names)
{
    enum { N = 100000 };
    char *contents = malloc(sizeof FOUR_BAR + 20 * (N + 2)), *end = contents;
    deck d;
    int i;

    assert_non_null(contents);
    end += sprintf(end, FOUR_BAR "[expect]\n");
    for (i = 0; i < N; i++)
        end += sprintf(end, "a%d = 1\n", i);
    assert_int_equal(read_deck(contents, &d), 1);
    assert_int_equal(d.n_expectations, N);
    assert_int_equal(d.expectations[N - 1].place.line, N + 10);
    flk_deck_free(&d);
    strcpy(end, "a77 = 2\n");
    assert_int_equal(read_deck(contents, &d), 0);
    assert_int_equal(d.mistakes.count, 1);
    assert_int_equal(d.mistakes.list[0].place.line, N + 11);
    assert_string_equal(d.mistakes.list[0].message, "'a77' is given twice");
    flk_deck_free(&d);
    free(contents);
}

TEST(test_mistaken_changes)
{
    static const struct {
        const char *assignment, *message;
    } cases[] = {
        {"crank.length", "expected [SECTION.]KEY=VALUE, not 'crank.length'"},
        {"", "expected [SECTION.]KEY=VALUE, not ''"},
        {"crank.length=", "expected a value after 'length ='"},
        {"cranc.length=1 m", "unknown section 'cranc'; did you mean 'crank'?"},
        {"crank.lenght=1 m", "unknown key 'lenght' in [crank]; did you mean 'length'?"},
        {"crank.length=1 kg", "'1 kg' is a mass; expected a length, such as 80 mm"},
        {"crank.length=-1 m", "the length must be positive, not -1 m"},
        {"load F9.torque=1 N m", "there is no [load F9] in the deck"},
        {"load F1.torque.x=1 N m", "'load F1.torque' has no parts that can be varied"},
        {"load F1.force.x=1 kg", "'1 kg' is a mass: its weight is 1 kgf"},
        {"load F1.force.angle=1 N", "'1 N' is a force; expected an angle, such as 40 deg"},
        {"load.torque=1 N m", "there are several [load] sections: name one of them"},
        {"rod.length=1 m", "a four-bar linkage has no [rod]; its link 3 is the [coupler]"},
        {"crank.length=1 m",
         "the crank, 1 m, is longer than the other three together, 0.202 m: the linkage cannot be "
         "assembled"},
    };
    fourlink_change change = {"--set", NULL};
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        deck d;

        change.assignment = cases[i].assignment;
        assert_int_equal(read_changed(FOUR_BAR LOADS, &change, 1, &d), 0);
        assert_int_equal(d.mistakes.count, 1);
        assert_string_equal(d.mistakes.list[0].message, cases[i].message);
        assert_string_equal(d.mistakes.list[0].place.source, "--set");
        assert_int_equal(d.mistakes.list[0].place.line, 0);
        flk_deck_free(&d);
    }
}

/* --------------------------------------------------------------------------------- hostile decks */

/* A deck is in order, and then the library takes all of it; or it has a mistake, and then it says
** where.  1 in order, 0 not. */
static int check_outcome(const char *contents, size_t length)
{
    text t;
    deck d;
    int status;
    size_t i;
    long lines = 1;

    for (i = 0; i < length; i++)
        lines += contents[i] == '\n' || contents[i] == '\r';
    t.start = contents;
    t.length = length;
    status = read_text(t, NULL, 0, &d);
    assert_int_equal(status, d.mistakes.count == 0);
    if (status) {
        fourlink_mechanism mechanism;
        fourlink_load *loads = calloc(d.machine.n_loads + 1, sizeof *loads);
        fourlink_range range;
        fourlink_row row;
        fourlink_state state;
        fourlink_forces forces;

        assert_int_equal(fourlink_prepare(&d.machine.mechanism.design, &mechanism), FOURLINK_OK);
        assert_int_equal(fourlink_motion_range(&d.motion, &range), FOURLINK_OK);
        assert_int_equal(fourlink_motion_row(&d.motion, &range, 0, &row), FOURLINK_OK);
        assert_int_equal(fourlink_deck_loads(&d, FOURLINK_OPEN, row.crank.theta2, loads, NULL),
                         FOURLINK_OK);
        status = fourlink_analyse(&mechanism, FOURLINK_OPEN, &row.crank, loads, d.machine.n_loads,
                                  &state, &forces);
        free(loads);
        assert_in_range(status, FOURLINK_OK, FOURLINK_NULL - 1);
        assert_true(d.open || d.crossed);
        assert_in_range(d.digits, 1, 17);
        for (i = 0; i < 20; i++) {
            if (gas_of(&d)->indicator.n)
                assert_true(fabs(flk_curve_piece(&gas_of(&d)->indicator, (double)i, (double)i)) <=
                            FOURLINK_NUMBER_MAX);
            if (given_loads(&d) && given_load(&d, 0)->values.torque_curve.n)
                assert_true(fabs(flk_curve_piece(&given_load(&d, 0)->values.torque_curve, (double)i,
                                                 (double)i)) <= FOURLINK_NUMBER_MAX);
        }
        status = 1;
    }
    for (i = 0; i < d.mistakes.count; i++) {
        const struct mistake *x = &d.mistakes.list[i];
        const char *c;

        assert_string_equal(x->place.source, "x.deck");
        assert_in_range(x->place.line, 1, lines);
        assert_true(i == 0 || x[-1].place.line <= x->place.line);
        assert_in_range(strlen(x->message), 5, sizeof x->message - 1);
        for (c = x->message; *c; c++)
            assert_true((unsigned char)*c >= ' ' && *c != 0x7f);
    }
    flk_deck_free(&d);
    return status;
}

static size_t pick(uint64_t *seed, size_t n)
{
    return (size_t)uniform(seed, 0, (double)n);
}

static int n_texts = 3000; /* at random, or the argument */

TEST(test_random_bytes)
{
    static const char likely[] = "[]=\n\r\t #;,.()\"-+019e^/*atmrdgkNloadcrank";
    char contents[400];
    uint64_t seed = 11;
    int i;
    size_t j, n;

    for (i = 0; i < n_texts; i++) {
        n = pick(&seed, sizeof contents);
        for (j = 0; j < n; j++)
            contents[j] = i % 2 ? likely[pick(&seed, sizeof likely - 1)]
                                : (char)(unsigned char)pick(&seed, 256);
        assert_int_equal(check_outcome(contents, n), 0); /* it has no mechanism */
    }
}

static const char valid[] = "title = \"Mutant; # 1\"\n"
                            "mechanism = four-bar\n"
                            "[units]\nlength = mm\nangle = deg\nforce = N\n"
                            "[ground]\nlength = 80\nangle = 10 deg\n"
                            "[crank] # 2\nlength = 20 mm\nmass = 0.1 kg\ngyration = 8 mm\n"
                            "cg = 10 mm\n"
                            "[coupler]\nlength = 66 mm\nmass = 0.3 kg\ninertia = 2 kg.mm2\n"
                            "cg = 30 mm at 10 deg\n"
                            "[rocker]\nlength = 56 mm\ncg = (28, -5) mm\n"
                            "[load Tl]\nlink = rocker\ntorque = 0.5 N m\n"
                            "[load F]\nlink = coupler\nforce = 5 N at 30 deg\nat = 3 mm\n"
                            "[motion]\nspeed = 10.5 rad/s\nacceleration = 1 rad/s2\nfrom = 0\n"
                            "to = 90 deg\ninterval = 5 deg\n"
                            "[gravity]\nacceleration = 9.81 m/s2\ndirection = -90 deg\n"
                            "[table]\nbranch = both\ncolumns = theta2, theta3,\n  Ts\n"
                            "digits = 7\n";

#define MUTANT_SIZE (sizeof valid + 4096)

/* Replace `remove` bytes at `where` by `n` others. */
static size_t splice(char *contents, size_t length, size_t where, size_t remove, const char *bytes,
                     size_t n)
{
    if (remove > length - where)
        remove = length - where;
    if (length - remove + n > MUTANT_SIZE)
        return length;
    memmove(contents + where + n, contents + where + remove, length - where - remove);
    memcpy(contents + where, bytes, n);
    return length - remove + n;
}

static void mutate(const char *original, size_t size, uint64_t seed)
{
    static const char *const tokens[] = {
        "1e400",
        "-",
        "nan",
        "inf",
        "1e30",
        "1e-30",
        "1e15",
        "0",
        "mm",
        "km4",
        "rad",
        " at ",
        "(",
        ")",
        ",",
        "=",
        "[",
        "]",
        "\"",
        "#",
        "\n",
        "\r\n",
        "\t",
        "\n[",
        "]\n",
        ",\n",
        "^",
        "/",
        "rpm",
        "1",
        "e9",
        "e-9",
        "\0",
        "\303",
        "\357\273\277",
        "9",
        "[load]\n",
        "[rod]\n",
        "run_up = 1\n",
        "at = 5\n",
        "hold = yes\n",
        "slider-crank",
        "[piston]\n",
        "stroke = 1\n",
        "cycle = 1e-9\n",
        "[motion]\n",
        "99999999999999999999",
        "\342\210\222",
        "\302\240",
        "\302\260",
        "\303\22710\302\263",
        "*10^-3",
        " %",
        "mid",
        "uniform = yes\n",
        "0 (1, 2), 90 (3, 4)",
    };
    char contents[MUTANT_SIZE], piece[64];
    int i, good = 0, bad = 0;

    assert_int_equal(check_outcome(original, size), 1);
    for (i = 0; i < n_texts; i++) {
        size_t length = size, changes = 1 + pick(&seed, 4), n, from;
        const char *token;
        char c;

        memcpy(contents, original, length);
        while (changes-- > 0) {
            size_t where = pick(&seed, length + 1);

            switch (pick(&seed, 7)) {
            case 0: /* another byte */
                c = (char)(unsigned char)pick(&seed, 256);
                length = splice(contents, length, where, 1, &c, 1);
                break;
            case 1: /* less */
                length = splice(contents, length, where, 1 + pick(&seed, 12), "", 0);
                break;
            case 2: /* a piece of itself */
                n = pick(&seed, sizeof piece);
                from = pick(&seed, length + 1);
                n = n > length - from ? length - from : n;
                memcpy(piece, contents + from, n);
                length = splice(contents, length, where, pick(&seed, 2) * n, piece, n);
                break;
            case 3: /* other digits: often still a deck */
            case 4:
            case 5:
                while (where < length && (contents[where] < '0' || '9' < contents[where]))
                    where++;
                c = (char)('0' + pick(&seed, 10));
                length = splice(contents, length, where, 1, &c, where < length);
                break;
            case 6: /* a word in place of some bytes */
            default:
                token = tokens[pick(&seed, COUNT(tokens))];
                n = *token ? strlen(token) : 1;
                length = splice(contents, length, where, pick(&seed, 6), token, n);
            }
        }
        if (check_outcome(contents, length))
            good++;
        else
            bad++;
    }
    print_message("%d in order, %d with mistakes\n", good, bad);
    assert_true(good > n_texts / 20); /* both ends of the reader are reached */
    assert_true(bad > n_texts / 20);
}

TEST(test_mutations)
{
    mutate(valid, sizeof valid - 1, 3491);
}

TEST(test_mutations_of_an_engine)
{
    mutate(ENGINE, sizeof ENGINE - 1, 3492);
}

/* Fill a buffer with copies of a piece, after a deck in order. */
static char *repeated(const char *before, const char *piece, size_t times, const char *after)
{
    size_t n = strlen(piece), i;
    char *all = malloc(strlen(before) + n * times + strlen(after) + 1), *end;

    assert_non_null(all);
    strcpy(all, before);
    end = all + strlen(all);
    for (i = 0; i < times; i++, end += n)
        memcpy(end, piece, n);
    strcpy(end, after);
    return all;
}

static void check_repeated(const char *before, const char *piece, size_t times, const char *after,
                           int good)
{
    char *contents = repeated(before, piece, times, after);

    print_message("%.20s %lu times\n", piece, (unsigned long)times);
    assert_int_equal(check_outcome(contents, strlen(contents)), good);
    free(contents);
}

TEST(test_large)
{
    static const char *const pieces[] = {"(",    ")",   "[",   "]",  "=",    ",",  "\"",
                                         "^",    "/",   ".",   "-",  "a",    "1",  "1 ",
                                         " at ", "mm ", "mm/", "1e", "(1, ", "m4 "};
    size_t i;

    check_repeated(FOUR_BAR, "# comment\n", 100000, "", 1);
    check_repeated(FOUR_BAR, "\n", 1000000, "", 1);
    check_repeated("title = ", "x", 1000000, "\n" FOUR_BAR, 0);
    check_repeated(FOUR_BAR, "x", 1000000, "", 0);
    check_repeated(FOUR_BAR, "[load]\n", 100000, "", 0);
    check_repeated(FOUR_BAR, "[load x]\nlink = crank\ntorque = 1\n", 100000, "", 0);
    check_repeated(FOUR_BAR, "[load]\nlink = crank\ntorque = 1\n", 1000, "", 1);
    check_repeated(FOUR_BAR, "[crank]\n", 100000, "", 0);
    check_repeated(FOUR_BAR, "[unknown]\nkey = 1\n", 100000, "", 0);
    check_repeated(FOUR_BAR, "mass = 1\n", 100000, "", 0);
    check_repeated(FOUR_BAR "[table]\ncolumns = theta2,", "theta2,\n", 100000, "mu\n", 1);
    check_repeated(FOUR_BAR "mass = 1", "0", 500, " kg\n", 0);
    check_repeated(FOUR_BAR "mass = 0.", "0", 300, "1 kg\n", 1);
    for (i = 0; i < COUNT(pieces); i++) {
        check_repeated(FOUR_BAR, pieces[i], 10000, "\n", 0);
        check_repeated(FOUR_BAR "cg = ", pieces[i], 10000, "\n", 0);
        check_repeated(FOUR_BAR "mass = 1 ", pieces[i], 10000, "\n", 0);
    }
}

TEST(test_left_out)
{
    char *contents = repeated(FOUR_BAR, "[unknown]\n", 100000, "");
    deck d;

    assert_int_equal(read_text(flk_text_of(contents), NULL, 0, &d), 0);
    assert_in_range(d.mistakes.count, 20, 1000); /* what fits a screen or a few */
    assert_int_equal(d.mistakes.count + d.mistakes.left_out, 100000);
    assert_int_equal(d.mistakes.list[0].place.line, 10);
    flk_deck_free(&d);
    free(contents);
}

/* What is no text has this mistake only: nothing is said of what it lacks as a deck. */
static void check_no_text(const char *contents, size_t length, long line, const char *message)
{
    text t;
    deck d;

    t.start = contents;
    t.length = length;
    assert_int_equal(read_text(t, NULL, 0, &d), 0);
    assert_int_equal(d.mistakes.count, 1);
    assert_int_equal(d.mistakes.list[0].place.line, line);
    assert_string_equal(d.mistakes.list[0].message, message);
    flk_deck_free(&d);
}

TEST(test_no_text)
{
    static const char null[] = FOUR_BAR "mass = 1\0 kg\n";
    static const char bell[] = "title = \a\n" FOUR_BAR, other[] = "title =\033[1m\n";
    static const char utf16[] = "\377\376t\0i\0t\0l\0e\0 \0=\0\a\0\n\0";
    static const char no_mark[] = "t\0i\0t\0l\0e\0 \0=\0 \0x\0\n\0";
    char *line = repeated("title = ", "x", 1000000, "\n" FOUR_BAR);

    check_no_text(null, sizeof null - 1, 10, "control character (0x00): a deck is plain text");
    check_no_text(other, sizeof other - 1, 1, "control character (0x1b): a deck is plain text");
    check_no_text(bell, sizeof bell - 1, 1, "control character (0x07): a deck is plain text");
    check_no_text(utf16, sizeof utf16 - 1, 1, "control character (0x07): a deck is plain text");
    check_no_text(no_mark, sizeof no_mark - 1, 1,
                  "UTF-16 without its mark, or no text: save the file as UTF-8");
    check_no_text(line, strlen(line), 1, "line longer than 65536 characters: not a deck");
    free(line);
}

/* A value on a line without = is not missing too. */
TEST(test_line_without_sign)
{
    deck d;

    assert_int_equal(
        read_text(flk_text_of("mechanism = four-bar\n[ground]\nlength = 80 mm\n[crank]\n"
                              "length = 20 mm\n[coupler]\nlength = 66 mm\n[rocker]\n"
                              "length : 56 mm\n[motion]\nspeed = 1 rad/s\n"),
                  NULL, 0, &d),
        0);
    assert_int_equal(d.mistakes.count, 1);
    assert_int_equal(d.mistakes.list[0].place.line, 9);
    flk_deck_free(&d);
}

/* Every beginning of a deck, as of a file cut short. */
TEST(test_cut_short)
{
    size_t n, good = 0;
    char *copy;

    for (n = 0; n < sizeof valid; n++) {
        copy = malloc(n + 1); /* of its own, so that reading past its end is seen */
        assert_non_null(copy);
        memcpy(copy, valid, n);
        good += (size_t)check_outcome(copy, n);
        free(copy);
    }
    assert_in_range(good, 50, sizeof valid / 2);
}

/* As many rows as are allowed; one more is a mistake above. */
TEST(test_most_rows)
{
    fourlink_abscissa over;
    fourlink_range range;
    deck d;

    assert_int_equal(
        read_changed(FOUR_BAR "[motion]\nto = 9999999 deg\ninterval = 1 deg\n", NULL, 0, &d), 1);
    assert_int_equal(flk_deck_rows(&d, &range, &over), FOURLINK_OK);
    assert_int_equal(range.n_rows, 10000000);
    flk_deck_free(&d);
    /* one instant has no interval */
    assert_int_equal(
        read_changed(FOUR_BAR "[motion]\nat = 3 deg\ninterval = 1e-12 deg\n", NULL, 0, &d), 1);
    flk_deck_free(&d);
}

int main(int argc, char **argv)
{
    n_texts = argc > 1 ? atoi(argv[1]) : n_texts;
    return run_all_tests(watch_gsl);
}
