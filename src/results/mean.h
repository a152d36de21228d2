/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mean.h - the mean and the root mean square of a column over the crank angles of a deck's motion.
*/
#ifndef FOURLINK_MEAN_H
#define FOURLINK_MEAN_H

#include "column.h"

/* FLK_MEAN or FLK_RMS of a column, in its unit; infinite if the integral is.  Returns FOURLINK_OK,
** FOURLINK_NOT_REACHED, FOURLINK_NO_MEAN, FOURLINK_LONG_SEARCH, FOURLINK_TOO_LONG or, for a motion of one
** instant, the status of its row. */
int flk_mean_find(flk_analysis *a, const flk_column *c, fourlink_branch branch,
                  flk_statistic statistic, double *mean);

#endif
