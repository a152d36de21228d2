/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_step.h - one step of the actual motion.
*/
#ifndef FOURLINK_ACTUAL_STEP_H
#define FOURLINK_ACTUAL_STEP_H

#include "corners.h"
#include "mechanics/dormand_prince.h"

/* Statuses of a step that is to be shorter. */
#define FLK_TO_REST (-1)    /* the energy vanishes within it */
#define FLK_NOT_FINITE (-2) /* it leads to no finite values */
#define FLK_INEXACT (-3)    /* a part of it, taken again, has an error above the tolerance */

/* Where a step begins. */
typedef struct flk_node {
    double s;                 /* rad passed since the first row */
    double t;                 /* s */
    double E;                 /* J, kinetic energy at the beginning and the work since then */
    double u;                 /* rad2/s2, omega2^2 / 2, from the equation of motion */
    double low, high;         /* rad passed: between them the torques are smooth */
    int by_time;              /* 1: time is the variable of this step, 0: the angle */
    double speed;             /* rad/s, of a step over time */
    double h;                 /* rad or s: the length of the step; 0 at the end */
    flk_curve_of_step within; /* E, t, u; by time s, speed, E */
} flk_node;

typedef struct flk_path {
    const deck *d;
    flk_corners *corners;
    flk_machine machine; /* the deck's, with the torque and the flywheel that are sought */
    flk_acting *acting;  /* memory for its loads */
    fourlink_branch branch;
    double tolerance; /* 1, of a step */
    double sense;     /* 1 or -1: of the range, and of the rotation */
    flk_node *node;   /* to be freed */
    size_t n, room;
    int status;           /* why it ends before its length, or FOURLINK_OK */
    int by_time;          /* 1: all steps are over time, and the crank may swing back */
    int is_steady;        /* 1: it is a cycle that repeats */
    unsigned long budget; /* trials of steps that are left, for all runs together */
    int no_memory;        /* 1: nodes are missing */
    double largest;       /* J, energy */
} flk_path;

/* Equations of a step. */
typedef struct flk_equations {
    const flk_path *p;
    double low, high;
    double slow, little; /* rad/s, J, of a step over time: of less, errors count as of this */
} flk_equations;

/* The crank angle, rad, after s. */
double flk_actual_theta2(const flk_path *p, double s);

/* J + I_f there; of a change point beside it. */
int flk_actual_whole(const flk_path *p, double s, double *whole);

/* Why no step from s is short enough: a dead position is there, where J is unbounded; nothing that moves there has
** mass; the shortest, with this status, leads to no finite values; otherwise too many steps. */
int flk_actual_no_step(const flk_path *p, double s, int status);

/* What turns the machine at a speed; speed, push and alpha2 are those in the sense of the motion. */
int flk_actual_push(const flk_path *p, const flk_machine_place *place, double speed,
                    flk_machine_push *push);

/* Set the equations and the beginning of a step at a node. */
int flk_actual_begin(const flk_path *p, flk_node *node, flk_equations *e, flk_step *step);

/* Take a step of this length: FOURLINK_OK and its error in parts of the tolerance, or a status.  Then find the values
** within it.  What is FOURLINK_OK is finite. */
int flk_actual_try(const flk_path *p, const flk_node *node, flk_step *step, double h, double *size);
int flk_actual_fill(flk_step *step, flk_curve_of_step *within);

/* Both, of a step whose length is not settled: 1 if its error is within the tolerance; 0 if it is to be shorter, and
** the status.  Returned as well: the factor by which the next try, or the next step, is longer. */
int flk_actual_attempt(const flk_path *p, flk_node *node, flk_step *step, double h, double *factor,
                       int *status);

/* Take a part of a step again, at whose end unknown i has a value. */
int flk_actual_cut(const flk_path *p, flk_node *node, flk_step *step, int i, double value);

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
