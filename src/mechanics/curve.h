/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.h - a quantity given at some crank angles, smooth between them and periodic; or over another
** argument, not periodic.
*/
#ifndef FOURLINK_CURVE_H
#define FOURLINK_CURVE_H

#include <stddef.h>

#include "base/arithmetic.h"

typedef struct curve {
    double *x, *y; /* n points, and the first again one period later; in one block of memory */
    double *slope; /* dy/dx at the n points of a periodic curve */
    size_t n;      /* 0: no curve */
    double period; /* 0: not periodic; constant before the first point and after the last */
} curve;

/* The number of doubles that a curve of n points needs. */
#define FLK_CURVE_MEMORY(n) (3 * (n) + 2)

/* Set up a curve of n >= 2 points in such memory; then fill in x, increasing, and y of the points, and finish
** it: x[n-1] - x[0] < period, or period 0. */
void flk_curve_place(double *memory, size_t n, curve *c);
void flk_curve_finish(double period, curve *c);

/* The value at any x, by the piece that contains `within`, less than half a period away, continued smoothly
** beyond its ends. */
double flk_curve_piece(const curve *c, double x, double within);

#endif
