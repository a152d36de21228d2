/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sweep.h - [sweep]: the designs of a deck that varies its quantities.
*/
#ifndef FOURLINK_DECK_SWEEP_H
#define FOURLINK_DECK_SWEEP_H

#include "parser.h"

/* The quantities of [sweep]; the values of one of its designs. */
void flk_sweep_read(parser *p);
void flk_sweep_assign(parser *p, unsigned long design);

/* The first `max` values of a design's variables, in the deck's unit; the values before and after them in
** their ranges, or the same value at an end of a range, and for a list.  `low` and `high` may be null. */
void flk_deck_variables(const deck *d, unsigned long design, size_t max, double *values,
                        double *low, double *high);

#endif
