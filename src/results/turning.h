/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turning.h - the turning moment over a cycle, and the flywheel that it needs.
*/
#ifndef FOURLINK_TURNING_H
#define FOURLINK_TURNING_H

#include "row.h"

/* An area between the turning moment and its mean. */
typedef struct turning_area {
    double from, to; /* rad, rising whichever way the crank turns */
    double energy;   /* J, which the flywheel takes up as the crank passes */
} turning_area;

#define TURNING_AREAS 40

typedef struct turning {
    double mean_torque;        /* N m, of the turning moment -Ts, which is delivered */
    double mean_power;         /* W */
    double energy_fluctuation; /* J, greatest less least energy of the flywheel in a cycle */
    int has_coefficient;       /* 0: the mean is 0 */
    double energy_coefficient; /* 1, of the fluctuation of energy: over the work of a cycle */
    double inertia;     /* kg m2, of the flywheel; 0: neither it nor the fluctuation is given */
    double fluctuation; /* 1, coefficient of fluctuation of speed */
    int n_areas;        /* in one cycle from 0; at most TURNING_AREAS are kept */
    turning_area area[TURNING_AREAS];
} turning;

/* The turning moment at the deck's speed, which is taken as constant.  1, or 0 if it is not defined: the
** crank does not turn, or is accelerated, or does not reach all angles, or there are no forces. */
int turning_find(analysis *a, fourlink_branch branch, turning *t);

#endif
