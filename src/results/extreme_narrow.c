/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme_narrow.c - more samples where an extreme may hide between two of them.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "extreme_search.h"

#define MOST_HALVED 100 /* so many within a first step */
#define NARROWEST 1e-4  /* of the first step: closer peaks are climbed from the best sample */
#define ROUGH 2e-6      /* of the column's size: below it nothing hides between samples */

double flk_search_size_about(const flk_search *x, const double *values, size_t i)
{
    double size = 0;
    size_t k, to = i + 3 < x->n ? i + 3 : x->n;

    for (k = i < 2 ? 0 : i - 2; k < to; k++)
        if (fabs(values[k]) > size)
            size = fabs(values[k]);
    return size;
}

int flk_search_is_even(const flk_search *x, size_t i)
{
    const double *s = x->s + i;
    double step;

    if (i < 2 || i + 2 >= x->n)
        return 0;
    step = s[1] - s[0];
    return fabs(s[-1] - s[-2] - step) + fabs(s[0] - s[-1] - step) + fabs(s[2] - s[1] - step) <
           1e-9 * step;
}

double flk_search_roughness(const flk_search *x, const double *values, size_t i, int even)
{
    size_t k, from = i < 2 ? 0 : i + 3 > x->n ? x->n - 5 : i - 2;
    const double *v = values + i;
    flk_polynomial p;
    double d;

    if (x->n < 5)
        return 0;
    if (even) {
        d = (v[-2] - 4 * v[-1] + 6 * v[0] - 4 * v[1] + v[2]) / 6;
    } else {
        p.n = 0;
        for (k = from; k < from + 5; k++)
            if (k != i)
                flk_polynomial_add(&p, x->s[k], values[k]);
        d = flk_polynomial_value(&p, x->s[i]) - values[i];
    }
    return d == d ? fabs(d) : 0;
}

/* 1 if an angle has half a turn between samples about number i, which no step resolves. */
static int jumps(const flk_search *x, const flk_tracked *t, const double *values, size_t i)
{
    size_t k, to = i + 4 < x->n ? i + 4 : x->n - 1;

    for (k = i < 4 ? 0 : i - 4; t->turn > 0 && k < to; k++)
        if (fabs(values[k + 1] - values[k]) > 0.4 * t->turn)
            return 1;
    return 0;
}

/* 1 while a column that has poles between samples showed none. */
static int is_bounded(const flk_tracked *t)
{
    return !gsl_finite(t->bound) ||
           (fabs(t->here[0].value) < t->bound && fabs(t->here[1].value) < t->bound);
}

/* 1 for a sample so close to a pole that the column is rough there on all scales. */
static int is_at_pole(const flk_search *x, const flk_tracked *t, double s)
{
    return (t->has_pole[0] && s - x->low < 4 * x->step && x->low <= 0) ||
           (t->has_pole[1] && x->high - s < 4 * x->step && x->high >= 1);
}

/* 1 if a better extreme of a column may hide beside a sample. */
static int may_hide(const flk_search *x, const flk_tracked *t, const double *values, size_t i,
                    int even)
{
    double rough = flk_search_roughness(x, values, i, even), reach = FLK_SEARCH_MARGIN * rough;

    if (!(rough > 1e-9 * t->size) || t->is_noise || jumps(x, t, values, i) ||
        is_at_pole(x, t, x->s[i]))
        return 0;
    return ((values[i] + reach > t->here[0].value &&
             !flk_search_is_beaten(x, t, 0, values[i] + reach)) ||
            (values[i] - reach < t->here[1].value &&
             !flk_search_is_beaten(x, t, 1, values[i] - reach))) &&
           rough > ROUGH * flk_search_size_about(x, values, i) && is_bounded(t);
}

static int hides(const flk_search *x, size_t i)
{
    int even = flk_search_is_even(x, i);
    size_t c;

    for (c = 0; c < x->n_columns; c++)
        if (may_hide(x, &x->columns[c], flk_search_row(x, c), i, even))
            return 1;
    return 0;
}

/* Halve the step before number i. */
static void halve(flk_search *x, size_t i)
{
    size_t c, first = (size_t)((x->s[i - 1] - x->low) / x->step);

    if (x->halved[first > FLK_SEARCH_MOST_STEPS ? FLK_SEARCH_MOST_STEPS : first]++ > MOST_HALVED ||
        x->n >= FLK_SEARCH_MOST_SAMPLES || x->s[i] - x->s[i - 1] < NARROWEST * x->step)
        return;
    flk_search_insert(x, i, 0.5 * (x->s[i - 1] + x->s[i]));
    for (c = 0; c < x->n_columns; c++) {
        flk_tracked *t = &x->columns[c];
        double *v = flk_search_row(x, c) + i;

        if (t->turn > 0)
            v[0] =
                flk_search_nearest(t, v[0], flk_search_turns_over(t, v[-1], v[0]) ? v[1] : v[-1]);
        flk_search_offer_at(x, &t->here[0], 0, v[0], x->s[i]);
        flk_search_offer_at(x, &t->here[1], 1, v[0], x->s[i]);
    }
}

void flk_search_resolve_narrow(flk_search *x)
{
    size_t i, before;

    for (i = 0; i < x->n && !flk_search_is_over(x); i++) {
        before = x->n;
        if (!hides(x, i))
            continue;
        if (i + 1 < x->n)
            halve(x, i + 1);
        if (i > 0)
            halve(x, i);
        if (x->n > before)
            i = i > 3 ? i - 4 : (size_t)-1;
    }
}
