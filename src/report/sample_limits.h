/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_limits.h - the limits of a mechanism in the sample calculation: swing or stroke, time ratio,
** transmission angle.
*/
#ifndef FOURLINK_REPORT_SAMPLE_LIMITS_H
#define FOURLINK_REPORT_SAMPLE_LIMITS_H

#include "mathml.h"
#include "report.h"

/* The limits, from the symbols of the motion; nothing of a mechanism without. */
void sample_put_limits(report *r, math *m);

#endif
