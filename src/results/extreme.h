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

/* The extremes of a column so far, in a search: the largest value and the smallest. */
typedef struct flk_bests {
    flk_extreme best[2];
    flk_extreme here[2]; /* since an angle started anew or a piece of an integrated motion began */
    double close;        /* relative difference of values that are equal */
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

#endif
