/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spring_column.h - the values of a spring's columns.
*/
#ifndef FOURLINK_SPRING_COLUMN_H
#define FOURLINK_SPRING_COLUMN_H

#include "fourlink.h"

/* Length or angle, force or torque, energy, power, in SI units: by number, in the order of the columns; NaN if the
** spring has no direction. */
double flk_spring_column_value(const fourlink_mechanism *mechanism, const fourlink_spring *spring,
                               int component, const fourlink_state *state);

#endif
