/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.c - the largest and smallest values of columns over a deck's motion, found together.
**
** The motion is cut into pieces within which columns are smooth (motion_pieces.c).  Each is sampled once for all
** columns, in steps of two degrees or less, over a parameter s in which square roots at its ends are smooth:
**
**    passed = from + (to - from) s^2, or (to - from) (1 - (1 - s)^2), or (to - from) (1 - cos(pi s)) / 2
**
** Where samples say that a narrow extreme may hide between them, the steps are halved.  A peak of the samples
** is refined by a polynomial through its neighbours; the row at the peak of the polynomial is computed, and if
** it is not what the polynomial says, there are new samples about it, ever closer.  Where there is no row, at
** dead positions and change points, the limit is that of a polynomial too, or the column is unbounded.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "extreme.h"
#include "motion_pieces.h"

#define MOST_SAMPLES 1000    /* of a stretch, */
#define STRETCH 400          /* which begins with so many at the most, */
#define LEAST_SAMPLES 12     /* and at the least */
#define MOST_STEPS 1e6       /* of all of the motion */
#define NODES 7              /* of a polynomial */
#define INSIDE 5e-11         /* rad, from a corner into the piece beside it */
#define CLOSE_TO_CHANGE 1e-4 /* rad */
#define CLOSE 1e-12          /* of a column's size: what is equal but for rounding */

/* An extreme in the search. */
typedef struct found {
    int is_there;
    double value, angle;
    double
        corner; /* what is told for an angle just inside a corner, if the row there is no worse */
} found;

/* A column in the search. */
typedef struct tracked {
    const flk_column *c;
    double turn;        /* of an angle: a turn in its unit; else 0 */
    double last;        /* the angle goes on from here, NaN: it starts anew */
    double first;       /* at the first row */
    double size, bound; /* the largest magnitude, and that beyond which it is infinite */
    int is_noise;       /* 1: a measure of rounding */
    double
        lost[2];   /* rad, from begin and end of the piece, where poles cancel and leave rounding */
    found best[2]; /* greatest, least */
    found here[2]; /* since the angle started anew */
} tracked;

typedef struct search {
    flk_analysis *a;
    fourlink_branch branch;
    int needs;
    flk_extreme_pair *pairs;
    size_t n_columns;
    tracked *columns;
    int has_noise; /* 1: samples are the rows of the deck's own solver, whose rounding is asked for */
    double from, length,
        per_rad; /* of the motion: first angle, rad passed in all, deck's units for each */
    double end;  /* last angle, in the deck's unit as the first */
    flk_piece piece;
    double low, high; /* of the stretch in the piece, s */
    double closest;   /* of its samples: those closer than that are one for polynomials */
    size_t n;         /* samples: */
    double *s;        /* the parameter, */
    double *values;   /* and a row of MOST_SAMPLES for each column, NaN where it has no value */
} search;

/* ----------------------------------------------------------------------------------------- one angle */

static int is_root(flk_piece_end end)
{
    return end == FLK_END_ROOT || end == FLK_END_DEAD || end == FLK_END_CHANGE_REST;
}

/* The angle that the motion has passed at a parameter of the piece; just inside at its ends. */
static double passed_at(const search *x, double s)
{
    double from = x->piece.from, length = x->piece.to - from, share = s;

    if (is_root(x->piece.begin) && is_root(x->piece.end))
        share = 0.5 - 0.5 * cos(M_PI * s);
    else if (is_root(x->piece.begin))
        share = s * s;
    else if (is_root(x->piece.end))
        share = s * (2 - s);
    if (s <= 0 && from > 0)
        return from + GSL_MIN_DBL(INSIDE, length / 4);
    if (s >= 1 && x->piece.to < x->length)
        return x->piece.to - GSL_MIN_DBL(INSIDE, length / 4);
    return from + length * share;
}

static double angle_of(const search *x, double passed)
{
    return passed >= x->length ? x->end : x->from + x->per_rad * passed;
}

/* The corner that a parameter is at, or its own angle. */
static double corner_at(const search *x, double s)
{
    return angle_of(x, s <= 0 ? x->piece.from : s >= 1 ? x->piece.to : passed_at(x, s));
}

static void compute(const search *x, int needs, double passed, flk_row *row)
{
    flk_analysis_at_angle(x->a, needs, x->branch, angle_of(x, passed), row);
}

/* By which part of a turn an angle leaps, at most a half. */
static double leap(const tracked *t, double from, double to)
{
    double d = (to - from) / t->turn;

    return fabs(d - floor(d + 0.5));
}

/* A force that passes through zero turns by half a turn at once: its direction does not go on there. */
#define HALF_TURN (0.5 - 1e-6)

/* 1 where rows of a column are rounding. */
static int is_lost(const search *x, const tracked *t, double s)
{
    double passed = passed_at(x, s);

    return passed - x->piece.from < t->lost[0] || x->piece.to - passed < t->lost[1];
}

