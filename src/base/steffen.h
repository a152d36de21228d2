/* SPDX-License-Identifier: GPL-3.0-or-later
**
** steffen.h - Steffen's interpolation, which does not overshoot.
*/
#ifndef FOURLINK_STEFFEN_H
#define FOURLINK_STEFFEN_H

#include <stddef.h>

#include "arithmetic.h"

/* The slope at a point between two intervals with these widths and secants. */
double flk_steffen_slope(double h0, double s0, double h1, double s1);

/* The value at distance d from the first of two points h apart, with these values and slopes. */
double flk_steffen_value(double d, double h, double y0, double y1, double slope0, double slope1);

/* The last of the n - 1 intervals between increasing x that begins at or before `at`; the first if none
** does. */
size_t flk_steffen_find(const double *x, size_t n, double at);

/* The value of a curve through n >= 2 points with increasing x.  The slope at an end is that of the first or
** last secant; beyond the ends the curve is constant.  The piece that contains `within` is used, and is
** continued smoothly beyond its ends. */
double flk_steffen_on(const double *x, const double *y, size_t n, double at, double within);

#endif
