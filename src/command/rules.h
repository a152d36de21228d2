/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rules.h - what goes together on a command line, and what a deck must have for it.
*/
#ifndef FOURLINK_RULES_H
#define FOURLINK_RULES_H

#include "fourlink.h"
#include "options.h"

/* A deck that has been opened. */
typedef struct rules_deck {
    fourlink_problem problem;
    int has_sweep;  /* 1: it has a [sweep], or was taken from one */
    int has_task;   /* 1: its linkage was found for a [synthesis], */
    int has_starts; /* ... from many starts */
    int has_values; /* 1: its columns are values of the deck */
} rules_deck;

/* Why the options do not go together, or with this deck, which is null before it has been read; in
** `message`.  Null: they do. */
const char *rules_broken(const options *o, const rules_deck *deck, char message[400]);

/* Why they need a [sweep], as those that have no use without one do; null: they do not. */
const char *rules_without_sweep(const options *o, char message[400]);

#endif
