/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fact.h - facts of a deck, which are single values: type, limits, masses, extremes, turning moment.
*/
#ifndef FOURLINK_FACT_H
#define FOURLINK_FACT_H

#include "extreme.h"
#include "list.h"

/* The largest number of facts besides extremes, on both branches. */
#define FLK_FACT_RANGES 16 /* of crank angles on a branch, of decks with outputs */
#define FLK_FACT_LIMIT (116 + 4 * FLK_FACT_RANGES + 2 * OUTPUT_FACTS * FOURLINK_MOST_GROUPS)

/* The handle of a fact, which is negative; 0 if no deck has one of this name, or the deck has no output
** of it.  `d` may be null. */
int flk_fact_find(const deck *d, text name);

/* 1 if a deck has the output that a handle is of, if of one. */
int flk_fact_is_there(const deck *d, int handle);

/* Its group, FOURLINK_FACTS_LIMITS ...; 0 if the handle is not that of a fact. */
int flk_fact_group(int handle);

/* 1 for an angle to which whole turns add nothing: a place of a link, not a swing. */
int flk_fact_is_direction(const deck *d, int handle);

/* The most similar name of a fact of any deck, or of an output of this one; or null. */
const char *flk_fact_nearest(const deck *d, text name);

/* Describe a fact without its value. */
void flk_fact_describe(const deck *d, int handle, fourlink_value *f);

/* Why a branch does not have a fact: FOURLINK_NO_SUCH_FACT, or the status, 1 to 19, with which the actual
** motion ended early. */
int flk_fact_why_missing(flk_analysis *a, int handle, fourlink_branch branch);

/* A statistic of a column, as a fact; returns FOURLINK_OK, FOURLINK_NOT_REACHED or why the actual motion
** does not begin, or FOURLINK_NO_MEAN.  `all` as in flk_extremes_find, `names` as in flk_fact_list. */
int flk_fact_of_statistic(flk_analysis *a, flk_extremes *x, const flk_column *c,
                          flk_statistic statistic, fourlink_branch branch, int all, char *names,
                          fourlink_value *f);

/* List the facts of some groups on a branch, or with 0 on the deck's branches; returns their number.  A
** handle other than 0 lists only the facts of this handle, such as the ends of two ranges.  The extremes are
** those of the columns.  `list` has room for FLK_FACT_LIMIT facts and four for each column, and for the
** names of the statistics of all columns, as flk_column_statistic_name writes them. */
unsigned long flk_fact_list(flk_analysis *a, flk_extremes *x, int branch, int groups, int handle,
                            const flk_column *columns, size_t n_columns, flk_list *list);

#endif
