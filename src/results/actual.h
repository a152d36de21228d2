/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual.h - the actual motion of the machine: speed, acceleration and time of the crank from torques and inertia.
*/
#ifndef FOURLINK_ACTUAL_H
#define FOURLINK_ACTUAL_H

#include "actual_row.h"
#include "jumps.h"

/* The motion of a deck on both branches, found once when the deck is opened. */
typedef struct flk_actual flk_actual;

/* What the motion is found with: a deck and its jumps, memory for its loads at one crank angle, the last crank angle
** of its rows, in its unit, and the angle, rad, after which everything repeats. */
typedef struct flk_actual_task {
    const deck *d;
    const flk_jumps *jumps;
    fourlink_load *loads;
    unsigned long n_loads;
    double end, cycle;
} flk_actual_task;

/* Find the motion, for flk_actual_close; null if it is given.  0 if out of memory.  What the task points to is needed
** as long as the motion. */
int flk_actual_open(const flk_actual_task *task, flk_actual **m);
void flk_actual_close(flk_actual *m);

/* The crank at an angle of the motion, in the deck's unit: FOURLINK_OK, or why the machine does not come there,
** with theta2 and 0 for the rest. */
int flk_actual_at(const flk_actual *m, fourlink_branch branch, double angle, flk_actual_row *row);

/* The same at a row: by angle or by time. */
int flk_actual_at_row(const flk_actual *m, fourlink_branch branch, unsigned long i,
                      flk_actual_row *row);

/* The same at a time, of rows by time. */
int flk_actual_at_time(const flk_actual *m, fourlink_branch branch, double time,
                       flk_actual_row *row);

/* The length of the motion, rad: of the rows, unless it ends before; of rows by time that through which the crank
** turns, forwards and backwards, and this takes `time`, s. */
double flk_actual_length(const flk_actual *m, fourlink_branch branch);
double flk_actual_time(const flk_actual *m, fourlink_branch branch);

/* 1 if it begins at rest. */
int flk_actual_from_rest(const deck *d);

/* Null if the motion is given. */
const flk_actual_facts *flk_actual_facts_of(flk_actual *m, fourlink_branch branch);

#endif
