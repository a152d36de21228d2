/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_motion.h - position, velocities and accelerations of the sample calculation, by the loop equation of
** each kind and its derivatives.
*/
#ifndef FOURLINK_REPORT_SAMPLE_MOTION_H
#define FOURLINK_REPORT_SAMPLE_MOTION_H

#include "mathml.h"
#include "report.h"

/* Position, velocities and accelerations by the equations of the kind.  The symbols stay set. */
void sample_put_motion(report *r, math *m);

/* What is done to two equations, of which this is the second. */
void sample_put_derived(math *m, int second, const char *words);

/* The acceleration of B, unless it is written above. */
void sample_put_acceleration_of_B(report *r, math *m);

#endif
