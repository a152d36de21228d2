/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.h - the largest and smallest values of columns over a deck's motion: those of some columns in one
** search (extreme.c), and those that a deck asks for (extremes.c).
*/
#ifndef FOURLINK_EXTREME_H
#define FOURLINK_EXTREME_H

#include "samples.h"

/* ------------------------------------------------------------------------------------------- one search */

typedef struct flk_extreme {
    int is_there; /* 0: the linkage cannot be assembled at any angle of the motion */
    double value; /* in the column's unit; infinite at a pole */
    double angle; /* crank angle at which it occurs, in the deck's unit of angle */
} flk_extreme;

/* The extremes of a column so far, in a search: the largest value and the smallest. */
typedef struct flk_bests {
    flk_extreme best[2];
    flk_extreme here[2]; /* since an angle started anew or a piece of an integrated motion began */
    double close;        /* relative difference of values that are equal, */
    double noise;        /* ... and their difference by rounding error, in this piece */
} flk_bests;

/* A column and its extremes. */
typedef struct flk_extreme_pair {
    flk_column c;
    flk_extreme min, max;
    int status;      /* FOURLINK_OK; FOURLINK_LONG_SEARCH, FOURLINK_TOO_LONG: they are not known */
    int is_searched; /* 1: the members above are set */
} flk_extreme_pair;

/* Find the extremes of n columns on a branch in one search, which needs room for n + 1 columns.  Their status
** is not FOURLINK_OK if it takes too many rows, or the motion too many steps. */
void flk_extreme_search(flk_analysis *a, const flk_samples_room *room, flk_bests *bests,
                        fourlink_branch branch, flk_extreme_pair *pairs, size_t n);

/* --------------------------------------------------------------------------- those that a deck asks for */

/* All are found in one search where all are wanted, or if they are
** few; else each is found alone.  The last digits may depend on which, but not on what was found before. */
typedef struct flk_extremes {
    flk_extreme_pair *together[2]; /* open, crossed */
    flk_extreme_pair *alone[2];    /* the same columns */
    flk_extreme_pair other[2];     /* any other column */
    size_t n,
        *asked; /* by flk_column.number: the column's place + 1 among these; 0: not asked for */
    int is_together; /* 1: all are always wanted */
    size_t most;
    flk_samples_room room; /* of searches, */
    flk_bests *bests;      /* of each column in one */
} flk_extremes;

/* Allocate memory for at most so many columns, in a struct that is 0; that of searches, unless there is
** some; and free both.  0 when out of memory. */
int flk_extremes_open(flk_extremes *x, size_t most);
int flk_extremes_prepare(flk_extremes *x);
void flk_extremes_close(flk_extremes *x);

/* Ask for the extremes of a column; to be called before flk_extremes_find. */
void flk_extremes_ask(flk_extremes *x, const flk_column *c);

/* An extreme of any column, FLK_MAX or FLK_MIN: FOURLINK_OK, FOURLINK_NOT_REACHED, or why it is not known.
** `all`: those of all columns asked for are wanted. */
int flk_extremes_find(flk_extremes *x, flk_analysis *a, const flk_column *c, fourlink_branch branch,
                      flk_statistic statistic, int all, flk_extreme *found);

#endif
