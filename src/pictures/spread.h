/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spread.h - the spread of an output of many designs over one quantity: extremes, quartiles and median.
*/
#ifndef FOURLINK_SPREAD_H
#define FOURLINK_SPREAD_H

#include <stddef.h>

enum { SPREAD_LEAST, SPREAD_LOWER, SPREAD_MEDIAN, SPREAD_UPPER, SPREAD_GREATEST, SPREAD_SIZES };

#define SPREAD_MOST 200 /* groups */

/* A design; a group of designs with the same x, or of neighbours, at the mean of theirs. */
typedef struct spread_point {
    double x, y;
} spread_point;

typedef struct spread_group {
    double x, y[SPREAD_SIZES];
} spread_group;

/* Sort the designs by x into groups: of the same x where there are few, else of as many designs each.
** Returns how many. */
size_t spread_find(spread_point *designs, size_t n, spread_group groups[SPREAD_MOST]);

#endif
