/* SPDX-License-Identifier: GPL-3.0-or-later
**
** follow.h - columns along the motion of a branch, piece by piece, and their limits where there is no row.
**
** Within a piece the motion is followed over a parameter s from 0 to 1, in which columns are smooth even
** where they behave as the root of the distance from an end:
**
**    passed = from + (to - from) sin^2(pi s / 2)
*/
#ifndef FOURLINK_FOLLOW_H
#define FOURLINK_FOLLOW_H

#include "column.h"
#include "motion/course.h"
#include "base/polynomial.h"

/* A walk along the motion. */
typedef struct flk_follower {
    flk_analysis *a;
    fourlink_branch branch;
    flk_pieces motion; /* its length, rad, is without the whole periods that are skipped */
    double skipped;    /* length of these periods, rad */
    flk_piece piece;   /* the present one */
} flk_follower;

/* Begin.  flk_follow_next goes to the first piece, then to the next, and returns 0 at the end.  Of a
** motion that repeats only the first period and the last ones are followed, unless flk_follow_all is
** called. */
void flk_follow(flk_follower *f, flk_analysis *a, fourlink_branch branch);
void flk_follow_all(flk_follower *f);
int flk_follow_next(flk_follower *f);

/* How many periods are skipped behind the present piece, the last one of the first period; 0 behind
** others. */
double flk_follow_skips(const flk_follower *f);

/* 1 if the linkage can be assembled in the piece. */
int flk_follow_is_reached(const flk_follower *f);

/* 1 if columns behave as the root of the distance from an end; 1 if there is no row. */
int flk_follow_is_root(flk_piece_end end);
int flk_follow_has_limit(flk_piece_end end);

/* The angle passed at a parameter, rad, and its derivative; just inside the piece at an end that has a
** neighbour, where a load may jump. */
double flk_follow_passed(const flk_follower *f, double s);
double flk_follow_rate(const flk_follower *f, double s);

/* The same, but exactly at the ends; but just inside at both ends. */
double flk_follow_corner(const flk_follower *f, double s);
double flk_follow_inside(const flk_follower *f, double s);

/* The place of the course after `passed`, and the crank angle there, in the deck's unit. */
double flk_follow_place(const flk_follower *f, double passed);
double flk_follow_crank(const flk_follower *f, double place);

/* The least and the largest place of the side of an input on which a place is. */
void flk_follow_ends(const flk_follower *f, double place, double *least, double *most);

/* The row after the angle `passed`.  Rows are counted: after too many, all have the status
** FOURLINK_LONG_SEARCH and the walk is over. */
void flk_follow_row(const flk_follower *f, int needs, double passed, flk_row *row);
int flk_follow_is_over(const flk_follower *f);

/* ------------------------------------------------------------------------------------------- a column */

/* A column that is followed.  An angle continues from turn to turn; it starts anew where its vector passes
** through zero or the linkage cannot be assembled. */
typedef struct flk_followed {
    const flk_column *c;
    double turn;  /* of an angle: a turn in its unit; else 0 */
    double last;  /* value from which an angle continues; NaN: it starts anew */
    double first; /* value at the first row */
    int restarts; /* 1: it started anew after that */
    double bound; /* magnitude beyond which it is infinite */
    int is_noise; /* 1: it measures rounding error */
} flk_followed;

/* Make a column ready to be followed, and include the corners that it has. */
void flk_follow_column(flk_follower *f, flk_followed *t, const flk_column *c);

/* Its value at a parameter. */
double flk_followed_value(const flk_follower *f, const flk_followed *t, double s);

/* A value of an angle, moved by whole turns as near as possible to another. */
double flk_followed_nearest(const flk_followed *t, double value, double near);

/* The turns of an angle in a period, 0 of other columns and where it started anew; those that move it,
** behind the last gap of a revolution, to the first row, which is the last. */
double flk_followed_per_period(const flk_followed *t);
double flk_followed_behind_gap(const flk_followed *t, const flk_follower *f);

/* The part of a turn by which an angle changes, at most a half; 1 if it is half a turn: its vector passes
** through zero. */
double flk_followed_change(const flk_followed *t, double from, double to);
int flk_followed_turns_over(const flk_followed *t, double from, double to);

/* ----------------------------------------------------------------------------------------------- limits */

#define FLK_LIMIT_SCALES 8
#define FLK_LIMIT_NODES 8

/* Rows near an end of the piece, on several scales.  x is the distance from the end, rad, or its root. */
typedef struct flk_limit_rows {
    int at_end, is_root, is_change, is_lock;
    int least_order, greatest_order; /* of the poles of columns there */
    double edge;                     /* rad passed at the end */
    double half; /* rad: so much of the piece has rows here, as a rule its half */
    double x[FLK_LIMIT_SCALES][FLK_LIMIT_NODES];
    flk_row row[FLK_LIMIT_SCALES][FLK_LIMIT_NODES];
} flk_limit_rows;

void flk_limit_rows_near(const flk_follower *f, int needs, int at_end, flk_limit_rows *e);

/* A column at the end of a piece and near it, where rows can be rounding error: a polynomial in x divided
** by x^order; for the size or the direction of a vector, one for each component. */
typedef struct flk_limit {
    double value;  /* at the end; infinite at a pole; NaN: it is not known */
    double growth; /* towards a pole it grows as distance^-growth */
    double
        reach; /* up to this x the polynomials replace the column; 0: only its value at the end is known */
    double rough;   /* ... its integral, which needs them less exact */
    double rounded; /* rad, up to this distance rows are rounding error */
    int order, n, is_root;
    double edge; /* rad passed at the end */
    flk_polynomial of[2];
} flk_limit;

/* Find the limit of a column; `size` is its size elsewhere, `scale` that of its quantity in the closest
** row. */
void flk_limit_find(const flk_limit_rows *e, const flk_followed *t, double size, double scale,
                    flk_limit *l);

/* No limit, where there are rows; the limit of a column of the crank, which has a value there. */
void flk_limit_none(flk_limit *l);
void flk_limit_of_crank(const flk_limit_rows *e, flk_limit *l);

/* The column by its polynomials, NaN beyond their reach; the same for an integral. */
double flk_limit_value(const flk_limit *l, const flk_followed *t, double passed, double near);
double flk_limit_rough(const flk_limit *l, const flk_followed *t, double passed);

#endif
