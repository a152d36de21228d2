/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_engine.h - the engine method of the sample calculation: the forces along the line of stroke, the
** effort at the crank, and the torque of an engine whose rod is two masses.
*/
#ifndef FOURLINK_REPORT_SAMPLE_ENGINE_H
#define FOURLINK_REPORT_SAMPLE_ENGINE_H

#include "mathml.h"
#include "report.h"

/* The engine method of a slider-crank that has one, from the symbols of its motion; else nothing. */
void sample_put_engine(report *r, math *m);

#endif
