/* SPDX-License-Identifier: GPL-3.0-or-later
**
** limit.h - columns at dead positions and change points, where there is no row.
*/
#ifndef FOURLINK_LIMIT_H
#define FOURLINK_LIMIT_H

#include "follow.h"
#include "base/polynomial.h"

#define FLK_LIMIT_SCALES 8
#define FLK_LIMIT_NODES 8

/* Rows near an end of the piece, on several scales.  x is the distance from the end, rad, or its root. */
typedef struct flk_limit_rows {
    int at_end, is_root, is_change;
    int pole_order; /* the greatest order that columns can have there */
    double edge;    /* rad passed at the end */
    double x[FLK_LIMIT_SCALES][FLK_LIMIT_NODES];
    flk_row row[FLK_LIMIT_SCALES][FLK_LIMIT_NODES];
} flk_limit_rows;

void flk_limit_rows_near(const flk_follower *f, int needs, int at_end, flk_limit_rows *e);

/* A column at the end of a piece and near it, where rows can be rounding error: a polynomial in x divided
** by x^order; for the size or the direction of a vector, one for each component. */
typedef struct flk_limit {
    double value; /* at the end; infinite at a pole; NaN: it is not known */
    double
        reach; /* up to this x the polynomials replace the column; 0: only its value at the end is known */
    double rounded; /* rad, up to this distance rows are rounding error */
    int order, n, is_root;
    double edge; /* rad passed at the end */
    flk_polynomial of[2];
} flk_limit;

/* Find the limit of a column; `size` is its size elsewhere. */
void flk_limit_find(const flk_limit_rows *e, const flk_followed *t, double size, flk_limit *l);

/* No limit, where there are rows; the limit of a column of the crank, which has a value there. */
void flk_limit_none(flk_limit *l);
void flk_limit_of_crank(const flk_limit_rows *e, flk_limit *l);

/* The column by its polynomials, NaN beyond their reach. */
double flk_limit_value(const flk_limit *l, const flk_followed *t, double passed, double near);

#endif
