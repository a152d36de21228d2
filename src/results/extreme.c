/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.c - the largest and smallest values of columns over a deck's motion, found together.
**
** Columns are sampled piece by piece (samples.c).  A peak of the samples is refined by a polynomial
** through its neighbours.  Where the row at the polynomial's peak does not agree with it, base/solve finds
** the peak.
**
** A column has two pairs of bests (flk_bests).  `here` is from where an angle last started anew, in values
** that whole turns may still move, all together; `best` is from before, and final: commit() moves the one
** into the other.  A value enters only if it is better by more than rounding: of equal values the first
** stays.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/scale.h"
#include "base/solve.h"
#include "extreme.h"
#include "pole.h"

#define CLOSE 1e-12       /* relative difference of values that are equal within rounding, */
#define CLOSE_TURNS 1e-10 /* ... in two turns of an integrated motion */

typedef struct search {
    flk_samples samples;
    flk_bests *bests; /* of each column */
} search;

/* ----------------------------------------------------------------------------------------- best values */

/* value for the largest (which = 0), -value for the smallest (1). */
static double signed_value(int which, double value)
{
    return which == 0 ? value : -value;
}

/* 1 if a value is better by more than rounding error and `part` of its size. */
static int is_better(const flk_bests *b, const flk_extreme *best, int which, double value,
                     double part)
{
    double close = GSL_MAX_DBL(part * GSL_MAX_DBL(fabs(value), fabs(best->value)), b->noise);

    return !best->is_there || signed_value(which, value) > signed_value(which, best->value) +
                                                               (gsl_finite(close) ? close : 0);
}

/* Keep a value if it is better than the best so far.  Of equal values the first one stays. */
static void offer(const flk_bests *b, flk_extreme *best, int which, double value, double angle,
                  double part)
{
    if (gsl_isnan(value) || !is_better(b, best, which, value, part))
        return;
    best->is_there = 1;
    best->value = value;
    best->angle = angle;
}

/* A column whose extremes are sought. */
typedef struct sought {
    const flk_samples *x;
    const flk_sampled *c;
    flk_bests *b;
    int which;
    double near;      /* value from which an angle continues */
    double end, away; /* near an end of the piece: its s, and the distance to the next sample */
    int is_root;      /* 1: the column behaves as the root of the distance from it */
} sought;

static void offer_at(const sought *k, int which, double value, double s)
{
    flk_extreme *here = &k->b->here[which];

    if (value == 0 && here->is_there && fabs(here->value) <= k->b->noise && !k->c->of.is_noise)
        here->value = 0; /* which it was but for rounding, as beside a rope that is slack */
    if (gsl_isnan(value) || !is_better(k->b, here, which, value, CLOSE))
        return;
    if (fabs(value) >= k->c->of.bound)
        value = value > 0 ? GSL_POSINF : GSL_NEGINF;
    offer(k->b, here, which, value, flk_samples_place(k->x, k->c, s), CLOSE);
}

/* Finish the part of a column's curve since it started anew; `shift` moves it by whole turns. */
static void commit(flk_bests *b, double shift)
{
    int which;

    for (which = 0; which < 2; which++)
        if (b->here[which].is_there)
            offer(b, &b->best[which], which, b->here[which].value + shift, b->here[which].angle,
                  b->close);
    memset(b->here, 0, sizeof b->here);
}

/* Offer the row at an end of the piece where a load jumps: the sample is just inside. */
static void offer_corner(const sought *k, int which, int end)
{
    const flk_followed *of = &k->c->of;
    double corner = k->c->corner[end], beside = k->c->v[end ? k->x->n - 1 : 0];

    if (!(of->turn > 0) || !flk_followed_turns_over(of, beside, corner))
        offer(k->b, &k->b->here[which], which, flk_followed_nearest(of, corner, beside),
              flk_follow_place(&k->x->f, flk_follow_corner(&k->x->f, end)), CLOSE);
}

/* The column at an end where it is 0 / 0: as just inside or, where it is that there too, by rows beside
** it. */
#define BESIDE 1e-4 /* of the piece */

static double value_at_end(const sought *k, int end)
{
    flk_polynomial of;
    int i;

    if (!gsl_isnan(k->c->corner[end]))
        return k->c->corner[end];
    for (of.n = 0, i = 1; i <= 3; i++) {
        double s = sqrt(BESIDE * i);

        flk_polynomial_add(&of, BESIDE * i,
                           flk_samples_value(k->x, k->c, end ? 1 - s : s, GSL_NAN));
    }
    return flk_polynomial_value(&of, 0);
}

