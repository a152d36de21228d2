/* SPDX-License-Identifier: GPL-3.0-or-later
**
** opened.h - a deck, or one of its designs, opened for results, and what names mean in it.
*/
#ifndef FOURLINK_OPENED_H
#define FOURLINK_OPENED_H

#include "extreme.h"
#include "list.h"

/* Comparisons are kept for so many expected values, more than people write. */
#define FLK_CHECKS_KEPT 1000

typedef struct flk_kept_check {
    int is_known;
    fourlink_check check;
} flk_kept_check;

#define FLK_ROWS_KEPT 16 /* the rows in which hints look for the values of a row */

typedef struct flk_kept_row {
    int needs;
    fourlink_branch branch;
    double angle; /* as asked */
    flk_row row;
} flk_kept_row;

#define FLK_AT_NAMES 256 /* of the form NAME at ANGLE, that can have handles */

#define FLK_SLIPS 9 /* hint.c */

/* One design of a deck. */
typedef struct flk_opened {
    deck d;
    int whole_cycle; /* as in fourlink_source */
    flk_analysis a;
    flk_extremes extremes;
    flk_column *columns; /* the columns that the deck asks for */
    size_t n_columns;
    int needs;        /* what these columns need */
    int is_of_places; /* 1: they, and the status of a row, depend on where the links are alone */
    flk_list facts;   /* of fourlink_results_facts; names by column and statistic */
    flk_list found;   /* facts of a name, found while a value is looked up */
    flk_list lists[FOURLINK_CONDITIONS + 1]; /* by FOURLINK_COLUMNS ... */
    fourlink_value number; /* the number asked for last that FOURLINK_INPUTS does not list */
    flk_line_units line_units;
    char *at_names; /* each NAME at ANGLE that has a handle, of DECK_NAME_SIZE bytes */
    size_t n_at_names;
    flk_kept_check *checks; /* of the first expected values */
    flk_kept_row *rows;     /* computed last, the next one over the first; null: none are kept */
    size_t n_rows;
    struct flk_opened *slips
        [FLK_SLIPS]; /* with a line as students misread it; null: not opened, or not possible */
    int is_slip_tried[FLK_SLIPS];
} flk_opened;

/* Results, whose numbers a host can set. */
struct fourlink_results {
    flk_opened *now;   /* the current design */
    flk_opened *first; /* the design as it was opened, with the settings that the others share */
    deck_number *set;  /* the numbers that differ from it */
    size_t n_set;
};

/* ------------------------------------------------------------------------------------------------ names */

typedef enum flk_name_kind {
    FLK_NAME_UNKNOWN,
    FLK_NAME_COLUMN,
    FLK_NAME_STATISTIC,
    FLK_NAME_FACT,
    FLK_NAME_GIVEN, /* an input, or a variable of the sweep */
    FLK_NAME_AT     /* NAME at ANGLE: a column at a crank angle */
} flk_name_kind;

typedef struct flk_name {
    flk_name_kind kind;
    int handle;              /* for fourlink_results_get; 0: unknown */
    text of;                 /* the name, or that of the column of which it is a value */
    flk_statistic statistic; /* FLK_NONE: not a statistic */
    flk_column c;            /* the column */
    text at;                 /* the crank angle as written; null: none */
    double angle;
    const fourlink_value *given;
} flk_name;

/* What a name means.  `statistic`, `of` and `at` are set even if the name is unknown. */
void flk_name_find(flk_opened *o, text name, flk_name *n);

/* Give a NAME at ANGLE a handle; 0 if it is too long, or there is no room for more.  Others have theirs. */
int flk_name_keep(flk_opened *o, text name, flk_name *n);

/* Take those with handles from another design. */
void flk_names_take(flk_opened *o, const flk_opened *from);

/* What a handle stands for in this design; `of` is empty. */
void flk_name_of_handle(flk_opened *o, int handle, flk_name *n);

/* Describe what a name means, without its value; all 0 if it is unknown. */
void flk_name_describe(const flk_opened *o, const flk_name *n, fourlink_value *v);

/* Beside groups of facts: extremes, means and crossings are searches along the motion, rows have places
** on it. */
#define FLK_SEARCHES FOURLINK_FACTS_EXTREMES
#define FLK_ROWS 64

/* Find the motion of a branch, or with 0 of those of the deck, as far as these groups need it, and room
** for searches.  What a name needs.  FOURLINK_OK, FOURLINK_NO_MEMORY. */
int flk_opened_prepare(flk_opened *o, int branch, int groups);
int flk_name_prepare(flk_opened *o, const flk_name *n, fourlink_branch branch);

/* Its value, or as fourlink_results_get why it has none. */
int flk_name_value(flk_opened *o, const flk_name *n, fourlink_branch branch, double angle,
                   fourlink_value *value);

/* The same of a column at a place of the course. */
int flk_name_value_along(flk_opened *o, const flk_name *n, fourlink_branch branch, int side,
                         double place, fourlink_value *value);

/* What may be added to it as often as one likes: a turn to a direction, in the unit of results; else 0. */
double flk_name_turn(const flk_opened *o, const flk_name *n);

/* Put the facts of this handle on a branch first in o->found, such as the ends of two ranges; returns their
** number. */
unsigned long flk_name_facts(flk_opened *o, int handle, fourlink_branch branch);

/* ---------------------------------------------------------------------------------------------- opening */

/* Where the mistakes of a deck go: as in fourlink_results_open. */
typedef struct flk_mistake_list {
    unsigned long max;
    fourlink_mistake *mistakes;
    unsigned long *n;
} flk_mistake_list;

/* Open the deck of a source; `like` is null, or a deck that may be the same and has done part of the
** work, and must then live longer.  Open another design of an opened deck's sweep, with `n_set` numbers
** set; another solution of its [synthesis]; the same deck with a change: these share the settings of
** `from`, which must live longer.  Return the status of fourlink_results_open. */
int flk_opened_read(const fourlink_source *source, const flk_opened *like,
                    const flk_mistake_list *list, flk_opened **opened);
int flk_opened_design(const flk_opened *from, unsigned long design, const deck_number *set,
                      size_t n_set, const flk_mistake_list *list, flk_opened **opened);
int flk_opened_solution(const flk_opened *from, unsigned long number, const flk_mistake_list *list,
                        flk_opened **opened);
int flk_opened_changed(const flk_opened *from, const fourlink_change *change,
                       const flk_mistake_list *list, flk_opened **opened);

/* Keep the rows that values of columns are taken from: FOURLINK_OK, FOURLINK_NO_MEMORY. */
int flk_opened_keep_rows(flk_opened *o);
void flk_opened_free(flk_opened *o);

#endif
