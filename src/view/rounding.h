/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rounding.h - what is rounding error, of a row, an extreme, a motion.
*/
#ifndef FOURLINK_ROUNDING_H
#define FOURLINK_ROUNDING_H

#include "view.h"

/* How large the quantities of a row are, in SI units: values of at most FORMAT_ROUNDING of that are rounding
** error.  0: it is not known.  `loads` may be null. */
void view_find_sizes(const view *v, const fourlink_instant *now, const fourlink_load *loads,
                     double sizes[QUANTITY_COUNT]);

/* Set values of the deck's columns in a row to 0 where they are rounding error. */
void view_settle_row(const view *v, const fourlink_instant *now, const fourlink_load *loads,
                     double *values);

/* Smaller velocities and accelerations, in the deck's unit, are rounding beside those of the crank alone
** at a speed of omega, rad/s; 0 for another quantity. */
double view_rounding(const view *v, const char *quantity, double omega);

/* An extreme as it is written: one that is rounding is 0 and has no crank angle. */
fourlink_value view_settled(const view *v, const fourlink_value *extreme);

/* N m: smaller torques are rounding, in a motion that is not given; there without motor and flywheel Ts is
** 0. */
double view_torque_rounding(const view *v, const fourlink_forces *forces);

/* N m, Ts, or 0 if it is rounding. */
double view_driving_torque(const view *v, const fourlink_forces *forces);

#endif
