/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual.h - the actual motion of the machine: crank speed, acceleration and time from torques and inertia.
*/
#ifndef FOURLINK_ACTUAL_H
#define FOURLINK_ACTUAL_H

#include "path.h"

/* The motion of a deck, found for each branch by flk_actual_prepare. */
typedef struct flk_actual flk_actual;

/* Set up the motion of a deck, for flk_actual_free; null if out of memory.
**
** acting  memory for the loads of a row; it and the corners must remain valid as long
** end     the last crank angle of the deck's motion, in its unit
** period  rad, of a steady motion
** winds   1: each cycle winds up a spring, so there is no steady motion */
flk_actual *flk_actual_open(const deck *d, flk_corners *corners, flk_acting *acting, double end,
                            double period, int winds);
void flk_actual_free(flk_actual *m);

/* Integrate the motion of a branch, if that is not done, and with `has_facts` find its facts: for those
** of a run-up the steady motion is sought that it approaches.  FOURLINK_OK, FOURLINK_NO_MEMORY.  It is
** called before anything is asked of a branch; then no status below means that memory failed.  Nothing
** to do if `m` is null. */
int flk_actual_prepare(flk_actual *m, fourlink_branch branch, int has_facts);

/* The crank at an angle of the motion, in the deck's unit: FOURLINK_OK, or why the machine does not get
** there, with theta2 set and the rest 0. */
int flk_actual_at(flk_actual *m, fourlink_branch branch, double angle, flk_actual_row *row);

/* The same at a time of a motion that was integrated by time. */
int flk_actual_at_time(flk_actual *m, fourlink_branch branch, double time, flk_actual_row *row);

/* The length of a motion that is integrated by angle, rad: that of the rows, unless it ends earlier. */
double flk_actual_length(flk_actual *m, fourlink_branch branch);

/* Of a motion that is integrated by time the angle through which the crank turns, forwards and backwards,
** rad, and the time that this takes, s. */
double flk_actual_travel(flk_actual *m, fourlink_branch branch);
double flk_actual_time(flk_actual *m, fourlink_branch branch);

/* 1 if the motion starts from rest. */
int flk_actual_from_rest(const deck *d);

/* The facts of a branch; null if `m` is null (the motion is given).  Unless they are prepared, only how
** and where the motion ends is known. */
const flk_actual_facts *flk_actual_facts_of(flk_actual *m, fourlink_branch branch);

#endif
