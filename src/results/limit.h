/* SPDX-License-Identifier: GPL-3.0-or-later
**
** limit.h - columns at dead positions and change points, where there is no row.
*/
#ifndef FOURLINK_LIMIT_H
#define FOURLINK_LIMIT_H

#include "follow.h"
#include "polynomial.h"

#define FLK_LIMIT_SCALES 8
#define FLK_LIMIT_NODES 8

/* Rows near an end of the piece, on several scales.  x is the distance from the end, rad, or its root. */
typedef struct flk_limit_rows {
    int at_end, is_root, is_change;
    int pole_order; /* the greatest that columns can have there */
    double edge;    /* rad passed at the end */
    double x[FLK_LIMIT_SCALES][FLK_LIMIT_NODES];
    flk_row row[FLK_LIMIT_SCALES][FLK_LIMIT_NODES];
} flk_limit_rows;

void flk_limit_rows_near(const flk_follower *f, int needs, int at_end, flk_limit_rows *e);

/* A column at the end of a piece, and near it, where rows can be rounding: a polynomial in x over x^order; of the size or
** the direction of a vector both components. */
typedef struct flk_limit {
    double value;   /* at the end; infinite at a pole; NaN: it is not known */
    double reach;   /* up to this x the polynomials stand for the column; 0: nowhere */
    double rounded; /* rad, up to this distance rows are rounding */
    int order, n, is_root;
    double edge; /* rad passed at the end */
    flk_polynomial of[2];
} flk_limit;

/* Find it for a column of this size elsewhere. */
void flk_limit_find(const flk_limit_rows *e, const flk_followed *t, double size, flk_limit *l);

/* None, where there are rows; that of a column that is defined there too. */
void flk_limit_none(flk_limit *l);
void flk_limit_of_crank(const flk_limit_rows *e, flk_limit *l);

/* The column by its polynomials, NaN beyond their reach. */
double flk_limit_value(const flk_limit *l, const flk_followed *t, double passed, double near);

#endif
