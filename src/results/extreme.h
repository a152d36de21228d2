/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.h - the largest and smallest value of a column over a deck's motion.
*/
#ifndef FOURLINK_EXTREME_H
#define FOURLINK_EXTREME_H

#include "column.h"

typedef struct extreme {
    double value; /* in the column's unit */
    double angle; /* crank angle at which it occurs, in the deck's unit of angle */
} extreme;

typedef enum extreme_result {
    EXTREME_NONE, /* the links reach at no angle of the motion */
    EXTREME_FOUND,
    EXTREME_UNBOUNDED /* the column grows beyond all bounds, as velocities do at a dead position */
} extreme_result;

/* Find the maximum (sign 1) or the minimum (-1) of a column on a branch, refined between the rows. */
extreme_result extreme_find(analysis *a, const column *c, fourlink_branch branch, int sign,
                            extreme *found);

#endif
