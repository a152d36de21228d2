/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.c - a quantity given at some crank angles, smooth between them and periodic; or over another
** argument, not periodic.
**
** Between the points the interpolation is Steffen's (base/steffen.c).
*/
#include "base/cycle.h"
#include "base/steffen.h"
#include "curve.h"

void flk_curve_place(double *memory, size_t n, curve *c)
{
    c->x = memory;
    c->y = c->x + n + 1;
    c->slope = c->y + n + 1;
    c->n = n;
}

void flk_curve_finish(double period, curve *c)
{
    size_t n = c->n, i;

    c->period = period;
    if (period <= 0)
        return;
    c->x[n] = c->x[0] + period;
    c->y[n] = c->y[0];
    for (i = 0; i < n; i++) {
        size_t last = (i + n - 1) % n;
        double h0 = c->x[last + 1] - c->x[last], h1 = c->x[i + 1] - c->x[i];

        c->slope[i] = flk_steffen_slope(h0, (c->y[last + 1] - c->y[last]) / h0, h1,
                                        (c->y[i + 1] - c->y[i]) / h1);
    }
}

double flk_curve_piece(const curve *c, double x, double within)
{
    double d, beside = x - within;
    size_t low;

    if (c->period <= 0)
        return flk_steffen_on(c->x, c->y, c->n, x, within);
    beside = flk_cycle_beside(beside, c->period);
    within = c->x[0] + flk_cycle_place(within - c->x[0], 0, c->period);
    low = flk_steffen_find(c->x, c->n + 1, within);
    d = within - c->x[low] + beside;
    return flk_steffen_value(d, c->x[low + 1] - c->x[low], c->y[low], c->y[low + 1], c->slope[low],
                             c->slope[(low + 1) % c->n]);
}
