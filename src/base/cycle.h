/* SPDX-License-Identifier: GPL-3.0-or-later
**
** cycle.h - whole cycles, the place within one, and the distance from the nearest end of one.
**
** A cycle may be negative: then cycles are counted, and places passed, towards smaller x.
*/
#ifndef FOURLINK_CYCLE_H
#define FOURLINK_CYCLE_H

/* The whole cycles from 0 to x.  An x that rounding puts just before the end of a cycle is at that end. */
double flk_cycle_count(double x, double cycle);

/* The place that x has in the cycle that begins at `from`: x less whole cycles, never before `from`, not even
** by rounding. */
double flk_cycle_place(double x, double from, double cycle);

/* The whole cycles from 0 to the end of a cycle that is nearest to x; x less these. */
double flk_cycle_nearest(double x, double cycle);
double flk_cycle_beside(double x, double cycle);

#endif
