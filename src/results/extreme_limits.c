/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme_limits.c - columns at dead positions and change points, where there is no row, and at poles.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "extreme_search.h"

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

#define BESIDE_POLE 1e-8          /* s */
#define ROUNDING_BESIDE_POLE 1e-6 /* there, in parts of the column's size */

typedef struct divisor {
    const flk_search *x;
    flk_tracked *t;
} divisor;

/* The denominator of a column that has poles, at a parameter. */
static double divisor_at(double s, void *data)
{
    const divisor *d = data;
    flk_row row;

    flk_search_compute(d->x, flk_column_need(d->t->c), flk_search_passed(d->x, s), &row);
    return row.at.status == FOURLINK_OK ? flk_column_denominator(d->t->c, &row) : GSL_NAN;
}

/* Find the zero of the denominator between two parameters where it has unlike signs: a pole, unless the numerator
** vanishes with it. */
static void find_pole(divisor *d, flk_bracket b)
{
    double at = flk_find_zero(divisor_at, d, &b, 0);
    double near = fabs(flk_search_value(d->x, d->t, at - BESIDE_POLE, 0));

    if (near > 1.5 * fabs(flk_search_value(d->x, d->t, at - 2 * BESIDE_POLE, 0))) {
        flk_search_offer_at(d->x, &d->t->here[0], 0, GSL_POSINF, at);
        flk_search_offer_at(d->x, &d->t->here[1], 1, GSL_NEGINF, at);
    }
}

/* A pole at a corner, an end of the stretch, has the sign of the rows beside it. */
static void find_pole_at_corner(flk_search *x, flk_tracked *t, const double *values, double s,
                                double inwards)
{
    double corner = flk_search_corner(x, s), step = inwards * BESIDE_POLE, beside, nearer, value;
    flk_row row;
    int which;

    if (flk_search_is_root(inwards > 0 ? x->piece.begin : x->piece.end))
        step = inwards * sqrt(BESIDE_POLE);
    flk_search_row_at(x, flk_column_need(t->c), corner, &row);
    if (row.at.status != FOURLINK_OK)
        return;
    value = flk_column_value(t->c, &row);
    beside = flk_search_value(x, t, s + 2 * step, 0);
    nearer = flk_search_value(x, t, s + step, 0);
    which = nearer > 0 ? 0 : 1;
    if (gsl_isnan(value) ? fabs(nearer) > 1.5 * fabs(beside) &&
                               fabs(nearer) > ROUNDING_BESIDE_POLE * size_inside(x, values)
                         : fabs(value) >= t->bound)
        flk_search_offer(&t->here[which], which, which == 0 ? GSL_POSINF : GSL_NEGINF, corner,
                         corner);
}

void flk_search_find_poles(flk_search *x, flk_tracked *t, const double *values)
{
    double at, before = GSL_NAN;
    size_t i, last = 0;
    divisor d;

    if (!gsl_finite(t->bound) || !x->n)
        return;
    d.x = x;
    d.t = t;
    find_pole_at_corner(x, t, values, x->s[0], 1);
    find_pole_at_corner(x, t, values, x->s[x->n - 1], -1);
    for (i = 0;
         i < x->n && (fabs(t->here[0].value) < t->bound || fabs(t->here[1].value) < t->bound);
         i++) {
        at = divisor_at(x->s[i], &d);
        if (at == 0) /* between samples of unlike sign */
            continue;
        if (before * at < 0)
            find_pole(&d, flk_bracket_of(x->s[last], x->s[i], before, at));
        before = at;
        last = i;
    }
}

/* Rows near an end of the piece, on several scales: the small ones are more exact for what has no poles, the
** large ones where poles cancel.  At a dead position x is the root of the angle. */
#define NODES FLK_POLYNOMIAL_MOST
#define SCALES 8
#define LONG_ENOUGH 0.4 /* rad, a length that holds all scales */

typedef struct approach {
    int at_end, is_dead;
    double edge, length; /* rad passed at the end of the piece, and over which columns are smooth */
    double x[SCALES][NODES];
    flk_row rows[SCALES][NODES];
} approach;

/* The angle passed at a distance x from the end. */
static double passed_near(const approach *e, double x)
{
    return e->edge + (e->at_end ? -1 : 1) * (e->is_dead ? x * x : x);
}

