/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.h - the largest and smallest values of columns over a deck's motion, found together.
*/
#ifndef FOURLINK_EXTREME_H
#define FOURLINK_EXTREME_H

#include "samples.h"

typedef struct flk_extreme {
    int is_there; /* 0: the linkage cannot be assembled at any angle of the motion */
    double value; /* in the column's unit; infinite at a pole */
    double angle; /* crank angle at which it occurs, in the deck's unit of angle */
} flk_extreme;

/* A column and its extremes. */
typedef struct flk_extreme_pair {
    flk_column c;
    flk_extreme min, max;
    int status; /* FOURLINK_OK; FOURLINK_LONG_SEARCH, FOURLINK_TOO_LONG: they are not known */
} flk_extreme_pair;

/* The extremes that a deck asks for.  The first one wanted is found alone, unless all are wanted or there
** are few.  With the second, all are found in one search. */
typedef struct flk_extremes {
    flk_extreme_pair *pairs[2]; /* open, crossed; the last one is for any other column */
    size_t n;
    int is_together;  /* 1: all are wanted */
    int has_other[2]; /* 1: the extremes of that column are known */
    int is_begun[2];  /* 1: one of the n has been found alone */
    int is_known[2];  /* 1: all n are known */
    flk_samples_room room;
    struct flk_bests *bests; /* of each column, in a search */
} flk_extremes;

/* Allocate memory for at most so many columns, and free it.  0 when out of memory. */
int flk_extremes_open(flk_extremes *x, size_t most);
void flk_extremes_close(flk_extremes *x);

/* Ask for the extremes of a column; to be called before flk_extremes_of. */
void flk_extremes_ask(flk_extremes *x, const flk_column *c);

/* The extremes of any column; valid until the next call. */
const flk_extreme_pair *flk_extremes_of(flk_extremes *x, flk_analysis *a, const flk_column *c,
                                        fourlink_branch branch);

#endif
