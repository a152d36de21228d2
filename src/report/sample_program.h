/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_program.h - the program of a motion in the sample calculation.
*/
#ifndef FOURLINK_REPORT_SAMPLE_PROGRAM_H
#define FOURLINK_REPORT_SAMPLE_PROGRAM_H

#include "mathml.h"
#include "report.h"

/* The coordinate, its speed and acceleration by the law of the program at the time of the sample; of a
** deck without a program, nothing. */
void sample_put_program(report *r, math *m);

#endif
