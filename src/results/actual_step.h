/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_step.h - one step of the actual motion.
*/
#ifndef FOURLINK_ACTUAL_STEP_H
#define FOURLINK_ACTUAL_STEP_H

#include "actual_path.h"

#define FLK_TO_REST (-1) /* a status: the energy vanishes within a step */

/* Equations of a step. */
typedef struct flk_equations {
    const flk_path *p;
    double low, high;
} flk_equations;

/* The crank angle, rad, after s. */
double flk_actual_theta2(const flk_path *p, double s);

/* J + I_f there; of a change point beside it. */
int flk_actual_whole(const flk_path *p, double s, double *whole);

/* What turns the machine at a speed; speed, push and alpha2 are those in the sense of the motion. */
int flk_actual_push(const flk_path *p, const flk_machine_place *place, double speed,
                    flk_machine_push *push);

/* Set the equations and the beginning of a step at a node. */
int flk_actual_begin(const flk_path *p, flk_node *node, flk_equations *e, flk_step *step);

/* Take a step of this length: FOURLINK_OK and its error in parts of the tolerance, or a status.  Then find the values
** within it. */
int flk_actual_try(const flk_path *p, const flk_node *node, flk_step *step, double h, double *size);
int flk_actual_fill(flk_step *step, flk_curve_of_step *within);

/* The part of a step at which unknown i, which passes it, has changed by this much. */
double flk_actual_part(const flk_curve_of_step *within, int i, double change);

/* The node at the end of a step of length h, or of a part of it, with these unknowns. */
void flk_actual_end_step(const flk_node *node, double h, const double *next, flk_node *after);

/* The state within the step that begins at a node: i 0, at this angle s; 1, of a step over time, at this time. */
void flk_actual_within(const flk_node *node, int i, double value, flk_node *at);

/* The time in which the crank turns through an angle from a speed, if its acceleration is constant. */
double flk_actual_time_of(double speed, double alpha, double angle);

/* Add a node; 0 if out of memory. */
int flk_actual_keep(flk_path *p, const flk_node *node);

#endif
