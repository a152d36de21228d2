/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme_peaks.c - from the best samples of a column to its peaks.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "extreme_search.h"

#define NODES 7     /* of a polynomial through samples */
#define EQUAL 1e-14 /* of a value: a search by rows ends */

/* A column between two samples, or its negative where its smallest value is sought. */
typedef struct peak {
    const flk_search *x;
    const flk_tracked *t;
    int which;
    flk_sample at[3]; /* a sample, the best place, a sample */
    double size;      /* of the column */
} peak;

static flk_sample sample_of(const flk_search *x, const double *values, int which, size_t i)
{
    flk_sample sample;

    sample.x = x->s[i];
    sample.value = flk_search_signed(which, values[i]);
    return sample;
}

/* The value at a parameter; an angle goes on from the best place. */
static double value_at(double s, void *data)
{
    const peak *p = data;
    double near = flk_search_signed(p->which, p->at[1].value);

    return flk_search_signed(p->which, flk_search_value(p->x, p->t, s, near));
}

/* The polynomial through the samples nearest to number i; 0 if there are too few. */
static int through_samples(const flk_search *x, const double *values, int which, size_t i,
                           flk_polynomial *p)
{
    size_t from = i, to = i, lower = i, upper = i;

    p->n = 0;
    flk_polynomial_add(p, x->s[i], flk_search_signed(which, values[i]));
    while (p->n < NODES) {
        lower = lower == from ? flk_search_beside(x, values, from, -1) : lower;
        upper = upper == to ? flk_search_beside(x, values, to, 1) : upper;
        if (lower == from && upper == to)
            break;
        if (upper == to || (lower != from && x->s[i] - x->s[lower] <= x->s[upper] - x->s[i]))
            flk_polynomial_add(p, x->s[lower], flk_search_signed(which, values[from = lower]));
        else
            flk_polynomial_add(p, x->s[upper], flk_search_signed(which, values[to = upper]));
    }
    return p->n > 2;
}

static double median(double x, double y, double z)
{
    return GSL_MAX_DBL(GSL_MIN_DBL(x, y), GSL_MIN_DBL(GSL_MAX_DBL(x, y), z));
}

/* Take the top of a polynomial between two places if it is better.  1 if the row there agrees with the polynomial. */
static int take_top(peak *p, flk_polynomial *through, double low, double high, double close)
{
    flk_sample top;
    int agrees;

    if (!flk_polynomial_find_flat(through, low, high, &top.x))
        return 0;
    top.value = value_at(top.x, p);
    agrees = top.value >= p->at[1].value - close &&
             fabs(top.value - flk_polynomial_value(through, top.x)) <= close;
    if (agrees || top.value > p->at[1].value)
        p->at[1] = top;
    return agrees;
}

/* From an end the search begins beside it, if the column rises there: a smooth one that does not rise at 1e-5 of the
** step gains less than 1e-10 of its size within it.  Near one line peaks are narrower. */
static int leave_end(peak *p)
{
    static const double near_line[] = {1e-3, 1e-4, 1e-5, 1e-6};
    double end = p->at[1].x;
    double length = end == p->at[0].x ? p->at[2].x - end : p->at[0].x - end;
    int is_near_line = p->x->closest_line < 0.05, k;
    flk_sample beside;

    for (k = 0; k < (is_near_line ? 4 : 1); k++) {
        beside.x = end + length * (is_near_line ? near_line[k] : 1e-5);
        beside.value = value_at(beside.x, p);
        if (beside.value > p->at[1].value) {
            p->at[1] = beside;
            return 1;
        }
    }
    return 0;
}

/* Improve the place of a peak.  It is flat, so values give its place to the root of the rounding only; the slope
** of a polynomial through rows close about it is more exact. */
static void sharpen(peak *p)
{
    double step = (p->at[2].x - p->at[0].x) / 20, middle = p->at[1].x;
    flk_polynomial through;
    int k;

    if (middle - 2 * step < p->at[0].x || middle + 2 * step > p->at[2].x)
        return;
    through.n = 0;
    for (k = -2; k <= 2; k++)
        flk_polynomial_add(&through, middle + k * step,
                           k ? value_at(middle + k * step, p) : p->at[1].value);
    take_top(p, &through, middle - step, middle + step, FLK_SEARCH_CLOSE * p->size);
}

