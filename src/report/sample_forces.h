/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_forces.h - the nine equations of the sample calculation, with their numbers, their solution, and the
** check by virtual work.
*/
#ifndef FOURLINK_REPORT_SAMPLE_FORCES_H
#define FOURLINK_REPORT_SAMPLE_FORCES_H

#include "mathml.h"
#include "report.h"

/* The nine equations, their solution, and virtual work. */
void sample_put_forces(report *r, math *m);

#endif
