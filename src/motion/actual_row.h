/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_row.h - the actual motion at one crank angle, and its facts.
*/
#ifndef FOURLINK_ACTUAL_ROW_H
#define FOURLINK_ACTUAL_ROW_H

#include "fourlink.h"

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

#endif
