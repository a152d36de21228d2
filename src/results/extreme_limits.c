/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme_limits.c - columns at dead positions and change points, where there is no row, and at poles.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "extreme_search.h"

/* 1 if a column grows from a sample towards a place where it is undefined. */
static int grows(const flk_search *x, const flk_tracked *t, flk_place from, double towards)
{
    double outside = 2 * from.s - towards;

    return outside >= x->low && outside <= x->high &&
           fabs(from.value) > 1.3 * fabs(flk_search_value(x, t, outside, 0));
}

/* Between two samples of unlike sign a column that has poles passes through zero or infinity: halving shows
** which of them, as the magnitude falls or rises.  Close to the pole it can be undefined. */
static void find_pole(flk_search *x, flk_tracked *t, flk_place low, flk_place high)
{
    int k;

    for (k = 0; k < 100; k++) {
        flk_place at, *same;

        at.s = 0.5 * (low.s + high.s);
        at.value = flk_search_value(x, t, at.s, 0);
        if (gsl_isnan(at.value) && !grows(x, t, low, at.s) && !grows(x, t, high, at.s))
            return;
        if (!(fabs(at.value) < t->bound)) {
            flk_search_offer_at(x, &t->here[0], 0, GSL_POSINF, at.s);
            flk_search_offer_at(x, &t->here[1], 1, GSL_NEGINF, at.s);
            return;
        }
        same = (at.value > 0) == (low.value > 0) ? &low : &high;
        if (k > 2 && !(fabs(at.value) > fabs(same->value)))
            return;
        *same = at;
    }
}

/* A pole at a corner, an end of the stretch, has the sign of the rows beside it. */
static void find_pole_at_corner(flk_search *x, flk_tracked *t, double s, double inwards)
{
    double corner = flk_search_corner(x, s), beside, nearer, value;
    flk_row row;
    int which;

    flk_analysis_at_angle(x->a, flk_column_need(t->c), x->branch, corner, &row);
    if (row.at.status != FOURLINK_OK)
        return;
    value = flk_column_value(t->c, &row);
    beside = flk_search_value(x, t, s + 1e-4 * inwards, 0);
    nearer = flk_search_value(x, t, s + 0.5e-4 * inwards, 0);
    which = beside > 0 ? 0 : 1;
    if (gsl_isnan(value) ? fabs(nearer) > 1.5 * fabs(beside) && fabs(nearer) > 1e-9 * t->size
                         : fabs(value) >= t->bound)
        flk_search_offer(&t->here[which], which, which == 0 ? GSL_POSINF : GSL_NEGINF, corner,
                         corner);
}

void flk_search_find_poles(flk_search *x, flk_tracked *t, const double *values)
{
    size_t i, last;

    if (!gsl_finite(t->bound) || !x->n)
        return;
    find_pole_at_corner(x, t, x->s[0], x->high - x->low);
    find_pole_at_corner(x, t, x->s[x->n - 1], x->low - x->high);
    for (i = last = 0;
         i < x->n && (fabs(t->here[0].value) < t->bound || fabs(t->here[1].value) < t->bound);
         i++) {
        if (values[last] * values[i] < 0)
            find_pole(x, t, flk_search_place(x, values, last), flk_search_place(x, values, i));
        last = gsl_isnan(values[i]) ? last : i;
    }
}

/* Rows near an end of the piece, on several scales: the small ones are more exact for what has no poles, the
** large ones where poles cancel.  At a dead position x is the root of the angle. */
#define NODES FLK_POLYNOMIAL_MOST
#define SCALES 8

typedef struct approach {
    int at_end, is_dead;
    double edge, length; /* rad passed at the end of the piece, and length of the piece */
    double x[SCALES][NODES];
    flk_row rows[SCALES][NODES];
} approach;

/* The angle passed at a distance x from the end. */
static double passed_near(const approach *e, double x)
{
    return e->edge + (e->at_end ? -1 : 1) * (e->is_dead ? x * x : x);
}

static void compute_approach(const flk_search *x, int at_end, approach *e)
{
    static const double scales[2][SCALES] = {{0.001, 0.002, 0.008, 0.02, 0.05, 0.1, 0.15, 0.2},
                                             {0.001, 0.004, 0.016, 0.04, 0.08, 0.12, 0.2, 0.3}};
    int scale, k;

    e->at_end = at_end;
    e->is_dead = flk_search_is_root(at_end ? x->piece.end : x->piece.begin);
    e->edge = at_end ? x->piece.to : x->piece.from;
    e->length = x->piece.to - x->piece.from;
    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES; k++) {
            double most = e->is_dead ? sqrt(e->length / 2) : e->length / 2;

            most = GSL_MIN_DBL(most, scales[e->is_dead][scale]);
            e->x[scale][k] = most * (k + 1) / NODES;
            flk_search_compute(x, x->needs, passed_near(e, e->x[scale][k]), &e->rows[scale][k]);
        }
}

