/* SPDX-License-Identifier: GPL-3.0-or-later
**
** units.h - the units used in the field, and the quantities of a deck.
*/
#ifndef FOURLINK_UNITS_H
#define FOURLINK_UNITS_H

#include "text.h"

/* Exponents of metre, kilogram, second and radian.  Angle is a separate dimension, so that 25 1/s is not an
** angular speed. */
typedef struct dimension {
    int m, kg, s, rad;
} dimension;

/* name, in words, exponents, unit in which bare numbers are read and columns printed, an example */
#define QUANTITY_LIST(X)                                                                        \
    X(LENGTH, "length", "a length", 1, 0, 0, 0, "m", "80 mm")                                   \
    X(AREA, "area", "an area", 2, 0, 0, 0, "m2", "5 mm2")                                       \
    X(VOLUME, "volume", "a volume", 3, 0, 0, 0, "m3", "40 cm3")                                 \
    X(ANGLE, "angle", "an angle", 0, 0, 0, 1, "deg", "40 deg")                                  \
    X(MASS, "mass", "a mass", 0, 1, 0, 0, "kg", "0.3 kg")                                       \
    X(TIME, "time", "a time", 0, 0, 1, 0, "s", "2.5 s")                                         \
    X(SPEED, "speed", "a speed", 1, 0, -1, 0, "m/s", "2 m/s")                                   \
    X(ACCELERATION, "acceleration", "an acceleration", 1, 0, -2, 0, "m/s2", "9.81 m/s2")        \
    X(ANGULAR_SPEED, "angular_speed", "an angular speed", 0, 0, -1, 1, "rad/s", "1000 rpm")     \
    X(ANGULAR_ACCELERATION, "angular_acceleration", "an angular acceleration", 0, 0, -2, 1,     \
      "rad/s2", "5 rad/s2")                                                                     \
    X(INERTIA, "inertia", "a moment of inertia", 2, 1, 0, 0, "kg.m2", "0.4 kg m2")              \
    X(FORCE, "force", "a force", 1, 1, -2, 0, "N", "50 N")                                      \
    X(TORQUE, "torque", "a torque", 2, 1, -2, 0, "N.m", "0.5 N m")                              \
    X(PRESSURE, "pressure", "a pressure", -1, 1, -2, 0, "Pa", "2 N/mm2")                        \
    X(POWER, "power", "a power", 2, 1, -3, 0, "W", "5 kW")                                      \
    X(ENERGY, "energy", "an energy", 2, 1, -2, 0, "J", "3 kJ")                                  \
    X(STIFFNESS, "stiffness", "a stiffness", 0, 1, -2, 0, "N/m", "800 N/m")                     \
    X(DAMPING, "damping", "a damping", 0, 1, -1, 0, "N.s/m", "12 N s/m")                        \
    X(TORSIONAL_STIFFNESS, "torsional_stiffness", "a torsional stiffness", 2, 1, -2, -1,        \
      "N.m/rad", "1.5 N m/rad")                                                                 \
    X(TORSIONAL_DAMPING, "torsional_damping", "a torsional damping", 2, 1, -1, -1, "N.m.s/rad", \
      "0.02 N m s/rad")                                                                         \
    X(MASS_MOMENT, "mass_moment", "a mass moment", 1, 1, 0, 0, "kg.m", "0.2 kg m")              \
    X(NUMBER, "number", "a number", 0, 0, 0, 0, "1", "0.02")

#define QUANTITY_CODE(name, key, words, m, kg, s, rad, unit, example) QUANTITY_##name,
typedef enum quantity { QUANTITY_LIST(QUANTITY_CODE) QUANTITY_COUNT } quantity;
#undef QUANTITY_CODE

typedef struct quantity_info {
    const char *name, *words;
    dimension dim;
    const char *unit, *example;
} quantity_info;

extern const quantity_info flk_quantities[QUANTITY_COUNT];

/* The quantity with this name; QUANTITY_COUNT if there is none. */
quantity flk_quantity_find(const char *name);

/* A unit: up / down SI units (and radians).  Kept as a fraction, so that 66 mm is 66/1000 m,
** rounded once. */
typedef struct unit {
    double up, down;
    dimension dim;
} unit;

/* Read a unit, such as N/mm2, kg m2, lbf-in: factors separated by a blank, '.', '*' or '-'; '/' divides by
** the next factor only; an exponent is a digit, may be negative, and may follow '^'.  Common words, and the
** spellings Nm and kgm2, are accepted.  lb and oz are masses.
** Returns 1 if it is a unit; 0 if not, with the unknown part in `bad`. */
int flk_unit_read(text t, unit *result, text *bad);

/* The same with lb and oz as forces. */
int flk_unit_read_forces(text t, unit *result);

/* The same where a dimension is wanted: lb and oz are forces if they give it so, and not as masses. */
int flk_unit_read_as(text t, dimension dim, unit *result, text *bad);

double flk_unit_to_si(double number, unit u);
double flk_unit_from_si(double si, unit u);

/* A number in another unit of the same quantity; it stays as it is if the units are the same. */
double flk_unit_in(double number, unit from, unit to);

/* The unit of a quantity in the list above: SI, or degrees. */
unit flk_unit_of_quantity(quantity q);

int flk_dimension_equal(dimension x, dimension y);

/* The unit that, in place of a word in the text of a unit, gives this dimension and is nearest to that word;
** or null. */
const char *flk_unit_nearest(text t, text word, dimension dim);

/* The unit of force or mass, `other`, that gives this dimension in place of a word of a text that is one of
** mass or of force: kgf for kg.  Returns 1 if there is one. */
int flk_unit_weight(text t, dimension dim, text *word, const char **other);

/* 1 for a bare lb or oz, which as a force is a weight. */
int flk_unit_is_weight(text t);

#endif
