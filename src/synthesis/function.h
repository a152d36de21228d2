/* SPDX-License-Identifier: GPL-3.0-or-later
**
** function.h - the equation of a function generator, and what its fits share.
*/
#ifndef FOURLINK_FUNCTION_H
#define FOURLINK_FUNCTION_H

#include "synthesis.h"

/* What a point weighs (function.c). */
double flk_weight_of(const fourlink_function_task *task, unsigned long i);

/* The length that the others are compared with, m: the ground, or the largest |X| (function.c). */
double flk_length_unit(const fourlink_function_task *task);

/* Lengths, and which links are turned by 180 deg, from K or S.  FOURLINK_OK, FOURLINK_INFINITE_LINK,
** FOURLINK_NO_LENGTH, FOURLINK_NO_LINKAGE (function.c). */
int flk_set_lengths(const fourlink_function_task *task, const double K[3], fourlink_solution *s);

/* Output of the linkage minus the wanted one (function.c). */
int flk_error_at(const fourlink_solution *s, const fourlink_mechanism *mechanism,
                 fourlink_branch branch, double theta2, double wanted, double *error);

/* Find K, the branch and is_better_longer of the fit of the output (fit.c). */
void flk_fit_output(const fourlink_function_task *task, double K[3], fourlink_solution *s);

#endif
