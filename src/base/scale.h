/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scale.h - how large the quantities of a machine are at a crank position: beside that, rounding error is 0.
*/
#ifndef FOURLINK_SCALE_H
#define FOURLINK_SCALE_H

#include "units.h"

typedef struct flk_scale {
    double length;              /* m, of the links */
    double speed, acceleration; /* rad/s, rad/s2, of the links */
    double force;               /* N, in the pins and of loads */
} flk_scale;

/* The largest magnitude so far. */
void flk_scale_take(double *largest, double x);

/* The magnitude of a quantity, in SI units; 0 if it does not follow, as that of a time. */
double flk_scale_of(const flk_scale *scale, quantity q);

#endif