/* A column at a parameter; an angle is the one nearest to `near`, NaN half a turn from it. */
static double value_at(const search *x, const tracked *t, double s, double near)
{
    double value;
    flk_row row;

    if (is_lost(x, t, s))
        return GSL_NAN;
    compute(x, flk_column_need(t->c), passed_at(x, s), &row);
    value = flk_column_value(t->c, &row);
    if (!(t->turn > 0))
        return value;
    return leap(t, near, value) > HALF_TURN
               ? GSL_NAN
               : value + t->turn * floor((near - value) / t->turn + 0.5);
}

/* ------------------------------------------------------------------------------------------- samples */

static double *row_of(const search *x, size_t column)
{
    return x->values + MOST_SAMPLES * column;
}

static int has_limit(flk_piece_end end)
{
    return end == FLK_END_DEAD || end == FLK_END_CHANGE || end == FLK_END_CHANGE_REST;
}

/* There is no row at a dead position, and close to a change point it is rounding. */
static int has_row(flk_piece_end end, double away)
{
    return !has_limit(end) || away > (end == FLK_END_DEAD ? 0 : CLOSE_TO_CHANGE);
}

static int has_row_at(const search *x, double s)
{
    double passed = passed_at(x, s);

    return has_row(x->piece.begin, s <= 0 ? 0 : passed - x->piece.from) &&
           has_row(x->piece.end, s >= 1 ? 0 : x->piece.to - passed);
}

/* Put a sample of all columns before number i. */
static void insert(search *x, size_t i, double s)
{
    size_t c, behind = (x->n - i) * sizeof(double);
    double *place = x->values + i;
    flk_row row;

    compute(x, x->needs, passed_at(x, s), &row);
    if (behind)
        memmove(x->s + i + 1, x->s + i, behind);
    x->s[i] = s;
    for (c = 0; c < x->n_columns; c++, place += MOST_SAMPLES) {
        tracked *t = &x->columns[c];

        if (behind)
            memmove(place + 1, place, behind);
        *place = (t->is_noise && x->a->is_fast) || is_lost(x, t, s) ? GSL_NAN
                                                                    : flk_column_value(t->c, &row);
        if (fabs(*place) > t->size && gsl_finite(*place))
            t->size = fabs(*place);
    }
    x->n++;
}

static void append(search *x, double s)
{
    if (has_row_at(x, s))
        insert(x, x->n, s);
}

/* Samples of a stretch in even steps, and closer and closer where there is no row at its end. */
#define HALVINGS 5

static void sample(search *x, size_t steps)
{
    double step = (x->high - x->low) / (double)(steps ? steps : 1);
    int at_begin = x->low <= 0 && has_limit(x->piece.begin),
        at_end = x->high >= 1 && has_limit(x->piece.end), k;
    size_t i;

    x->n = 0;
    x->closest = 1e-4 * step;
    x->a->is_fast = !x->has_noise;
    for (k = HALVINGS; at_begin && k > 0; k--)
        append(x, x->low + step * pow(0.5, k));
    for (i = 0; i <= steps; i++)
        append(x, i == steps ? x->high : x->low + step * (double)i);
    for (k = 1; at_end && k <= HALVINGS; k++)
        append(x, x->high - step * pow(0.5, k));
    x->a->is_fast = 1;
}

/* Angles go on from sample to sample past half a turn.  Where one leaps by more than a sixth of a turn there are
** more samples, until it does not or they are too close. */
#define LEAP (1.0 / 6)
#define CLOSEST_SAMPLES 1e-7

static int leaps(const search *x, size_t i)
{
    size_t c;

    for (c = 0; c < x->n_columns; c++) {
        const double *values = row_of(x, c);

        if (x->columns[c].turn > 0 && leap(&x->columns[c], values[i], values[i + 1]) > LEAP)
            return 1;
    }
    return 0;
}

static void resolve_leaps(search *x)
{
    size_t i;

    for (i = 0; i + 1 < x->n; i++)
        while (x->n < MOST_SAMPLES && x->s[i + 1] - x->s[i] > CLOSEST_SAMPLES && leaps(x, i))
            insert(x, i + 1, 0.5 * (x->s[i] + x->s[i + 1]));
}

/* ------------------------------------------------------------------------------------------- the best */

static double signed_value(int which, double value)
{
    return which == 0 ? value : -value;
}

/* Keep a value if it is better than what there is; of equal ones the first. */
static void offer(found *best, int which, double value, double angle, double corner)
{
    double close = CLOSE * GSL_MAX_DBL(fabs(value), fabs(best->value));

    if (gsl_isnan(value))
        return;
    if (!best->is_there || signed_value(which, value) >
                               signed_value(which, best->value) + (gsl_finite(close) ? close : 0)) {
        best->is_there = 1;
        best->value = value;
        best->angle = angle;
        best->corner = corner;
    }
}

/* The same at a parameter. */
static void offer_at(const search *x, found *best, int which, double value, double s)
{
    offer(best, which, value, angle_of(x, passed_at(x, s)), corner_at(x, s));
}

/* Close what has been found since an angle started anew, which is shifted by whole turns. */
static void commit(tracked *t, double shift)
{
    int which;

    for (which = 0; which < 2; which++)
        if (t->here[which].is_there)
            offer(&t->best[which], which, t->here[which].value + shift, t->here[which].angle,
                  t->here[which].corner);
    memset(t->here, 0, sizeof t->here);
}

