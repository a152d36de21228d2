/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.h - a quantity over the crank angle, given at some angles, smooth and periodic between them.
*/
#ifndef FOURLINK_CURVE_H
#define FOURLINK_CURVE_H

#include <stddef.h>

typedef struct curve {
    double *x, *y; /* the points, and two of the neighbouring periods on either side */
    size_t n;      /* 0: no curve */
    double period;
    void *interpolation; /* GSL's */
} curve;

/* Make a curve through n >= 2 points, x rising, x[n-1] - x[0] < period.  1, or 0 when out of memory. */
int curve_make(const double *x, const double *y, size_t n, double period, curve *c);

/* Its value at any x. */
double curve_value(const curve *c, double x);

void curve_free(curve *c);

#endif
