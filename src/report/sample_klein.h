/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_klein.h - Klein's construction in the sample calculation.
*/
#ifndef FOURLINK_REPORT_SAMPLE_KLEIN_H
#define FOURLINK_REPORT_SAMPLE_KLEIN_H

#include "mathml.h"
#include "report.h"

/* The lengths of Klein's construction, and what follows from them, with the symbols of the motion; of
** other kinds than a slider-crank, nothing. */
void sample_put_klein(report *r, math *m);

#endif