/* The value at 0 of the polynomial through x_k^power y_k, and how much its last node counts. */
static double extrapolate(const double *x, const double *y, int power, double *error)
{
    flk_polynomial p;
    double slope, before, value;
    int k;

    p.n = 0;
    for (k = 0; k < NODES - 1; k++)
        flk_polynomial_add(&p, x[k], gsl_pow_int(x[k], power) * y[k]);
    before = flk_polynomial_value(&p, 0, &slope);
    flk_polynomial_add(&p, x[k], gsl_pow_int(x[k], power) * y[k]);
    value = flk_polynomial_value(&p, 0, &slope);
    *error = fabs(value - before);
    return value;
}

/* The coefficient of x^-order, if there is one; else 0. */
static double coefficient(const double *x, const double *y, int order)
{
    double error, largest = 0, value = extrapolate(x, y, order, &error);
    int k;

    for (k = 0; k < NODES; k++)
        largest = GSL_MAX_DBL(largest, fabs(gsl_pow_int(x[k], order) * y[k]));
    return fabs(value) > 1e-3 * largest && error < 0.1 * fabs(value) ? value : 0;
}

/* The order of a column's pole at the end of the piece, 0 if it has none: a pole is the same on two scales. */
#define POLE_SCALE 1

static int pole_order(const approach *e, double y[][NODES], int order, double *strength)
{
    for (; order > 0; order--) {
        double other = coefficient(e->x[POLE_SCALE + 1], y[POLE_SCALE + 1], order);

        *strength = coefficient(e->x[POLE_SCALE], y[POLE_SCALE], order);
        if (*strength != 0 && fabs(*strength - other) < 0.1 * fabs(*strength))
            return order;
    }
    *strength = 0;
    return 0;
}

/* Leave the samples of a column out that are so close to an end of the piece. */
static void lose(flk_search *x, size_t c, int at_end, double away)
{
    flk_tracked *t = &x->columns[c];
    size_t i;

    t->lost[at_end] = away;
    for (i = 0; i < x->n; i++)
        if (flk_search_is_lost(x, t, x->s[i]))
            flk_search_row(x, c)[i] = GSL_NAN;
}

/* The rounding in a column at five rows, -h -h/4 0 h/4 h from a place: what is left of the second difference
** of the inner ones without the curvature, which the outer ones say. */
static double rounding_of(const flk_tracked *t, const flk_row *rows)
{
    double v[5];
    int i;

    for (i = 0; i < 5; i++)
        v[i] = flk_column_value(t->c, &rows[i]);
    for (i = 0; i < 5 && t->turn > 0; i++)
        v[i] = flk_search_nearest(t, v[i], v[2]);
    return fabs(v[1] - 2 * v[2] + v[3] - (v[0] - 2 * v[2] + v[4]) / 16);
}

/* Where poles cancel, rows close to an end of the piece are rounding: find how far from it. */
#define CLOSE_ROWS 14
#define ROUNDING 2e-10 /* of the column's size */

static void find_rounding(flk_search *x, const approach *e)
{
    double away = GSL_MIN_DBL(e->is_dead ? 0.3 : 0.1, 0.5 * e->length);
    static const double steps[] = {-1e-6, -2.5e-7, 0, 2.5e-7, 1e-6};
    flk_row rows[5];
    size_t c;
    int k, i;

    for (k = 0; k < CLOSE_ROWS; k++, away /= 2) {
        for (i = 0; i < 5; i++)
            flk_search_compute(x, x->needs, passed_near(e, away * (1 + steps[i])), &rows[i]);
        for (c = 0; c < x->n_columns; c++) {
            flk_tracked *t = &x->columns[c];

            if (t->is_rough && !(rounding_of(t, rows) <= ROUNDING * t->size_here)) {
                lose(x, c, e->at_end, e->is_dead ? away * away : away);
                t->is_rough = 0;
            }
        }
    }
}

static void offer_near(const flk_search *x, flk_tracked *t, const approach *e, double at,
                       double value)
{
    double angle = flk_search_angle(x, passed_near(e, at));
    int which;

    for (which = 0; which < 2; which++)
        flk_search_offer(&t->here[which], which, value, angle, angle);
}

/* Offer the extremes of a column between the end of the piece and the first of its samples, by the polynomial
** that says its limit. */
#define PARTS 8

static void offer_flats(const flk_search *x, flk_tracked *t, const double *values,
                        const approach *e, const double *away, const double *y)
{
    size_t i = e->at_end ? x->n - 1 : 0, k;
    double most, slope, at;
    flk_polynomial p;

    while (values[i] != values[i] && i != (e->at_end ? 0 : x->n - 1))
        i += e->at_end ? (size_t)-1 : 1;
    most = fabs(flk_search_passed(x, x->s[i]) - e->edge);
    most = GSL_MIN_DBL(e->is_dead ? sqrt(most) : most, away[NODES - 1]);
    p.n = 0;
    for (k = 0; k < NODES; k++)
        flk_polynomial_add(&p, away[k], y[k]);
    for (k = 0; k < PARTS; k++)
        if (flk_polynomial_find_flat(&p, most * (double)k / PARTS, most * (double)(k + 1) / PARTS,
                                     &at))
            offer_near(x, t, e, at, flk_polynomial_value(&p, at, &slope));
}

