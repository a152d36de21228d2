/* SPDX-License-Identifier: GPL-3.0-or-later
**
** equation.h - the equation of motion in time, within a cell of the machine.
*/
#ifndef FOURLINK_EQUATION_H
#define FOURLINK_EQUATION_H

#include "deck/deck.h"

/* The equation that is integrated, on one branch. */
typedef struct flk_equation {
    flk_machine machine; /* the deck's, with the torque and the flywheel that are sought */
    fourlink_branch branch;
    flk_acting *acting; /* memory for its loads, and the held cell */
    double from;        /* rad, theta2 of the first row */
    double total;       /* kg m2, J + I_f where derivatives were last found */
    double sense;       /* 1 or -1: sense of the range, in which passed angles and speeds are
                           positive */
} flk_equation;

/* The unknowns: rad passed since the first row; rad/s; J, initial kinetic energy plus the work done since. */
enum { FLK_PASSED, FLK_SPEED, FLK_ENERGY };

/* The crank angle, rad, after s. */
double flk_equation_theta2(const flk_equation *e, double s);

/* J + I_f there; at a change point, beside it. */
int flk_equation_inertia(const flk_equation *e, double s, double *total);

/* The torques on the machine at a speed; net and alpha2 are in the sense of the motion. */
int flk_equation_torque(const flk_equation *e, const flk_machine_place *place, double speed,
                        flk_machine_torque *torque);

/* The derivatives of the unknowns, as flk_derivative of an flk_equation. */
int flk_equation_derive(void *equation, double t, const double *y, double *dy);

#endif
