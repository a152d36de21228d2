/* SPDX-License-Identifier: GPL-3.0-or-later
**
** crossing.c - the crank angles at which a column has a value.
**
** Each piece of the motion is sampled.  Between two samples on both sides of the value base/solve finds the zero of the
** difference; where three samples come near to it and turn, their extreme may touch it.  A column that jumps over the
** value, at the end of a piece, through infinity, or as an angle half a turn away, does not have it.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "crossing.h"
#include "extreme_search.h"

#define STEP (M_PI / 180) /* rad, of samples */
#define LEAST_STEPS 8     /* of a piece */
#define EXACT 1e-9        /* of the column's size: it has the value */
#define CONTINUOUS 1e-6   /* ... from piece to piece */
#define SAME 1e-7         /* rad: two crank angles are one */

typedef struct sample {
    double s, off; /* of the piece; the column less the value, NaN: it has none */
} sample;

typedef struct crossings {
    flk_search x;
    flk_tracked t;
    double value, size;
    int varies;         /* 1: the column is not constant */
    double side;        /* 1 or -1: of the samples at hand */
    double first, last; /* rad passed, of the first and of the last that was found */
    unsigned long max, n;
    double *angles;
} crossings;

/* The column less the value; of an angle to the nearest turn. */
static double off_at(double s, void *data)
{
    crossings *k = data;
    double off;
    flk_row row;

    flk_search_compute(&k->x, flk_column_need(k->t.c), flk_search_passed(&k->x, s), &row);
    off = flk_column_value(k->t.c, &row) - k->value;
    if (!(fabs(off) < k->t.bound))
        return GSL_NAN;
    if (k->t.turn > 0)
        off -= k->t.turn * floor(off / k->t.turn + 0.5);
    return off;
}

static double size_of(const crossings *k)
{
    return GSL_MAX_DBL(k->t.turn > 0 ? k->t.turn : k->size, fabs(k->value));
}

/* Keep a parameter of the piece, unless the column does not have the value there, or has been found there. */
static void keep(crossings *k, double s)
{
    double passed = flk_search_passed(&k->x, s), off = off_at(s, k);

    if (!(fabs(off) <= EXACT * size_of(k)) || fabs(passed - k->last) < SAME)
        return;
    if (k->n < k->max)
        k->angles[k->n] = flk_search_corner(&k->x, s);
    k->first = k->n == 0 ? passed : k->first;
    k->last = passed;
    k->n++;
}

/* 1 if an angle passes half a turn from the value between two samples. */
static int leaps(const crossings *k, const sample *a, const sample *b)
{
    return k->t.turn > 0 && fabs(a->off - b->off) > 0.5 * k->t.turn;
}

static void search_step(crossings *k, const sample *a, const sample *b)
{
    flk_bracket bracket;

    if (gsl_isnan(a->off) || gsl_isnan(b->off) || leaps(k, a, b) || (a->off < 0) == (b->off < 0))
        return;
    bracket = flk_bracket_of(a->s, b->s, a->off, b->off);
    keep(k, flk_find_zero(off_at, k, &bracket, 0));
}

/* How far the column is beyond the value, against the side on which the samples are. */
static double beyond(double s, void *data)
{
    crossings *k = data;

    return -k->side * off_at(s, k);
}

/* Three samples on one side of the value that come near to it and turn: between them the column may touch it, or pass it
** there and back. */
static void search_turn(crossings *k, const sample *a, const sample *b, const sample *c)
{
    double sign = b->off < 0 ? -1 : 1;
    flk_sample p[3], top;
    sample near;

    if (gsl_isnan(a->off) || gsl_isnan(b->off) || gsl_isnan(c->off) || leaps(k, a, b) ||
        leaps(k, b, c) || sign * a->off < 0 || sign * c->off < 0 ||
        !(fabs(b->off) < fabs(a->off)) || fabs(b->off) > fabs(c->off))
        return;
    k->side = sign;
    p[0].x = a->s;
    p[1].x = b->s;
    p[2].x = c->s;
    p[0].value = -sign * a->off;
    p[1].value = -sign * b->off;
    p[2].value = -sign * c->off;
    top = flk_find_peak(beyond, k, p, 0);
    near.s = top.x;
    near.off = -sign * top.value;
    if (fabs(near.off) <= EXACT * size_of(k))
        keep(k, near.s);
    else {
        search_step(k, a, &near);
        search_step(k, &near, c);
    }
}