/* The peak that the samples have at or beside number i. */
static void refine(flk_search *x, const flk_tracked *t, const double *values, int which, size_t i,
                   flk_found *f)
{
    size_t before = flk_search_beside(x, values, i, -1),
           behind = flk_search_beside(x, values, i, 1);
    flk_polynomial through;
    peak p;

    p.x = x;
    p.t = t;
    p.which = which;
    p.at[0] = sample_of(x, values, which, before);
    p.at[1] = sample_of(x, values, which, i);
    p.at[2] = sample_of(x, values, which, behind);
    p.size = median(fabs(p.at[0].value), fabs(p.at[1].value), fabs(p.at[2].value));
    if (!t->is_noise && before < behind &&
        !(through_samples(x, values, which, i, &through) &&
          take_top(&p, &through, p.at[0].x, p.at[2].x, 1e-11 * p.size))) {
        int is_end = (before == i || behind == i) && p.at[1].x == x->s[i];

        if (!is_end || leave_end(&p))
            p.at[1] = flk_find_peak(value_at, &p, p.at, EQUAL * p.size);
        sharpen(&p);
    }
    flk_search_offer_at(x, f, which, flk_search_signed(which, p.at[1].value), p.at[1].x);
}

void flk_search_offer_samples(const flk_search *x, flk_tracked *t, const double *values)
{
    int which;

    for (which = 0; which < 2; which++) {
        double here, best = GSL_NAN, least;
        size_t i;

        for (i = 0; i < x->n; i++) {
            here = flk_search_signed(which, values[i]);
            best = here <= best || here != here ? best : here;
        }
        least = best - (fabs(best) < GSL_POSINF ? FLK_SEARCH_CLOSE * fabs(best) : 0);
        for (i = 0; i < x->n && !(flk_search_signed(which, values[i]) >= least); i++)
            ;
        if (i < x->n)
            flk_search_offer_at(x, &t->here[which], which, values[i], x->s[i]);
    }
}

/* 1 if sample i is a peak among its neighbours, but for rounding. */
static int is_peak(const flk_search *x, const double *values, int which, size_t i)
{
    double here = flk_search_signed(which, values[i]), close = here + FLK_SEARCH_CLOSE * fabs(here);

    return here == here && !(i > 0 && flk_search_signed(which, values[i - 1]) > close) &&
           !(i + 1 < x->n && flk_search_signed(which, values[i + 1]) > close);
}

/* The same among those that are not too close. */
static int is_peak_beside(const flk_search *x, const double *values, int which, size_t i)
{
    double here = flk_search_signed(which, values[i]);

    return flk_search_signed(which, values[flk_search_beside(x, values, i, -1)]) <= here &&
           flk_search_signed(which, values[flk_search_beside(x, values, i, 1)]) <= here;
}

/* The second difference of three samples, as if all steps were the longer one of the two. */
static double bend_of(const flk_search *x, const double *values, size_t i)
{
    double before = x->s[i] - x->s[i - 1], behind = x->s[i + 1] - x->s[i],
           step = GSL_MAX_DBL(before, behind);

    return 2 * step * step / (before + behind) *
           fabs((values[i + 1] - values[i]) / behind - (values[i] - values[i - 1]) / before);
}

/* By how much a column may be better beside a peak of the samples. */
static double gain_beside(const flk_search *x, const double *values, size_t i)
{
    double gain = FLK_SEARCH_MARGIN * flk_search_roughness(x, values, i, flk_search_is_even(x, i)),
           bend = i > 0 && i + 1 < x->n ? bend_of(x, values, i) : GSL_NAN;

    return gain + (bend == bend ? bend : flk_search_size_about(x, values, i));
}

void flk_search_refine_peaks(flk_search *x, flk_tracked *t, const double *values)
{
    size_t i;
    int which;

    for (which = 0; which < 2; which++)
        for (i = 0; i < x->n && !flk_search_is_over(x); i++) {
            double gain;

            if (!is_peak(x, values, which, i))
                continue;
            gain = gain_beside(x, values, i);
            if (flk_search_is_beaten(x, t, which, values[i] + (which == 0 ? gain : -gain)))
                continue;
            if (gain > FLK_SEARCH_CLOSE * fabs(values[i]) &&
                flk_search_signed(which, values[i]) + gain >=
                    flk_search_signed(which, t->here[which].value) &&
                is_peak_beside(x, values, which, i))
                refine(x, t, values, which, i, &t->here[which]);
        }
}
