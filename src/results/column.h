/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column.h - the columns of the tables: their names, units and meanings, and their values.
*/
#ifndef FOURLINK_COLUMN_H
#define FOURLINK_COLUMN_H

#include "row.h"

typedef struct column_info column_info;

/* A column chosen for a deck. */
typedef struct column {
    const column_info *info;
    const char *name;
    const char *unit;        /* as the deck names it */
    double scale;            /* what SI values are multiplied by */
    const deck_point *point; /* null: a column of the mechanism */
    int component;           /* which of the point's columns */
} column;

/* Zero it before its first use, and give it to columns_free after its last. */
typedef struct column_list {
    column *list;
    size_t count, capacity;
} column_list;

/* Add a column that the list does not have yet: same name, same unit.  0 when out of memory. */
int columns_add(column_list *columns, const column *c);
void columns_free(column_list *columns);

/* 1 if two columns have the same name and the same unit. */
int columns_are_same(const column *x, const column *y);

/* Choose the columns that the deck asks for, or the usual ones.  1; 0 and mistakes of the deck if it
** asks for some that it has not; -1 out of memory. */
int columns_choose(deck *d, column_list *columns);

/* Of a deck with other mistakes: look for columns that no deck has. */
void columns_check(deck *d);

/* The column of that name; 0 if the deck has none. */
int column_find(const deck *d, text name, column *c);

/* The next name of a list separated by commas or blanks; 0 at its end. */
int column_next_name(text *rest, text *name);

/* max(COLUMN) or min(COLUMN): its sign, and the column's name; 0 if it is neither. */
int column_extreme_of(text name, text *of);

/* The column's name most like this one, or null. */
const char *column_nearest(const deck *d, text name);

/* Add all columns that the deck has.  0 when out of memory. */
int columns_all(const deck *d, column_list *columns);

/* The value of a column in its unit.  Defined for any row if column_of_crank, else only where
** r->status is FOURLINK_OK. */
double column_value(const column *c, const result *r);

/* 1: a column of the crank alone, which has a value also where the links do not reach. */
int column_of_crank(const column *c);

/* 1: a measure of rounding, printed as a power of ten. */
int column_of_rounding(const column *c);

/* What has to be computed for a column, or for a list of them: NEED_FORCES ... */
int column_need(const column *c);
int columns_need(const column_list *columns);

/* Beyond this magnitude, in its unit, a column is infinite: a centre or an advantage at a position where
** there is none. */
double column_bound(const column *c);

/* 1: the crank angle itself, the one column without extremes. */
int column_is_angle_of_crank(const column *c);

quantity column_quantity(const column *c);
const char *column_meaning(const column *c);

/* What the sources call it; "" if they do not. */
const char *column_source_name(const column *c);

#endif
