/* SPDX-License-Identifier: GPL-3.0-or-later
**
** condition.h - the conditions of [sweep] that count for the yield.
*/
#ifndef FOURLINK_CONDITION_H
#define FOURLINK_CONDITION_H

#include "base/text.h"

/* NAME > QUANTITY */
typedef struct flk_condition {
    text whole, name, limit;
    int flags; /* FOURLINK_ABOVE ... */
} flk_condition;

/* Take the next condition from a list separated by commas.  Returns 1; 0 at the end; -1 if `whole`, its
** text, is not a condition. */
int flk_condition_next(text *rest, flk_condition *c);

#endif
