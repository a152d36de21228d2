/* SPDX-License-Identifier: GPL-3.0-or-later
**
** catalogue.c - the list of all columns and facts, of any deck: those of decks that have everything.
*/
#include <string.h>

#include "command.h"
#include "tables/content.h"
#include "terminal.h"
#include "catalogue.h"

#define MASS "mass = 1 kg\nuniform = yes\n"
#define LINK(name) "[" name "]\nlength = 60 mm\n" MASS
#define CRANK "[crank]\nlength = 20 mm\n" MASS
#define GROUND "[ground]\nlength = 80 mm\n"
#define PIN(name) name " = 0.1\nradius_" name " = 5 mm\n"

static const char four_bar[] = "mechanism = four-bar\n" GROUND CRANK LINK("coupler") LINK("rocker");
static const char slider_crank[] =
    "mechanism = slider-crank\n" CRANK LINK("rod") "[piston]\nmass = 1 kg\n";
static const char inverted[] =
    "mechanism = inverted-slider-crank\n" GROUND CRANK
    "[slider]\nmass = 1 kg\n[lever]\nmass = 1 kg\ncg = 30 mm\ninertia = 0.01\n";
static const char elements[] = "[point P]\nlink = crank\nat = 20 mm\n[gravity]\n"
                               "[spring S]\nlink = crank\nto = ground\nat = 10 mm\n"
                               "to_at = (0, 100) mm\nstiffness = 1 N/m\n"
                               "[balance]\ncrank = yes\nradius = 40 mm\n";
static const char of_four_bar[] = "rocker = yes\n[friction]\n" PIN("A") PIN("B") PIN("C") PIN("D");
static const char of_slider_crank[] =
    "fraction = 0.5\n[gas]\nbore = 50 mm\npressure = 3 bar\n[friction]\n" PIN("A") PIN("B")
        PIN("C") "guide = 0.1\n";
static const char of_inverted[] =
    "[friction]\n" PIN("A") PIN("B") PIN("D") "guide = 0.1\nguide_length = 10 mm\n";
static const char given[] = "[spring T]\nlink = crank\nto = ground\nstiffness = 1 N m/rad\n"
                            "[motion]\nspeed = 10 rad/s\n[flywheel]\nfluctuation = 0.02\n";
static const char steady[] =
    "[motor]\ntorque = constant\n[motion]\nmode = steady\nmean_speed = 10 rad/s\n"
    "[flywheel]\nfluctuation = 0.05\nexact = yes\n";
static const char run_up[] = "[motor]\nstall_torque = 50 N m\nno_load_speed = 10 rad/s\n"
                             "[load]\nlink = crank\ntorque = -10 N m\n"
                             "[motion]\nmode = run-up\nto = 3600 deg\n[flywheel]\ninertia = 0.1\n";

#define PARTS 4

/* What one deck cannot have, another one has. */
static const char *const decks[CONTENT_LISTED][PARTS] = {
    {four_bar, elements, of_four_bar, given},
    {slider_crank, elements, of_slider_crank, given},
    {inverted, elements, of_inverted, given},
    {four_bar, elements, of_four_bar, steady},
    {four_bar, elements, of_four_bar, run_up}};

int catalogue_write(FILE *out, const options *o)
{
    fourlink_results *results[CONTENT_LISTED] = {NULL};
    fourlink_source source;
    fourlink_mistake mistake;
    char deck[2000];
    int status = FOURLINK_OK;
    size_t i, k;
    sheet s;

    memset(&source, 0, sizeof source);
    source.units = o->units;
    source.name = "--units"; /* the only mistake there can be */
    for (i = 0; i < CONTENT_LISTED && status == FOURLINK_OK; i++) {
        strcpy(deck, decks[i][0]);
        for (k = 1; k < PARTS; k++)
            strcat(deck, decks[i][k]);
        source.text = deck;
        source.length = (unsigned long)strlen(deck);
        status = fourlink_results_open(&source, 1, &results[i], &mistake, NULL);
    }
    memset(&s, 0, sizeof s);
    s.format = o->format;
    s.content = SHEET_LIST;
    s.width = o->wide ? 0 : terminal_width(out);
    if (status == FOURLINK_OK) {
        content_begin(&s, out, 1);
        content_write_list(&s, results, CONTENT_LISTED);
    }
    for (i = 0; i < CONTENT_LISTED; i++)
        fourlink_results_free(results[i]);
    if (status == FOURLINK_BAD_DECK) {
        command_tell("error", mistake.file, mistake.line, mistake.message, NULL);
        return EXIT_USAGE;
    }
    return status != FOURLINK_OK || s.out_of_memory
               ? command_complain("cannot list", "", "not enough memory")
               : 0;
}
