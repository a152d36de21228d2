/* SPDX-License-Identifier: GPL-3.0-or-later
**
** name.h - what a name means: a column, a statistic of a column, a fact, or a value that the deck gives.
*/
#ifndef FOURLINK_NAME_H
#define FOURLINK_NAME_H

#include "opened.h"

typedef enum flk_name_kind {
    FLK_NAME_UNKNOWN,
    FLK_NAME_COLUMN,
    FLK_NAME_STATISTIC,
    FLK_NAME_FACT,
    FLK_NAME_GIVEN /* an input, or a variable of the sweep */
} flk_name_kind;

typedef struct flk_name {
    flk_name_kind kind;
    int handle;              /* for fourlink_results_get; 0: unknown */
    text of;                 /* the name, or that of the column of a statistic */
    flk_statistic statistic; /* FLK_NONE: not a statistic */
    flk_column c;            /* the column, or that of the statistic */
    const fourlink_value *given;
} flk_name;

/* What a name means.  `statistic` and `of` are set even if the name is unknown. */
void flk_name_find(flk_opened *o, text name, flk_name *n);

/* What a handle stands for in this design; `of` is empty. */
void flk_name_of_handle(flk_opened *o, int handle, flk_name *n);

/* Describe what a name means, without its value; all 0 if it is unknown. */
void flk_name_describe(const flk_opened *o, const flk_name *n, fourlink_value *v);

/* Its value, or as fourlink_results_get why it has none. */
int flk_name_value(flk_opened *o, const flk_name *n, fourlink_branch branch, double angle,
                   fourlink_value *value);

/* The same of a column at a time, s, of a deck with rows by time. */
int flk_name_value_at_time(flk_opened *o, const flk_name *n, fourlink_branch branch, double time,
                           fourlink_value *value);

/* Put the facts of this handle on a branch first in o->facts, such as the ends of two ranges; returns their
** number. */
unsigned long flk_name_facts(flk_opened *o, int handle, fourlink_branch branch);

#endif
