/* SPDX-License-Identifier: GPL-3.0-or-later
**
** expected.h - the values that a source printed, compared with the computed ones.
*/
#ifndef FOURLINK_EXPECTED_H
#define FOURLINK_EXPECTED_H

#include "opened.h"

/* Compare a printed value with the computed one, and give what its name means: FOURLINK_OK,
** FOURLINK_NO_MEMORY. */
int flk_expected_compare(flk_opened *o, const deck_expectation *e, flk_name *n,
                         fourlink_check *check);

/* 1 if a value agrees with check->printed within check->tolerance.  For an angle, `turn` is a full turn in
** its unit, since whole turns do not count; else 0. */
int flk_expected_agrees(const fourlink_check *check, double value, double turn);

/* How far a value is from check->printed; of angles, whose turn is above 0, at most half a turn. */
double flk_expected_apart(const fourlink_check *check, double value, double turn);

#endif
