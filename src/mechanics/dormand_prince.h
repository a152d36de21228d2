/* SPDX-License-Identifier: GPL-3.0-or-later
**
** dormand_prince.h - steps of an eighth-order integration.
*/
#ifndef FOURLINK_DORMAND_PRINCE_H
#define FOURLINK_DORMAND_PRINCE_H

#include "base/arithmetic.h"

#define FLK_UNKNOWNS 3
#define FLK_STAGES 16
#define FLK_STAGE_AT_END 12
#define FLK_POWERS 7

/* Find dy/dx at x.  Returns FOURLINK_OK, or a status that ends the step. */
typedef int flk_derivative(void *context, double x, const double *y, double *dy);

/* A step.  The caller sets the members up to h, and k[0]. */
typedef struct flk_step {
    flk_derivative *f;
    void *context; /* for f */
    double x, y[FLK_UNKNOWNS];
    double h;                           /* its length, of either sign */
    double k[FLK_STAGES][FLK_UNKNOWNS]; /* derivatives: k[0] at x, k[FLK_STAGE_AT_END] at x + h */
    double next[FLK_UNKNOWNS];          /* y at x + h */
} flk_step;

/* What changes within a step. */
typedef struct flk_curve_of_step {
    double F[FLK_UNKNOWNS][FLK_POWERS];
} flk_curve_of_step;

/* Find `next` and its estimated error; then k[12]; then the values within the step, which need both.  Return
** FOURLINK_OK, or a status of f. */
int flk_step_take(flk_step *step, double *error);
int flk_step_end(flk_step *step);
int flk_step_within(flk_step *step, flk_curve_of_step *within);

/* The change of y[i] from the beginning of the step to its fraction `part`, 0 to 1; its derivative there. */
double flk_step_change(const flk_curve_of_step *within, int i, double part, double *slope);

#endif
