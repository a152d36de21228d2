/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_source.h - where columns come from: the table, the points that every deck has, the deck's points,
** its springs, what drives and the actuators, its outputs, the forces opposite to those of the table.
*/
#ifndef FOURLINK_COLUMN_SOURCE_H
#define FOURLINK_COLUMN_SOURCE_H

#include "base/message.h"
#include "analysis.h"

typedef struct flk_column_info flk_column_info;
typedef struct flk_column_source flk_column_source;

/* A column chosen for a deck. */
typedef struct flk_column {
    const deck *d;
    const flk_column_source *source; /* column_source.h */
    const flk_column_info *info;
    size_t number; /* its place among all possible ones */
    const char *name;
    int is_usual;  /* 1: printed if the deck names no columns */
    int is_number; /* 1, as nearly all: it is a number of a row */
    double scale;  /* what SI values are multiplied by */
    union {
        struct {
            int link;
            fourlink_vector at; /* m, in the link's own axes */
        } point;
        const fourlink_spring *spring;
        const flk_actuator *actuator;
        int output;
    } of;          /* whose it is, in a source that repeats its columns */
    int component; /* which of these columns */
} flk_column;

/* A source of columns: one file, and a place in the list of column.c.
**
** infos     the columns that decks can have, by their names; null if the names are those of the deck
** count     how many columns a deck can have of it
** make      fills in column i, flk_column_start done; returns 1 if the deck has it
** lacks     why a deck does not have infos[i], to follow its name; may use `words`.  Null for infos that
**           are null
** value     in SI units, of a row that could be computed, or of the crank
** vector    of a column whose form is that of a vector's size or direction: the vector, in SI units
** size      in SI units, what the rounding error of its value in a row is a small part of; null: that
**           follows from the machine (samples.c)
** is_apart  1: decks have them by name only; `all` and the lists leave them out
*/
struct flk_column_source {
    const flk_column_info *infos;
    size_t n_infos;
    size_t (*count)(const deck *d);
    int (*make)(const flk_analysis *a, size_t i, flk_column *c);
    const char *(*lacks)(const deck *d, size_t i, char words[MESSAGE_SIZE]);
    double (*value)(const flk_column *c, const flk_row *row);
    void (*vector)(const flk_column *c, const flk_row *row, double *x, double *y);
    double (*size)(const flk_column *c, const flk_row *row);
    int is_apart;
};

extern const flk_column_source flk_table_columns, flk_own_point_columns, flk_point_columns,
    flk_spring_columns, flk_drive_columns, flk_output_columns, flk_opposite_columns;

/* A number of a row, by its place in it. */
#define FLK_ROW_NUMBER(row, place) (*(const double *)(const void *)((const char *)(row) + (place)))

/* Fill in a column with what is said of it, without its source and number. */
void flk_column_start(const deck *d, const flk_column_info *info, flk_column *c);

#endif
