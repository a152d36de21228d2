/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_path.h - the motion of one branch from a given energy: steps of the integration, and any angle between them.
*/
#ifndef FOURLINK_ACTUAL_PATH_H
#define FOURLINK_ACTUAL_PATH_H

#include "actual_row.h"
#include "actual_step.h"

/* Integrate from this speed, rad/s, >= 0, over a length in rad; 1 if the path has this length. */
int flk_path_run(flk_path *p, double speed, double length);

/* The last node: where it ends. */
const flk_node *flk_path_end(const flk_path *p);

/* The last node at or before a value: i 0, of s; 1, of the time. */
const flk_node *flk_path_before(const flk_path *p, int i, double value);

/* The crank after it has passed s, within the path: FOURLINK_OK, or why there is no position. */
int flk_path_at(const flk_path *p, double s, flk_actual_row *row);

/* The row at a state within a step. */
int flk_path_row(const flk_path *p, const flk_node *at, flk_actual_row *row);

/* By which the logarithm of a small difference of energy grows over the path:
** integral of d(T_m + Q)/d(omega2) / ((J + I_f) omega2) dtheta2; NaN if a torque is not known. */
double flk_path_growth(const flk_path *p);

#endif
