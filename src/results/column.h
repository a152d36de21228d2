/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column.h - the columns of the tables: their names, units and meanings, and their values.
*/
#ifndef FOURLINK_COLUMN_H
#define FOURLINK_COLUMN_H

#include "analysis.h"

typedef struct flk_column_info flk_column_info;

/* A column chosen for a deck. */
typedef struct flk_column {
    const flk_column_info *info;
    const char *name;
    double scale;            /* what SI values are multiplied by */
    const deck_point *point; /* null: a column of the mechanism */
    int component;           /* which of the point's columns */
} flk_column;

/* How many columns a deck can have at most. */
size_t flk_column_limit(const deck *d);

/* Choose the columns that the deck asks for, or the usual ones; how many.  Mistakes of the deck if it asks
** for some that it has not.  `list` has room for flk_column_limit. */
size_t flk_column_choose(const flk_analysis *a, mistakes *m, flk_column *list);

/* Column i of those that there can be, 0 ... flk_column_limit - 1; 0 if the deck has it not. */
int flk_column_number(const flk_analysis *a, size_t i, flk_column *c);

/* Of a deck with other mistakes: look for columns that no deck has. */
void flk_column_check(deck *d);

/* The column of that name; 0 if the deck has none. */
int flk_column_find(const flk_analysis *a, text name, flk_column *c);

/* The next name of a list separated by commas or blanks; 0 at its end. */
int flk_column_next_name(text *rest, text *name);

/* max(COLUMN) or min(COLUMN): its sign, and the column's name; 0 if it is neither. */
int flk_column_extreme_of(text name, text *of);

/* The column's name most like this one, or null. */
const char *flk_column_nearest(const flk_analysis *a, text name);

/* The value of a column in its unit; NaN where it has none. */
double flk_column_value(const flk_column *c, const flk_row *row);

/* FOURLINK_OF_CRANK ... */
int flk_column_flags(const flk_column *c);

/* What has to be computed for it: NEED_FORCES ... */
int flk_column_need(const flk_column *c);

/* Beyond this magnitude, in its unit, a column is infinite: a centre or an advantage at a position where
** there is none. */
double flk_column_bound(const flk_column *c);

quantity flk_column_quantity(const flk_column *c);
const char *flk_column_meaning(const flk_column *c);

/* What the sources call it; "" if they do not. */
const char *flk_column_source_name(const flk_column *c);

#endif