/* Make an angle go on through the samples of a stretch. */
static void follow(search *x, tracked *t, double *values)
{
    size_t i;

    for (i = 0; i < x->n; i++) {
        if (x->piece.from <= 0 && x->low <= 0 && i == 0)
            t->first = values[i];
        if (gsl_isnan(values[i]) ||
            (!gsl_isnan(t->last) && leap(t, t->last, values[i]) > HALF_TURN)) {
            commit(t, 0);
            t->last = values[i];
            continue;
        }
        if (!gsl_isnan(t->last))
            values[i] += t->turn * floor((t->last - values[i]) / t->turn + 0.5);
        t->last = values[i];
    }
}

/* ---------------------------------------------------------------------------------------- polynomials */

/* A place and the value there. */
typedef struct place {
    double s, value;
} place;

static place sample_at(const search *x, const double *values, size_t i)
{
    place p;

    p.s = x->s[i];
    p.value = values[i];
    return p;
}

/* A polynomial by divided differences. */
typedef struct polynomial {
    int n;
    double x[NODES + 1], c[NODES + 1];
} polynomial;

static void add_node(polynomial *p, double x, double y)
{
    int i;

    p->x[p->n] = x;
    p->c[p->n] = y;
    for (i = 0; i < p->n; i++)
        p->c[p->n] = (p->c[p->n] - p->c[i]) / (x - p->x[i]);
    p->n++;
}

static double value_of(const polynomial *p, double x, double *slope)
{
    double value = 0;
    int i;

    *slope = 0;
    for (i = p->n - 1; i >= 0; i--) {
        *slope = *slope * (x - p->x[i]) + value;
        value = value * (x - p->x[i]) + p->c[i];
    }
    return value;
}

/* Where the slope of a polynomial vanishes between two places, by false position (the Illinois rule); 0 if it
** has one sign at both. */
static int find_flat(const polynomial *p, double low, double high, double *at)
{
    double rise_low, rise_high, rise, enough = 1e-10 * (high - low);
    int i, side = 0;

    value_of(p, low, &rise_low);
    value_of(p, high, &rise_high);
    if ((rise_low > 0) == (rise_high > 0))
        return 0;
    for (i = 0; i < 60 && high - low > enough; i++) {
        double before = *at;

        *at = (low * rise_high - high * rise_low) / (rise_high - rise_low);
        value_of(p, *at, &rise);
        if (rise == 0 || (i > 0 && fabs(*at - before) <= enough))
            break;
        if ((rise > 0) == (rise_low > 0)) {
            low = *at;
            rise_low = rise;
            rise_high *= side == 1 ? 0.5 : 1;
            side = 1;
        } else {
            high = *at;
            rise_high = rise;
            rise_low *= side == -1 ? 0.5 : 1;
            side = -1;
        }
    }
    return 1;
}

/* The nearest sample on a side that is not so close that differences are rounding; i if there is none. */
static size_t beside(const search *x, const double *values, size_t i, int side)
{
    size_t k = i;

    while (side > 0 ? k + 1 < x->n : k > 0) {
        k = side > 0 ? k + 1 : k - 1;
        if (values[k] != values[k])
            return i;
        if (fabs(x->s[k] - x->s[i]) >= x->closest)
            return k;
    }
    return i;
}

/* The polynomial through the samples nearest to number i; 0 if there are too few. */
static int through_samples(const search *x, const double *values, size_t i, polynomial *p)
{
    size_t from = i, to = i, lower = i, upper = i;

    p->n = 0;
    add_node(p, x->s[i], values[i]);
    while (p->n < NODES) {
        lower = lower == from ? beside(x, values, from, -1) : lower;
        upper = upper == to ? beside(x, values, to, 1) : upper;
        if (lower == from && upper == to)
            break;
        if (upper == to || (lower != from && x->s[i] - x->s[lower] <= x->s[upper] - x->s[i]))
            add_node(p, x->s[lower], values[from = lower]);
        else
            add_node(p, x->s[upper], values[to = upper]);
    }
    return p->n > 2;
}

/* ---------------------------------------------------------------------------------------- refinement */

/* The magnitude of a column about sample i. */
static double size_about(const search *x, const double *values, size_t i)
{
    double size = 0;
    size_t k, to = i + 3 < x->n ? i + 3 : x->n;

    for (k = i < 2 ? 0 : i - 2; k < to; k++)
        if (fabs(values[k]) > size)
            size = fabs(values[k]);
    return size;
}

static double median(double x, double y, double z)
{
    return GSL_MAX_DBL(GSL_MIN_DBL(x, y), GSL_MIN_DBL(GSL_MAX_DBL(x, y), z));
}

