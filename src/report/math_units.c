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
    QUANTITY_FORCE,  QUANTITY_TORQUE,       QUANTITY_ENERGY,        QUANTITY_POWER,
    QUANTITY_MASS,   QUANTITY_INERTIA,      QUANTITY_TIME};

#define SAME 1e-12 /* relative difference of units that have two names, */
#define ONE 1e-9   /* ... of a factor that is 1 */

static void set(math_units *u, math_unit of, double up, double down, const char *first,
                const char *second, const char *third)
{
    flk_text_join(u->of[of].name, sizeof u->of[of].name, first, second, third, (char *)NULL);
    u->of[of].up = up;
    u->of[of].down = down;
}

static double size_of(const math_units *u, math_unit of)
{
    return u->of[of].up / u->of[of].down;
}

static double factor_of(double factor)
{
    return fabs(factor - 1) < ONE ? 1 : factor;
}

void math_units_take(math_units *u, const fourlink_unit *units)
{
    const fourlink_unit *L = &units[QUANTITY_LENGTH], *F = &units[QUANTITY_FORCE],
                        *m = &units[QUANTITY_MASS], *P = &units[QUANTITY_POWER];
    int i;

    set(u, MATH_LENGTH, L->up, L->down, L->name, "", "");
    set(u, MATH_AREA, L->up * L->up, L->down * L->down, L->name, "2", "");
    set(u, MATH_ANGLE, 1, 1, "", "", "");
    set(u, MATH_TIME, 1, 1, "s", "", "");
    set(u, MATH_ONE, 1, 1, "", "", "");
    set(u, MATH_SPEED, L->up, L->down, L->name, "/s", "");
    set(u, MATH_ACCELERATION, L->up, L->down, L->name, "/s2", "");
    set(u, MATH_ANGULAR_SPEED, 1, 1, "rad/s", "", "");
    set(u, MATH_ANGULAR_ACCELERATION, 1, 1, "rad/s2", "", "");
    set(u, MATH_FORCE, F->up, F->down, F->name, "", "");
    set(u, MATH_TORQUE, F->up * L->up, F->down * L->down, F->name, ".", L->name);
    set(u, MATH_ENERGY, F->up * L->up, F->down * L->down, F->name, ".", L->name);
    set(u, MATH_POWER, P->up, P->down, P->name, "", "");
    set(u, MATH_MASS, m->up, m->down, m->name, "", "");
    set(u, MATH_INERTIA, m->up * u->of[MATH_AREA].up, m->down * u->of[MATH_AREA].down, m->name, ".",
        u->of[MATH_AREA].name);
    for (i = 0; i < MATH_UNITS; i++) {
        const fourlink_unit *t = &units[quantities[i]];

        memset(&u->of[i].tables, 0, sizeof u->of[i].tables);
        if (i != MATH_ANGLE && i != MATH_ONE && i != MATH_AREA &&
            fabs(size_of(u, (math_unit)i) * t->down / t->up - 1) > SAME)
            u->of[i].tables = *t;
    }
    u->per_force =
        factor_of(size_of(u, MATH_FORCE) / size_of(u, MATH_LENGTH) / size_of(u, MATH_MASS));
    u->per_power = factor_of(size_of(u, MATH_POWER) / size_of(u, MATH_TORQUE));
}

const char *math_units_over(char out[MATH_EQUATION], const char *equation, double factor)
{
    char number[FORMAT_SIZE];

    format_general(factor > 1 ? factor : 1 / factor, 9, number);
    return factor == 1  ? flk_text_join(out, MATH_EQUATION, equation, (char *)NULL)
           : factor > 1 ? flk_text_join(out, MATH_EQUATION, "{ ", equation, " | ", number, " }",
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
