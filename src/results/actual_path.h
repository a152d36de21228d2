/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_path.h - the motion of one branch from a given energy: steps of the integration, and any angle between them.
*/
#ifndef FOURLINK_ACTUAL_PATH_H
#define FOURLINK_ACTUAL_PATH_H

#include "actual.h"
#include "actual_machine.h"
#include "mechanics/dormand_prince.h"

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
    const struct flk_analysis *a;
    flk_machine machine;
    double tolerance; /* 1, of a step */
    double sense;     /* 1 or -1: of the range, and of the rotation */
    flk_node *node;   /* to be freed */
    size_t n, room;
    int status;     /* why it ends before its length, or FOURLINK_OK */
    int by_time;    /* 1: all steps are over time, and the crank may swing back */
    int is_steady;  /* 1: it is a cycle that repeats */
    int no_memory;  /* 1: nodes are missing */
    double largest; /* J, energy */
} flk_path;

/* Integrate from this speed, rad/s, >= 0, over a length in rad; 1 if the path has this length. */
int flk_path_run(flk_path *p, double speed, double length);

/* The last node: where it ends. */
const flk_node *flk_path_end(const flk_path *p);

/* The crank after it has passed s, within the path: FOURLINK_OK, or why there is no position. */
int flk_path_at(const flk_path *p, double s, flk_actual_row *row);

/* The row at a state within a step. */
int flk_path_row(const flk_path *p, const flk_node *at, flk_actual_row *row);

/* By which the logarithm of a small difference of energy grows over the path:
** integral of d(T_m + Q)/d(omega2) / ((J + I_f) omega2) dtheta2. */
int flk_path_growth(const flk_path *p, double *growth);

#endif