/* Samples about a place, closer and closer, until a parabola through three of them says what the row at its top
** is, or they cannot be told apart: `best` climbs. */
static void climb(search *x, const tracked *t, int which, double low, double high, place *best)
{
    double step = (high - low) / 8;
    int i;

    for (i = 0; i < 60 && step > 1e-13; i++) {
        place left, right, top;
        polynomial p;
        double slope;

        p.n = 0;
        left.s = GSL_MAX_DBL(best->s - step, low);
        right.s = GSL_MIN_DBL(best->s + step, high);
        left.value = value_at(x, t, left.s, best->value);
        right.value = value_at(x, t, right.s, best->value);
        if (signed_value(which, left.value) > signed_value(which, best->value) &&
            signed_value(which, left.value) >= signed_value(which, right.value)) {
            *best = left;
            continue;
        }
        if (signed_value(which, right.value) > signed_value(which, best->value)) {
            *best = right;
            continue;
        }
        step /= 4;
        if (fabs(left.value - best->value) + fabs(right.value - best->value) <=
            CLOSE * fabs(best->value))
            return;
        if (!(left.s < best->s && best->s < right.s) || gsl_isnan(left.value + right.value))
            continue;
        add_node(&p, left.s, left.value);
        add_node(&p, best->s, best->value);
        add_node(&p, right.s, right.value);
        if (!find_flat(&p, left.s, right.s, &top.s))
            continue;
        top.value = value_at(x, t, top.s, best->value);
        if (fabs(top.value - value_of(&p, top.s, &slope)) <=
            CLOSE * median(fabs(left.value), fabs(best->value), fabs(right.value))) {
            *best = top;
            return;
        }
        if (signed_value(which, top.value) > signed_value(which, best->value))
            *best = top;
    }
}

/* The same from an end, if the column rises from there. */
static void climb_from_end(search *x, const tracked *t, int which, double low, double high,
                           place *best)
{
    place beside;

    beside.s = best->s + 1e-3 * (best->s == low ? high - low : low - high);
    beside.value = value_at(x, t, beside.s, best->value);
    if (signed_value(which, beside.value) <= signed_value(which, best->value))
        return;
    *best = beside;
    climb(x, t, which, low, high, best);
}

/* A peak is flat: values tell its place to the root of the rounding only.  The slope of a polynomial through rows
** close about it tells it better. */
static void sharpen(const search *x, const tracked *t, double low, double high, double size,
                    place *top)
{
    double step = (high - low) / 20, slope;
    polynomial p;
    place sharp;
    int k;

    if (top->s - 2 * step < low || top->s + 2 * step > high)
        return;
    p.n = 0;
    for (k = -2; k <= 2; k++)
        add_node(&p, top->s + k * step,
                 k ? value_at(x, t, top->s + k * step, top->value) : top->value);
    if (!find_flat(&p, top->s - step, top->s + step, &sharp.s))
        return;
    sharp.value = value_at(x, t, sharp.s, top->value);
    if (fabs(sharp.value - value_of(&p, sharp.s, &slope)) <= CLOSE * size)
        *top = sharp;
}

/* The peak that the samples have at or beside number i. */
static void refine(search *x, const tracked *t, const double *values, int which, size_t i, found *f)
{
    size_t before = beside(x, values, i, -1), behind = beside(x, values, i, 1);
    double low = x->s[before], high = x->s[behind], slope;
    double size = median(fabs(values[before]), fabs(values[i]), fabs(values[behind]));
    place best = sample_at(x, values, i), top;
    polynomial p;
    int is_good = 0;

    if (!t->is_noise && low < high) {
        if (through_samples(x, values, i, &p) && find_flat(&p, low, high, &top.s)) {
            top.value = value_at(x, t, top.s, best.value);
            is_good = fabs(top.value - value_of(&p, top.s, &slope)) <= 1e-11 * size;
            if (signed_value(which, top.value) > signed_value(which, best.value))
                best = top;
        }
        if (!is_good && (before == i || behind == i) && best.s == x->s[i])
            climb_from_end(x, t, which, low, high, &best);
        else if (!is_good)
            climb(x, t, which, low, high, &best);
        sharpen(x, t, low, high, size, &best);
    }
    offer_at(x, f, which, best.value, best.s);
}

/* 1 if the samples about number i are evenly spaced. */
static int is_even(const search *x, size_t i)
{
    const double *s = x->s + i;
    double step;

    if (i < 2 || i + 2 >= x->n)
        return 0;
    step = s[1] - s[0];
    return fabs(s[-1] - s[-2] - step) + fabs(s[0] - s[-1] - step) + fabs(s[2] - s[1] - step) <
           1e-9 * step;
}

/* How far sample i is from what its four neighbours say: by so much the column may differ from a smooth
** curve. */
static double roughness(const search *x, const double *values, size_t i, int even)
{
    size_t k, from = i < 2 ? 0 : i + 3 > x->n ? x->n - 5 : i - 2;
    const double *v = values + i;
    polynomial p;
    double slope, d;

    if (x->n < 5)
        return 0;
    if (even) {
        d = (v[-2] - 4 * v[-1] + 6 * v[0] - 4 * v[1] + v[2]) / 6;
    } else {
        p.n = 0;
        for (k = from; k < from + 5; k++)
            if (k != i)
                add_node(&p, x->s[k], values[k]);
        d = value_of(&p, x->s[i], &slope) - values[i];
    }
    return d == d ? fabs(d) : 0;
}

