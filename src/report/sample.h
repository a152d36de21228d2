/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample.h - the parts of the sample calculation.
*/
#ifndef FOURLINK_SAMPLE_H
#define FOURLINK_SAMPLE_H

#include "mathml.h"
#include "report.h"

/* Position, velocities and accelerations by the equations of the kind.  The symbols stay set. */
void sample_put_motion(report *r, math *m);

/* The nine equations, their solution, and virtual work. */
void sample_put_forces(report *r, math *m);

/* What friction adds to the loads, from the forces; nothing without friction. */
void sample_put_friction(report *r, math *m);

#endif
