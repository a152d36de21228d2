/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mean.c - the mean and the root mean square of a column over the crank angles of a deck's motion.
**
**    mean = (integral of y dtheta) / c,   rms = sqrt((integral of y^2 dtheta) / c)
**
** with c the angle of that part of the motion in which the linkage can be assembled.  Each piece of the
** motion (motion/crank_motion.c) is integrated over the parameter s of follow.h, in which a root at its end
** is smooth: at a dead position a velocity grows as 1 / sqrt(distance) and has a mean.  A part in which the
** rule is not exact is halved.  Where that does not end, the integral is infinite.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "follow.h"
#include "mean.h"

#define STEP (M_PI / 18)     /* rad, of a part at first */
#define MOST_PARTS 2e4       /* of the whole motion, at first */
#define HALVINGS 2000        /* at most */
#define EXACT 1e-10          /* error of a part, relative to itself or to the whole */
#define ROUNDING 1e-6        /* relative error that rows can have near a pole */
#define SHORTEST 1e-10       /* part of a piece that is not halved any more, */
#define SHORTEST_AT_END 1e-4 /* at an end without a row */
#define UNBOUNDED 1e-6 /* error relative to the whole that so short a part has only at a pole */

enum { UP = 1, DOWN = 2 };

/* The integrals of 1, y, y^2. */
typedef struct moments {
    double of[3];
} moments;

typedef struct means {
    flk_follower x;
    flk_followed t;  /* t.last: value from which an angle continues; NaN: it starts anew */
    int first, most; /* powers of y to integrate */
    int is_rough;    /* 1: in the present part an angle jumps, or the rule is not exact */
    int poles;       /* UP, DOWN */
    int halvings;
    moments total, here; /* before, and since an angle started anew */
    double size[3];      /* integrals of magnitudes so far */
} means;

static double value_at(const means *m, double s)
{
    flk_row row;

    flk_follow_row(&m->x, flk_column_need(m->t.c), flk_follow_passed(&m->x, s), &row);
    return flk_column_value(m->t.c, &row);
}

/* 1, y, y^2; where there is no value y is 0. */
static void powers(double s, void *data, double *power)
{
    means *m = data;
    double value = value_at(m, s);

    if (gsl_isnan(value)) {
        value = 0;
    } else if (fabs(value) >= m->t.bound) {
        m->poles |= value > 0 ? UP : DOWN;
        value = 0;
    } else if (m->t.turn > 0 && !gsl_isnan(m->t.last)) {
        value = flk_followed_nearest(&m->t, value, m->t.last);
        m->is_rough |= fabs(value - m->t.last) > m->t.turn / 6;
    }
    power[0] = flk_follow_rate(&m->x, s);
    power[1] = value * power[0];
    power[2] = value * power[1];
}

static void add_moments(moments *sum, const moments *more, double times)
{
    int k;

    for (k = 0; k < 3; k++)
        sum->of[k] += times * more->of[k];
}

/* The moments of y + by. */
static void shift(moments *m, double by)
{
    m->of[2] += by * (2 * m->of[1] + by * m->of[0]);
    m->of[1] += by * m->of[0];
}

static void start_anew(means *m, double value)
{
    add_moments(&m->total, &m->here, 1);
    memset(&m->here, 0, sizeof m->here);
    m->t.last = value;
}

/* Follow an angle to a parameter, or at an end without a row to one beside it. */
static void follow_angle(means *m, double s)
{
    double value;

    if (!(m->t.turn > 0))
        return;
    if (s <= 0 && flk_follow_has_limit(m->x.piece.begin))
        s = 1e-3;
    else if (s >= 1 && flk_follow_has_limit(m->x.piece.end))
        s = 1 - 1e-3;
    value = value_at(m, s);
    if (gsl_isnan(value))
        return;
    if (gsl_isnan(m->t.last) || flk_followed_turns_over(&m->t, m->t.last, value))
        start_anew(m, value);
    else
        m->t.last = flk_followed_nearest(&m->t, value, m->t.last);
}

/* 1 if a part must not be halved. */
static int is_shortest(const means *m, double from, double to)
{
    int at_end = (from <= 0 && flk_follow_has_limit(m->x.piece.begin)) ||
                 (to >= 1 && flk_follow_has_limit(m->x.piece.end));

    return to - from < (at_end ? SHORTEST_AT_END : SHORTEST);
}

/* 1 if the rule is exact for a part, or if its error is rounding error of the rows, which halving does not
** reduce. */
static int is_exact(const flk_integral *part, const flk_integral *both, double whole)
{
    return part->error <= EXACT * part->size || part->error <= EXACT * whole ||
           (both && part->error <= ROUNDING * part->size && part->error > both->error / 8);
}

/* The signs of a pole in a part. */
static int signs_of(const flk_integral *part)
{
    return (part->value < 0.999 * part->size ? DOWN : 0) |
           (part->value > -0.999 * part->size ? UP : 0);
}

