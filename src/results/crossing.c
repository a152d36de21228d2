/* SPDX-License-Identifier: GPL-3.0-or-later
**
** crossing.c - the crank angles at which a column has a value.
**
** The column is sampled piece by piece (samples.c).  Between two samples on different sides of the value,
** base/solve finds the zero of the difference.  Where three samples approach the value and turn back, their
** extreme may touch it.  A column does not have a value over which it jumps: at the end of a piece, through
** infinity, or as an angle half a turn away.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "crossing.h"

#define EXACT 1e-9      /* of the column's size: closer, it has the value */
#define CONTINUOUS 1e-6 /* ... a smaller step from piece to piece is no jump */
#define SAME 1e-7       /* rad: closer crank angles are the same */

typedef struct sample {
    double s, off; /* its parameter; the column minus the value, NaN: it is undefined */
} sample;

typedef struct crossings {
    flk_samples x;
    const flk_sampled *c;
    double value, size;
    double side;        /* 1 or -1: the side of the present samples */
    double first, last; /* rad passed at the first and the last crossing found */
    unsigned long max, n;
    double *angles;
} crossings;

/* A value of the column minus the value sought; for an angle, to the nearest turn. */
static double off_of(const crossings *k, double value)
{
    double off = value - k->value;

    if (!(fabs(off) < k->c->of.bound))
        return GSL_NAN;
    return flk_followed_nearest(&k->c->of, off, 0);
}

static double off_at(double s, void *data)
{
    const crossings *k = data;

    return off_of(k, flk_samples_value(&k->x, k->c, s, GSL_NAN));
}

static double size_of(const crossings *k)
{
    return GSL_MAX_DBL(k->c->of.turn > 0 ? k->c->of.turn : k->size, fabs(k->value));
}

/* Keep the crossing at a parameter, if the column has the value there and it is not the last crossing
** found. */
static void keep(crossings *k, double s)
{
    double passed = flk_follow_corner(&k->x.f, s), off = off_at(s, k);

    if (!(fabs(off) <= EXACT * size_of(k)) || fabs(passed - k->last) < SAME)
        return;
    if (k->n < k->max)
        k->angles[k->n] = flk_follow_angle(&k->x.f, passed);
    k->first = k->n == 0 ? passed : k->first;
    k->last = passed;
    k->n++;
}

/* 1 if between two samples an angle passes the point half a turn from the value. */
static int turns_over(const crossings *k, const sample *a, const sample *b)
{
    return k->c->of.turn > 0 && fabs(a->off - b->off) > 0.5 * k->c->of.turn;
}

static void search_step(crossings *k, const sample *a, const sample *b)
{
    flk_bracket bracket;

    if (gsl_isnan(a->off) || gsl_isnan(b->off) || turns_over(k, a, b) ||
        (a->off < 0) == (b->off < 0))
        return;
    bracket = flk_bracket_of(a->s, b->s, a->off, b->off);
    keep(k, flk_find_zero(off_at, k, &bracket, 0));
}

/* How far the column is beyond the value, seen from the side of the samples. */
static double beyond(double s, void *data)
{
    crossings *k = data;

    return -k->side * off_at(s, k);
}

/* Three samples on one side of the value approach it and turn back: between them the column may touch the
** value, or cross it twice. */
static void search_turn(crossings *k, const sample *a, const sample *b, const sample *c)
{
    double sign = b->off < 0 ? -1 : 1;
    flk_sample p[3], top;
    sample near;

    if (sign * a->off < 0 || sign * c->off < 0 || !(fabs(b->off) < fabs(a->off)) ||
        !(fabs(b->off) <= fabs(c->off))) /* or one of them is NaN */
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
    sample a, b, c;
    size_t i;

    a.s = b.s = c.s = 0;
    a.off = b.off = c.off = GSL_NAN;
    for (i = 0; i < k->x.n && !flk_follow_is_over(&k->x.f); i++) {
        a = b;
        b = c;
        c.s = k->x.s[i];
        c.off = off_of(k, k->c->v[i]);
        if (i == 0 && (fabs(c.off) <= EXACT * size_of(k) ||
                       (fabs(c.off - before->off) <= CONTINUOUS * size_of(k) &&
                        (c.off < 0) != (before->off < 0))))
            keep(k, c.s);
        search_turn(k, &a, &b, &c);
        search_step(k, &b, &c);
    }
    if (fabs(c.off) <= EXACT * size_of(k))
        keep(k, c.s);
    *before = c;
}

static void begin(crossings *k, const flk_samples_room *room, flk_analysis *a, const flk_column *c,
                  fourlink_branch branch)
{
    flk_samples_begin(&k->x, room, a, branch);
    flk_samples_add(&k->x, c);
    flk_follow_all(&k->x.f);
    k->c = &k->x.columns[0];
}

/* Find the size of the column; returns 0 if it is constant. */
static int measure(crossings *k)
{
    double least = GSL_POSINF, most = GSL_NEGINF;
    size_t i;

    while (flk_samples_next(&k->x))
        for (i = 0; i < k->x.n; i++) {
            double value = k->c->v[i];

            if (!(fabs(value) < k->c->of.bound))
                continue;
            least = GSL_MIN_DBL(least, value);
            most = GSL_MAX_DBL(most, value);
        }
    k->size = GSL_MAX_DBL(fabs(least), fabs(most));
    return !(most - least <= EXACT * k->size);
}

static void search_motion(crossings *k)
{
    sample before = {0, 0};

    before.off = k->last = GSL_NAN;
    while (flk_samples_next(&k->x))
        search_piece(k, &before);
    /* a revolution ends with its first row */
    if (k->n > 1 && k->first < SAME && k->last > k->x.f.motion.length - SAME &&
        flk_crank_motion_is_periodic(&k->x.f.a->crank_motion))
        k->n--;
}

int flk_crossings_find(const flk_samples_room *room, flk_analysis *a, const flk_column *c,
                       fourlink_branch branch, double value, unsigned long max, double *angles,
                       unsigned long *n)
{
    crossings k;
    int varies;

    if (flk_crank_motion_stops(&a->crank_motion, branch))
        return FOURLINK_TOO_LONG;
    memset(&k, 0, sizeof k);
    k.value = value;
    k.max = max;
    k.angles = angles;
    a->is_fast = 1;
    begin(&k, room, a, c, branch);
    varies = measure(&k);
    begin(&k, room, a, c, branch);
    if (varies)
        search_motion(&k);
    a->is_fast = 0;
    if (flk_follow_is_over(&k.x.f))
        return FOURLINK_LONG_SEARCH;
    if (!varies)
        return FOURLINK_CONSTANT;
    *n = k.n;
    return FOURLINK_OK;
}
