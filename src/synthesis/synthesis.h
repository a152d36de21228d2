/* SPDX-License-Identifier: GPL-3.0-or-later
**
** synthesis.h - what the tasks of synthesis share: a linear system, the plane, the checks of a solution.
*/
#ifndef FOURLINK_SYNTHESIS_H
#define FOURLINK_SYNTHESIS_H

#include <gsl/gsl_complex.h>

#include "base/solve.h"
#include "mechanics/mechanics.h"

/* Below this a determinant, a singular value or a length is rounding error, relative to what it is made
** of. */
#define FLK_NOTHING 1e-12

/* Least squares: make |A x - b| small, A with n rows, 3 to FOURLINK_PRECISION_MAX, of three numbers.  Three
** rows are solved exactly.  `condition` is that of A with columns of the same length.  FOURLINK_OK, or
** FOURLINK_DEPENDENT (linear.c). */
int flk_least_squares(unsigned long n, const double A[][3], const double *b, double x[3],
                      double *condition);

/* Points of the plane are complex numbers (linear.c). */
gsl_complex flk_plane(const fourlink_vector *v);
fourlink_vector flk_vector_of(gsl_complex z);

/* 1 if |x| <= max for n numbers; if n points have valid coordinates (linear.c). */
int flk_are_within(const double *x, unsigned long n, double max);
int flk_points_within(const fourlink_vector *v, unsigned long n);

/* An angle reduced to (-pi, pi] (linear.c). */
double flk_reduced(double angle);

/* Output of a state minus the wanted one: theta4 (rad), or X of a piston (m) (check.c). */
double flk_output_error(const fourlink_state *state, fourlink_kind kind, double wanted);

/* The largest of n + 1 values from x = from on, then the peak beside it; value < 0: there is none.  Negative
** values and NaN mean that the function is not defined there (check.c). */
flk_sample flk_find_largest(flk_function *f, void *data, double from, double step, int n);

/* How a crank may pass the positions. */
typedef enum flk_freedom {
    FLK_AS_GIVEN,   /* as their theta2 goes on */
    FLK_EITHER_WAY, /* in their order, either way */
    FLK_ABOUT /* the same; points nearer to each other than they are missed may change places */
} flk_freedom;

/* Check a solution that has its design, turned links, wanted positions (at most three are met exactly) and,
** if they are not to follow from the positions, `branch`, `from` and `to`.  Sets all that follows from these.
** FOURLINK_OK, FOURLINK_INFINITE_LINK, FOURLINK_NO_LENGTH (check.c). */
int flk_check_solution(fourlink_solution *s, flk_freedom freedom);

/* Find the only solution of a task, which is 0 before, and write it to the caller's array (check.c). */
typedef int flk_finder(const void *task, fourlink_solution *s);
int flk_find_one(flk_finder *find, const void *task, unsigned long max,
                 fourlink_solution *solutions, unsigned long *n);

#endif
