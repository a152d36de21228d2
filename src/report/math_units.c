/* SPDX-License-Identifier: GPL-3.0-or-later
**
** math_units.c - the units of equations.
*/
#include <math.h>
#include <string.h>

#include "base/quantity.h"
#include "base/text.h"
#include "math_units.h"
#include "system/format.h"

/* What the tables call the quantities. */
static const quantity quantities[MATH_UNITS] = {
    QUANTITY_LENGTH, QUANTITY_AREA,         QUANTITY_ANGLE,         QUANTITY_NUMBER,
    QUANTITY_SPEED,  QUANTITY_ACCELERATION, QUANTITY_ANGULAR_SPEED, QUANTITY_ANGULAR_ACCELERATION,
    QUANTITY_FORCE,  QUANTITY_TORQUE,       QUANTITY_POWER,         QUANTITY_MASS,
    QUANTITY_INERTIA};

#define SAME 1e-12 /* relative difference of units that have two names */

/* `first` and what follows it, times `other` if that is not null. */
static void set(math_units *u, math_unit of, const fourlink_unit *first, const char *after,
                const fourlink_unit *other)
{
    flk_text_join(u->of[of].name, sizeof u->of[of].name, first->name, after,
                  other ? other->name : "", (char *)NULL);
    u->of[of].up = first->up * (other ? other->up : 1);
    u->of[of].down = first->down * (other ? other->down : 1);
}

static double size_of(const math_units *u, math_unit of)
{
    return u->of[of].up / u->of[of].down;
}

void math_units_take(math_units *u, const fourlink_unit *units)
{
    static const fourlink_unit none = {"", 1, 1, 0}, turning = {"rad", 1, 1, 0};
    const fourlink_unit *length = &units[QUANTITY_LENGTH], *force = &units[QUANTITY_FORCE],
                        *mass = &units[QUANTITY_MASS];
    int i;

    set(u, MATH_LENGTH, length, "", NULL);
    set(u, MATH_AREA, length, "2", NULL);
    u->of[MATH_AREA].up *= length->up;
    u->of[MATH_AREA].down *= length->down;
    set(u, MATH_ANGLE, &none, "", NULL);
    set(u, MATH_ONE, &none, "", NULL);
    set(u, MATH_SPEED, length, "/s", NULL);
    set(u, MATH_ACCELERATION, length, "/s2", NULL);
    set(u, MATH_ANGULAR_SPEED, &turning, "/s", NULL);
    set(u, MATH_ANGULAR_ACCELERATION, &turning, "/s2", NULL);
    set(u, MATH_FORCE, force, "", NULL);
    set(u, MATH_TORQUE, force, ".", length);
    set(u, MATH_POWER, &units[QUANTITY_POWER], "", NULL);
    set(u, MATH_MASS, mass, "", NULL);
    set(u, MATH_INERTIA, mass, ".", length);
    flk_text_join(u->of[MATH_INERTIA].name, sizeof u->of[MATH_INERTIA].name, mass->name, ".",
                  length->name, "2", (char *)NULL);
    u->of[MATH_INERTIA].up *= length->up;
    u->of[MATH_INERTIA].down *= length->down;
    for (i = 0; i < MATH_UNITS; i++) {
        const fourlink_unit *t = &units[quantities[i]];

        memset(&u->of[i].tables, 0, sizeof u->of[i].tables);
        if (i != MATH_ANGLE && i != MATH_ONE && i != MATH_AREA &&
            fabs(size_of(u, (math_unit)i) * t->down / t->up - 1) > SAME)
            u->of[i].tables = *t;
    }
    u->per_force = size_of(u, MATH_FORCE) / size_of(u, MATH_LENGTH) * mass->down / mass->up;
    u->per_power = size_of(u, MATH_POWER) / size_of(u, MATH_TORQUE);
}

#define ONE 1e-9 /* relative difference of a factor that is 1 */

const char *math_units_over(char out[MATH_EQUATION], const char *equation, double factor)
{
    char number[FORMAT_SIZE];

    format_general(factor > 1 ? factor : 1 / factor, 9, number);
    if (fabs(factor - 1) < ONE)
        return flk_text_join(out, MATH_EQUATION, equation, (char *)NULL);
    return factor > 1 ? flk_text_join(out, MATH_EQUATION, "{ ", equation, " | ", number, " }",
                                      (char *)NULL)
                      : flk_text_join(out, MATH_EQUATION, equation, " * ", number, (char *)NULL);
}

double math_units_value(const math_units *u, double si, math_unit of)
{
    return si * u->of[of].down / u->of[of].up;
}

double math_units_in_tables(const math_units *u, double si, math_unit of)
{
    return si * u->of[of].tables.down / u->of[of].tables.up;
}