static void search_piece(crossings *k, sample *before)
{
    double length = k->x.piece.to - k->x.piece.from;
    double n = GSL_MAX_DBL(LEAST_STEPS, ceil(length / STEP)), i;
    sample a, b, c;

    a.s = b.s = c.s = 0;
    a.off = b.off = GSL_NAN;
    c.off = off_at(0, k);
    if (fabs(c.off) <= EXACT * size_of(k) ||
        (fabs(c.off - before->off) <= CONTINUOUS * size_of(k) && (c.off < 0) != (before->off < 0)))
        keep(k, 0);
    for (i = 1; i <= n && !flk_search_is_over(&k->x); i++) {
        a = b;
        b = c;
        c.s = i / n;
        c.off = off_at(c.s, k);
        search_turn(k, &a, &b, &c);
        search_step(k, &b, &c);
    }
    if (fabs(c.off) <= EXACT * size_of(k))
        keep(k, 1);
    *before = c;
}

/* The size of the column, and whether it varies. */
static void measure(crossings *k)
{
    double least = GSL_POSINF, most = GSL_NEGINF, i;
    flk_row row;

    while (!flk_search_is_over(&k->x) && flk_search_next(&k->x))
        for (i = 0; i <= LEAST_STEPS; i++) {
            double value;

            flk_search_compute(&k->x, flk_column_need(k->t.c),
                               flk_search_passed(&k->x, i / LEAST_STEPS), &row);
            value = flk_column_value(k->t.c, &row);
            if (!(fabs(value) < k->t.bound))
                continue;
            least = GSL_MIN_DBL(least, value);
            most = GSL_MAX_DBL(most, value);
        }
    k->size = GSL_MAX_DBL(fabs(least), fabs(most));
    k->varies = !(most - least <= EXACT * k->size);
    memset(&k->x.piece, 0, sizeof k->x.piece);
}

static void search_motion(crossings *k)
{
    sample before = {0, 0};

    before.off = k->last = GSL_NAN;
    while (!flk_search_is_over(&k->x) && flk_search_next(&k->x))
        search_piece(k, &before);
    /* a revolution ends with its first row */
    if (k->n > 1 && k->first < SAME && k->last > k->x.motion.length - SAME &&
        flk_course_is_periodic(&k->x.a->course))
        k->n--;
}

int flk_crossings_find(flk_analysis *a, const flk_column *c, fourlink_branch branch, double value,
                       unsigned long max, double *angles, unsigned long *n)
{
    crossings k;

    if (flk_course_stops(&a->course, branch))
        return FOURLINK_TOO_LONG;
    memset(&k, 0, sizeof k);
    k.x.a = a;
    k.x.branch = branch;
    k.value = value;
    k.max = max;
    k.angles = angles;
    a->is_fast = 1;
    flk_search_begin(&k.x);
    flk_search_track(&k.x, &k.t, c);
    k.x.motion.has_loads |= !flk_column_is_of_motion(c);
    k.x.motion.length += k.x.skipped; /* every period has its own */
    k.x.skipped = 0;
    measure(&k);
    if (k.varies)
        search_motion(&k);
    a->is_fast = 0;
    if (flk_search_is_over(&k.x))
        return FOURLINK_LONG_SEARCH;
    if (!k.varies)
        return FOURLINK_CONSTANT;
    *n = k.n;
    return FOURLINK_OK;
}