#define ROUGH 1e-5 /* of the column's size: below it nothing hides between samples */
#define MARGIN 8   /* a column may reach so many times its roughness beyond a sample */

/* 1 if an angle has half a turn between samples about number i, which no step resolves. */
static int jumps(const search *x, const tracked *t, const double *values, size_t i)
{
    size_t k, to = i + 4 < x->n ? i + 4 : x->n - 1;

    for (k = i < 4 ? 0 : i - 4; t->turn > 0 && k < to; k++)
        if (fabs(values[k + 1] - values[k]) > 0.4 * t->turn)
            return 1;
    return 0;
}

/* 1 if a better extreme of a column may hide beside a sample. */
static int may_hide(const search *x, const tracked *t, const double *values, size_t i, int even)
{
    double rough = roughness(x, values, i, even);

    if (!(rough > 1e-9 * t->size) || jumps(x, t, values, i) ||
        (values[i] + MARGIN * rough <= t->here[0].value &&
         values[i] - MARGIN * rough >= t->here[1].value))
        return 0;
    return rough > ROUGH * size_about(x, values, i) && !t->is_noise &&
           fabs(t->here[0].value) < t->bound && fabs(t->here[1].value) < t->bound;
}

/* Between two samples of unlike sign a column that has poles passes through zero or infinity: halving shows
** which of them, as the magnitude falls or rises. */
static void find_pole(search *x, tracked *t, place low, place high)
{
    int k;

    for (k = 0; k < 100; k++) {
        place at, *same;

        at.s = 0.5 * (low.s + high.s);
        at.value = value_at(x, t, at.s, 0);
        same = (at.value > 0) == (low.value > 0) ? &low : &high;
        if (fabs(at.value) >= t->bound) {
            offer_at(x, &t->here[0], 0, GSL_POSINF, at.s);
            offer_at(x, &t->here[1], 1, GSL_NEGINF, at.s);
            return;
        }
        if (k > 2 && !(fabs(at.value) > fabs(same->value)))
            return;
        *same = at;
    }
}

/* A pole at a corner has the sign of the samples beside it. */
static void find_pole_at_corner(search *x, tracked *t, place end)
{
    int which = end.value > 0 ? 0 : 1;
    double corner = corner_at(x, end.s);
    flk_row row;

    flk_analysis_at_angle(x->a, flk_column_need(t->c), x->branch, corner, &row);
    if (fabs(flk_column_value(t->c, &row)) >= t->bound)
        offer(&t->here[which], which, which == 0 ? GSL_POSINF : GSL_NEGINF, corner, corner);
}

static void find_poles(search *x, tracked *t, const double *values)
{
    size_t i;

    if (!gsl_finite(t->bound) || !x->n)
        return;
    find_pole_at_corner(x, t, sample_at(x, values, 0));
    find_pole_at_corner(x, t, sample_at(x, values, x->n - 1));

    for (i = 0;
         i + 1 < x->n && (fabs(t->here[0].value) < t->bound || fabs(t->here[1].value) < t->bound);
         i++)
        if (values[i] * values[i + 1] < 0)
            find_pole(x, t, sample_at(x, values, i), sample_at(x, values, i + 1));
}

static int hides(const search *x, size_t i)
{
    int even = is_even(x, i);
    size_t c;

    for (c = 0; c < x->n_columns; c++)
        if (may_hide(x, &x->columns[c], row_of(x, c), i, even))
            return 1;
    return 0;
}

/* Halve the step before number i. */
static void halve(search *x, size_t i)
{
    size_t c;

    if (x->n >= MOST_SAMPLES || x->s[i] - x->s[i - 1] < 1e-12)
        return;
    insert(x, i, 0.5 * (x->s[i - 1] + x->s[i]));
    for (c = 0; c < x->n_columns; c++) {
        tracked *t = &x->columns[c];
        double *v = row_of(x, c) + i;

        if (t->turn > 0)
            v[0] +=
                t->turn *
                floor(((leap(t, v[-1], v[0]) > HALF_TURN ? v[1] : v[-1]) - v[0]) / t->turn + 0.5);
        offer_at(x, &t->here[0], 0, v[0], x->s[i]);
        offer_at(x, &t->here[1], 1, v[0], x->s[i]);
    }
}

