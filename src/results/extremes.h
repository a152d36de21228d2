/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extremes.h - the extremes that a deck asks for.
*/
#ifndef FOURLINK_EXTREMES_H
#define FOURLINK_EXTREMES_H

#include "extreme.h"

/* All are found in one search where all are wanted, or if they are
** few; else each is found alone.  The last digits may depend on which, but not on what was found before. */
typedef struct flk_extremes {
    flk_extreme_pair *together[2]; /* open, crossed */
    flk_extreme_pair *alone[2];    /* the same columns */
    flk_extreme_pair other[2];     /* any other column */
    size_t n,
        *asked; /* by flk_column.number: the column's place + 1 among these; 0: not asked for */
    int is_together; /* 1: all are always wanted */
    flk_samples_room room;
    flk_bests *bests; /* of each column, in a search */
} flk_extremes;

/* Allocate memory for at most so many columns, in a struct that is 0, and free it.  0 when out of memory. */
int flk_extremes_open(flk_extremes *x, size_t most);
void flk_extremes_close(flk_extremes *x);

/* Ask for the extremes of a column; to be called before flk_extremes_find. */
void flk_extremes_ask(flk_extremes *x, const flk_column *c);

/* An extreme of any column, FLK_MAX or FLK_MIN: FOURLINK_OK, FOURLINK_NOT_REACHED, or why it is not known.
** `all`: those of all columns asked for are wanted. */
int flk_extremes_find(flk_extremes *x, flk_analysis *a, const flk_column *c, fourlink_branch branch,
                      flk_statistic statistic, int all, flk_extreme *found);

#endif
