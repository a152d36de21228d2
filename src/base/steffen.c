/* SPDX-License-Identifier: GPL-3.0-or-later
**
** steffen.c - Steffen's interpolation (Astron. Astrophys. 239, 443, 1990), which does not overshoot: a
** pressure that is never negative at the points of an indicator card is not negative between them either,
** unlike that of a cubic spline beside the steep rise of a combustion.  With h_i = x_{i+1} - x_i and the
** secant s_i = (y_{i+1} - y_i) / h_i, the slope at a point and the cubic after it are
**
**    p_i  = (s_{i-1} h_i + s_i h_{i-1}) / (h_{i-1} + h_i)                                      (eq. 8)
**    y'_i = (sign s_{i-1} + sign s_i) min(|s_{i-1}|, |s_i|, |p_i| / 2)                         (eq. 11)
**    y    = y_i + d (y'_i + d (b + d a)),  d = x - x_i                                         (eq. 1)
**    a    = (y'_i + y'_{i+1} - 2 s_i) / h_i^2,  b = (3 s_i - 2 y'_i - y'_{i+1}) / h_i    (eqs. 2, 3)
**
** GSL has this interpolation too, but allocates memory, and calls its error handler on failure.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "steffen.h"

double flk_steffen_slope(double h0, double s0, double h1, double s1)
{
    double p = (s0 * h1 + s1 * h0) / (h0 + h1);

    return (GSL_SIGN(s0) + GSL_SIGN(s1)) * GSL_MIN(GSL_MIN(fabs(s0), fabs(s1)), fabs(p) / 2);
}

double flk_steffen_value(double d, double h, double y0, double y1, double slope0, double slope1)
{
    double s = (y1 - y0) / h;
    double a = (slope0 + slope1 - 2 * s) / (h * h);
    double b = (3 * s - 2 * slope0 - slope1) / h;

    return y0 + d * (slope0 + d * (b + d * a));
}

size_t flk_steffen_find(const double *x, size_t n, double at)
{
    size_t low = 0, high = n - 1;

    while (high - low > 1) {
        size_t middle = (low + high) / 2;

        if (x[middle] <= at)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static double secant(const double *x, const double *y, size_t i)
{
    return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
}

static double slope_of_node(const double *x, const double *y, size_t n, size_t i)
{
    if (i == 0)
        return secant(x, y, 0);
    if (i == n - 1)
        return secant(x, y, i - 1);
    return flk_steffen_slope(x[i] - x[i - 1], secant(x, y, i - 1), x[i + 1] - x[i],
                             secant(x, y, i));
}

double flk_steffen_on(const double *x, const double *y, size_t n, double at, double within)
{
    size_t i;

    if (!(within > x[0]) || within >= x[n - 1])
        return within >= x[n - 1] ? y[n - 1] : y[0];
    i = flk_steffen_find(x, n, within);
    return flk_steffen_value(at - x[i], x[i + 1] - x[i], y[i], y[i + 1], slope_of_node(x, y, n, i),
                             slope_of_node(x, y, n, i + 1));
}
