/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turning.h - the turning moment over a cycle, and the flywheel that it needs.
*/
#ifndef FOURLINK_TURNING_H
#define FOURLINK_TURNING_H

#include "analysis.h"

/* Allocate the memory that the turning moment of a deck needs, until flk_analysis_close; 0 when out of
** memory. */
int flk_turning_open(flk_analysis *a);

/* The turning moment at the deck's speed, which is taken as constant; null if it is not defined: the
** crank does not turn, or is accelerated, or does not reach all angles, or there are no forces. */
const fourlink_turning *flk_turning_find(flk_analysis *a, fourlink_branch branch);

#endif