/* Offer the first of the best samples, and what is at the ends of the piece. */
static void offer_samples(const sought *k, int which)
{
    const flk_samples *x = k->x;
    const double *v = k->c->v;
    double here, best = GSL_NAN, least;
    size_t i;
    int end;

    for (i = 0; i < x->n; i++) {
        here = signed_value(which, v[i]);
        best = here <= best || here != here ? best : here;
    }
    least = best - CLOSE * fabs(best);
    for (i = 0; i < x->n && !(signed_value(which, v[i]) >= least); i++)
        ;
    if (i < x->n)
        offer_at(k, which, v[i], x->s[i]);
    for (end = 0; end < 2; end++)
        if (k->c->is_inside[end] && x->n > 0)
            offer_corner(k, which, end);
        else if (gsl_finite(k->c->of.bound) && x->n > 2 && gsl_isnan(v[end ? x->n - 1 : 0]))
            offer_at(k, which, value_at_end(k, end), end);
}

/* ------------------------------------------------------------------------------------------------ peaks */

#define NODES 9 /* of a polynomial through samples */
#define AGREED \
    1e-11 /* of the column's size: the row at the top of the polynomial is what that says */
#define EQUAL 1e-14 /* of the column's size: a search by rows ends */
#define AGREED_BEND \
    1e-6 /* of the bend of the samples: in closer samples a corner agrees by chance */

/* The column, or its negative where its smallest value is sought. */
static double peak_at(double s, void *data)
{
    const sought *k = data;

    return signed_value(k->which, flk_samples_value(k->x, k->c, s, k->near));
}

/* The parameter at a part of the distance from an end of the piece to the next sample. */
static double parameter_beside_end(const sought *k, double part)
{
    return k->end + k->away * (k->is_root ? part : sqrt(part));
}

static double peak_beside_end(double part, void *data)
{
    return peak_at(parameter_beside_end(data, part), data);
}

static flk_sample sample_of(const sought *k, size_t i)
{
    flk_sample sample;

    sample.x = k->x->s[i];
    sample.value = signed_value(k->which, k->c->v[i]);
    return sample;
}

/* The polynomial through samples about number i. */
static void through(const sought *k, size_t i, flk_polynomial *of)
{
    const double *v = k->c->v;
    size_t from = i, to = i + 1;

    while (from > 0 && i - from < NODES / 2 && !gsl_isnan(v[from - 1]))
        from--;
    while (to < k->x->n && to - i <= NODES / 2 && !gsl_isnan(v[to]))
        to++;
    for (of->n = 0; from < to; from++)
        flk_polynomial_add(of, k->x->s[from], signed_value(k->which, v[from]));
}

/* The column's size, at least its value there. */
static double size_of(const sought *k, double there)
{
    return GSL_MAX_DBL(k->c->size, fabs(there));
}

/* Take the top of a polynomial between two places if f is better there.  Returns 1 if f agrees there with
** the polynomial to within `close`. */
static int take_top(flk_function *f, sought *k, flk_polynomial *of, double low, double high,
                    double close, flk_sample *best)
{
    flk_sample top;
    int agrees;

    if (!flk_polynomial_find_flat(of, low, high, &top.x))
        return 0;
    top.value = f(top.x, k);
    agrees = fabs(top.value - flk_polynomial_value(of, top.x)) <= close &&
             top.value >= best->value - EQUAL * size_of(k, top.value);
    if (agrees || top.value > best->value)
        *best = top;
    return agrees;
}

/* A peak is flat, so values locate it only to the square root of rounding; the slope of a polynomial
** through values close to it locates it better. */
static void sharpen(flk_function *f, sought *k, double low, double high, flk_sample *best)
{
    double middle = best->x;
    double step = GSL_MIN_DBL((high - low) / 60, GSL_MIN_DBL(middle - low, high - middle) / 2);
    flk_polynomial of;
    int i;

    if (!(step > 0))
        return;
    for (of.n = 0, i = -2; i <= 2; i++)
        flk_polynomial_add(&of, middle + i * step, i ? f(middle + i * step, k) : best->value);
    take_top(f, k, &of, middle - step, middle + step, EQUAL * size_of(k, best->value), best);
}

