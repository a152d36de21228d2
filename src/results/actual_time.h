/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_time.h - the motion of one branch over the time, for machines that may swing back.
*/
#ifndef FOURLINK_ACTUAL_TIME_H
#define FOURLINK_ACTUAL_TIME_H

#include "actual_path.h"

/* Integrate from a speed, rad/s, of either sign, for a duration; 1 if the path lasts as long. */
int flk_time_run(flk_path *p, double speed, double duration);

/* The crank at a time within the path, and where it first passes s: FOURLINK_OK, or why there is none. */
int flk_time_at(const flk_path *p, double t, flk_actual_row *row);
int flk_time_find(const flk_path *p, double s, flk_actual_row *row);

/* The angle through which the crank turns, forwards and backwards, rad. */
double flk_time_travel(const flk_path *p);

#endif
