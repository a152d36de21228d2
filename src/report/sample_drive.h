/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_drive.h - in the sample calculation, the power of what drives a machine that no torque on the
** crank drives.
*/
#ifndef FOURLINK_REPORT_SAMPLE_DRIVE_H
#define FOURLINK_REPORT_SAMPLE_DRIVE_H

#include "mathml.h"
#include "report.h"

/* The effort of what drives and its power, after the forces; of a crank that is driven, nothing. */
void sample_put_drive(report *r, math *m);

#endif
