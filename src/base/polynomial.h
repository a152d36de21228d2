/* SPDX-License-Identifier: GPL-3.0-or-later
**
** polynomial.h - a polynomial through points, by divided differences.
*/
#ifndef FOURLINK_POLYNOMIAL_H
#define FOURLINK_POLYNOMIAL_H

#include "arithmetic.h"

#define FLK_POLYNOMIAL_MOST 10

/* Begin with n = 0. */
typedef struct flk_polynomial {
    int n;
    double x[FLK_POLYNOMIAL_MOST], c[FLK_POLYNOMIAL_MOST];
} flk_polynomial;

/* Add a point; at most FLK_POLYNOMIAL_MOST. */
void flk_polynomial_add(flk_polynomial *p, double x, double y);

double flk_polynomial_value(const flk_polynomial *p, double x);

/* Find where the slope is 0 between two places; returns 0 unless it has opposite signs at them. */
int flk_polynomial_find_flat(flk_polynomial *p, double low, double high, double *at);

#endif
