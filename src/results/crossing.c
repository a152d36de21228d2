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

/* Samples here are of the column minus the value sought; NaN: it is undefined. */
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
static int turns_over(const crossings *k, const flk_sample *a, const flk_sample *b)
{
    return k->c->of.turn > 0 && fabs(a->value - b->value) > 0.5 * k->c->of.turn;
}

static void search_step(crossings *k, const flk_sample *a, const flk_sample *b)
{
    flk_bracket bracket;

    if (gsl_isnan(a->value) || gsl_isnan(b->value) || turns_over(k, a, b) ||
        (a->value < 0) == (b->value < 0))
        return;
    bracket = flk_bracket_of(a->x, b->x, a->value, b->value);
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
static void search_turn(crossings *k, const flk_sample *a, const flk_sample *b, const flk_sample *c)
{
    double sign = b->value < 0 ? -1 : 1;
    flk_sample p[3], near;
    int i;

    if (sign * a->value < 0 || sign * c->value < 0 || !(fabs(b->value) < fabs(a->value)) ||
        !(fabs(b->value) <= fabs(c->value))) /* or one of them is NaN */
        return;
    k->side = sign;
    p[0] = *a;
    p[1] = *b;
    p[2] = *c;
    for (i = 0; i < 3; i++)
        p[i].value *= -sign;
    near = flk_find_peak(beyond, k, p, 0);
    near.value *= -sign;
    if (fabs(near.value) <= EXACT * size_of(k))
        keep(k, near.x);
    else {
        search_step(k, a, &near);
        search_step(k, &near, c);
    }
}

static void search_piece(crossings *k, flk_sample *before)
{
    flk_sample a, b, c;
    size_t i;

    a.x = b.x = c.x = 0;
    a.value = b.value = c.value = GSL_NAN;
    for (i = 0; i < k->x.n && !flk_follow_is_over(&k->x.f); i++) {
        a = b;
        b = c;
        c.x = k->x.s[i];
        c.value = off_of(k, k->c->v[i]);
        if (i == 0 && (fabs(c.value) <= EXACT * size_of(k) ||
                       (fabs(c.value - before->value) <= CONTINUOUS * size_of(k) &&
                        (c.value < 0) != (before->value < 0))))
            keep(k, c.x);
        search_turn(k, &a, &b, &c);
        search_step(k, &b, &c);
    }
    if (fabs(c.value) <= EXACT * size_of(k))
        keep(k, c.x);
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
    flk_sample before = {0, 0};

    before.value = k->last = GSL_NAN;
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
