/* SPDX-License-Identifier: GPL-3.0-or-later
**
** samples.h - samples of columns along the motion of a branch, piece by piece.
**
** A piece of the motion is sampled once for all columns, in steps of about four degrees over the parameter of
** follow.h, of eight where all columns are smooth.  Where there is no row, at dead positions and change
** points, columns have a limit (limit.h).  A piece in which friction locks the mechanism is cut
** further, where that begins and ends.
**
** The samples of a piece are n parameters s, rising within 0 to 1, and for each column n values v: v[i] is
** the column at s[i], and all columns have the same s.  A value is finite or NaN.  Values of an angle go on
** from one sample to the next without a jump of a turn, unless `starts_anew` is set.
*/
#ifndef FOURLINK_SAMPLES_H
#define FOURLINK_SAMPLES_H

#include "follow.h"

#define FLK_SAMPLES_MOST 1000 /* of a piece */

/* A column with its samples in the present piece. */
typedef struct flk_sampled {
    flk_followed of;
    int is_of_crank;    /* 1: it is defined where the linkage cannot be assembled */
    double *v;          /* samples, continuous for an angle; NaN: no value, or a pole */
    double *vector[2];  /* of a size or direction: its vector there; else null */
    double size;        /* its largest magnitude in the middle of pieces so far, */
    double scale;       /* ... and that of its quantity in the middle of this piece */
    double largest;     /* the largest magnitude of the samples */
    flk_limit limit[2]; /* at the beginning and the end of the piece */
    int is_inside[2];   /* 1: the first, the last sample is just inside, where a load jumps */
    double corner[2];   /* its value at the end itself or, if that is the sample, just inside */
    int starts_anew;    /* 1: an angle starts anew in the piece */
} flk_sampled;

/* Room for the samples of so many columns. */
typedef struct flk_samples_room {
    flk_sampled *columns;
    flk_limit_rows *near; /* rows near an end */
    double *values;
} flk_samples_room;

/* Allocate and free it.  0 when out of memory. */
int flk_samples_open(flk_samples_room *room, size_t most);
void flk_samples_close(flk_samples_room *room);

typedef struct flk_samples {
    flk_follower f;
    int needs, has_noise;
    int may_lock; /* 1: friction can lock the mechanism */
    size_t n_columns;
    flk_sampled *columns;
    flk_limit_rows *near;
    size_t n;       /* samples of the present piece */
    double *s;      /* their parameters */
    double *force;  /* their largest pin force, N, if it may_lock; NaN at the ends of the piece */
    int has_limit;  /* 1: at an end of it there is no row */
    int is_reached; /* 1: the linkage can be assembled in it */
    int is_whole;   /* 1: it is not a part that ends at an edge of a locked range */
    int has_lock;   /* 1: friction locks the mechanism in a sample */
    flk_piece rest; /* the rest of the piece after such a part */
    int n_parts;
} flk_samples;

/* Begin, add columns, then go through the pieces; the last returns 0. */
void flk_samples_begin(flk_samples *x, const flk_samples_room *room, flk_analysis *a,
                       fourlink_branch branch);
void flk_samples_add(flk_samples *x, const flk_column *c);
int flk_samples_next(flk_samples *x);

/* Insert a sample of all columns before number i, which is not the first; 0 if there is no room. */
int flk_samples_insert(flk_samples *x, size_t i, double s);

/* Where the vector of a column has its least size between samples i and i + 1, nearly: where it is at
** right angles to its change over the step.  0 if that is nowhere.  And how small it may be there, by
** how it bends. */
int flk_samples_find_least_size(const flk_samples *x, const flk_sampled *c, size_t i, double *s);
double flk_samples_least_size(const flk_samples *x, const flk_sampled *c, size_t i);

/* A column at a parameter.  An angle is moved by whole turns next to `near`; it is NaN half a turn from
** it. */
double flk_samples_value(const flk_samples *x, const flk_sampled *c, double s, double near);

/* The same for an integral: where rows are rounding error, the polynomial that follows the others best. */
double flk_samples_smooth(const flk_samples *x, const flk_sampled *c, double s);

/* How large the column's quantity is in a row, in its unit: rounding error is small beside it. */
double flk_samples_scale(const flk_samples *x, const flk_sampled *c, const flk_row *row);

/* |sin(mu)|: where links are closer to one line, columns change within 1e-5 rad, and rows beside one another
** differ by rounding. */
#define FLK_SAMPLES_NEAR_LINE 0.05

/* 1 at an end of the piece where there is no row. */
int flk_samples_is_at_limit(const flk_samples *x, double s);

/* 1 where rows of a column are rounding error. */
int flk_sampled_is_rounded(const flk_sampled *c, double passed);

/* The place of the course at a sample, or at another parameter. */
double flk_samples_place(const flk_samples *x, const flk_sampled *c, double s);

#endif