/* Two peaks can be beside one sample, which is lower than both: if the column rises on the other side of
** the sample too, search there. */
#define ON_OTHER_SIDE 0.25 /* of the way to the next sample */

static void take_other_side(sought *k, const flk_sample at[3], flk_sample *top)
{
    int other = top->x > at[1].x ? 0 : 2;
    flk_sample beside[3], second;

    beside[0] = at[other == 0 ? 0 : 1];
    beside[1].x = at[1].x + ON_OTHER_SIDE * (at[other].x - at[1].x);
    beside[1].value = peak_at(beside[1].x, k);
    beside[2] = at[other == 0 ? 1 : 2];
    if (!(beside[1].value > at[1].value))
        return;
    second = flk_find_peak(peak_at, k, beside, EQUAL * fabs(beside[1].value));
    if (second.value > top->value)
        *top = second;
}

/* Search between the neighbours of a sample, from the best place so far. */
static flk_sample search_peak(sought *k, const flk_sample at[3], const flk_sample *best)
{
    flk_sample from[3], top;

    from[0] = at[0];
    from[1] = *best;
    from[2] = at[2];
    top = flk_find_peak(peak_at, k, from, EQUAL * fabs(best->value));
    take_other_side(k, at, &top);
    return top;
}

/* The peak between the neighbours of sample i. */
static flk_sample find_peak(sought *k, size_t i)
{
    flk_polynomial of;
    flk_sample at[3], top;
    double size, bend;

    at[0] = sample_of(k, i - 1);
    at[1] = sample_of(k, i);
    at[2] = sample_of(k, i + 1);
    through(k, i, &of);
    size = size_of(k, at[1].value);
    bend = 2 * at[1].value - at[0].value - at[2].value;
    top = at[1];
    if (!take_top(peak_at, k, &of, at[0].x, at[2].x,
                  GSL_MAX_DBL(EQUAL * size, GSL_MIN_DBL(AGREED * size, AGREED_BEND * bend)), &top))
        top = search_peak(k, at, &top);
    sharpen(peak_at, k, at[0].x, at[2].x, &top);
    return top;
}

/* Take the top of the parabola through the end and two places beside it, closer than these. */
static void take_top_beside_end(sought *k, const flk_sample *end, const flk_sample beside[2],
                                flk_sample *best)
{
    flk_polynomial of;

    of.n = 0;
    flk_polynomial_add(&of, 0, end->value);
    flk_polynomial_add(&of, beside[0].x, beside[0].value);
    flk_polynomial_add(&of, beside[1].x, beside[1].value);
    if (gsl_finite(end->value))
        take_top(peak_beside_end, k, &of, 0, beside[0].x, 0, best);
}

/* The peak between sample i, which has no neighbour on one side, and the next sample.  It is sample i
** itself, unless the column rises beside it, or jumps there, as where a joint with friction stands still.
** The search runs over the distance from the end, or where the column behaves as its root, over that. */
#define BESIDE_END 4e-4 /* of the distance to the next sample */

/* Behind at[0], the closest place, take the highest of some, ever farther away, into at[1] and its
** neighbours into the others: of two alone rounding error could decide. */
#define FARTHER 4

static void take_highest_beside_end(sought *k, double next, flk_sample at[3])
{
    flk_sample place[3];

    place[0] = at[0];
    place[1].x = 2 * BESIDE_END;
    place[1].value = peak_beside_end(place[1].x, k);
    for (at[1].value = GSL_NEGINF; place[1].x < 1; place[0] = place[1], place[1] = place[2]) {
        place[2].x = GSL_MIN_DBL(FARTHER * place[1].x, 1);
        place[2].value = place[2].x < 1 ? peak_beside_end(place[2].x, k) : next;
        if (place[1].value > at[1].value || place[1].x <= 2 * BESIDE_END)
            memcpy(at, place, sizeof place);
    }
}

