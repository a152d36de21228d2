/* SPDX-License-Identifier: GPL-3.0-or-later
**
** style.h - how the numbers of a table's columns are written, so that they are aligned.
*/
#ifndef FOURLINK_STYLE_H
#define FOURLINK_STYLE_H

#include "base/digits.h"
#include "sheet.h"

#define EACH_PAGE (-1)

/* Of a column. */
typedef struct style {
    int decimals;
    int exponent; /* 1: as 1.2e-16 */
    size_t width;
    size_t line,
        n_cells;  /* of the first style: the width of a line of the present page, its cells */
    double limit; /* numbers below it fit the width, with a sign and a blank */
    double size;  /* the largest finite magnitude of the column */
    int page;     /* from fit_columns; EACH_PAGE: on each of them */
    unsigned long column;          /* of the k-th style: the k-th column that is printed */
    const fourlink_value *extreme; /* that is being written; null: none */
} style;

/* The layout of a table is a style for each column, and after these the cells of a line. */
#define STYLE_AND_CELL (sizeof(style) + sizeof(digits_cell))
#define STYLE_CELLS(s) ((digits_cell *)(void *)((style *)(s)->layout + (s)->v.n_columns))

/* Find the size of each column, in rows spread evenly over the motion that have at least this transmission
** angle, rad.  That of a column which is only rounding, compared with others of its quantity, is 0, or
** theirs if all have one. */
void style_find_sizes(const view *v, double sound, int has_all, double *values, style *styles);

/* Find the styles of a deck's columns; `is_at`: of rows at any crank angles.  `values` is room for a row. */
void style_find(const view *v, int is_at, double *values, style *styles);

/* Write a number with the decimals of its column; returns its end.  The same right-aligned in a field. */
char *style_text(double value, const style *x, char out[FORMAT_SIZE]);
void style_put(line *l, double value, const style *x, size_t width);

#endif
