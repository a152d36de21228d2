/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.h - the input deck: text in, a problem to solve out, or its mistakes.
*/
#ifndef FOURLINK_DECK_H
#define FOURLINK_DECK_H

#include "fourlink.h"
#include "units.h"

#define DECK_NAME_SIZE 64

/* A unit in which a quantity is printed, and in which bare numbers of it are read. */
typedef struct deck_unit {
    char name[DECK_NAME_SIZE];
    unit unit;
} deck_unit;

/* A list of names in a deck, such as columns, and where it stands. */
typedef struct deck_names {
    text names;
    text_place place;
} deck_names;

typedef struct deck {
    char title[256];
    fourlink_design design;
    fourlink_mechanism mechanism; /* the design, prepared */
    fourlink_motion motion;       /* angles in the deck's unit of angle */
    int one_instant;              /* 1: motion.at */
    int one_revolution;           /* 1: the last row repeats the first */
    fourlink_load *loads;
    unsigned long n_loads;
    int has_forces; /* 1: the deck has masses or loads */
    int open, crossed;
    deck_names columns;
    int digits;
    deck_unit units[QUANTITY_COUNT];

    mistakes mistakes; /* none: the deck is in order */
    char *storage;     /* the texts that the names point to */
} deck;

/* A change to a deck from outside it: [SECTION[ NAME].]KEY=VALUE. */
typedef struct deck_change {
    const char *option; /* for messages, such as "--set" */
    const char *assignment;
} deck_change;

/* Read a deck.
**
** Given:
**    name        for messages: the file's name
**    contents    the deck's text
**    changes     assignments that replace or add to those of the deck
** Returned:
**    d           the deck; to be given to deck_free also where it is full of mistakes
** Returned (function value):
**    1 the deck is in order, 0 see d->mistakes, -1 out of memory
*/
int deck_read(const char *name, text contents, const deck_change *changes, size_t n_changes,
              deck *d);

void deck_free(deck *d);

#endif
