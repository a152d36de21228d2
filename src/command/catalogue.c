/* SPDX-License-Identifier: GPL-3.0-or-later
**
** catalogue.c - the list of all columns and facts, of any deck: those of decks that have everything.
*/
#include <string.h>

#include "system/memory.h"
#include "command.h"
#include "tables/content.h"
#include "terminal.h"
#include "catalogue.h"
#include "view/results.h"

#define MASS "mass = 1 kg\nuniform = yes\n"
#define LINK(name) "[" name "]\nlength = 60 mm\n" MASS
#define BLOCK(name) "[" name "]\nmass = 1 kg\n"
#define LEVER(name) "[" name "]\nmass = 1 kg\ncg = 30 mm\ninertia = 0.01\n"
#define CRANK "[crank]\nlength = 20 mm\n" MASS
#define GROUND "[ground]\nlength = 80 mm\n"
#define PIN(name) name " = 0.1\nradius_" name " = 5 mm\n"

static const char elements[] = "[point P]\nlink = crank\nat = 20 mm\n[gravity]\n"
                               "[spring S]\nlink = crank\nto = ground\nat = 10 mm\n"
                               "to_at = (0, 100) mm\nstiffness = 1 N/m\n";
static const char given[] = "[spring T]\nlink = crank\nto = ground\nstiffness = 1 N m/rad\n"
                            "[output Q]\nlink = crank\nat = 20 mm\nrod = 200 mm\n"
                            "line = (0, 0) mm\nangle = 0 deg\n"
                            "[output R]\nlink = crank\nat = 20 mm\nslot = output\n"
                            "pivot = (150, 0) mm\n"
                            "[motion]\nspeed = 10 rad/s\n";
static const char run_up[] = "[motor]\nstall_torque = 50 N m\nno_load_speed = 10 rad/s\n"
                             "[motion]\nmode = run-up\n";
static const char driven[] =
    "[actuator A]\nlink = crank\nat = 20 mm\nto = ground\nto_at = (0, 100) mm\n"
    "bore = 20 mm\n[motion]\nspeed = 10 rad/s\n";

#define DECK 2000

/* How the crank moves of itself, and what else drives it: what one deck cannot have, another one has. */
static const char *const others[] = {run_up, driven};

static char *put_friction(char *deck, const fourlink_kind_facts *k)
{
    int i, has_guide = 0;

    deck += sprintf(deck, "[friction]\n");
    for (i = 0; i < 4; i++)
        if (k->joint[i].slider)
            has_guide = 1;
        else
            deck += sprintf(deck, PIN("%s"), k->joint[i].letter, k->joint[i].letter);
    if (k->shape[FOURLINK_FOLLOWER] == FOURLINK_SHAPE_YOKE)
        deck += sprintf(deck, "slot = 0.1\n");
    if (has_guide)
        deck += sprintf(deck, "guide = 0.1\n%s", k->slotted ? "guide_length = 10 mm\n" : "");
    return deck;
}

/* Write the text of a deck of a kind, if the motion is given with all that its links and joints can
** have: names of other motions do not depend on that. */
static void put_deck(char *deck, int kind, const char *motion)
{
    fourlink_kind_facts k;
    int i;

    fourlink_kind_of(kind, &k);
    deck += sprintf(deck, "mechanism = %s\n%s" CRANK, k.name, k.guided ? "" : GROUND);
    for (i = FOURLINK_COUPLER; i <= FOURLINK_FOLLOWER; i++) {
        deck += sprintf(deck,
                        k.slides_on[i]   ? BLOCK("%s")
                        : i == k.slotted ? LEVER("%s")
                                         : LINK("%s"),
                        k.link[i]);
    }
    if (motion == given) {
        deck += sprintf(deck, "%s", elements);
        if (k.guided)
            deck += sprintf(deck, "[balance]\ncrank = yes\nfraction = 0.5\n[gas]\nbore = 50 mm\n"
                                  "indicator = 0 deg 3 bar, 90 deg 1 bar\n");
        if (k.slides_on[FOURLINK_FOLLOWER] == FOURLINK_GROUND)
            deck += sprintf(deck, "clearance = 5 mm\n");
        deck = put_friction(deck, &k);
    }
    sprintf(deck, "%s", motion);
}

/* Open a deck of a kind; a status. */
static int open_deck(fourlink_source *source, int kind, const char *motion,
                     fourlink_results **results, fourlink_mistake *mistake)
{
    char deck[DECK];

    put_deck(deck, kind, motion);
    source->text = deck;
    source->length = (unsigned long)strlen(deck);
    return results_open(source, 1, results, mistake, NULL);
}

int catalogue_write(FILE *out, const options *o)
{
    fourlink_results *results[CONTENT_LISTED] = {NULL};
    fourlink_source source;
    fourlink_mistake mistake;
    fourlink_kind_facts facts;
    int status = FOURLINK_OK, kind;
    size_t i, n = 0;
    sheet s;

    memset(&source, 0, sizeof source);
    source.units = o->units;
    source.deck_units = o->format == &table_format;
    source.name = "--units"; /* the only mistake there can be */
    for (kind = 1; status == FOURLINK_OK && fourlink_kind_of(kind, &facts) == FOURLINK_OK;
         kind *= 2)
        status = open_deck(&source, kind, given, &results[n++], &mistake);
    for (i = 0; status == FOURLINK_OK && i < sizeof others / sizeof others[0]; i++)
        status = open_deck(&source, 1, others[i], &results[n++], &mistake);
    memset(&s, 0, sizeof s);
    s.format = o->format;
    s.content = SHEET_LIST;
    terminal_set_up(&s, out, o->wide, o->colour);
    if (status == FOURLINK_OK) {
        content_begin(&s, out, 1);
        content_write_list(&s, results, n);
    }
    for (i = 0; i < n; i++)
        fourlink_results_free(results[i]);
    if (status == FOURLINK_BAD_DECK) {
        command_tell("error", mistake.file, mistake.line, mistake.message, NULL);
        return EXIT_USAGE;
    }
    return memory_has_failed() ? command_lacks_memory("cannot list", "") : 0;
}
