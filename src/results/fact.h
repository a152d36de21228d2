/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fact.h - what can be said of a deck in single numbers: type, limits, masses, extremes, turning moment.
*/
#ifndef FOURLINK_FACT_H
#define FOURLINK_FACT_H

#include "extreme.h"

/* How many facts of the limits and of the turning moment there are at most, on both branches. */
#define FLK_FACT_LIMIT 80

/* The group of the fact of this name, FOURLINK_FACTS_LIMITS or FOURLINK_FACTS_TURNING; 0 if there is none
** in any deck. */
int flk_fact_group(text name);

/* The name of a fact most like this one, or null. */
const char *flk_fact_nearest(text name);

/* The name and unit of a fact without its value, as a host names it. */
void flk_fact_describe(const deck *d, const char *name, fourlink_value *f);

/* The extreme of a column, its name being that of the fact: FOURLINK_OK, or FOURLINK_NOT_REACHED. */
int flk_fact_of_extreme(flk_analysis *a, flk_extremes *x, const flk_column *c, const char *name,
                        fourlink_branch branch, int sign, fourlink_value *f);

/* List the facts of these groups on a branch, or if it is 0 on those that the deck asks for; how many.  The
** extremes are those of the columns; `list` has room for FLK_FACT_LIMIT and four times their number,
** `names` for two times their number of DECK_NAME_SIZE bytes. */
unsigned long flk_fact_list(flk_analysis *a, flk_extremes *x, int branch, int groups,
                            const flk_column *columns, size_t n_columns, fourlink_value *list,
                            char *names);

#endif
