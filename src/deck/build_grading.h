/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_grading.h - builds [grading]: tolerances, marks and digits that hold whatever answers say.
*/
#ifndef FOURLINK_DECK_BUILD_GRADING_H
#define FOURLINK_DECK_BUILD_GRADING_H

#include "deck.h"

/* Read an item of a rule: a tolerance in per cent or of this quantity, in SI units; marks, as in "2 marks".
** 1; 0 if it is something else. */
int flk_rule_tolerance(const deck *d, text item, quantity q, int *is_percent, double *tolerance);
int flk_rule_marks(text item, double *marks);

/* 1 if a rule with a name is for a value: of that name or, as NAME at ANGLE, also at that crank angle. */
int flk_rule_is_for(const deck *d, const deck_rule *rule, const deck_expectation *e);

#endif
