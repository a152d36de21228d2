/* SPDX-License-Identifier: GPL-3.0-or-later
**
** cycle.c - whole cycles, the place within one, and the distance from the nearest end of one.
*/
#include <float.h>
#include <math.h>

#include "arithmetic.h"
#include "cycle.h"

#define ROUNDING 1e-12 /* of the cycle; */
#define DIGITS 8       /* ... or last digits of x, if it has many cycles before it */

double flk_cycle_count(double x, double cycle)
{
    double n = x / cycle, rounding = DIGITS * DBL_EPSILON * fabs(n);

    return floor(n + (rounding > ROUNDING ? rounding : ROUNDING));
}

double flk_cycle_place(double x, double from, double cycle)
{
    double place = x - cycle * flk_cycle_count(x - from, cycle);

    return (place - from) / cycle < 0 ? from : place;
}

double flk_cycle_nearest(double x, double cycle)
{
    return floor(x / cycle + 0.5);
}

double flk_cycle_beside(double x, double cycle)
{
    return x - cycle * flk_cycle_nearest(x, cycle);
}
