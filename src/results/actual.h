/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual.h - the actual motion of the machine: speed, acceleration and time of the crank from torques and inertia.
*/
#ifndef FOURLINK_ACTUAL_H
#define FOURLINK_ACTUAL_H

#include "deck/deck.h"

/* The motion of a deck on both branches, found once when the deck is opened. */
typedef struct flk_actual flk_actual;

/* The crank at one angle, and the columns of the actual motion. */
typedef struct flk_actual_row {
    fourlink_crank crank;
    double angle;           /* in the deck's unit */
    double time;            /* s */
    double T_motor;         /* N m, at the crank */
    double J;               /* kg m2, of the links, without flywheel and rotor */
    double energy;          /* J, kinetic, with flywheel and rotor */
    double energy_residual; /* 1, energy less the work put in, relative to the largest energy */
} flk_actual_row;

/* What is known of the motion of one branch; NaN: not defined for it. */
typedef struct flk_actual_facts {
    int status;       /* FOURLINK_OK, or why the motion ends before the last row, or has none */
    double end_angle; /* in the deck's unit: where it ends, if the status is not FOURLINK_OK */
    double
        mean_speed; /* rad/s, the time mean over the last cycle, or the whole motion if shorter */
    double mean_speed_textbook; /* rad/s, (largest + smallest) / 2 there */
    double period;              /* s, of that cycle */
    double fluctuation_exact;   /* 1, (largest - smallest) / mean speed */
    double steady_rate;  /* 1, by which a difference from the steady cycle shrinks in a cycle */
    double stall_angle;  /* in the deck's unit */
    double run_up_time;  /* s, until the speed first reaches the mean speed of the steady cycle */
    double motor_torque; /* N m, of a motor that balances: at the crank */
    double inertia;      /* kg m2, of flywheel and rotor at the crank; found if wanted */
} flk_actual_facts;

struct flk_analysis;

/* Find the motion; 0 if out of memory.  The analysis is ready but for this. */
int flk_actual_open(struct flk_analysis *a);
void flk_actual_close(struct flk_analysis *a);

/* The crank at an angle of the motion, in the deck's unit: FOURLINK_OK, or why the machine does not come there,
** with theta2 and 0 for the rest. */
int flk_actual_at(const struct flk_analysis *a, fourlink_branch branch, double angle,
                  flk_actual_row *row);

/* The same at a row: by angle or by time. */
int flk_actual_at_row(const struct flk_analysis *a, fourlink_branch branch, unsigned long i,
                      flk_actual_row *row);

/* The same at a time, of rows by time. */
int flk_actual_at_time(const struct flk_analysis *a, fourlink_branch branch, double time,
                       flk_actual_row *row);

/* The length of the motion, rad: of the rows, unless it ends before; of rows by time that through which the crank
** turns, forwards and backwards, and this takes `time`, s. */
double flk_actual_length(const struct flk_analysis *a, fourlink_branch branch);
double flk_actual_time(const struct flk_analysis *a, fourlink_branch branch);

/* 1 if it begins at rest. */
int flk_actual_from_rest(const deck *d);

/* Null if the motion is given. */
const flk_actual_facts *flk_actual_facts_of(const struct flk_analysis *a, fourlink_branch branch);

#endif
