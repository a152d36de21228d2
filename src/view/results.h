/* SPDX-License-Identifier: GPL-3.0-or-later
**
** results.h - the functions of fourlink.h that need memory, with the same names but for their beginning: if
** it fails, that is noted (system/memory.h).  The others on a branch could fail so only where its motion is
** integrated: they are called after view_find_motion, for the branches that the deck requests.
*/
#ifndef FOURLINK_VIEW_RESULTS_H
#define FOURLINK_VIEW_RESULTS_H

#include "fourlink.h"

int results_open(const fourlink_source *source, unsigned long max_mistakes,
                 fourlink_results **results, fourlink_mistake *mistakes, unsigned long *n_mistakes);
int results_open_like(const fourlink_source *source, fourlink_results *like,
                      unsigned long max_mistakes, fourlink_results **results,
                      fourlink_mistake *mistakes, unsigned long *n_mistakes);
int results_design(const fourlink_results *from, unsigned long design, unsigned long max_mistakes,
                   fourlink_results **results, fourlink_mistake *mistakes,
                   unsigned long *n_mistakes);
int results_set(fourlink_results *results, const char *name, double value,
                fourlink_mistake *mistake);
int results_put(fourlink_results *results, unsigned long n, const int *handles,
                const double *values);

/* Where the motion ends; what has a name; the facts, none if memory fails. */
int results_end(fourlink_results *results, fourlink_branch branch, double *angle);
int results_get(fourlink_results *results, int handle, fourlink_branch branch, double angle,
                fourlink_value *value);
int results_value(fourlink_results *results, const char *name, fourlink_branch branch, double angle,
                  fourlink_value *value);
int results_facts(fourlink_results *results, int branch, int groups, const fourlink_value **facts,
                  unsigned long *n);

/* The i-th comparison; 0 if memory fails, and all of it is 0, with empty texts. */
int results_check(fourlink_results *results, unsigned long i, fourlink_check *check);

/* 1 for a status that leaves open what a value is: the motion or the search would take too long.  Others
** say that there is none. */
int results_gave_up(int status);

#endif
