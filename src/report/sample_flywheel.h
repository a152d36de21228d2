/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_flywheel.h - the flywheel in the sample calculation, from the turning moment.
*/
#ifndef FOURLINK_REPORT_SAMPLE_FLYWHEEL_H
#define FOURLINK_REPORT_SAMPLE_FLYWHEEL_H

#include "mathml.h"
#include "report.h"

/* The fluctuation of energy and the flywheel, of a deck with a turning moment; else nothing. */
void sample_put_flywheel(report *r, math *m);

#endif
