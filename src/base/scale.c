/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scale.c - how large the quantities of a machine are at a crank position.
**
** With the dimension m^i kg^j s^k of a quantity, and length L, angular speed w and force F ~ kg m s^-2, its
** magnitude is
**
**    F^j L^(i - j) w^n,   n = -(k + 2 j)
**
** where the angular acceleration takes the place of w^2.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "scale.h"

void flk_scale_take(double *largest, double x)
{
    if (fabs(x) > *largest && gsl_finite(x))
        *largest = fabs(x);
}

double flk_scale_of(const flk_scale *scale, quantity q)
{
    const dimension *d = &flk_quantities[q].dim;
    int n = -(d->s + 2 * d->kg), m = d->m - d->kg;
    double rate = n == 0 ? 1 : n == 1 ? scale->speed : n == 2 ? scale->acceleration : 0;

    if (m < 0)
        return 0;
    return gsl_pow_int(scale->force, d->kg) * gsl_pow_int(scale->length, m) * rate;
}
