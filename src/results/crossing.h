/* SPDX-License-Identifier: GPL-3.0-or-later
**
** crossing.h - the crank angles at which a column has a value.
*/
#ifndef FOURLINK_CROSSING_H
#define FOURLINK_CROSSING_H

#include "samples.h"

/* Find the crank angles, in the deck's unit and in the order of the motion, at which a column of a branch has a value, in
** the column's unit; at most `max` are written, *n is their number.  FOURLINK_OK; FOURLINK_CONSTANT: it has the value at
** all of them; FOURLINK_LONG_SEARCH, FOURLINK_TOO_LONG. */
int flk_crossings_find(const flk_samples_room *room, flk_analysis *a, const flk_column *c,
                       fourlink_branch branch, double value, unsigned long max, double *angles,
                       unsigned long *n);

#endif