static flk_sample find_peak_at_end(sought *k, size_t i, size_t next)
{
    const flk_samples *x = k->x;
    flk_sample end = sample_of(k, i), at[3], top;

    k->end = end.x;
    k->away = x->s[next] - end.x;
    k->is_root = flk_follow_is_root(k->end < 0.5 ? x->f.piece.begin : x->f.piece.end);
    at[0].x = BESIDE_END;
    at[0].value = peak_beside_end(at[0].x, k);
    take_highest_beside_end(k, sample_of(k, next).value, at);
    top = at[0];
    if (at[1].value > at[0].value) {
        top = flk_find_peak(peak_beside_end, k, at, EQUAL * fabs(at[1].value));
        sharpen(peak_beside_end, k, at[0].x, at[2].x, &top);
    } else {
        take_top_beside_end(k, &end, at, &top);
    }
    if (!(top.value > end.value))
        return end;
    top.x = parameter_beside_end(k, top.x);
    return top;
}

/* A column may exceed a sample by this multiple of the bend of the sample and its neighbours. */
#define MARGIN 4

/* The samples about number i that are equal to it within rounding. */
static void find_equal(const sought *k, size_t i, size_t *from, size_t *to)
{
    const double *v = k->c->v;
    double close = GSL_MAX_DBL(CLOSE * fabs(v[i]), k->b->noise);

    for (*from = i; *from > 0 && fabs(v[*from - 1] - v[i]) <= close; --*from)
        ;
    for (*to = i; *to + 1 < k->x->n && fabs(v[*to + 1] - v[i]) <= close; ++*to)
        ;
}

/* 1 if the column is constant about sample i.  The next samples alone can be too close to tell, where
** another column needs them. */
#define AROUND 0.05 /* s */

static int is_flat(const sought *k, size_t i)
{
    const double *s = k->x->s, *v = k->c->v;
    size_t from, to;

    find_equal(k, i, &from, &to);
    return (from == 0 || gsl_isnan(v[from - 1]) || s[i] - s[from] > AROUND) &&
           (to + 1 == k->x->n || gsl_isnan(v[to + 1]) || s[to] - s[i] > AROUND);
}

/* The best value so far; -infinite if there is none.  Angles are compared only since they last started
** anew. */
static double best_so_far(const sought *k, int which)
{
    const flk_bests *b = k->b;
    double best = b->here[which].is_there ? signed_value(which, b->here[which].value) : GSL_NEGINF;

    return k->c->of.turn > 0 || !b->best[which].is_there
               ? best
               : GSL_MAX_DBL(best, signed_value(which, b->best[which].value));
}

/* How much the samples bend about sample i; at an end, about the next sample too: of two on both sides of a
** peak, the difference is nothing. */
static double bend_of(const sought *k, size_t i, double a, double b)
{
    const double *v = k->c->v;
    size_t last = k->x->n - 1, next = i == 0 ? 1 : i == last ? last - 1 : i;
    double bend = fabs(2 * v[next] - v[next - 1] - v[next + 1]);

    return GSL_MAX_DBL(bend, 2 * signed_value(k->which, v[i]) - a - b);
}

/* How far the parabola through sample i and its neighbours rises above it: where these are close on one side
** only, because another column needs them, the samples hardly bend beside a peak. */
static double rise_of(const sought *k, size_t i)
{
    const double *s = k->x->s + i, *v = k->c->v + i;
    double before = s[0] - s[-1], behind = s[1] - s[0];
    double to = (v[0] - v[-1]) / before, from = (v[1] - v[0]) / behind;
    double slope = (to * behind + from * before) / (before + behind);
    double bend = (to - from) / (before + behind);

    return bend != 0 ? fabs(slope * slope / (4 * bend)) : 0;
}

/* Offer the top of a peak at sample i.  It takes the place of a lower sample of the same peak, even if they
** are equal. */
static void offer_top(const sought *k, size_t i, const flk_sample *top)
{
    const flk_samples *x = k->x;
    flk_extreme *best = &k->b->here[k->which];
    double close = GSL_MAX_DBL(EQUAL * fabs(top->value), k->b->noise);
    double before, behind;
    size_t from, to;

    find_equal(k, i, &from, &to);
    before = best->angle - flk_samples_place(x, k->c, x->s[from > 0 ? from - 1 : 0]);
    behind = best->angle - flk_samples_place(x, k->c, x->s[to + 1 < x->n ? to + 1 : to]);
    if (before * behind <= 0 && top->value > signed_value(k->which, best->value) + close)
        best->is_there = 0;
    offer_at(k, k->which, signed_value(k->which, top->value), top->x);
}

