/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve.c - a quantity over the crank angle, given at some angles, smooth and periodic between them.
**
** Steffen's interpolation, which does not overshoot: a pressure that is never negative at the points of
** an indicator card is not negative between them, as a cubic spline's would be beside the steep rise of
** a combustion.  It looks at the neighbours of an interval alone, so two points of the neighbouring
** periods on either side make it periodic.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_interp.h>

#include "curve.h"

#define BEYOND 2

int curve_make(const double *x, const double *y, size_t n, double period, curve *c)
{
    size_t i, total = n + 2 * BEYOND;

    memset(c, 0, sizeof *c);
    c->x = malloc(total * sizeof *c->x);
    c->y = malloc(total * sizeof *c->y);
    c->interpolation = gsl_interp_alloc(gsl_interp_steffen, total);
    if (!c->x || !c->y || !c->interpolation) {
        curve_free(c);
        return 0;
    }
    for (i = 0; i < total; i++) {
        size_t j = (i + n - BEYOND % n) % n;

        c->x[i] = x[j] + (i < BEYOND ? -period : i < n + BEYOND ? 0 : period);
        c->y[i] = y[j];
    }
    c->n = total;
    c->period = period;
    gsl_interp_init(c->interpolation, c->x, c->y, total);
    return 1;
}

double curve_value(const curve *c, double x)
{
    double first = c->x[BEYOND], y = 0;

    x -= c->period * floor((x - first) / c->period);
    if (x < first)
        x = first; /* rounding */
    gsl_interp_eval_e(c->interpolation, c->x, c->y, x, NULL, &y);
    return y;
}

void curve_free(curve *c)
{
    free(c->x);
    free(c->y);
    if (c->interpolation)
        gsl_interp_free(c->interpolation);
    memset(c, 0, sizeof *c);
}
