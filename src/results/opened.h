/* SPDX-License-Identifier: GPL-3.0-or-later
**
** opened.h - a deck, or one of its designs, opened for results.
*/
#ifndef FOURLINK_OPENED_H
#define FOURLINK_OPENED_H

#include "extremes.h"
#include "list.h"

/* One design of a deck. */
typedef struct flk_opened {
    deck d;
    int whole_cycle; /* as in fourlink_source */
    flk_analysis a;
    flk_extremes extremes;
    flk_column *columns; /* the columns that the deck asks for */
    size_t n_columns;
    int needs;      /* what these columns need */
    flk_list facts; /* of the last call of flk_fact_list; names by column and statistic */
    flk_list lists[FOURLINK_CONDITIONS + 1]; /* by FOURLINK_COLUMNS ... */
    fourlink_value number; /* the number asked for last that FOURLINK_INPUTS does not list */
} flk_opened;

/* Results, whose numbers a host can set. */
struct fourlink_results {
    flk_opened *now;   /* the current design */
    flk_opened *first; /* the design as it was opened, with the settings that the others share */
    deck_number *set;  /* the numbers that differ from it */
    size_t n_set;
};

#endif
