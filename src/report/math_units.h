/* SPDX-License-Identifier: GPL-3.0-or-later
**
** math_units.h - the units of equations.
**
** They go together, so that no factor stands in an equation: the deck's length and force, seconds and
** radians.  Where the tables have another unit, a result is written in that one, too: 800 mm/s = 0.8 m/s.
*/
#ifndef FOURLINK_MATH_UNITS_H
#define FOURLINK_MATH_UNITS_H

#include "fourlink.h"

#define MATH_EQUATION 200 /* bytes of one that is put together */

/* What a symbol is.  Angles are in radians, and written in degrees; powers are in the unit of the tables. */
typedef enum math_unit {
    MATH_LENGTH,
    MATH_AREA,
    MATH_ANGLE,
    MATH_ONE,
    MATH_SPEED,
    MATH_ACCELERATION,
    MATH_ANGULAR_SPEED,
    MATH_ANGULAR_ACCELERATION,
    MATH_FORCE,
    MATH_TORQUE,
    MATH_ENERGY,
    MATH_POWER,
    MATH_MASS,
    MATH_INERTIA,
    MATH_TIME,
    MATH_UNITS
} math_unit;

typedef struct math_units {
    struct {
        char name[48];
        double up, down;      /* value * up / down is in SI units */
        fourlink_unit tables; /* the other one of the tables; no name: it is the same */
    } of[MATH_UNITS];
    double per_force,
        per_power; /* how many of mass * acceleration are a force; of torque / s, a power */
} math_units;

/* Take the units of a deck, by quantity. */
void math_units_take(math_units *u, const fourlink_unit *units);

/* A value in the unit of equations; in that of the tables. */
double math_units_value(const math_units *u, double si, math_unit of);
double math_units_in_tables(const math_units *u, double si, math_unit of);

/* An equation, divided by such a factor if that is not 1. */
const char *math_units_over(char out[MATH_EQUATION], const char *equation, double factor);

#endif
