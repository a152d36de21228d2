/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mean.h - integrals along the motion: mean and root mean square of a column; the turning moment over a
** cycle, and the flywheel that it needs.
*/
#ifndef FOURLINK_MEAN_H
#define FOURLINK_MEAN_H

#include "samples.h"

/* Allocate the memory for the means of at most so many columns, until flk_analysis_close; 0 when out of
** memory. */
int flk_means_open(flk_analysis *a, size_t most);

/* FLK_MEAN or FLK_RMS of a column, in its unit; infinite if the integral is.  `room` is for two
** columns.  Both are found at once.  Returns FOURLINK_OK, FOURLINK_NOT_REACHED, FOURLINK_NO_MEAN,
** FOURLINK_LONG_SEARCH, FOURLINK_TOO_LONG or, for a motion of one instant, the status of its row. */
int flk_mean_find(flk_analysis *a, const flk_samples_room *room, const flk_column *c,
                  fourlink_branch branch, flk_statistic statistic, double *mean);

/* Allocate the memory that the turning moment of a deck needs, until flk_analysis_close; 0 when out of
** memory. */
int flk_turning_open(flk_analysis *a);

/* The turning moment at the deck's speed, which is taken as constant; null if it is not defined: the
** crank does not turn, or is accelerated, or does not reach all angles, or there are no forces. */
const fourlink_turning *flk_turning_find(flk_analysis *a, fourlink_branch branch);

#endif