static void resolve_narrow(search *x)
{
    size_t i, before;

    for (i = 0; i < x->n; i++) {
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

/* ------------------------------------------------------------------------------------------ the stretch */

/* Offer the first of the best samples of a column. */
static void offer_samples(const search *x, tracked *t, const double *values)
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
    for (i = 0;
         values[i] != values[most] && !(values[i] > values[most] - CLOSE * fabs(values[most])); i++)
        ;
    offer_at(x, &t->here[0], 0, values[i], x->s[i]);
    for (i = 0;
         values[i] != values[least] && !(values[i] < values[least] + CLOSE * fabs(values[least]));
         i++)
        ;
    offer_at(x, &t->here[1], 1, values[i], x->s[i]);
}

/* 1 if sample i is a peak among its neighbours, but for rounding. */
static int is_peak(const search *x, const double *values, int which, size_t i)
{
    double here = signed_value(which, values[i]), close = here + CLOSE * fabs(here);

    return here == here && !(i > 0 && signed_value(which, values[i - 1]) > close) &&
           !(i + 1 < x->n && signed_value(which, values[i + 1]) > close);
}

/* The same among those that are not too close. */
static int is_peak_beside(const search *x, const double *values, int which, size_t i)
{
    double here = signed_value(which, values[i]);

    return signed_value(which, values[beside(x, values, i, -1)]) <= here &&
           signed_value(which, values[beside(x, values, i, 1)]) <= here;
}

/* By how much a column may be better beside a peak of the samples. */
static double gain_beside(const search *x, const double *values, size_t i)
{
    double gain = MARGIN * roughness(x, values, i, is_even(x, i)), bend = GSL_NAN;

    if (i > 0 && i + 1 < x->n)
        bend = fabs(values[i - 1] - 2 * values[i] + values[i + 1]);
    return gain + (bend == bend ? bend : size_about(x, values, i));
}

static void refine_peaks(search *x, tracked *t, const double *values)
{
    size_t i;
    int which;

    for (which = 0; which < 2; which++)
        for (i = 0; i < x->n; i++) {
            double gain;

            if (!is_peak(x, values, which, i))
                continue;
            gain = gain_beside(x, values, i);
            if (gain > CLOSE * fabs(values[i]) &&
                signed_value(which, values[i]) + gain >=
                    signed_value(which, t->here[which].value) &&
                is_peak_beside(x, values, which, i))
                refine(x, t, values, which, i, &t->here[which]);
        }
}

/* ---------------------------------------------------------------------------------------------- limits */

#define LIMIT_NODES (NODES + 1)
#define SCALES 5

/* The value at 0 of the polynomial through x_k^power y_k, and how much its last node counts. */
static double extrapolate(const double *x, const double *y, int power, double *error)
{
    polynomial p;
    double slope, before, value;
    int k;

    p.n = 0;
    for (k = 0; k < LIMIT_NODES - 1; k++)
        add_node(&p, x[k], gsl_pow_int(x[k], power) * y[k]);
    before = value_of(&p, 0, &slope);
    add_node(&p, x[k], gsl_pow_int(x[k], power) * y[k]);
    value = value_of(&p, 0, &slope);
    *error = fabs(value - before);
    return value;
}

/* The coefficient of x^-order, if there is one; else 0. */
static double coefficient(const double *x, const double *y, int order)
{
    double error, largest = 0, value = extrapolate(x, y, order, &error);
    int k;

    for (k = 0; k < LIMIT_NODES; k++)
        largest = GSL_MAX_DBL(largest, fabs(gsl_pow_int(x[k], order) * y[k]));
    return fabs(value) > 1e-3 * largest && error < 0.1 * fabs(value) ? value : 0;
}

/* How a column behaves towards a place without a row, x away: a pole, +-1 by the sign of it, or 0.  A pole is
** the same on two scales. */
static int pole_of(double x[][LIMIT_NODES], double y[][LIMIT_NODES], int order)
{
    for (; order > 0; order--) {
        double c = coefficient(x[0], y[0], order), other = coefficient(x[1], y[1], order);

        if (c != 0 && fabs(c - other) < 0.1 * fabs(c))
            return c > 0 ? 1 : -1;
    }
    return 0;
}

/* Leave the samples of a column out that are so close to an end of the piece. */
static void lose(search *x, size_t c, int at_end, double away)
{
    tracked *t = &x->columns[c];
    size_t i;

    t->lost[at_end] = away;
    for (i = 0; i < x->n; i++)
        if (is_lost(x, t, x->s[i]))
            row_of(x, c)[i] = GSL_NAN;
}

/* The limits of all columns at an end of the piece where there is no row, or that they have none.  Rows at
** x_k from it are computed on several scales: the small ones are more exact for what has no poles, the large
** ones where poles cancel.  At a dead position x is the root of the angle. */
static void find_limits(search *x, int at_end)
{
    static const double scales[2][SCALES] = {{0.004, 0.016, 0.06, 0.15, 0.3},
                                             {0.002, 0.008, 0.03, 0.08, 0.2}};
    flk_piece_end kind = at_end ? x->piece.end : x->piece.begin;
    int is_dead = is_root(kind), scale, k, which;
    double length = x->piece.to - x->piece.from, edge = at_end ? x->piece.to : x->piece.from;
    double away[SCALES][LIMIT_NODES], y[SCALES][LIMIT_NODES];
    flk_row rows[SCALES][LIMIT_NODES], at_edge;
    size_t c;

    if (!has_limit(kind))
        return;
    compute(x, 0, edge, &at_edge);
    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < LIMIT_NODES; k++) {
            double most = scales[is_dead ? 0 : 1][scale];

            most = GSL_MIN_DBL(most, is_dead ? sqrt(length / 2) : length / 2);
            away[scale][k] = most * (k + 1) / LIMIT_NODES;
            compute(x, x->needs,
                    edge + (at_end ? -1 : 1) * (is_dead ? away[scale][k] : 1) * away[scale][k],
                    &rows[scale][k]);
        }
    for (c = 0; c < x->n_columns; c++) {
        tracked *t = &x->columns[c];
        double near = row_of(x, c)[at_end ? x->n - 1 : 0], limit[SCALES], error[SCALES];
        int pole;

        if (t->is_noise)
            continue;
        if (flk_column_flags(t->c) & FOURLINK_OF_CRANK) {
            for (which = 0; which < 2; which++)
                offer(&t->here[which], which, flk_column_value(t->c, &at_edge), angle_of(x, edge),
                      angle_of(x, edge));
            continue;
        }
        for (scale = 0; scale < SCALES; scale++)
            for (k = 0; k < LIMIT_NODES; k++) {
                y[scale][k] = flk_column_value(t->c, &rows[scale][k]);
                if (t->turn > 0)
                    y[scale][k] += t->turn * floor((near - y[scale][k]) / t->turn + 0.5);
            }
        pole = t->turn > 0 ? 0 : pole_of(away, y, kind == FLK_END_CHANGE_REST ? 6 : 4);
        if (pole) {
            offer(&t->here[pole > 0 ? 0 : 1], pole > 0 ? 0 : 1, pole > 0 ? GSL_POSINF : GSL_NEGINF,
                  angle_of(x, edge), angle_of(x, edge));
            continue;
        }
        for (scale = 0; scale < SCALES; scale++)
            limit[scale] = extrapolate(away[scale], y[scale], 0, &error[scale]);
        for (scale = 0, k = 1; k < SCALES; k++)
            scale = error[k] < error[scale] ? k : scale;
        if (!(error[0] <= 1e-10 * fabs(y[scale][LIMIT_NODES - 1])) && !(t->turn > 0))
            lose(x, c, at_end, away[scale][1] * (is_dead ? away[scale][1] : 1));
        if (fabs(limit[scale]) < 1e-9 * fabs(y[scale][LIMIT_NODES - 1]))
            limit[scale] = 0; /* of a transmission angle nothing is left */
        for (which = 0; which < 2; which++)
            offer(&t->here[which], which, limit[scale], angle_of(x, edge), angle_of(x, edge));
    }
}

