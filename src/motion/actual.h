/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual.h - the actual motion of the machine: speed, acceleration and time of the crank from torques and inertia.
*/
#ifndef FOURLINK_ACTUAL_H
#define FOURLINK_ACTUAL_H

#include "actual_row.h"
#include "corners.h"

/* The motion of a deck: on the branches that it asks for it is found when the deck is opened, on another one when that is
** first asked for. */
typedef struct flk_actual flk_actual;

/* Find the motion of a deck, for flk_actual_free; null if out of memory.
**
** acting  memory for the loads of a row; it and the corners last as long
** end     the crank angle of the last row, in the deck's unit; unused by time
** period  rad, of a steady motion
** winds   1: a spring is wound up by each cycle, and there is none */
flk_actual *flk_actual_find(const deck *d, flk_corners *corners, flk_acting *acting, double end,
                            double period, int winds);
void flk_actual_free(flk_actual *m);

/* The crank at an angle of the motion, in the deck's unit: FOURLINK_OK, or why the machine does not come there,
** with theta2 and 0 for the rest. */
int flk_actual_at(flk_actual *m, fourlink_branch branch, double angle, flk_actual_row *row);

/* The same at a time, of rows by time. */
int flk_actual_at_time(flk_actual *m, fourlink_branch branch, double time, flk_actual_row *row);

/* The length of the motion, rad: of the rows, unless it ends before; of rows by time that through which the crank
** turns, forwards and backwards, and this takes `time`, s. */
double flk_actual_length(flk_actual *m, fourlink_branch branch);
double flk_actual_time(flk_actual *m, fourlink_branch branch);

/* 1 if it begins at rest. */
int flk_actual_from_rest(const deck *d);

/* Null for null: the motion is given. */
const flk_actual_facts *flk_actual_facts_of(flk_actual *m, fourlink_branch branch);

#endif
