/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_output.h - the motion of outputs in the sample calculation.
*/
#ifndef FOURLINK_REPORT_SAMPLE_OUTPUT_H
#define FOURLINK_REPORT_SAMPLE_OUTPUT_H

#include "mathml.h"
#include "report.h"

/* The loops, velocities and accelerations of all outputs, after those of the four links. */
void sample_put_outputs(report *r, math *m);

#endif
