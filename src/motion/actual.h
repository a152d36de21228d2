/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual.h - the actual motion of the machine: speed, acceleration and time of the crank from torques and inertia.
*/
#ifndef FOURLINK_ACTUAL_H
#define FOURLINK_ACTUAL_H

#include "actual_row.h"
#include "corners.h"

/* The motion of a deck on both branches, found once when the deck is opened. */
typedef struct flk_actual flk_actual;

/* What it is found from. */
typedef struct flk_course {
    const deck *d;
    flk_corners *corners;
    double last;        /* the crank angle of the last row, in the deck's unit; unused by time */
    double period;      /* rad, of a steady motion */
    int winds;          /* 1: a spring is wound up by each cycle: there is no steady motion */
    flk_acting *acting; /* memory for the loads of a row */
} flk_course;

/* Find the motion, for flk_actual_free; null if out of memory.  What the course has must last as long. */
flk_actual *flk_actual_find(const flk_course *course);
void flk_actual_free(flk_actual *m);

/* The crank at an angle of the motion, in the deck's unit: FOURLINK_OK, or why the machine does not come there,
** with theta2 and 0 for the rest. */
int flk_actual_at(const flk_actual *m, fourlink_branch branch, double angle, flk_actual_row *row);

/* The same at a time, of rows by time. */
int flk_actual_at_time(const flk_actual *m, fourlink_branch branch, double time,
                       flk_actual_row *row);

/* The length of the motion, rad: of the rows, unless it ends before; of rows by time that through which the crank
** turns, forwards and backwards, and this takes `time`, s. */
double flk_actual_length(const flk_actual *m, fourlink_branch branch);
double flk_actual_time(const flk_actual *m, fourlink_branch branch);

/* 1 if it begins at rest. */
int flk_actual_from_rest(const deck *d);

/* Null for null: the motion is given. */
const flk_actual_facts *flk_actual_facts_of(flk_actual *m, fourlink_branch branch);

#endif
