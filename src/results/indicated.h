/* SPDX-License-Identifier: GPL-3.0-or-later
**
** indicated.h - what the indicator card of an engine says: the work of the gas in a cycle, its power, the
** mean effective pressure.
*/
#ifndef FOURLINK_INDICATED_H
#define FOURLINK_INDICATED_H

#include "analysis.h"

typedef struct flk_indicated {
    double work;           /* J, in a cycle; negative where the gas takes up work */
    double power;          /* W; NaN: the crank has no constant or mean speed */
    double mean_effective; /* Pa */
} flk_indicated;

/* 0 if a deck has no indicator, or its crank does not turn through whole cycles. */
int flk_indicated_find(const flk_analysis *a, fourlink_branch branch, flk_indicated *found);

#endif