/* --------------------------------------------------------------------------------------- the motion */

static void search_stretch(search *x, size_t steps)
{
    size_t c;

    sample(x, steps);
    resolve_leaps(x);
    for (c = 0; c < x->n_columns; c++)
        if (x->columns[c].turn > 0)
            follow(x, &x->columns[c], row_of(x, c));
    if (x->low <= 0)
        find_limits(x, 0);
    if (x->high >= 1)
        find_limits(x, 1);
    for (c = 0; c < x->n_columns; c++) {
        offer_samples(x, &x->columns[c], row_of(x, c));
        find_poles(x, &x->columns[c], row_of(x, c));
    }
    resolve_narrow(x);
    for (c = 0; c < x->n_columns; c++)
        refine_peaks(x, &x->columns[c], row_of(x, c));
}

/* A piece in stretches. */
static void search_piece(search *x, int is_reached)
{
    double length = x->piece.to - x->piece.from;
    double step = GSL_MAX_DBL(M_PI / 90, x->length / MOST_STEPS);
    size_t steps = is_reached ? (size_t)ceil(length / step - 1e-9) : 1, stretches, i;

    steps = steps > LEAST_SAMPLES ? steps : LEAST_SAMPLES;
    stretches = (steps + STRETCH - 1) / STRETCH;
    for (i = 0; i < x->n_columns; i++)
        x->columns[i].lost[0] = x->columns[i].lost[1] = 0;
    for (i = 0; i < stretches; i++) {
        x->low = (double)i / (double)stretches;
        x->high = (double)(i + 1) / (double)stretches;
        search_stretch(x, (steps + stretches - 1) / stretches);
    }
}

/* 1 if the linkage can be assembled in the piece. */
static int is_reached(const search *x)
{
    flk_row row;

    compute(x, 0, 0.5 * (x->piece.from + x->piece.to), &row);
    return row.at.status == FOURLINK_OK;
}

static void start(search *x, double *memory)
{
    size_t c;

    x->s = memory;
    x->values = memory + MOST_SAMPLES;
    x->columns = (tracked *)(void *)(x->values + MOST_SAMPLES * x->n_columns);
    x->length = flk_pieces_length(x->a);
    x->from = x->a->d->motion.from;
    x->end = flk_analysis_end(x->a);
    x->per_rad = (x->end < x->from ? -1 : 1) / x->a->d->motion.angle_unit;
    x->needs = 0;
    x->n = 0;
    memset(x->columns, 0, x->n_columns * sizeof *x->columns);
    x->a->is_fast = 1;
    x->has_noise = 0;
    for (c = 0; c < x->n_columns; c++) {
        tracked *t = &x->columns[c];

        t->c = &x->pairs[c].c;
        if (flk_column_quantity(t->c) == QUANTITY_ANGLE)
            t->turn = flk_unit_from_si(2 * M_PI, x->a->d->units[QUANTITY_ANGLE].unit);
        t->last = t->first = GSL_NAN;
        t->bound = flk_column_bound(t->c);
        t->is_noise = (flk_column_flags(t->c) & FOURLINK_OF_ROUNDING) != 0;
        x->needs |= flk_column_need(t->c);
        x->has_noise |= t->is_noise;
    }
    memset(&x->piece, 0, sizeof x->piece);
}

