/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.c - a quantity over the crank angle, given at some angles, smooth and periodic between them; or over another
** argument, not periodic.
**
** Between the points the interpolation is Steffen's (base/steffen.c).  At the ends of a curve that is not periodic the
** slope is the secant beside it.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/steffen.h"
#include "curve.h"

static double secant(const curve *c, size_t i)
{
    return (c->y[i + 1] - c->y[i]) / (c->x[i + 1] - c->x[i]);
}

/* Of a curve that is not periodic. */
static void set_open_slopes(curve *c)
{
    size_t i, last = c->n - 1;

    c->slope[0] = secant(c, 0);
    c->slope[last] = secant(c, last - 1);
    for (i = 1; i < last; i++)
        c->slope[i] = flk_steffen_slope(c->x[i] - c->x[i - 1], secant(c, i - 1),
                                        c->x[i + 1] - c->x[i], secant(c, i));
}

int flk_curve_make(const double *x, const double *y, size_t n, double period, curve *c)
{
    size_t i;

    memset(c, 0, sizeof *c);
    c->x = malloc((3 * n + 2) * sizeof *c->x);
    if (!c->x)
        return 0;
    c->y = c->x + n + 1;
    c->slope = c->y + n + 1;
    c->n = n;
    c->period = period;
    memcpy(c->x, x, n * sizeof *x);
    memcpy(c->y, y, n * sizeof *y);
    if (period <= 0) {
        set_open_slopes(c);
        return 1;
    }
    c->x[n] = x[0] + period;
    c->y[n] = y[0];
    for (i = 0; i < n; i++) {
        size_t last = (i + n - 1) % n;
        double h0 = c->x[last + 1] - c->x[last], h1 = c->x[i + 1] - c->x[i];

        c->slope[i] = flk_steffen_slope(h0, (c->y[last + 1] - c->y[last]) / h0, h1,
                                        (c->y[i + 1] - c->y[i]) / h1);
    }
    return 1;
}

double flk_curve_value(const curve *c, double x)
{
    size_t low = 0, high = c->n, next;
    double d;

    if (c->period > 0) {
        x = fmod(x - c->x[0], c->period);
        x = c->x[0] + (x < 0 ? x + c->period : x);
    } else {
        high = c->n - 1;
        if (!(x > c->x[0]) || x >= c->x[high])
            return x >= c->x[high] ? c->y[high] : c->y[0];
    }
    while (high - low > 1) {
        size_t middle = (low + high) / 2;

        if (c->x[middle] <= x)
            low = middle;
        else
            high = middle;
    }
    next = high % c->n;
    d = x - c->x[low];
    if (d < 0)
        d = 0; /* rounding */
    return flk_steffen_value(d, c->x[high] - c->x[low], c->y[low], c->y[high], c->slope[low],
                             c->slope[next]);
}

void flk_curve_free(curve *c)
{
    free(c->x);
    memset(c, 0, sizeof *c);
}
