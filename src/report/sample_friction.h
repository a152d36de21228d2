/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_friction.h - the friction of the sample calculation: moments of pins, force of the guide.
*/
#ifndef FOURLINK_REPORT_SAMPLE_FRICTION_H
#define FOURLINK_REPORT_SAMPLE_FRICTION_H

#include "mathml.h"
#include "report.h"

/* What friction adds to the loads, from the forces; nothing without friction. */
void sample_put_friction(report *r, math *m);

#endif