/* Refine the peaks of the samples that can be better than the best. */
static void refine(sought *k, int which)
{
    const flk_samples *x = k->x;
    const double *v = k->c->v;
    flk_sample top;
    size_t i;

    k->which = which;
    for (i = 0; i < x->n && x->n > 2; i++) {
        double here = signed_value(which, v[i]);
        double before = i > 0 ? signed_value(which, v[i - 1]) : GSL_NAN;
        double behind = i + 1 < x->n ? signed_value(which, v[i + 1]) : GSL_NAN;
        double a, b, bend;

        if (before > here || behind > here) /* nearly all samples */
            continue;
        a = gsl_isnan(before) ? behind : before;
        b = gsl_isnan(behind) ? before : behind;
        if (!(here >= a && here >= b) || !(here > GSL_MIN_DBL(a, b)))
            continue;
        bend = bend_of(k, i, a, b);
        if (!gsl_isnan(before + behind))
            bend = GSL_MAX_DBL(bend, rise_of(k, i));
        if (!(here + MARGIN * bend >= best_so_far(k, which)) || is_flat(k, i) ||
            flk_follow_is_over(&x->f))
            continue;
        k->near = v[i];
        top = gsl_isnan(before)   ? find_peak_at_end(k, i, i + 1)
              : gsl_isnan(behind) ? find_peak_at_end(k, i, i - 1)
                                  : find_peak(k, i);
        offer_top(k, i, &top);
    }
}

/* A peak between an end of the piece where the column is 0 / 0 and the next sample, at places ever
** closer to the end. */
#define CLOSER 10 /* halvings of the distance */

static void refine_beside_undefined_end(sought *k, int which, int end)
{
    const flk_samples *x = k->x;
    size_t inner = end ? x->n - 2 : 1;
    flk_sample list[CLOSER + 3], at[3], top;
    double s = x->s[end ? x->n - 1 : 0], away = x->s[inner] - s;
    int i;

    k->which = which;
    k->near = k->c->v[inner];
    list[0] = sample_of(k, end ? inner - 1 : inner + 1);
    list[1] = sample_of(k, inner);
    for (i = 2; i < CLOSER + 2; i++) {
        away /= 2;
        list[i].x = s + away;
        list[i].value = peak_at(s + away, k);
    }
    list[i].x = s;
    list[i].value = signed_value(which, value_at_end(k, end));
    for (i = 1; i < CLOSER + 2; i++)
        if (list[i].value > list[i - 1].value && list[i].value > list[i + 1].value) {
            at[0] = list[end ? i - 1 : i + 1];
            at[1] = list[i];
            at[2] = list[end ? i + 1 : i - 1];
            top = flk_find_peak(peak_at, k, at, EQUAL * fabs(at[1].value));
            sharpen(peak_at, k, at[0].x, at[2].x, &top);
            offer_at(k, which, signed_value(which, top.value), top.x);
        }
}

static void refine_beside_undefined_ends(sought *k, int which)
{
    const flk_samples *x = k->x;
    const double *v = k->c->v;
    int end;

    for (end = 0; end < 2 && gsl_finite(k->c->of.bound) && x->n > 2; end++)
        if (gsl_isnan(v[end ? x->n - 1 : 0]) && !gsl_isnan(v[end ? x->n - 2 : 1]) &&
            !k->c->is_inside[end] && !flk_follow_is_over(&x->f))
            refine_beside_undefined_end(k, which, end);
}

/* ------------------------------------------------------------------------------------------ least sizes */

/* 1 if no sample beside this one is less: refine() has searched about it. */
static int is_low(const sought *k, size_t i)
{
    const double *v = k->c->v + i;

    return !(i > 0 && v[-1] < v[0]) && !(i + 1 < k->x->n && v[1] < v[0]);
}

/* Offer the least size of a vector between samples that do not show it, as where a force nearly
** vanishes; where it does vanish, its size has a corner, and the place is better known by the
** components. */
#define VANISHES 1e-9 /* of the column's size */

static void refine_least_sizes(sought *k)
{
    const flk_samples *x = k->x;
    flk_sample at[3], top;
    double least = -best_so_far(k, 1);
    int vanishes = least > 0 && least < VANISHES * k->c->size;
    size_t i;

    for (i = 0; i + 1 < x->n && x->n > 2; i++) {
        int is_hidden = !is_low(k, i) && !is_low(k, i + 1) &&
                        -flk_samples_least_size(x, k->c, i) > best_so_far(k, 1);

        if (!(is_hidden || vanishes) || is_flat(k, i) || flk_follow_is_over(&x->f) ||
            !flk_samples_find_least_size(x, k->c, i, &at[1].x))
            continue;
        at[0] = sample_of(k, i);
        at[1].value = peak_at(at[1].x, k);
        at[2] = sample_of(k, i + 1);
        if (!(at[1].value > at[0].value && at[1].value > at[2].value))
            continue;
        top = flk_find_peak(peak_at, k, at, EQUAL * fabs(at[1].value));
        sharpen(peak_at, k, at[0].x, at[2].x, &top);
        offer_at(k, 1, -top.value, top.x);
    }
}

