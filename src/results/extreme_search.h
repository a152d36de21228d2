/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme_search.h - the search for extremes: what extreme.c, extreme_samples.c, extreme_narrow.c,
** extreme_peaks.c, extreme_limits.c and extreme_locks.c share.  mean.c follows columns in the same way.
*/
#ifndef FOURLINK_EXTREME_SEARCH_H
#define FOURLINK_EXTREME_SEARCH_H

#include <stddef.h>

#include "base/solve.h"
#include "column.h"
#include "motion/pieces.h"
#include "polynomial.h"

#define FLK_SEARCH_MOST_SAMPLES 2000 /* of a stretch */
#define FLK_SEARCH_MOST_STEPS 400    /* with which it begins */
#define FLK_SEARCH_MARGIN 8    /* a column may reach so many times its roughness beyond a sample */
#define FLK_SEARCH_CLOSE 1e-12 /* of a value: equal but for rounding */

/* An extreme in the search. */
typedef struct flk_found {
    int is_there;
    double value, angle;
    double corner; /* printed for an angle just inside a corner, if the row there is as good */
} flk_found;

/* A column in the search. */
typedef struct flk_tracked {
    const flk_column *c;
    double turn;        /* of an angle: a turn in its unit; else 0 */
    double last;        /* value from which an angle goes on; NaN: it starts anew */
    double before;      /* the same at the begin of the stretch */
    double first;       /* value at the first row */
    int restarts;       /* 1: it started anew after that */
    double size;        /* largest magnitude of the samples */
    double size_middle; /* largest in the middle of long pieces */
    double bound;       /* magnitude beyond which it is infinite */
    int is_noise;       /* 1: a measure of rounding */
    int has_pole[2];    /* 1: unbounded at the begin, the end of the piece */
    double lost[2];   /* rad from the begin, the end of the piece, within which rows are rounding */
    int is_rough;     /* 1: rows near the present end of the piece may be rounding, */
    double rounding;  /* more than this, of its size, is too much */
    double size_here; /* beside this magnitude */
    flk_polynomial near_end; /* gives its limit there; up to this distance from the end */
    double most_near_end;    /* rows that differ by more than `doubt` are rounding */
    double doubt;
    double close;      /* part of a value: equal but for rounding, or for integration */
    flk_found best[2]; /* largest, smallest */
    flk_found here[2]; /* the same since an angle started anew, or in a piece of an actual motion */
    double known[2];   /* of an actual motion: its largest value is not less than known[0] ... */
} flk_tracked;

typedef struct flk_search {
    flk_analysis *a;
    fourlink_branch branch;
    int needs;
    size_t n_columns;
    flk_tracked *columns;
    int has_noise; /* 1: a column measures rounding, so samples come from the deck's own solver */
    double from,
        end; /* first and last angle of the motion, in the deck's unit; of rows by time the times, s */
    flk_pieces motion; /* its length, rad, but for the whole periods that are skipped, */
    double skipped;    /* rad */
    double per_rad;    /* the deck's unit of angle for 1 rad passed, with sign */
    flk_piece piece;
    double low, high; /* of the stretch in the piece, s */
    double step;      /* of its first samples */
    double
        closest_line; /* the least |sin(mu)| of the samples: near 0 columns change within 1e-5 rad */
    int pole_order;   /* of the poles that columns can have at the end at hand */
    int has_lock;     /* 1: friction locks the mechanism in a sample */
    int is_cut;       /* 1: the piece is a part of such a stretch, whose size is known */
    size_t n;         /* number of samples */
    int halved[FLK_SEARCH_MOST_STEPS + 1]; /* samples added within each first step */
    double *s;                             /* their parameters */
    double *values; /* FLK_SEARCH_MOST_SAMPLES for each column; NaN: no value */
} flk_search;

/* ---- extreme_samples.c */

/* Begin with the motion of x->a on x->branch; its first piece comes with flk_search_next, which is 0 at the end. */
void flk_search_begin(flk_search *x);
int flk_search_next(flk_search *x);

/* 1 if the linkage can be assembled in the piece. */
int flk_search_is_reached(const flk_search *x);

/* The derivative of the angle passed, rad, by the parameter. */
double flk_search_rate(const flk_search *x, double s);

/* The angle passed at a parameter of the piece, rad; just inside the piece at its ends.  The crank angle after
** such a part of the motion, in the deck's unit; that of the corner if the parameter is at one. */
double flk_search_passed(const flk_search *x, double s);
double flk_search_angle(const flk_search *x, double passed);
double flk_search_corner(const flk_search *x, double s);