/* The limit of a column at x = 0, of its values on the scale that is surest. */
typedef struct limit {
    double value, error, size; /* the column's magnitude near the end */
    int scale;
} limit;

static limit limit_of(const approach *e, double y[][NODES], int order)
{
    double value, error;
    limit best;
    int scale;

    best.error = GSL_POSINF;
    best.value = 0;
    best.scale = 0;
    for (scale = 0; scale < SCALES; scale++) {
        value = extrapolate(e->x[scale], y[scale], order, &error);
        if (error < best.error) {
            best.value = value;
            best.error = error;
            best.scale = scale;
        }
    }
    best.size = GSL_MAX_DBL(fabs(y[best.scale][NODES - 1]), fabs(y[SCALES - 1][NODES - 1]));
    return best;
}

/* A direction at a pole of its vector is that of the strengths. */
static int has_direction(const flk_search *x, const flk_tracked *t, const approach *e,
                         double *direction)
{
    double u[2][SCALES][NODES], strength[2];
    int scale, k, i, order[2], most;

    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES; k++)
            if (!flk_column_vector(t->c, &e->rows[scale][k], &u[0][scale][k], &u[1][scale][k]))
                return 0;
    for (i = 0; i < 2; i++)
        order[i] = pole_order(e, u[i], x->pole_order, &strength[i]);
    most = GSL_MAX_INT(order[0], order[1]);
    for (i = 0; i < 2; i++)
        if (order[i] < most)
            strength[i] = 0;
        else if (most > 0)
            strength[i] = limit_of(e, u[i], most).value;
    *direction = atan2(strength[1], strength[0]) * t->c->scale;
    return most > 0;
}

/* A column's size in a stretch, whatever it does at the ends. */
static double size_inside(const flk_search *x, const double *values)
{
    double size = 0;
    size_t k;

    for (k = 1; k < 4; k++)
        if (fabs(values[k * (x->n - 1) / 4]) > size)
            size = fabs(values[k * (x->n - 1) / 4]);
    return size;
}

/* Of a column's size: a limit that is so sure is used; so sure the polynomial is the column. */
#define KNOWN 1e-6
#define EXACT 1e-9

/* Offer what a column has at an end of the piece: its limit, or a pole. */
static void find_limit(flk_search *x, size_t c, const approach *e)
{
    flk_tracked *t = &x->columns[c];
    const double *values = flk_search_row(x, c);
    double near = values[e->at_end ? x->n - 1 : 0], strength, direction, size;
    double y[SCALES][NODES];
    int scale, k;
    limit l;

    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES; k++) {
            y[scale][k] = flk_column_value(t->c, &e->rows[scale][k]);
            if (t->turn > 0)
                y[scale][k] = flk_search_nearest(t, y[scale][k], near);
        }
    if (!(t->turn > 0) && pole_order(e, y, x->pole_order, &strength)) {
        t->has_pole[e->at_end] = 1;
        k = strength > 0 ? 0 : 1;
        flk_search_offer(&t->here[k], k, k == 0 ? GSL_POSINF : GSL_NEGINF,
                         flk_search_angle(x, e->edge), flk_search_angle(x, e->edge));
        return;
    }
    l = limit_of(e, y, 0);
    t->size_here = l.size;
    t->is_rough = !gsl_finite(t->bound) && !(l.scale == 0 && l.error <= 1e-10 * l.size);
    size = GSL_MAX_DBL(l.size, size_inside(x, values));
    if (fabs(l.value) <= GSL_MAX_DBL(4 * l.error, EXACT * size))
        l.value = 0; /* of a transmission angle nothing is left */
    if (!(l.error <= EXACT * size) && t->turn > 0 && has_direction(x, t, e, &direction))
        offer_near(x, t, e, 0, flk_search_nearest(t, direction, near));
    else if (l.error <= KNOWN * size)
        offer_near(x, t, e, 0, l.value);
    if (l.error <= EXACT * size)
        offer_flats(x, t, values, e, e->x[l.scale], y[l.scale]);
}

void flk_search_find_limits(flk_search *x, int at_end)
{
    flk_piece_end kind = at_end ? x->piece.end : x->piece.begin;
    int is_rough = 0;
    flk_row at_edge;
    approach e;
    size_t c;

    if (!flk_search_has_limit(kind))
        return;
    compute_approach(x, at_end, &e);
    flk_search_compute(x, 0, e.edge, &at_edge);
    x->pole_order = kind == FLK_END_CHANGE_REST ? 6 : 4;
    for (c = 0; c < x->n_columns; c++) {
        flk_tracked *t = &x->columns[c];

        t->is_rough = 0;
        if (flk_column_flags(t->c) & FOURLINK_OF_CRANK)
            offer_near(x, t, &e, 0, flk_column_value(t->c, &at_edge));
        else if (!t->is_noise && x->n > 0)
            find_limit(x, c, &e);
        is_rough |= t->is_rough;
    }
    if (is_rough)
        find_rounding(x, &e);
}
