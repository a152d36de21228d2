/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pins.c - the deck of --print-deck --pins: a deck by lengths as one by the places of its pins.
**
** What is written is read back, and must be the same mechanism: in a dead position, or with a piston on the
** other side of A, a drawing tells less than the lengths.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/memory.h"
#include "view/results.h"
#include "view/view.h"
#include "command.h"
#include "pins.h"

#define STEPS 36   /* crank angles of a turn that are tried */
#define SAME 1e-10 /* of the size of a mechanism, and of an angle */

/* 1 if two designs are the same but for rounding. */
static int is_same(const fourlink_design *a, const fourlink_design *b)
{
    double size = fabs(a->offset), differs = fabs(a->offset - b->offset);
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        size = GSL_MAX(size, a->link[i].length);
        differs = GSL_MAX(differs, fabs(a->link[i].length - b->link[i].length));
    }
    return differs <= SAME * size && fabs(a->angle - b->angle) <= SAME &&
           fabs(a->gravity.x - b->gravity.x) + fabs(a->gravity.y - b->gravity.y) <=
               SAME * (fabs(a->gravity.x) + fabs(a->gravity.y));
}

/* The text of the deck as drawn at a crank angle, rad from x of link 1: memory to free; null, and why,
** if it is not the same mechanism, or if memory fails. */
static char *text_at(const input *in, double theta2, unsigned long *length, const char **why,
                     char message[MESSAGE_SIZE])
{
    const fourlink_deck *deck = fourlink_results_deck(in->results);
    int status = fourlink_deck_write_pins(deck, theta2, NULL, 0, length);
    fourlink_results *again = NULL;
    fourlink_source source = in->source;
    fourlink_problem problem;
    fourlink_mistake mistake;
    char *words = NULL;

    *why = fourlink_status_text(status);
    if (status == FOURLINK_OK)
        words = memory_get(*length + 1, 1);
    if (!words)
        return NULL;
    fourlink_deck_write_pins(deck, theta2, words, *length + 1, length);
    source.text = words;
    source.length = *length;
    source.changes = NULL;
    source.n_changes = 0;
    source.synthesis = 0;
    source.design = 0;
    status = results_open(&source, 1, &again, &mistake, NULL);
    if (status == FOURLINK_OK) {
        fourlink_deck_problem(fourlink_results_deck(again), &problem);
        if (is_same(&problem.mechanism.design, &in->problem.mechanism.design)) {
            fourlink_results_free(again);
            return words;
        }
    }
    *why = flk_message(
        message, MESSAGE_SIZE, "%s",
        status == FOURLINK_BAD_DECK ? mistake.message
        : status == FOURLINK_OK
            ? "the pin of the piston is not on the side of x, from which a drawing tells it"
            : fourlink_status_text(status));
    fourlink_results_free(again);
    free(words);
    return NULL;
}

/* The crank angle of --plot-at, rad from x of link 1; 0 and a message if it is none. */
static int read_angle(const input *in, double *theta2, char message[MESSAGE_SIZE])
{
    text at = flk_text_of(in->o->drawing.at);
    view_spot spot;
    view v;

    view_take(&v, in->results);
    if (!view_read_spot(&v, at, &spot, message))
        return 0;
    if (spot.is_place) {
        flk_message(message, MESSAGE_SIZE, "expected a crank angle, not '%t'", at);
        return 0;
    }
    *theta2 = view_si(&v, QUANTITY_ANGLE, spot.at) - in->problem.x_angle;
    return 1;
}

static int refuse(const char *option, const char *message)
{
    command_tell("error", option, 0, message, NULL);
    return EXIT_USAGE;
}

int pins_write(FILE *out, input *in)
{
    char message[MESSAGE_SIZE], told[MESSAGE_SIZE], *words = NULL;
    const char *why = "", *first = NULL;
    unsigned long length = 0;
    double theta2;
    view v;
    int i;

    view_take(&v, in->results);
    if (in->problem.has_drawn)
        return refuse("--pins", "the deck has [pins] already");
    theta2 = view_si(&v, QUANTITY_ANGLE, in->problem.motion.from);
    if (in->o->drawing.at && !read_angle(in, &theta2, message))
        return refuse("--plot-at", message);
    for (i = 0; i < (in->o->drawing.at ? 1 : STEPS) && !words && !memory_has_failed(); i++) {
        words = text_at(in, theta2 + i * 2 * M_PI / STEPS, &length, &why, message);
        if (!words && !first)
            first = flk_message(told, sizeof told, "drawn there, %s", why);
    }
    if (memory_has_failed()) {
        free(words);
        return command_lacks_memory("cannot write", in->name);
    }
    if (!words)
        return refuse(in->o->drawing.at ? "--plot-at" : "--pins", first);
    fwrite(words, 1, length, out);
    free(words);
    return 0;
}
