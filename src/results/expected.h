/* SPDX-License-Identifier: GPL-3.0-or-later
**
** expected.h - the values that a source printed, compared with the computed ones.
*/
#ifndef FOURLINK_EXPECTED_H
#define FOURLINK_EXPECTED_H

#include "extreme.h"

/* Compare a printed value with the computed one.  `facts` has room for FLK_FACT_LIMIT facts. */
void flk_expected_compare(flk_analysis *a, flk_extremes *x, const deck_expectation *e,
                          fourlink_value *facts, fourlink_check *check);

/* 1 if a value agrees with check->printed within check->tolerance.  `turn` is a turn of an angle in its unit, as whole
** turns do not count; else 0. */
int flk_expected_agrees(const fourlink_check *check, double value, double turn);

#endif
