/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.c - a quantity over the crank angle, given at some angles, smooth and periodic between them; or over another
** argument, not periodic.
**
** Steffen's interpolation (Astron. Astrophys. 239, 443, 1990), which does not overshoot: a pressure
** that is never negative at the points of an indicator card is not negative between them, as a cubic
** spline's would be beside the steep rise of a combustion.  With h_i = x_{i+1} - x_i and the secant
** s_i = (y_{i+1} - y_i) / h_i, the slope at a point and the cubic after it are
**
**    p_i  = (s_{i-1} h_i + s_i h_{i-1}) / (h_{i-1} + h_i)                                      (eq. 8)
**    y'_i = (sign s_{i-1} + sign s_i) min(|s_{i-1}|, |s_i|, |p_i| / 2)                         (eq. 11)
**    y    = y_i + d (y'_i + d (b + d a)),  d = x - x_i                                         (eq. 1)
**    a    = (y'_i + y'_{i+1} - 2 s_i) / h_i^2,  b = (3 s_i - 2 y'_i - y'_{i+1}) / h_i    (eqs. 2, 3)
**
** At the ends of a curve that is not periodic the slope is the secant beside it.
**
** GSL has it too, but GSL allocates memory, and calls its error handler if it cannot.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "curve.h"

/* The slope at a point between two intervals with these widths and secants. */
static double slope(double h0, double s0, double h1, double s1)
{
    double p = (s0 * h1 + s1 * h0) / (h0 + h1);

    return (GSL_SIGN(s0) + GSL_SIGN(s1)) * GSL_MIN(GSL_MIN(fabs(s0), fabs(s1)), fabs(p) / 2);
}

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
        c->slope[i] =
            slope(c->x[i] - c->x[i - 1], secant(c, i - 1), c->x[i + 1] - c->x[i], secant(c, i));
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

        c->slope[i] =
            slope(h0, (c->y[last + 1] - c->y[last]) / h0, h1, (c->y[i + 1] - c->y[i]) / h1);
    }
    return 1;
}

double flk_curve_value(const curve *c, double x)
{
    size_t low = 0, high = c->n, next;
    double h, s, a, b, d;

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
    h = c->x[high] - c->x[low];
    s = (c->y[high] - c->y[low]) / h;
    a = (c->slope[low] + c->slope[next] - 2 * s) / (h * h);
    b = (3 * s - 2 * c->slope[low] - c->slope[next]) / h;
    return c->y[low] + d * (c->slope[low] + d * (b + d * a));
}

void flk_curve_free(curve *c)
{
    free(c->x);
    memset(c, 0, sizeof *c);
}