/* Integrate a piece between two parameters.  `both` is null, or the integrals of the part of which this is
** one half. */
static void integrate(means *m, double from, double to, const flk_integral *both)
{
    double middle = 0.5 * (from + to);
    int shortest = is_shortest(m, from, to), k;
    flk_integral i[3];

    m->is_rough = 0;
    flk_integrate(powers, m, 3, from, to, i);
    for (k = m->first; k <= m->most; k++) {
        m->size[k] += i[k].size - (both ? both[k].size / 2 : 0);
        m->is_rough |= !is_exact(&i[k], both ? &both[k] : NULL, m->size[k]);
        if (shortest && m->t.turn <= 0 && i[k].error > UNBOUNDED * m->size[k])
            m->poles |= signs_of(&i[k]);
    }
    if (m->is_rough && !shortest && !m->t.is_noise && m->halvings < HALVINGS &&
        !flk_follow_is_over(&m->x)) {
        m->halvings++;
        integrate(m, from, middle, i);
        integrate(m, middle, to, i);
        return;
    }
    for (k = 0; k < 3; k++)
        m->here.of[k] += i[k].value;
    follow_angle(m, to);
}

static int is_done(const means *m)
{
    return m->poles == (UP | DOWN) || (m->poles && m->most == 2) || flk_follow_is_over(&m->x);
}

static void integrate_piece(means *m)
{
    double length = m->x.piece.to - m->x.piece.from;
    double n = 2 + floor(length / GSL_MAX_DBL(STEP, m->x.motion.length / MOST_PARTS)), i;

    follow_angle(m, 0);
    for (i = 0; i < n && !is_done(m); i++)
        integrate(m, i / n, (i + 1) / n, NULL);
}

/* Of a motion that repeats, the first period counts for all that are skipped. */
static void integrate_motion(means *m)
{
    flk_follower *x = &m->x;
    double periods;
    int has_gap = 0, is_first = 1;

    for (; !is_done(m) && flk_follow_next(x); is_first = 0) {
        if (flk_follow_is_reached(x)) {
            if (is_first) {
                follow_angle(m, 0);
                m->t.first = m->t.last;
            }
            integrate_piece(m);
        } else {
            start_anew(m, GSL_NAN);
            has_gap = 1;
        }
        periods = flk_follow_skips(x);
        if (periods > 0) {
            add_moments(&m->total, &m->total, periods);
            add_moments(&m->here, &m->here, periods);
        }
    }
    if (has_gap)
        shift(&m->here, flk_followed_behind_gap(&m->t, x));
    add_moments(&m->total, &m->here, 1);
}

static void begin_mean(means *m, flk_analysis *a, const flk_column *c, fourlink_branch branch,
                       flk_statistic statistic)
{
    int flags = flk_column_flags(c);

    memset(m, 0, sizeof *m);
    flk_follow(&m->x, a, branch);
    flk_follow_column(&m->x, &m->t, c);
    if (flags & FOURLINK_OF_CRANK)
        m->t.turn = 0; /* it goes on by itself */
    m->first = m->most = statistic == FLK_MEAN ? 1 : 2;
    if (m->t.turn > 0 || (flags & FOURLINK_OF_CRANK)) {
        flk_follow_all(&m->x); /* it does not repeat */
        m->first = 1;
    }
}

static int of_instant(means *m, flk_statistic statistic, double *mean)
{
    double value;
    flk_row row;

    flk_follow_row(&m->x, flk_column_need(m->t.c), 0, &row);
    value = flk_column_value(m->t.c, &row);
    if (row.at.status != FOURLINK_OK && gsl_isnan(value))
        return row.at.status;
    *mean = statistic == FLK_MEAN ? value : fabs(value);
    return FOURLINK_OK;
}

int flk_mean_find(flk_analysis *a, const flk_column *c, fourlink_branch branch,
                  flk_statistic statistic, double *mean)
{
    means m;

    if (flk_crank_motion_stops(&a->crank_motion, branch))
        return FOURLINK_TOO_LONG;
    begin_mean(&m, a, c, branch, statistic);
    if (m.x.motion.length <= 0)
        return of_instant(&m, statistic, mean);
    a->is_fast = !m.t.is_noise;
    integrate_motion(&m);
    a->is_fast = 0;
    if (flk_follow_is_over(&m.x))
        return FOURLINK_LONG_SEARCH;
    if (statistic == FLK_MEAN && m.poles == (UP | DOWN))
        return FOURLINK_NO_MEAN;
    if (!m.poles && !(m.total.of[0] > 0))
        return FOURLINK_NOT_REACHED;
    *mean = m.poles == DOWN && statistic == FLK_MEAN ? GSL_NEGINF
            : m.poles                                ? GSL_POSINF
            : statistic == FLK_MEAN                  ? m.total.of[1] / m.total.of[0]
                                                     : sqrt(m.total.of[2] / m.total.of[0]);
    return FOURLINK_OK;
}
