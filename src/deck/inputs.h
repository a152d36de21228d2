/* SPDX-License-Identifier: GPL-3.0-or-later
**
** inputs.h - the values that a deck gives, section by section.
*/
#ifndef FOURLINK_DECK_INPUTS_H
#define FOURLINK_DECK_INPUTS_H

#include "deck.h"
#include "schema.h"

/* A value that a deck gives. */
typedef struct deck_input {
    char name[DECK_NAME_SIZE]; /* SECTION.KEY, of a vector SECTION.KEY.x and .y */
    const char *words;         /* null: it is a number */
    unsigned long number;      /* of a number: as from flk_number_find */
    double place;              /* m, of a point given as a part of its link's length */
    const char *meaning;
} deck_input;

/* What takes the inputs one by one. */
typedef void deck_input_taker(void *host, const deck_input *input);

/* Pass the inputs of all sections of this name to a function.  Titles, lists of names and a component that
** is 0 are not among them. */
void flk_inputs_walk(const deck *d, section_code section, deck_input_taker *take, void *host);

/* The largest number of inputs of all sections. */
size_t flk_inputs_limit(const deck *d);

#endif
