/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_defaults.c - what a deck leaves unsaid: the branch of an engine, the unit of a speed.
*/
#include "outcome.h"

#define SLIDER_CRANK "mechanism = slider-crank\n[crank]\nlength = 50 mm\n[rod]\nlength = 200 mm\n"
#define INVERTED \
    "mechanism = inverted-slider-crank\n[crank]\nlength = 50 mm\n[ground]\nlength = 200 mm\n"
#define GAS "[gas]\nbore = 80 mm\npressure = 2 bar\n"

static void check_branches(const char *contents, int open, int crossed)
{
    deck d;

    print_message("%s\n", contents);
    read_accepted(contents, NULL, &d);
    assert_int_equal(d.open, open);
    assert_int_equal(d.crossed, crossed);
    flk_deck_free(&d);
}

/* With gas in the cylinder the open branch alone, unless the deck has a word on it. */
TEST(test_branch)
{
    check_branches(SLIDER_CRANK, 1, 1);
    check_branches(SLIDER_CRANK GAS, 1, 0);
    check_branches(SLIDER_CRANK GAS "[table]\ndigits = 5\n", 1, 0);
    check_branches(SLIDER_CRANK GAS "[table]\nbranch = both\n", 1, 1);
    check_branches(SLIDER_CRANK GAS "[table]\nbranch = crossed\n", 0, 1);
    check_branches(SLIDER_CRANK GAS "[table]\nbranch = open\n", 1, 0);
    check_branches(INVERTED, 1, 1);
    check_branches(INVERTED GAS, 1, 0);
    check_branches(INVERTED GAS "[table]\nbranch = both\n", 1, 1);
    /* a force on the piston is no gas */
    check_branches(SLIDER_CRANK "[load]\nlink = piston\nforce = (-3, 0) N\n", 1, 1);
}

TEST(test_speed)
{
    check_note(SLIDER_CRANK "[motion]\nspeed = 300\n", NULL, 7,
               "'300' is read as rad/s: write 300 rad/s or 300 rpm");
    check_note(SLIDER_CRANK "[motion]\nspeed = -1e2\n", NULL, 7,
               "'-1e2' is read as rad/s: write -1e2 rad/s or -1e2 rpm");
    check_note(SLIDER_CRANK "[sweep]\nmotion.speed = 100 to 300 in 3\n", NULL, 7,
               "'100' is read as rad/s: write 100 rad/s or 100 rpm");
    check_note(SLIDER_CRANK "[motion]\nspeed = 0\n", NULL, 0, NULL);
    check_note(SLIDER_CRANK "[motion]\nspeed = 300 rad/s\n", NULL, 0, NULL);
    check_note(SLIDER_CRANK "[motion]\nspeed = 300rpm\n", NULL, 0, NULL);
    check_note(SLIDER_CRANK "[motion]\nspeed = 300\n[units]\nangular_speed = rpm\n", NULL, 0, NULL);
    check_note(SLIDER_CRANK "[motion]\nspeed = 300\n[units]\nangular_speed = rad/s\n", NULL, 0,
               NULL);
    check_note(SLIDER_CRANK "[sweep]\nmotion.speed = 100 rpm to 300 rpm in 3\n", NULL, 0, NULL);
    check_mistake(SLIDER_CRANK "[motion]\nspeed = 300 300\n", NULL, 7,
                  "'300 300': two numbers in place of one; a blank does not separate thousands");
}

#define THOUSANDS(written, read, meant)                                                     \
    "'" written "' is read as " read " rpm, with a decimal point: if thousands are meant, " \
    "write " meant " rpm"

/* A point between thousands, where these are a plausible speed. */
TEST(test_thousands)
{
    check_note(SLIDER_CRANK "[motion]\nspeed = 1.200 rpm\n", NULL, 7,
               THOUSANDS("1.200 rpm", "1.2", "1200"));
    check_note(SLIDER_CRANK "[motion]\nspeed = -12.500 1/min\n", NULL, 7,
               THOUSANDS("-12.500 1/min", "-12.5", "-12500"));
    check_note(SLIDER_CRANK "[motion]\nspeed = 3.000\n[units]\nangular_speed = rpm\n", NULL, 7,
               THOUSANDS("3.000", "3", "3000"));
    check_note(SLIDER_CRANK "[motion]\nspeed = 1.20 rpm\n", NULL, 0, NULL);
    check_note(SLIDER_CRANK "[motion]\nspeed = 1.2000 rpm\n", NULL, 0, NULL);
    check_note(SLIDER_CRANK "[motion]\nspeed = 0.500 rpm\n", NULL, 0, NULL);
    check_note(SLIDER_CRANK "[motion]\nspeed = 120.500 rpm\n", NULL, 0, NULL);
    check_note(SLIDER_CRANK "[motion]\nspeed = 1.200 rad/s\n", NULL, 0, NULL);
}

int main(void)
{
    return run_all_tests(NULL);
}
