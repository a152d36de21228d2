/* SPDX-License-Identifier: GPL-3.0-or-later
**
** list.h - the lists of a deck: columns, inputs, variables of a sweep.
*/
#ifndef FOURLINK_LIST_H
#define FOURLINK_LIST_H

#include "column.h"

/* A list, in memory allocated when the deck was opened. */
typedef struct flk_list {
    fourlink_value *list;
    char *names; /* of DECK_NAME_SIZE bytes each, of what has no lasting name */
    unsigned long n;
} flk_list;

/* The units in which the lines of a deck give its numbers, each once, in memory allocated when it was
** opened. */
typedef struct flk_line_units {
    char *texts; /* of DECK_NAME_SIZE bytes each */
    size_t n;
} flk_line_units;

/* The handle of an input that is not a number of the deck; of a number of the deck, by flk_number_find.
** Those of facts are between these and 0, those of columns greater than 0. */
#define FLK_LIST_HANDLE(i) (-1000 - 2 * (int)(i))
#define FLK_NUMBER_HANDLE(id) (-1001 - 2 * (int)(id))

/* The number of the deck that a handle stands for; 0 if it is another. */
unsigned long flk_list_number(int handle);

/* Describe a value of a deck without its name and number; a column with its name. */
void flk_list_describe(const deck *d, quantity q, const char *meaning, fourlink_value *v);
void flk_list_column(const deck *d, const flk_column *c, fourlink_value *v);

/* Describe a number of the deck, with its value or NaN, and the unit of its line; 0 if it is none. */
int flk_list_number_value(const deck *d, unsigned long id, flk_line_units *units,
                          fourlink_value *v);

/* The lasting text of a unit. */
const char *flk_line_unit_text(flk_line_units *units, const char *name);

/* All columns that the deck has. */
void flk_list_columns(const flk_analysis *a, flk_list *columns);

/* The largest number of inputs of a deck, and of units of its lines. */
size_t flk_list_input_limit(const deck *d);
size_t flk_line_unit_limit(const deck *d);

/* The inputs of a deck as the reader understood them, listed once; the variables of its sweep, with this
** design's values.  Both are in the deck's units. */
void flk_list_inputs(const deck *d, flk_line_units *units, flk_list *inputs);
void flk_list_variables(const deck *d, flk_line_units *units, flk_list *variables);

#endif
