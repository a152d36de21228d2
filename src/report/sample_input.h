/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_input.h - in the sample calculation, how another coordinate that is prescribed gives the crank's
** motion.
*/
#ifndef FOURLINK_REPORT_SAMPLE_INPUT_H
#define FOURLINK_REPORT_SAMPLE_INPUT_H

#include "mathml.h"
#include "report.h"

/* The crank angle of a prescribed coordinate, and the crank's speed and acceleration, with the symbols
** of the motion; of a deck that prescribes the crank's, nothing. */
void sample_put_input(report *r, math *m);

#endif
