/* SPDX-License-Identifier: GPL-3.0-or-later
**
** dormand_prince.h - steps of an integration of order 8.
*/
#ifndef FOURLINK_DORMAND_PRINCE_H
#define FOURLINK_DORMAND_PRINCE_H

#define FLK_UNKNOWNS 4 /* at most */

/* dy/dx at x: FOURLINK_OK, or a status that ends the step. */
typedef int flk_derivative(void *context, double x, const double *y, double *dy);

/* One step.
**
** Given:
**    f, context  the equations
**    n           how many
**    x, y, dy    where the step begins, and the derivatives there
**    h           its length, of either sign
** Returned:
**    next        y at x + h; may be y
**    error       the estimated error of each; null: not wanted
** Returned (function value):
**    FOURLINK_OK, or the status of f; then nothing is returned
*/
int flk_dormand_prince(flk_derivative *f, void *context, int n, double x, const double *y,
                       const double *dy, double h, double *next, double *error);

#endif
