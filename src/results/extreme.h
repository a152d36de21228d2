/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.h - the largest and smallest values of columns over a deck's motion, found together.
*/
#ifndef FOURLINK_EXTREME_H
#define FOURLINK_EXTREME_H

#include "column.h"

typedef struct flk_extreme {
    int is_there; /* 0: the linkage cannot be assembled at any angle of the motion */
    double value; /* in the column's unit; infinite: unbounded, as velocities are at a dead position */
    double angle; /* crank angle at which it occurs, in the deck's unit of angle */
} flk_extreme;

/* A column and its extremes. */
typedef struct flk_extreme_pair {
    flk_column c;
    flk_extreme min, max;
} flk_extreme_pair;

/* How many numbers of memory a search for the extremes of n columns needs. */
size_t flk_extreme_size(size_t n);

/* Find the extremes of n columns on a branch, in one pass over the motion, refined between its samples. */
void flk_extreme_find(flk_analysis *a, fourlink_branch branch, flk_extreme_pair *pairs, size_t n,
                      double *memory);

#endif