/* ------------------------------------------------------------------------------------------------ poles */

/* Offer a pole: one of both infinities, or both. */
static void offer_pole(void *data, const flk_pole *pole)
{
    const sought *k = data;

    if (pole->signs & FLK_POLE_UP)
        offer_at(k, 0, GSL_POSINF, pole->s);
    if (pole->signs & FLK_POLE_DOWN)
        offer_at(k, 1, GSL_NEGINF, pole->s);
}

/* --------------------------------------------------------------------------------------- rounding error */

/* The rounding error of a column: rows beside one another are so far from a straight line.  A column can
** be far smaller than its quantity elsewhere in the machine and yet exact, as an inertia force beside
** pin forces.  One that is nowhere larger than the rounding error of its quantity is 0 by symmetry, also
** where some rows beside one another are exactly 0. */
#define NOISE_ROWS 6
#define NOISE_STEP 2e-9         /* rad: so close, rows bend by rounding error only, */
#define NOISE_PLACE 0.38        /* ... at this part of the piece, where no symmetry hides it */
#define NOISE_FACTOR 4          /* of many rows, beside the largest of these few */
#define NOISE_OF_QUANTITY 1e-14 /* of the size of its quantity: more is not rounding error */

static double noise_of(const flk_sampled *c, const flk_row *rows)
{
    double most = NOISE_OF_QUANTITY * c->scale, bend = 0, v[NOISE_ROWS];
    int i;

    for (i = 0; i < NOISE_ROWS; i++) {
        v[i] = flk_column_value(c->of.c, &rows[i]);
        if (i > 0)
            v[i] = flk_followed_nearest(&c->of, v[i], v[i - 1]);
        if (i > 1)
            flk_scale_take(&bend, v[i] - 2 * v[i - 1] + v[i - 2]);
    }
    return c->largest <= most ? most : GSL_MIN_DBL(most, NOISE_FACTOR * bend);
}

static void find_noise(search *x)
{
    const flk_samples *s = &x->samples;
    double length = s->f.piece.to - s->f.piece.from;
    double step = GSL_MIN_DBL(NOISE_STEP, length / (4 * NOISE_ROWS));
    flk_row rows[NOISE_ROWS];
    size_t i;

    for (i = 0; i < NOISE_ROWS; i++)
        flk_follow_row(&s->f, s->needs, s->f.piece.from + NOISE_PLACE * length + step * (double)i,
                       &rows[i]);
    for (i = 0; i < s->n_columns; i++)
        x->bests[i].noise = noise_of(&s->columns[i], rows);
}

/* --------------------------------------------------------------------------------------- piece by piece */

static void search_column(const flk_samples *x, const flk_sampled *c, flk_bests *b)
{
    sought k;
    int which;

    k.x = x;
    k.c = c;
    k.b = b;
    if (c->starts_anew)
        commit(b, 0);
    for (which = 0; which < 2; which++)
        offer_samples(&k, which);
    flk_poles_find(x, c, offer_pole, &k);
    for (which = 0; which < 2 && !c->of.is_noise; which++) {
        refine(&k, which);
        refine_beside_undefined_ends(&k, which);
    }
    if (c->vector[0] && !(c->of.turn > 0))
        refine_least_sizes(&k);
}

/* Angles start anew after a piece in which the linkage cannot be assembled. */
static void end_piece(search *x)
{
    size_t i;

    for (i = 0; i < x->samples.n_columns; i++) {
        flk_sampled *c = &x->samples.columns[i];

        if (!x->samples.is_reached && c->of.turn > 0 && !c->is_of_crank) {
            commit(&x->bests[i], 0);
            c->of.last = GSL_NAN;
            c->of.restarts = 1;
        } else if (x->samples.f.a->course.actual) {
            commit(&x->bests[i], 0);
        }
    }
}

