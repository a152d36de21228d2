/* SPDX-License-Identifier: GPL-3.0-or-later
**
** polynomial.c - a polynomial through points, by divided differences.
*/
#include "solve.h"
#include "polynomial.h"

void flk_polynomial_add(flk_polynomial *p, double x, double y)
{
    int i;

    p->x[p->n] = x;
    p->c[p->n] = y;
    for (i = 0; i < p->n; i++)
        p->c[p->n] = (p->c[p->n] - p->c[i]) / (x - p->x[i]);
    p->n++;
}

double flk_polynomial_value(const flk_polynomial *p, double x)
{
    double value = 0;
    int i;

    for (i = p->n - 1; i >= 0; i--)
        value = value * (x - p->x[i]) + p->c[i];
    return value;
}

static double slope_at(double x, void *data)
{
    const flk_polynomial *p = data;
    double value = 0, slope = 0;
    int i;

    for (i = p->n - 1; i >= 0; i--) {
        slope = slope * (x - p->x[i]) + value;
        value = value * (x - p->x[i]) + p->c[i];
    }
    return slope;
}

int flk_polynomial_find_flat(flk_polynomial *p, double low, double high, double *at)
{
    flk_bracket b = flk_bracket_of(low, high, slope_at(low, p), slope_at(high, p));

    if (!(b.f_low * b.f_high < 0))
        return 0;
    *at = flk_find_zero(slope_at, p, &b, 0);
    return 1;
}
