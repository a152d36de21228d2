/* SPDX-License-Identifier: GPL-3.0-or-later
**
** path.h - the motion of one branch from a given speed: integration steps, and any instant between them.
*/
#ifndef FOURLINK_PATH_H
#define FOURLINK_PATH_H

#include "corners.h"
#include "equation.h"
#include "mechanics/dormand_prince.h"

/* The crank at one angle, and the columns of the actual motion. */
typedef struct flk_actual_row {
    fourlink_crank crank;
    double angle;           /* in the deck's unit */
    double time;            /* s */
    double T_motor;         /* N m, at the crank */
    double J;               /* kg m2, of the links, without flywheel and rotor */
    double energy;          /* J, kinetic, with flywheel and rotor */
    double energy_residual; /* 1, energy minus work done, relative to the largest energy */
} flk_actual_row;

/* The facts of the motion of one branch; NaN: not defined. */
typedef struct flk_actual_facts {
    int status;   /* FOURLINK_OK, or why the motion ends before the last row, or has none */
    int no_cycle; /* FOURLINK_OK, or why the facts of the steady motion of a run-up are missing */
    double end_angle;           /* in the deck's unit: where the motion ends, if the status is not
                                   FOURLINK_OK */
    double mean_speed;          /* rad/s, the time mean over the last cycle */
    double mean_speed_textbook; /* rad/s, (largest + smallest) / 2 over that cycle */
    double period;              /* s, of that cycle */
    double fluctuation_exact;   /* 1, (largest - smallest) / mean speed */
    double steady_rate;         /* 1, factor by which a difference from the steady cycle shrinks per
                                   cycle */
    double stall_angle;         /* in the deck's unit */
    double run_up_time;  /* s, until the speed first reaches the mean speed of the steady cycle */
    double motor_torque; /* N m, of a motor that balances: at the crank */
    double flywheel;     /* kg m2, of the flywheel alone; found if requested */
    double inertia;      /* kg m2, of flywheel and rotor at the crank */
} flk_actual_facts;

/* Where a step begins. */
typedef struct flk_node {
    double t;                 /* s */
    double y[FLK_UNKNOWNS];   /* rad passed since the first row, rad/s, J */
    double residual;          /* J, excess so far of the energy of the speed over y */
    double h;                 /* s, of the step, which may extend beyond the next node; 0 at the
                                 end */
    flk_curve_of_step within; /* the unknowns within it */
    int is_at_rest;           /* 1: it stays here */
} flk_node;

typedef struct flk_path {
    const deck *d;
    flk_corners *corners;
    flk_equation equation;
    double tolerance; /* 1, of a step */
    flk_node *node;   /* to be freed */
    size_t n, room;
    int status;           /* why it ends early, or FOURLINK_OK */
    int swings;           /* 1: the crank may swing back */
    int is_steady;        /* 1: it is a cycle that repeats */
    unsigned long budget; /* trial steps left, for all runs together */
    int no_memory;        /* 1: nodes are missing */
    double largest;       /* J, energy */
} flk_path;

/* Integrate from a speed >= 0, rad/s, over an angle, rad, which a crank that comes to rest does not complete;
** or from a speed of either sign for a duration, s, during which it may swing back.  1 if the path reaches
** its full length. */
int flk_path_run(flk_path *p, double speed, double length);
int flk_path_run_for(flk_path *p, double speed, double duration);

/* The end of the path. */
const flk_node *flk_path_end(const flk_path *p);

/* The unknowns at a fraction of the step that begins at a node.  The fraction, up to `most`, at which unknown
** i has a value; the fraction at which the speed has a peak, or `to` if its slopes at both ends have one
** sign. */
void flk_node_within(const flk_node *node, double part, flk_node *at);
double flk_node_part(const flk_node *node, int i, double value, double most);
double flk_node_peak(const flk_node *node, double from, double to);

/* The unknowns when the crank first passes s. */
int flk_path_node_at(const flk_path *p, double s, flk_node *at);

/* The crank when it first passes s, to rounding; at a time within the path; in the state of a node:
** FOURLINK_OK, or why there is none. */
int flk_path_at(const flk_path *p, double s, flk_actual_row *row);
int flk_path_at_time(const flk_path *p, double t, flk_actual_row *row);
int flk_path_row(const flk_path *p, const flk_node *at, flk_actual_row *row);

/* The angle through which the crank turns, forwards and backwards, rad. */
double flk_path_travel(const flk_path *p);

#endif
