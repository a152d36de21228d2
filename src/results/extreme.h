/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.h - the largest and smallest value of a column over a deck's motion.
*/
#ifndef FOURLINK_EXTREME_H
#define FOURLINK_EXTREME_H

#include "column.h"

typedef struct flk_extreme {
    double
        value; /* in the column's unit; infinite: the column grows beyond all bounds, as velocities do
                     at a dead position */
    double angle; /* crank angle at which it occurs, in the deck's unit of angle */
} flk_extreme;

/* Find the maximum (sign 1) or the minimum (-1) of a column on a branch, refined between the rows.
** FOURLINK_OK, or FOURLINK_NOT_REACHED. */
int flk_extreme_find(flk_analysis *a, const flk_column *c, fourlink_branch branch, int sign,
                     flk_extreme *found);

#endif
