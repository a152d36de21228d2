/* SPDX-License-Identifier: GPL-3.0-or-later
**
** crossing.h - the crank angles at which a column has a value.
*/
#ifndef FOURLINK_CROSSING_H
#define FOURLINK_CROSSING_H

#include "samples.h"

/* Find the crank angles at which a column of a branch has a value, in the column's unit.  `angles`
** receives at most `max` of them, in the deck's unit and in the order of the motion; *n is the number of
** all.  Returns FOURLINK_OK, FOURLINK_CONSTANT if the column is constant, FOURLINK_LONG_SEARCH or
** FOURLINK_TOO_LONG. */
int flk_crossings_find(const flk_samples_room *room, flk_analysis *a, const flk_column *c,
                       fourlink_branch branch, double value, unsigned long max, double *angles,
                       unsigned long *n);

#endif
