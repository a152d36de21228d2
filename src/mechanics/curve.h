/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.h - a quantity over the crank angle, given at some angles, smooth and periodic between them; or over another
** argument, not periodic.
*/
#ifndef FOURLINK_CURVE_H
#define FOURLINK_CURVE_H

#include <stddef.h>

#include "base/arithmetic.h"

typedef struct curve {
    double *x, *y; /* n points, and the first again one period later; in one piece of memory */
    double *slope; /* dy/dx at the n points of a periodic curve */
    size_t n;      /* 0: no curve */
    double
        period; /* 0: not periodic; before the first point and behind the last their values hold */
} curve;

/* The numbers for which a curve of n points needs memory. */
#define FLK_CURVE_MEMORY(n) (3 * (n) + 2)

/* Set up a curve of n >= 2 points in such memory; then, after x, increasing, and y of the points are filled in, finish it:
** x[n-1] - x[0] < period, or period 0. */
void flk_curve_place(double *memory, size_t n, curve *c);
void flk_curve_finish(double period, curve *c);

/* Its value at any x; that of the piece in which `within` lies, less than half a period away, which goes on smoothly beyond
** its ends. */
double flk_curve_value(const curve *c, double x);
double flk_curve_piece(const curve *c, double x, double within);

#endif
