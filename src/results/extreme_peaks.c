/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme_peaks.c - from the best samples of a column to its peaks.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "extreme_search.h"

#define NODES 7 /* of a polynomial through samples */

/* The polynomial through the samples nearest to number i; 0 if there are too few. */
static int through_samples(const flk_search *x, const double *values, size_t i, flk_polynomial *p)
{
    size_t from = i, to = i, lower = i, upper = i;

    p->n = 0;
    flk_polynomial_add(p, x->s[i], values[i]);
    while (p->n < NODES) {
        lower = lower == from ? flk_search_beside(x, values, from, -1) : lower;
        upper = upper == to ? flk_search_beside(x, values, to, 1) : upper;
        if (lower == from && upper == to)
            break;
        if (upper == to || (lower != from && x->s[i] - x->s[lower] <= x->s[upper] - x->s[i]))
            flk_polynomial_add(p, x->s[lower], values[from = lower]);
        else
            flk_polynomial_add(p, x->s[upper], values[to = upper]);
    }
    return p->n > 2;
}

static double median(double x, double y, double z)
{
    return GSL_MAX_DBL(GSL_MIN_DBL(x, y), GSL_MIN_DBL(GSL_MAX_DBL(x, y), z));
}

/* Move `best` up: compute rows on both sides, closer and closer, until the parabola through three of them gives the
** value of the row at its top, or their values are equal. */
static void climb(flk_search *x, const flk_tracked *t, int which, double low, double high,
                  flk_place *best)
{
    double step = (high - low) / 8;
    int i;

    for (i = 0; i < 60 && step > 1e-13; i++) {
        flk_place left, right, top;
        flk_polynomial p;
        double slope;

        p.n = 0;
        left.s = GSL_MAX_DBL(best->s - step, low);
        right.s = GSL_MIN_DBL(best->s + step, high);
        left.value = flk_search_value(x, t, left.s, best->value);
        right.value = flk_search_value(x, t, right.s, best->value);
        if (flk_search_signed(which, left.value) > flk_search_signed(which, best->value) &&
            flk_search_signed(which, left.value) >= flk_search_signed(which, right.value)) {
            *best = left;
            continue;
        }
        if (flk_search_signed(which, right.value) > flk_search_signed(which, best->value)) {
            *best = right;
            continue;
        }
        step /= 4;
        if (fabs(left.value - best->value) + fabs(right.value - best->value) <=
            FLK_SEARCH_CLOSE * fabs(best->value))
            return;
        if (!(left.s < best->s && best->s < right.s) || gsl_isnan(left.value + right.value))
            continue;
        flk_polynomial_add(&p, left.s, left.value);
        flk_polynomial_add(&p, best->s, best->value);
        flk_polynomial_add(&p, right.s, right.value);
        if (!flk_polynomial_find_flat(&p, left.s, right.s, &top.s))
            continue;
        top.value = flk_search_value(x, t, top.s, best->value);
        if (fabs(top.value - flk_polynomial_value(&p, top.s, &slope)) <=
            FLK_SEARCH_CLOSE * median(fabs(left.value), fabs(best->value), fabs(right.value))) {
            *best = top;
            return;
        }
        if (flk_search_signed(which, top.value) > flk_search_signed(which, best->value))
            *best = top;
    }
}

/* The same from an end, if the column rises from there: a smooth one that does not rise at 1e-5 of the step gains less
** than 1e-10 of its size within it.  Near one line peaks are narrower. */
static void climb_from_end(flk_search *x, const flk_tracked *t, int which, double low, double high,
                           flk_place *best)
{
    static const double near_line[] = {1e-3, 1e-4, 1e-5, 1e-6};
    double length = best->s == low ? high - low : low - high;
    int is_near_line = x->closest_line < 0.05, k;
    flk_place beside;

    for (k = 0; k < (is_near_line ? 4 : 1); k++) {
        beside.s = best->s + length * (is_near_line ? near_line[k] : 1e-5);
        beside.value = flk_search_value(x, t, beside.s, best->value);
        if (flk_search_signed(which, beside.value) > flk_search_signed(which, best->value)) {
            *best = beside;
            climb(x, t, which, low, high, best);
            return;
        }
    }
}

/* Improve the place of a peak.  It is flat, so values give its place to the root of the rounding only; the slope
** of a polynomial through rows close about it is more exact. */
static void sharpen(const flk_search *x, const flk_tracked *t, double low, double high, double size,
                    flk_place *top)
{
    double step = (high - low) / 20, slope;
    flk_polynomial p;
    flk_place sharp;
    int k;

    if (top->s - 2 * step < low || top->s + 2 * step > high)
        return;
    p.n = 0;
    for (k = -2; k <= 2; k++)
        flk_polynomial_add(&p, top->s + k * step,
                           k ? flk_search_value(x, t, top->s + k * step, top->value) : top->value);
    if (!flk_polynomial_find_flat(&p, top->s - step, top->s + step, &sharp.s))
        return;
    sharp.value = flk_search_value(x, t, sharp.s, top->value);
    if (fabs(sharp.value - flk_polynomial_value(&p, sharp.s, &slope)) <= FLK_SEARCH_CLOSE * size)
        *top = sharp;
}

/* The peak that the samples have at or beside number i. */
static void refine(flk_search *x, const flk_tracked *t, const double *values, int which, size_t i,
                   flk_found *f)
{
    size_t before = flk_search_beside(x, values, i, -1),
           behind = flk_search_beside(x, values, i, 1);
    double low = x->s[before], high = x->s[behind], slope;
    double size = median(fabs(values[before]), fabs(values[i]), fabs(values[behind]));
    flk_place best = flk_search_place(x, values, i), top;
    flk_polynomial p;
    int is_good = 0;

    if (!t->is_noise && low < high) {
        if (through_samples(x, values, i, &p) && flk_polynomial_find_flat(&p, low, high, &top.s)) {
            top.value = flk_search_value(x, t, top.s, best.value);
            is_good = fabs(top.value - flk_polynomial_value(&p, top.s, &slope)) <= 1e-11 * size &&
                      flk_search_signed(which, top.value) >= flk_search_signed(which, best.value);
            if (flk_search_signed(which, top.value) > flk_search_signed(which, best.value))
                best = top;
        }
        if (!is_good && (before == i || behind == i) && best.s == x->s[i])
            climb_from_end(x, t, which, low, high, &best);
        else if (!is_good)
            climb(x, t, which, low, high, &best);
        if (!is_good)
            sharpen(x, t, low, high, size, &best);
    }
    flk_search_offer_at(x, f, which, best.value, best.s);
}

void flk_search_offer_samples(const flk_search *x, flk_tracked *t, const double *values)
{
    size_t i, most = x->n, least = x->n;

    for (i = 0; i < x->n; i++) {
        if (most == x->n ? values[i] == values[i] : values[i] > values[most])
            most = i;
        if (least == x->n ? values[i] == values[i] : values[i] < values[least])
            least = i;
    }
    if (most == x->n)
        return;
    for (i = 0; values[i] != values[most] &&
                !(values[i] > values[most] - FLK_SEARCH_CLOSE * fabs(values[most]));
         i++)
        ;
    flk_search_offer_at(x, &t->here[0], 0, values[i], x->s[i]);
    for (i = 0; values[i] != values[least] &&
                !(values[i] < values[least] + FLK_SEARCH_CLOSE * fabs(values[least]));
         i++)
        ;
    flk_search_offer_at(x, &t->here[1], 1, values[i], x->s[i]);
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
