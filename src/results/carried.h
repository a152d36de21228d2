/* SPDX-License-Identifier: GPL-3.0-or-later
**
** carried.h - a value as it follows from the values above it as they were written: rounding, or a mistake,
** carried on.
*/
#ifndef FOURLINK_CARRIED_H
#define FOURLINK_CARRIED_H

#include "opened.h"

/* Room for "theta3 = 25.1 deg, theta4 = 104 deg". */
#define FLK_CARRIED_WORDS 160

/* Find the value of a column that follows from the angles and angular velocities that the same position of
** the same branch has above this expected value.
**
** Given:
**    e          an expected value, of o->d.expectations
**    n          the column that it names
** Returned:
**    value      in the unit of results
**    words      the values from which it follows
** Returned (function value):
**    FOURLINK_OK; FOURLINK_NO_SUCH_ROW: none are above it, or it does not follow from them;
**    FOURLINK_NO_MEMORY
** Notes:
** 1) Velocities follow from the angles as written, and accelerations from these and the angular
**    velocities as written.
** 2) Four-bars and slider-cranks without outputs, columns of the motion alone.
*/
int flk_carried_value(flk_opened *o, const deck_expectation *e, const flk_name *n, double *value,
                      char words[FLK_CARRIED_WORDS]);

#endif