/* The largest scale is at most half of the length; no two are the same, or rounding would look like a pole. */
static void compute_approach(const flk_search *x, int at_end, double length, approach *e)
{
    static const double scales[2][SCALES] = {{0.001, 0.002, 0.008, 0.02, 0.05, 0.1, 0.15, 0.2},
                                             {0.001, 0.004, 0.016, 0.04, 0.08, 0.12, 0.2, 0.3}};
    int scale, k;

    e->at_end = at_end;
    e->is_dead = flk_search_is_root(at_end ? x->piece.end : x->piece.begin);
    e->edge = at_end ? x->piece.to : x->piece.from;
    e->length = length;
    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES; k++) {
            double most = (e->is_dead ? sqrt(length / 2) : length / 2) * (scale + 1) / SCALES;

            most = GSL_MIN_DBL(most, scales[e->is_dead][scale]);
            e->x[scale][k] = most * (k + 1) / NODES;
            flk_search_compute(x, x->needs, passed_near(e, e->x[scale][k]), &e->rows[scale][k]);
        }
}

/* The value at 0 of the polynomial through x_k^power y_k, and how much its last node counts. */
static double extrapolate(const double *x, const double *y, int power, double *error)
{
    flk_polynomial p;
    double before, value;
    int k;

    p.n = 0;
    for (k = 0; k < NODES - 1; k++)
        flk_polynomial_add(&p, x[k], gsl_pow_int(x[k], power) * y[k]);
    before = flk_polynomial_value(&p, 0);
    flk_polynomial_add(&p, x[k], gsl_pow_int(x[k], power) * y[k]);
    value = flk_polynomial_value(&p, 0);
    *error = fabs(value - before);
    return value;
}

/* 1 if the rows closest to a dead position, or to where friction locks, show a finite limit.  Those farther away may
** still look like a pole, which is beyond a narrow locked range. */
#define FINITE 1e-3 /* error of the limit, of the column's size */

static int is_finite(const approach *e, double y[][NODES])
{
    double error;

    extrapolate(e->x[0], y[0], 0, &error);
    return e->is_dead && error <= FINITE * fabs(y[0][NODES - 1]);
}

/* The order of a column's pole at the end of the piece, 0 if it has none.  A pole is the same on two scales, and above
** the error: far above it on the larger scales, where poles are found that rounding hides on the small ones. */
#define POLE_SCALE 1 /* the smallest one that is used: closer to the end there may be rounding */

static int is_pole(const approach *e, double y[][NODES], int scale, int order, double *strength)
{
    double part = scale == POLE_SCALE ? 0.1 : 1e-3, error, other, error_of_other;
    double size = fabs(gsl_pow_int(e->x[scale][NODES - 1], order) * y[scale][NODES - 1]);

    *strength = extrapolate(e->x[scale], y[scale], order, &error);
    other = extrapolate(e->x[scale + 1], y[scale + 1], order, &error_of_other);
    return error < part * fabs(*strength) && error_of_other < part * fabs(other) &&
           fabs(*strength - other) < GSL_MAX_DBL(part, 0.01) * fabs(*strength) &&
           (scale > POLE_SCALE || fabs(*strength) > 1e-3 * size);
}

static int pole_order(const approach *e, double y[][NODES], int most, double *strength)
{
    int scale, order;

    for (scale = POLE_SCALE; scale + 1 < SCALES && !is_finite(e, y); scale++)
        for (order = most; order > 0; order--)
            if (is_pole(e, y, scale, order, strength))
                return order;
    *strength = 0;
    return 0;
}

/* A number of the size and sign of a column's pole, if its rows close to the end grow towards it as a power of x that
** is steady, or changes slowly; else 0.  A pole beside a narrow locked range has one order close to it and another one
** farther away.  In a very short piece all scales are close, and rounding is less on the larger ones. */
#define CLOSE 0.00101   /* x */
#define LEAST_ORDER 0.7 /* of a power */
#define MOST_CHANGE 0.8 /* from row to row */

