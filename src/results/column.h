/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column.h - the columns of the tables: their names, units and meanings, and their values.
*/
#ifndef FOURLINK_COLUMN_H
#define FOURLINK_COLUMN_H

#include "column_source.h"

/* The largest number of columns of a deck. */
size_t flk_column_limit(const deck *d);

/* Choose the columns that the deck asks for, or the usual ones; returns their number.  A column that the deck
** does not have is a mistake.  `list` has room for flk_column_limit. */
size_t flk_column_choose(const flk_analysis *a, mistakes *m, flk_column *list);

/* The same for another design of a deck whose columns are known, without looking up their names; 0 if this
** design has others. */
size_t flk_column_copy(const flk_analysis *a, const flk_analysis *of, const flk_column *from,
                       size_t n, flk_column *list);

/* Possible column i, 0 ... flk_column_limit - 1; returns 0 if the deck does not have it. */
int flk_column_number(const flk_analysis *a, size_t i, flk_column *c);

/* For a deck with other mistakes: report columns that no deck has. */
void flk_column_check(deck *d, int is_value(text name));

/* Find the column of a name; 0 if the deck has none. */
int flk_column_find(const flk_analysis *a, text name, flk_column *c);

/* The next name in a list separated by commas or blanks, with its `at ANGLE`; 0 at the end. */
int flk_column_next_name(text *rest, text *name);

/* 1 for an angle to which whole turns add nothing: of a link, or of a force; not for an angle between two. */
int flk_column_is_direction(const flk_column *c);

/* 1 for an angle that counts turns, as that of a spring: nothing moves it by whole turns. */
int flk_column_counts_turns(const flk_column *c);

/* What a column has over the motion: max(COLUMN) and so on. */
typedef enum flk_statistic {
    FLK_NONE,
    FLK_MAX = FOURLINK_MAX,
    FLK_MIN = FOURLINK_MIN,
    FLK_MEAN = FOURLINK_MEAN,
    FLK_RMS = FOURLINK_RMS
} flk_statistic;

#define FLK_STATISTICS 4

/* The statistic that a name asks for, and the column's name; FLK_NONE for another name. */
flk_statistic flk_column_statistic_of(text name, text *of);

/* Write the name of a statistic, max(COLUMN), into DECK_NAME_SIZE bytes; or into its place in the memory
** for the names of all columns. */
char *flk_column_statistic_text(flk_statistic statistic, const char *column, char *name);
char *flk_column_statistic_name(flk_statistic statistic, const flk_column *c, char *names);

/* The handle of a column, or of a statistic of it, and what it stands for; 0 if that is no column of the
** deck. */
int flk_column_handle(const flk_column *c, flk_statistic statistic);
int flk_column_of_handle(const flk_analysis *a, int handle, flk_column *c,
                         flk_statistic *statistic);

/* The handle of name i of those that are kept because they have a crank angle: behind those of columns. */
int flk_column_handle_of_name(const deck *d, size_t i);

/* 1 if two decks of a kind have the same of the points that every deck has. */
int flk_column_same_points(const deck *d, const deck *other);

/* The column that another name means, such as w4; null if there is none. */
const char *flk_column_meant(const flk_analysis *a, text name);

/* 1 if decks of some mechanism have a column of this name, whatever its case. */
int flk_column_is_known(text name);

/* The same, or the most similar column name, or null. */
const char *flk_column_nearest(const flk_analysis *a, text name);

/* The value of a column in its unit; NaN if it has none. */
double flk_column_value(const flk_column *c, const flk_row *row);
void flk_column_values(const flk_column *list, size_t n, const flk_row *row, double *values);

/* 1 if a column depends on positions, velocities and accelerations alone: loads have no corners in it. */
int flk_column_is_of_motion(const flk_column *c);

/* Turn a vector from the axes of link 1 to those of the deck. */
void flk_column_turn(const deck *d, fourlink_vector *u);

/* 1 if a column is the size or the direction of a vector; the vector itself, in SI units. */
int flk_column_has_vector(const flk_column *c);
void flk_column_vector(const flk_column *c, const flk_row *row, double *x, double *y);

/* FOURLINK_OF_CRANK ... */
int flk_column_flags(const flk_column *c);

/* What must be computed for it: NEED_FORCES ... */
int flk_column_need(const flk_column *c);

/* 1 if it depends on where the links are alone, and is printed without their velocities. */
int flk_column_is_of_places(const flk_column *c);

/* What the rounding error of a column in a row is a small part of, in its unit; NaN: that follows from
** the machine. */
double flk_column_size(const flk_column *c, const flk_row *row);

/* A column is infinite beyond this magnitude, in its unit: a centre or an advantage that does not exist at a
** position. */
double flk_column_bound(const flk_column *c);

/* The denominator of such a column, which is 0 at its poles. */
double flk_column_denominator(const flk_column *c, const flk_row *row);

quantity flk_column_quantity(const flk_column *c);
const char *flk_column_meaning(const flk_column *c);

/* Its name in the sources; "" if it has none. */
const char *flk_column_source_name(const flk_column *c);

#endif
