/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pole.c - where a column grows without bound in a piece of the motion.
**
** At a dead position or a change point, where there is no row, the limit of the column has its pole.
** Elsewhere the column is a quotient whose denominator is 0 there.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "pole.h"

#define BESIDE_POLE 1e-8 /* s */
#define BESIDE_END 1e-4  /* s, at an end of the piece, */
#define DISTINCT 1e-9    /* ... at least so many rad, or the row is that at the end */

typedef struct quotient {
    const flk_samples *x;
    const flk_sampled *c;
} quotient;

/* The denominator at a parameter. */
static double divisor_at(double s, void *data)
{
    const quotient *q = data;
    const flk_column *c = q->c->of.c;
    flk_row row;

    flk_follow_row(&q->x->f, flk_column_need(c), flk_follow_passed(&q->x->f, s), &row);
    return row.at.status == FOURLINK_OK ? flk_column_denominator(c, &row) : GSL_NAN;
}

/* 1 if the column grows towards a parameter from one side: else the numerator vanishes too. */
static int grows_towards(const quotient *q, double s, double step, double *nearer)
{
    *nearer = flk_samples_value(q->x, q->c, s + step, GSL_NAN);
    return fabs(*nearer) > 1.5 * fabs(flk_samples_value(q->x, q->c, s + 2 * step, GSL_NAN));
}

static int sign_of(double value)
{
    return value > 0 ? FLK_POLE_UP : FLK_POLE_DOWN;
}

/* Where the denominator changes its sign between samples. */
static void find_between_samples(quotient *q, flk_take_pole *take, void *data)
{
    const flk_samples *x = q->x;
    double at, before = GSL_NAN, nearer;
    size_t i, last = 0;
    flk_pole pole;

    pole.signs = FLK_POLE_UP | FLK_POLE_DOWN;
    pole.order = 1;
    for (i = 0; i < x->n; i++) {
        at = divisor_at(x->s[i], q);
        if (at == 0) /* the zero is found between its neighbours */
            continue;
        if (before * at < 0) {
            flk_bracket b = flk_bracket_of(x->s[last], x->s[i], before, at);

            pole.s = flk_find_zero(divisor_at, q, &b, 0);
            if (grows_towards(q, pole.s, -BESIDE_POLE, &nearer))
                take(data, &pole);
        }
        before = at;
        last = i;
    }
}

static void find_at_end(const quotient *q, int at_end, flk_take_pole *take, void *data)
{
    const flk_samples *x = q->x;
    double nearest = sqrt(DISTINCT / (x->f.piece.to - x->f.piece.from)) / M_PI_2;
    double step = GSL_MIN_DBL(GSL_MAX_DBL(BESIDE_END, nearest), 0.25), nearer;
    flk_pole pole;

    if (x->n < 3 || fabs(q->c->v[at_end ? x->n - 1 : 0]) < q->c->of.bound ||
        !grows_towards(q, at_end, at_end ? -step : step, &nearer))
        return;
    pole.s = at_end;
    pole.signs = sign_of(nearer);
    pole.order = 1;
    take(data, &pole);
}

static void find_limit(const flk_limit *limit, int at_end, flk_take_pole *take, void *data)
{
    flk_pole pole;

    if (!gsl_isinf(limit->value))
        return;
    pole.s = at_end;
    pole.signs = sign_of(limit->value);
    pole.order = limit->growth;
    take(data, &pole);
}

void flk_poles_find(const flk_samples *x, const flk_sampled *c, flk_take_pole *take, void *data)
{
    quotient q;
    int end;

    q.x = x;
    q.c = c;
    if (gsl_finite(c->of.bound))
        find_between_samples(&q, take, data);
    for (end = 0; end < 2; end++) {
        find_limit(&c->limit[end], end, take, data);
        if (gsl_finite(c->of.bound))
            find_at_end(&q, end, take, data);
    }
}