/* Tell the corner in place of an angle just inside it, unless a load jumps there. */
static void settle(const search *x, tracked *t, int which)
{
    found *f = &t->best[which];
    double value, close = 1e-10 * fabs(f->value);
    flk_row row;

    if (!f->is_there || f->corner == f->angle || !gsl_finite(f->value))
        return;
    flk_analysis_at_angle(x->a, flk_column_need(t->c), x->branch, f->corner, &row);
    value = flk_column_value(t->c, &row);
    if (t->turn > 0)
        value += t->turn * floor((f->value - value) / t->turn + 0.5);
    if (fabs(value) >= t->bound)
        value = f->value > 0 ? GSL_POSINF : GSL_NEGINF;
    if (signed_value(which, value) < signed_value(which, f->value) - close)
        return;
    f->angle = f->corner;
    if (!gsl_isnan(value))
        f->value = value;
}

static void give(const found *f, flk_extreme *extreme)
{
    extreme->is_there = f->is_there;
    extreme->value = f->value;
    extreme->angle = f->angle;
}

/* Angles behind the last gap of a revolution go on to those of its first row, which is its last. */
static void finish(search *x, int has_gap)
{
    size_t c;

    for (c = 0; c < x->n_columns; c++) {
        tracked *t = &x->columns[c];
        double shift = 0;
        int which;

        if (has_gap && t->turn > 0 && flk_analysis_is_periodic(x->a) &&
            !gsl_isnan(t->first + t->last))
            shift = t->turn * floor((t->first - t->last) / t->turn + 0.5);
        commit(t, shift);
        for (which = 0; which < 2; which++) {
            settle(x, t, which);
            if (fabs(t->best[which].value) >= t->bound)
                t->best[which].value = t->best[which].value > 0 ? GSL_POSINF : GSL_NEGINF;
        }
        give(&t->best[0], &x->pairs[c].max);
        give(&t->best[1], &x->pairs[c].min);
    }
    x->a->is_fast = 0;
}

/* Find the extremes of n columns on a branch. */
static void find(flk_analysis *a, fourlink_branch branch, flk_extreme_pair *pairs, size_t n,
                 double *memory)
{
    int has_gap = 0;
    search x;
    size_t c;

    x.a = a;
    x.branch = branch;
    x.pairs = pairs;
    x.n_columns = n;
    start(&x, memory);
    if (x.length <= 0) {
        x.low = x.high = 0;
        search_stretch(&x, 0);
    }
    while (flk_pieces_next(a, &x.piece)) {
        int reached = is_reached(&x);

        search_piece(&x, reached);
        for (c = 0; c < n; c++)
            if (!reached && x.columns[c].turn > 0 &&
                !(flk_column_flags(x.columns[c].c) & FOURLINK_OF_CRANK)) {
                commit(&x.columns[c], 0);
                x.columns[c].last = GSL_NAN;
            }
        has_gap |= !reached;
    }
    finish(&x, has_gap);
}

/* ------------------------------------------------------------------------------------- the asked for */

int flk_extremes_open(flk_extremes *x, size_t most)
{
    size_t numbers = MOST_SAMPLES * (most + 1) + most * (sizeof(tracked) / sizeof(double) + 1);

    x->pairs[0] = malloc(2 * (most + 1) * sizeof *x->pairs[0]);
    x->pairs[1] = x->pairs[0] + most + 1;
    x->memory = malloc(numbers * sizeof *x->memory);
    return x->pairs[0] && x->memory;
}

void flk_extremes_close(flk_extremes *x)
{
    free(x->pairs[0]);
    free(x->memory);
}

static int is_same(const flk_column *x, const flk_column *y)
{
    return x->info == y->info && x->point == y->point;
}

void flk_extremes_ask(flk_extremes *x, const flk_column *c)
{
    size_t i;

    for (i = 0; i < x->n; i++)
        if (is_same(&x->pairs[0][i].c, c))
            return;
    x->pairs[0][x->n].c = x->pairs[1][x->n].c = *c;
    x->n++;
}

const flk_extreme_pair *flk_extremes_of(flk_extremes *x, flk_analysis *a, const flk_column *c,
                                        fourlink_branch branch)
{
    int k = branch == FOURLINK_OPEN ? 0 : 1;
    flk_extreme_pair *pairs = x->pairs[k];
    size_t i;

    for (i = 0; i < x->n && !is_same(&pairs[i].c, c); i++)
        ;
    if (i == x->n) {
        pairs[i].c = *c;
        find(a, branch, &pairs[i], 1, x->memory);
    } else if (!x->is_known[k]) {
        find(a, branch, pairs, x->n, x->memory);
        x->is_known[k] = 1;
    }
    return &pairs[i];
}