static int grows(const double *x, const double *y)
{
    double order = GSL_NAN, before;
    int k;

    for (k = 0; k + 1 < NODES; k++) {
        before = order;
        order = log(y[k] / y[k + 1]) / log(x[k + 1] / x[k]);
        if (!(order > LEAST_ORDER) || fabs(order - before) > MOST_CHANGE)
            return 0;
    }
    return 1;
}

static double growing_pole(const approach *e, double y[][NODES])
{
    int scale;

    for (scale = 0; scale < SCALES && e->x[scale][NODES - 1] < CLOSE; scale++)
        if (grows(e->x[scale], y[scale]))
            return e->x[scale][0] * y[scale][0];
    return 0;
}

/* A number of the sign of a column's pole, 0 if it has none.  The closest rows, if they grow, know the sign best.  A
** column that is zero but for rounding can seem to have a pole: where alpha2 is 0, alpha3 of a crank and a rod of the
** same length, for one. */
#define LEAST_POLE 1e-11 /* of the size in the middle of pieces, at a radian: less is rounding */

static double pole_sign(const approach *e, double y[][NODES], int most, double size)
{
    double strength = growing_pole(e, y);

    if (strength == 0)
        pole_order(e, y, most, &strength);
    return fabs(strength) > LEAST_POLE * size ? strength : 0;
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
** of the inner ones without the curvature, which the outer ones give. */
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

static double size_at(const flk_tracked *t, const flk_row *row)
{
    return GSL_MAX_DBL(t->size_here, fabs(flk_column_value(t->c, row)));
}

static int is_size(const flk_tracked *t)
{
    return !(t->turn > 0) && flk_column_has_vector(t->c);
}

/* The value of a column by the polynomial through rows near the end.  A size whose vector passes through zero
** between them and the end goes on as that of the vector does, with the other sign. */
static double value_near(const flk_tracked *t, const flk_polynomial *p, double at)
{
    double value = flk_polynomial_value(p, at);

    return is_size(t) ? fabs(value) : value;
}

/* How far a row is from the polynomial that gives the limit: terms that cancel can leave the same rounding in
** all rows. */
static double distance_from_limit(const flk_tracked *t, double at, const flk_row *row)
{
    double value = value_near(t, &t->near_end, at);
    double there = flk_column_value(t->c, row);

    return fabs((t->turn > 0 ? flk_search_nearest(t, there, value) : there) - value);
}

/* 1 if the row in the middle of five, at a distance from the end of the piece, is rounding. */
static int is_rounding(const flk_tracked *t, double at, const flk_row *rows)
{
    if (!(rounding_of(t, rows) <= t->rounding * size_at(t, &rows[2])))
        return 1;
    return at <= t->most_near_end && distance_from_limit(t, at, &rows[2]) > t->doubt;
}

/* Where poles cancel, rows close to an end of the piece are rounding: find how far from it. */
#define CLOSE_ROWS 14

static void find_rounding(flk_search *x, const approach *e)
{
    double away =
        e->is_dead ? GSL_MIN_DBL(0.3, sqrt(0.5 * e->length)) : GSL_MIN_DBL(0.1, 0.5 * e->length);
    static const double steps[] = {-1e-6, -2.5e-7, 0, 2.5e-7, 1e-6};
    flk_row rows[5];
    size_t c;
    int k, i;

    for (k = 0; k < CLOSE_ROWS; k++, away /= 2) {
        for (i = 0; i < 5; i++)
            flk_search_compute(x, x->needs, passed_near(e, away * (1 + steps[i])), &rows[i]);
        for (c = 0; c < x->n_columns; c++) {
            flk_tracked *t = &x->columns[c];

            if (t->is_rough && is_rounding(t, away, rows)) {
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

/* The number of a column's first sample from the end of the piece. */
static size_t first_number(const flk_search *x, const double *values, const approach *e)
{
    size_t i = e->at_end ? x->n - 1 : 0;

    while (gsl_isnan(values[i]) && i != (e->at_end ? 0 : x->n - 1))
        i += e->at_end ? (size_t)-1 : 1;
    return i;
}

/* The distance x of a column's first sample from the end of the piece. */
static double first_sample(const flk_search *x, const double *values, const approach *e)
{
    double away = fabs(flk_search_passed(x, x->s[first_number(x, values, e)]) - e->edge);

    return e->is_dead ? sqrt(away) : away;
}

/* The limit of a column at x = 0, from the scale on which it is most exact. */
typedef struct limit {
    double value, error, size; /* the column's magnitude near the end */
    int scale;
} limit;

/* Offer the extremes of a column between the end of the piece and the first of its samples, by the polynomial
** that gives its limit, if they are better than that. */
#define PARTS 8
#define AS_GOOD 1e-10 /* of the column's size: less is rounding, which has flat places of its own */

static void offer_flats(const flk_search *x, flk_tracked *t, const double *values,
                        const approach *e, const limit *l, const double *y)
{
    const double *away = e->x[l->scale];
    double most = GSL_MIN_DBL(first_sample(x, values, e), away[NODES - 1]), at, value;
    flk_polynomial p;
    int k;

    p.n = 0;
    for (k = 0; k < NODES; k++)
        flk_polynomial_add(&p, away[k], y[k]);
    for (k = 0; k < PARTS; k++) {
        if (!flk_polynomial_find_flat(&p, most * (double)k / PARTS, most * (double)(k + 1) / PARTS,
                                      &at))
            continue;
        value = value_near(t, &p, at);
        if (fabs(value - l->value) > GSL_MAX_DBL(l->error, AS_GOOD * l->size))
            offer_near(x, t, e, at, value);
    }
}

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

/* The vector of a column near a pole: x^order times its components are polynomials. */
typedef struct vector_pole {
    int order;
    double most; /* the polynomials hold up to this x */
    double strength[2];
    flk_polynomial u[2];
} vector_pole;

/* Find the pole of a column's vector; 0 if it has none. */
static int find_vector_pole(const flk_search *x, const flk_tracked *t, const approach *e,
                            vector_pole *v)
{
    double u[2][SCALES][NODES];
    int scale, k, i, order[2];
    limit l;

    if (!flk_column_has_vector(t->c))
        return 0;
    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES; k++)
            flk_column_vector(t->c, &e->rows[scale][k], &u[0][scale][k], &u[1][scale][k]);
    for (i = 0; i < 2; i++)
        order[i] = pole_order(e, u[i], x->pole_order, &v->strength[i]);
    v->order = GSL_MAX_INT(order[0], order[1]);
    v->most = GSL_POSINF;
    for (i = 0; i < 2 && v->order > 0; i++) {
        l = limit_of(e, u[i], v->order);
        v->most = GSL_MIN_DBL(v->most, e->x[l.scale][NODES - 1]);
        v->strength[i] = order[i] < v->order ? 0 : l.value;
        v->u[i].n = 0;
        for (k = 0; k < NODES; k++)
            flk_polynomial_add(&v->u[i], e->x[l.scale][k],
                               gsl_pow_int(e->x[l.scale][k], v->order) * u[i][l.scale][k]);
    }
    return v->order > 0;
}

/* The column of a vector at a distance x from its pole; a direction is that nearest to `near`. */
static double near_pole(const flk_tracked *t, const vector_pole *v, double x, double near)
{
    double u[2];
    int i;

    for (i = 0; i < 2; i++)
        u[i] = x > 0 ? flk_polynomial_value(&v->u[i], x) : v->strength[i];
    if (t->turn > 0)
        return flk_search_nearest(t, atan2(u[1], u[0]) * t->c->scale, near);
    return gsl_hypot(u[0], u[1]) / gsl_pow_int(x, v->order) * t->c->scale;
}

/* 1 if the row at a distance x from the end has about this value: rounding may hide the rest. */
static int is_row(const flk_search *x, const flk_tracked *t, const approach *e, double at,
                  double value)
{
    double there;
    flk_row row;

    flk_search_compute(x, flk_column_need(t->c), passed_near(e, at), &row);
    there = flk_column_value(t->c, &row);
    if (t->turn > 0)
        there = flk_search_nearest(t, there, value);
    return fabs(there - value) <= 1e-4 * GSL_MAX_DBL(fabs(value), t->size_here);
}

/* A column near the pole of its vector, or its negative where its smallest value is sought. */
typedef struct beside_pole {
    const flk_tracked *t;
    const vector_pole *v;
    int which;
    double near; /* an angle goes on from there */
} beside_pole;

static double beside_pole_at(double x, void *data)
{
    const beside_pole *n = data;

    return flk_search_signed(n->which, near_pole(n->t, n->v, x, n->near));
}

/* Offer the extremes of a column whose vector has a weak pole, between the end of the piece and its first
** sample, at the distance `most`: there it can turn or shrink on any scale. */
#define SCALES_OF_POLE 20 /* each half of the next */

static void offer_near_pole(const flk_search *x, flk_tracked *t, const approach *e,
                            const vector_pole *v, double most, double near)
{
    flk_sample at[SCALES_OF_POLE], top;
    beside_pole n;
    int k;

    n.t = t;
    n.v = v;
    most = GSL_MIN_DBL(most, v->most);
    for (n.which = 0; n.which < 2; n.which++) {
        n.near = near;
        for (k = SCALES_OF_POLE - 1; k >= 0; k--) {
            at[k].x = most * gsl_pow_int(0.5, SCALES_OF_POLE - 1 - k);
            at[k].value = beside_pole_at(at[k].x, &n);
            n.near = flk_search_signed(n.which, at[k].value);
        }
        if (t->turn > 0)
            offer_near(x, t, e, 0, near_pole(t, v, 0, n.near));
        for (k = 1; k + 1 < SCALES_OF_POLE; k++) {
            if (!(at[k].value >= at[k - 1].value && at[k].value >= at[k + 1].value))
                continue;
            n.near = flk_search_signed(n.which, at[k].value);
            top = flk_find_peak(beside_pole_at, &n, &at[k - 1], 0);
            top.value = flk_search_signed(n.which, top.value);
            if (is_row(x, t, e, top.x, top.value))
                offer_near(x, t, e, top.x, top.value);
        }
    }
}

/* The error of a limit, in parts of the column's size, up to which it is used, and up to which its polynomial stands
** for the column. */
#define KNOWN 1e-6
#define EXACT 1e-9

/* The values of a column near the end of the piece; of an angle those nearest to its first sample. */
static void list_values(const flk_search *x, size_t c, const approach *e, double y[][NODES])
{
    const flk_tracked *t = &x->columns[c];
    const double *values = flk_search_row(x, c);
    double near = values[first_number(x, values, e)];
    int scale, k;

    for (scale = 0; scale < SCALES; scale++)
        for (k = 0; k < NODES; k++) {
            y[scale][k] = flk_column_value(t->c, &e->rows[scale][k]);
            if (t->turn > 0)
                y[scale][k] = flk_search_nearest(t, y[scale][k], near);
        }
}

/* The rounding of rows, in parts of the column's size, above which they are left out: where the polynomial stands for
** them, and where it does not, as at a weak pole. */
#define TINY 2e-10
#define MOST_ROUNDING 1e-6

/* 1 if the small scale does not know the limit of a column: its rows may be rounding. */
static int is_rough(const flk_search *x, size_t c, const approach *e)
{
    flk_tracked *t = &x->columns[c];
    double y[SCALES][NODES];
    limit l;
    int k;

    if (gsl_finite(t->bound) || t->is_noise || (flk_column_flags(t->c) & FOURLINK_OF_CRANK))
        return 0;
    list_values(x, c, e, y);
    l = limit_of(e, y, 0);
    t->size_here = l.size;
    t->rounding = l.error <= EXACT * l.size ? TINY : MOST_ROUNDING;
    t->doubt = GSL_MAX_DBL(10 * l.error, TINY * l.size);
    t->most_near_end = l.error <= KNOWN * l.size ? e->x[l.scale][NODES - 1] : 0;
    t->near_end.n = 0;
    if (l.scale == 0 && l.error <= 1e-10 * l.size)
        return 0;
    for (k = 0; k < NODES; k++)
        flk_polynomial_add(&t->near_end, e->x[l.scale][k], y[l.scale][k]);
    return 1;
}

static void offer_pole(const flk_search *x, flk_tracked *t, const approach *e, int which)
{
    double angle = flk_search_angle(x, e->edge);

    t->has_pole[e->at_end] = 1;
    flk_search_offer(&t->here[which], which, which == 0 ? GSL_POSINF : GSL_NEGINF, angle, angle);
}

/* Note the size of a column in the middle of a long piece. */
static void note_size(const flk_search *x, flk_tracked *t, const double *values)
{
    double middle = (x->s[0] + x->s[x->n - 1]) / 2;
    size_t i = 0;

    if (x->piece.to - x->piece.from < LONG_ENOUGH)
        return;
    while (x->s[i] < middle)
        i++;
    if (fabs(values[i]) > t->size_middle) /* not where there is no row */
        t->size_middle = fabs(values[i]);
}

/* Offer what a column has at an end of the piece: its limit, or a pole. */
static void find_limit(flk_search *x, size_t c, const approach *e)
{
    flk_tracked *t = &x->columns[c];
    const double *values = flk_search_row(x, c);
    double near = values[first_number(x, values, e)], sign, size;
    double y[SCALES][NODES];
    int has_vector_pole;
    vector_pole v;
    limit l;

    list_values(x, c, e, y);
    note_size(x, t, values);
    has_vector_pole = find_vector_pole(x, t, e, &v);
    if (!(t->turn > 0) && has_vector_pole) {
        offer_pole(x, t, e, 0);
        offer_near_pole(x, t, e, &v, first_sample(x, values, e), near);
        return;
    }
    sign = t->turn > 0 ? 0 : pole_sign(e, y, x->pole_order, t->size_middle);
    if (sign != 0) {
        offer_pole(x, t, e, sign > 0 ? 0 : 1);
        return;
    }
    l = limit_of(e, y, 0);
    if (is_size(t))
        l.value = fabs(l.value);
    size = GSL_MAX_DBL(l.size, size_inside(x, values));
    if (fabs(l.value) <= GSL_MAX_DBL(4 * l.error, EXACT * size))
        l.value = 0; /* such as the transmission angle at a dead position */
    if (!(l.error <= EXACT * size) && has_vector_pole)
        offer_near_pole(x, t, e, &v, first_sample(x, values, e), near);
    else if (l.error <= KNOWN * size)
        offer_near(x, t, e, 0, l.value);
    else if (is_finite(e, y))
        offer_near(x, t, e, 0, flk_search_value(x, t, e->at_end, near));
    if (l.error <= EXACT * size)
        offer_flats(x, t, values, e, &l, y[l.scale]);
}

/* Columns that loads have no corners in are smooth over more than the piece. */
enum { OF_MOTION = 1, OF_LOADS = 2 };

static int group_of(const flk_tracked *t)
{
    return flk_column_is_of_motion(t->c) ? OF_MOTION : OF_LOADS;
}

/* Offer the limits of the groups of columns that are smooth over such a length. */
static void find_limits(flk_search *x, int at_end, int groups, double length)
{
    int rough = 0;
    flk_row at_edge;
    approach e;
    size_t c;

    compute_approach(x, at_end, length, &e);
    for (c = 0; c < x->n_columns; c++) {
        x->columns[c].is_rough = (group_of(&x->columns[c]) & groups) && is_rough(x, c, &e);
        rough |= x->columns[c].is_rough;
    }
    if (rough)
        find_rounding(x, &e);
    flk_search_compute(x, 0, e.edge, &at_edge);
    for (c = 0; c < x->n_columns; c++) {
        flk_tracked *t = &x->columns[c];

        if (!(group_of(t) & groups))
            continue;
        if (flk_column_flags(t->c) & FOURLINK_OF_CRANK)
            offer_near(x, t, &e, 0, flk_column_value(t->c, &at_edge));
        else if (!t->is_noise)
            find_limit(x, c, &e);
    }
}

void flk_search_find_limits(flk_search *x, int at_end)
{
    flk_piece_end kind = at_end ? x->piece.end : x->piece.begin;
    double length = x->piece.to - x->piece.from,
           of_motion =
               at_end ? x->piece.to - x->piece.motion_from : x->piece.motion_to - x->piece.from;

    if (!flk_search_has_limit(kind) || !x->n)
        return;
    x->pole_order = kind == FLK_END_CHANGE_REST ? 6 : 4;
    if (length >= LONG_ENOUGH || of_motion <= length) {
        find_limits(x, at_end, OF_MOTION | OF_LOADS, length);
    } else {
        find_limits(x, at_end, OF_MOTION, of_motion);
        find_limits(x, at_end, OF_LOADS, length);
    }
}
