/* SPDX-License-Identifier: GPL-3.0-or-later
**
** fact.h - what can be said of a deck in single numbers: type, limits, masses, extremes, turning moment.
*/
#ifndef FOURLINK_FACT_H
#define FOURLINK_FACT_H

#include "column.h"

typedef struct fact {
    char name[DECK_NAME_SIZE];
    const char *words; /* a fact in words; null: it is a number */
    double value;
    quantity q;
    const char *unit;
    int has_angle; /* 1: it occurs at a crank angle, in the deck's unit */
    double theta2;
    int branch; /* FOURLINK_OPEN, FOURLINK_CROSSED, or 0 where it is the same for both */
    const char *meaning;
} fact;

/* 1 if a fact has this name, in some deck or other; its quantity, and whether it is one of the turning
** moment. */
int fact_known(text name, quantity *q, int *of_turning);

/* The name of a fact most like this one, or null. */
const char *fact_nearest(text name);

typedef void fact_taker(const fact *f, void *data);

/* Tell the facts of a deck one by one: those of the mechanism; if `with_turning`, of its turning
** moment; if `columns` is not null, the extremes of these; of this branch, or if it is 0 of those that the
** deck prints. */
void facts_tell(analysis *a, int branch, int with_turning, const column_list *columns,
                fact_taker *take, void *data);

#endif