/* A search has a budget of rows; without any left, rows have the status FOURLINK_LONG_SEARCH, and the search is over. */
int flk_search_is_over(const flk_search *x);

/* The row at an angle of the search: of rows by time that is a time, s.  The crank angle there, in the deck's unit. */
void flk_search_row_at(const flk_search *x, int needs, double angle, flk_row *row);
double flk_search_crank(const flk_search *x, double angle);

void flk_search_compute(const flk_search *x, int needs, double passed, flk_row *row);

/* A column at a parameter; of an angle the value nearest to `near`, NaN half a turn from it. */
double flk_search_value(const flk_search *x, const flk_tracked *t, double s, double near);

/* Make a column ready to be followed on x->a. */
void flk_search_track(const flk_search *x, flk_tracked *t, const flk_column *c);

/* The whole turns of an angle from one value to another, in its unit; a value moved by such turns as near as
** possible to another. */
double flk_search_turns(const flk_tracked *t, double from, double to);
double flk_search_nearest(const flk_tracked *t, double value, double near);

/* The part of a turn by which an angle jumps, at most a half; 1 if it jumps by half a turn. */
double flk_search_leap(const flk_tracked *t, double from, double to);
int flk_search_turns_over(const flk_tracked *t, double from, double to);

/* 1 where rows of a column are rounding. */
int flk_search_is_lost(const flk_search *x, const flk_tracked *t, double s);

/* 1: columns behave as the root of the distance at such an end; no row is there. */
int flk_search_is_root(flk_piece_end end);
int flk_search_has_limit(flk_piece_end end);

/* Samples of a stretch in even steps, and closer where there is no row at its end. */
void flk_search_sample(flk_search *x, size_t steps);

/* More samples until no angle jumps by more than a sixth of a turn, or they are too close. */
void flk_search_resolve_leaps(flk_search *x);

/* Make an angle continuous through the samples of a stretch. */
void flk_search_follow(flk_search *x, flk_tracked *t, double *values);

/* Put a sample of all columns before number i. */
void flk_search_insert(flk_search *x, size_t i, double s);

double *flk_search_row(const flk_search *x, size_t column);

/* The nearest sample on a side that is not so close that differences are rounding, or the last one; i if there is
** none. */
size_t flk_search_beside(const flk_search *x, const double *values, size_t i, int side);

/* value for the largest (which = 0), -value for the smallest (1). */
double flk_search_signed(int which, double value);

/* Keep a value if it is better than the best so far; of equal ones the first. */
void flk_search_offer(flk_found *best, int which, double value, double angle, double corner);
void flk_search_offer_at(const flk_search *x, flk_found *best, int which, double value, double s);

/* 1 if another piece has a better value, in an actual motion, each of whose pieces has extremes of its own. */
int flk_search_is_beaten(const flk_search *x, const flk_tracked *t, int which, double value);

/* Close the part of an angle's curve since it started anew, moved by whole turns. */
void flk_search_commit(flk_tracked *t, double shift);

/* ---- extreme_narrow.c */

/* 1 if the samples about number i are evenly spaced. */
int flk_search_is_even(const flk_search *x, size_t i);

/* How far sample i is from what its four neighbours say: by so much a column may differ from a smooth curve. */
double flk_search_roughness(const flk_search *x, const double *values, size_t i, int even);

/* The largest magnitude of the samples about number i. */
double flk_search_size_about(const flk_search *x, const double *values, size_t i);

/* Halve steps where a better extreme may hide. */
void flk_search_resolve_narrow(flk_search *x);

/* ---- extreme_peaks.c */

/* Offer the first of the best samples of a column; then the peaks between samples. */
void flk_search_offer_samples(const flk_search *x, flk_tracked *t, const double *values);
void flk_search_refine_peaks(flk_search *x, flk_tracked *t, const double *values);

/* ---- extreme_limits.c */

/* Offer the limits of all columns at an end of the piece where there is no row; infinite at a pole. */
void flk_search_find_limits(flk_search *x, int at_end);

/* Offer the poles of a column between samples and at corners. */
void flk_search_find_poles(flk_search *x, flk_tracked *t, const double *values);

/* ---- extreme_locks.c */

/* 1 if friction locks the mechanism in the first sample.  `edge`: the angle passed at which this ends, rad, on the side
** with rows; infinite if no sample is beyond it. */
int flk_search_find_lock(const flk_search *x, double *edge);

#endif