/* In each skipped period an angle makes as many turns as in the first. */
static void skip_turns(search *x, double periods)
{
    size_t c;

    for (c = 0; c < x->samples.n_columns && periods > 0; c++) {
        flk_followed *t = &x->samples.columns[c].of;

        t->last += flk_followed_per_period(t) * periods;
    }
}

#define NOISE 1e-10 /* of a column's size: so much a constant one may vary near a change point */

/* A column that is constant within rounding has its extremes at the first row. */
static void move_constant(const search *x, const flk_followed *t, flk_bests *b)
{
    flk_extreme *max = &b->best[0], *min = &b->best[1];
    double value;
    flk_row row;

    if (!max->is_there || !min->is_there || !gsl_finite(max->value) ||
        !(max->value - min->value <= NOISE * fabs(max->value)))
        return;
    flk_follow_row(&x->samples.f, flk_column_need(t->c), 0, &row);
    value = flk_followed_nearest(t, flk_column_value(t->c, &row), max->value);
    if (row.at.status == FOURLINK_CHANGE_POINT ||
        fabs(value - max->value) <= NOISE * fabs(max->value))
        max->angle = min->angle = x->samples.f.motion.first;
}

/* The least value of a difference of lengths, such as a displacement, may be 0 within rounding. */
#define ROUNDING (32 * GSL_DBL_EPSILON)

static void report(const search *x, const flk_extreme *best, double size, flk_extreme *extreme)
{
    extreme->is_there = best->is_there;
    extreme->value = fabs(best->value) <= ROUNDING * size ? 0 : best->value;
    extreme->angle = flk_follow_crank(&x->samples.f, best->angle);
}

/* The last row of a revolution is its first: after a gap angles are moved by whole turns to agree with it. */
static void finish(search *x, int has_gap, flk_extreme_pair *pairs)
{
    size_t i;

    for (i = 0; i < x->samples.n_columns; i++) {
        const flk_sampled *c = &x->samples.columns[i];
        flk_bests *b = &x->bests[i];

        commit(b, has_gap ? flk_followed_behind_gap(&c->of, &x->samples.f) : 0);
        move_constant(x, &c->of, b);
        report(x, &b->best[0], c->size, &pairs[i].max);
        report(x, &b->best[1], c->size, &pairs[i].min);
    }
}

static void begin_search(search *x, const flk_samples_room *room, flk_bests *bests, flk_analysis *a,
                         fourlink_branch branch, const flk_extreme_pair *pairs, size_t n)
{
    size_t i;

    flk_samples_begin(&x->samples, room, a, branch);
    x->bests = bests;
    for (i = 0; i < n; i++) {
        flk_samples_add(&x->samples, &pairs[i].c);
        memset(&x->bests[i], 0, sizeof x->bests[i]);
        x->bests[i].close = a->course.actual ? CLOSE_TURNS : CLOSE;
    }
}

static void search_extremes(search *x, flk_extreme_pair *pairs)
{
    flk_samples *s = &x->samples;
    int has_gap = 0;
    size_t i;

    while (flk_samples_next(s)) {
        find_noise(x);
        for (i = 0; i < s->n_columns; i++)
            search_column(s, &s->columns[i], &x->bests[i]);
        has_gap |= !s->is_reached;
        if (!s->is_whole)
            continue;
        end_piece(x);
        skip_turns(x, flk_follow_skips(&s->f));
    }
    finish(x, has_gap, pairs);
}

void flk_extreme_search(flk_analysis *a, const flk_samples_room *room, flk_bests *bests,
                        fourlink_branch branch, flk_extreme_pair *pairs, size_t n)
{
    int status = flk_course_stops(&a->course, branch) ? FOURLINK_TOO_LONG : FOURLINK_OK;
    search x;
    size_t i;

    if (status == FOURLINK_OK) {
        begin_search(&x, room, bests, a, branch, pairs, n);
        a->is_fast = 1;
        search_extremes(&x, pairs);
        a->is_fast = 0;
        status = flk_follow_is_over(&x.samples.f) ? FOURLINK_LONG_SEARCH : FOURLINK_OK;
    }
    for (i = 0; i < n; i++) {
        pairs[i].status = status;
        pairs[i].is_searched = 1;
        if (status != FOURLINK_OK)
            pairs[i].max.is_there = pairs[i].min.is_there = 0;
    }
}
