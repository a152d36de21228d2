/* SPDX-License-Identifier: GPL-3.0-or-later
**
** program.c - how a coordinate goes over time: points that it passes, and a law between them.
**
** On a segment of length T and rise H, with u = (t - t0) / T:
**
**    q = q0 + H s(u)      q' = H s'(u) / T      q" = H s"(u) / T^2
**
** Where the points are speeds, these are the speed and its derivatives, and the coordinate rises by
** T (q0 u + H S(u)), S the integral of s.
*/
#include <float.h>
#include <math.h>
#include <stddef.h>

#include <gsl/gsl_math.h>

#include "base/arithmetic.h"
#include "base/trig.h"
#include "program.h"

#define PARTS 8 /* of a segment, whose speeds are compared */

/* S, s, s', s" */
typedef struct shape {
    double integral, value, rate, second;
} shape;

/* The shape of a segment at u, for a rise of 1; a spline's has its rise in it. */
typedef void law(const flk_program_segment *g, double u, shape *x);

#define SINE_PART 0.125 /* of the length: a modified sine begins and ends with a sine of its own */

/* The shape at u of a law whose second half is its first half turned, from the shape at 1 - u. */
static void turn_half(double u, shape *x)
{
    x->integral += u - 0.5;
    x->value = 1 - x->value;
    x->second = -x->second;
}

/* ------------------------------------------------------------------------------------------------- laws */

/* s = (1 - cos pi u) / 2 */
static void harmonic(const flk_program_segment *g, double u, shape *x)
{
    double sine, cosine;

    (void)g;
    flk_sine_cosine(M_PI * u, &sine, &cosine);
    x->integral = (u - sine / M_PI) / 2;
    x->value = (1 - cosine) / 2;
    x->rate = M_PI_2 * sine;
    x->second = M_PI * M_PI_2 * cosine;
}

/* s = u - sin(2 pi u) / (2 pi),   s' = 1 - cos(2 pi u) = 2 sin^2(pi u); the second half is the first one
** turned */
static void cycloidal(const flk_program_segment *g, double u, shape *x)
{
    double half = GSL_MIN(u, 1 - u), sine, cosine;

    (void)g;
    flk_sine_cosine(M_PI * half, &sine, &cosine);
    x->integral = half * half / 2 - sine * sine / (2 * M_PI * M_PI);
    x->value = half - sine * cosine / M_PI;
    x->rate = 2 * sine * sine;
    x->second = 4 * M_PI * sine * cosine;
    if (u > 0.5)
        turn_half(u, x);
}

/* s = 10 u^3 - 15 u^4 + 6 u^5 */
static void polynomial_5(const flk_program_segment *g, double u, shape *x)
{
    double square = u * u, cube = square * u;

    (void)g;
    x->integral = cube * u * (2.5 - 3 * u + square);
    x->value = cube * (10 - 15 * u + 6 * square);
    x->rate = 30 * square * (1 - u) * (1 - u);
    x->second = 60 * u * (1 - u) * (1 - 2 * u);
}

/* s = 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7 */
static void polynomial_7(const flk_program_segment *g, double u, shape *x)
{
    double square = u * u, cube = square * u, rest = 1 - u;

    (void)g;
    x->integral = cube * square * (7 - 14 * u + 10 * square - 2.5 * cube);
    x->value = cube * u * (35 - 84 * u + 70 * square - 20 * cube);
    x->rate = 140 * cube * rest * rest * rest;
    x->second = 420 * square * rest * rest * (1 - 2 * u);
}

/* With k = 1 / (4 + pi), s = k (pi u - sin(4 pi u) / 4) up to 1/8, then
** s = k (2 + pi u - 9/4 sin((4 pi u + pi) / 3)) up to 1/2; the second half is the first turned. */
static void modified_sine(const flk_program_segment *g, double u, shape *x)
{
    double sine, cosine, k = 1 / (4 + M_PI), half = GSL_MIN(u, 1 - u);
    int is_middle = half > SINE_PART;

    (void)g;
    flk_sine_cosine(is_middle ? (4 * half + 1) * M_PI / 3 : 4 * M_PI * half, &sine, &cosine);
    x->value = M_PI * half - sine / 4;
    x->integral = M_PI_2 * half * half - (1 - cosine) / (16 * M_PI);
    if (is_middle) {
        x->value = 2 + M_PI * half - 2.25 * sine;
        x->integral = M_PI_2 * half * half + 2 * (half - SINE_PART) + 27 / (16 * M_PI) * cosine -
                      1 / (16 * M_PI);
    }
    x->value *= k;
    x->integral *= k;
    x->rate = M_PI * k * (is_middle ? 1 - 3 * cosine : 2 * gsl_pow_2(flk_sine(2 * M_PI * half)));
    x->second = 4 * M_PI * M_PI * k * sine;
    if (u > 0.5)
        turn_half(u, x);
}

/* s = 3 u^2 - 2 u^3 */
static void cubic(const flk_program_segment *g, double u, shape *x)
{
    (void)g;
    x->integral = u * u * u * (1 - u / 2);
    x->value = u * u * (3 - 2 * u);
    x->rate = 6 * u * (1 - u);
    x->second = 6 - 12 * u;
}

/* The speed V rises evenly up to a and falls evenly from 1 - b, V (1 - a / 2 - b / 2) = 1. */
static void trapezoid(const flk_program_segment *g, double u, shape *x)
{
    double a = g->ramp[0], b = g->ramp[1], V = 1 / (1 - (a + b) / 2), left = 1 - u;

    if (u < a) {
        x->integral = V * u * u * u / (6 * a);
        x->value = V * u * u / (2 * a);
        x->rate = V * u / a;
        x->second = V / a;
    } else if (u < 1 - b || b <= 0) {
        x->integral = V * (a * a / 6 + u * (u - a) / 2);
        x->value = V * (u - a / 2);
        x->rate = V;
        x->second = 0;
    } else {
        x->integral = V * (a * a / 6 + (1 - b) * (1 - b - a) / 2) + b - left -
                      V * (b * b * b - left * left * left) / (6 * b);
        x->value = 1 - V * left * left / (2 * b);
        x->rate = V * left / b;
        x->second = -V / b;
    }
}

static void linear(const flk_program_segment *g, double u, shape *x)
{
    (void)g;
    x->integral = u * u / 2;
    x->value = u;
    x->rate = 1;
    x->second = 0;
}

/* A cubic with the second derivatives M0, M1 at its ends:
** H u + T^2 / 6 (M0 ((1 - u)^3 - (1 - u)) + M1 (u^3 - u)) */
static void spline(const flk_program_segment *g, double u, shape *x)
{
    double v = 1 - u, M0 = g->bend[0], M1 = g->bend[1], sixth = g->length * g->length / 6;

    x->integral = g->rise * u * u / 2 + sixth * (M0 * ((1 - v * v * v * v) / 4 - u + u * u / 2) +
                                                 M1 * (u * u * u * u / 4 - u * u / 2));
    x->value = g->rise * u + sixth * (M0 * (v * v * v - v) + M1 * (u * u * u - u));
    x->rate = g->rise + sixth * (M1 * (3 * u * u - 1) - M0 * (3 * v * v - 1));
    x->second = 6 * sixth * (M0 * v + M1 * u);
}

#define LAW_NAME(code, name, function) name,
const char *const flk_law_names[] = {FLK_LAWS(LAW_NAME) NULL};

#define LAW_FUNCTION(code, name, function) function,
static law *const laws[] = {FLK_LAWS(LAW_FUNCTION)};

/* The shape of a segment at u, in the unit of its points and times its length. */
static void find_shape(const flk_program_segment *g, double u, shape *x)
{
    double rise = g->law == FLK_LAW_SPLINE ? 1 : g->rise;

    laws[g->law](g, u, x);
    x->integral *= rise;
    x->value *= rise;
    x->rate *= rise;
    x->second *= rise;
}

/* ---------------------------------------------------------------------------------------------- splines */

/* The second derivatives M of a spline over n segments, for continuous speeds d = H / T:
**
**    T[i-1] M[i-1] + 2 (T[i-1] + T[i]) M[i] + T[i] M[i+1] = 6 (d[i] - d[i-1])
**
** by elimination, without pivots: each row has its largest coefficient on the diagonal.  GSL's splines
** have no speeds at their ends, and its solvers reach the host's error handler. */
typedef struct equations {
    double *diagonal, *right,
        *of_first; /* n + 1 of each; the coefficient of M[0] where it repeats */
} equations;

static double slope_of(const flk_program_segment *g)
{
    return g->rise / g->length;
}

/* Set up the rows of the inner points. */
static void set_inner(const flk_program_segment *g, unsigned long n, const equations *e)
{
    unsigned long i;

    for (i = 1; i < n; i++) {
        e->diagonal[i] = 2 * (g[i - 1].length + g[i].length);
        e->right[i] = 6 * (slope_of(&g[i]) - slope_of(&g[i - 1]));
        e->of_first[i] = 0;
    }
}

/* Solve rows first to last, of which each has the lengths of segments beside it; the M of the point
** behind the last row is 0. */
static void eliminate(const flk_program_segment *g, unsigned long first, unsigned long last,
                      const equations *e)
{
    unsigned long i;
    double factor;

    for (i = first + 1; i <= last; i++) {
        factor = g[i - 1].length / e->diagonal[i - 1];
        e->diagonal[i] -= factor * g[i - 1].length;
        e->right[i] -= factor * e->right[i - 1];
        e->of_first[i] -= factor * e->of_first[i - 1];
    }
    for (i = last + 1; i-- > first;) {
        if (i < last) {
            e->right[i] -= g[i].length * e->right[i + 1];
            e->of_first[i] -= g[i].length * e->of_first[i + 1];
        }
        e->right[i] /= e->diagonal[i];
        e->of_first[i] /= e->diagonal[i];
    }
}

static void set_bends(flk_program_segment *g, unsigned long n, const double *M)
{
    unsigned long i;

    for (i = 0; i < n; i++) {
        g[i].bend[0] = M[i];
        g[i].bend[1] = M[i + 1];
    }
}

/* Where it repeats, M[n] = M[0]: the other M are a + b M[0], and the row of the first point gives M[0]. */
static void solve_periodic(flk_program_segment *g, unsigned long n, const equations *e)
{
    double *M = e->right, before = g[n - 1].length, after = g[0].length;
    unsigned long i;

    M[0] = 0;
    if (n > 1) {
        e->of_first[1] -= after;
        e->of_first[n - 1] -= before;
        eliminate(g, 1, n - 1, e);
        M[0] = (6 * (slope_of(&g[0]) - slope_of(&g[n - 1])) - after * M[1] - before * M[n - 1]) /
               (2 * (before + after) + after * e->of_first[1] + before * e->of_first[n - 1]);
        for (i = 1; i < n; i++)
            M[i] += e->of_first[i] * M[0];
    }
    M[n] = M[0];
}

/* The speed at an end is given, or the second derivative there is 0. */
static void set_end(const flk_program_segment *g, unsigned long point, const double *speed,
                    double sense, const equations *e)
{
    e->diagonal[point] = speed ? 2 * g->length : 1;
    e->right[point] = speed ? 6 * sense * (slope_of(g) - *speed) : 0;
    e->of_first[point] = 0;
}

/* A spline over n segments, natural where an end has no speed. */
static void solve_open(flk_program_segment *g, unsigned long n, const double *first,
                       const double *last, const equations *e)
{
    set_end(&g[0], 0, first, 1, e);
    set_end(&g[n - 1], n, last, -1, e);
    eliminate(g, first ? 0 : 1, last ? n : n - 1, e);
    set_bends(g, n, e->right);
}

/* The speed at which a segment of another law begins and ends. */
static double speed_beside(const flk_program_segment *g)
{
    return g->law == FLK_LAW_LINEAR ? slope_of(g) : 0;
}

/* Each run of splines is one spline.  Beside another law it has the speed of that. */
static void solve_splines(flk_program *p, const equations *e)
{
    unsigned long i, n;
    double before, after;

    for (i = 0; i < p->n; i += n) {
        int is_first = i == 0, is_last;

        for (n = 0; i + n < p->n && p->segment[i + n].law == FLK_LAW_SPLINE;)
            n++;
        is_last = i + n == p->n;
        if (!n) {
            n = 1;
            continue;
        }
        before = is_first ? p->speed[0] : speed_beside(&p->segment[i - 1]);
        after = is_last ? p->speed[1] : speed_beside(&p->segment[i + n]);
        set_inner(&p->segment[i], n, e);
        if (p->ends == FLK_ENDS_PERIODIC && is_first && is_last) {
            solve_periodic(&p->segment[i], n, e);
            set_bends(&p->segment[i], n, e->right);
        } else {
            solve_open(&p->segment[i], n, is_first && p->ends != FLK_ENDS_SPEEDS ? NULL : &before,
                       is_last && p->ends != FLK_ENDS_SPEEDS ? NULL : &after, e);
        }
    }
}

/* --------------------------------------------------------------------------------------------- programs */

void flk_program_prepare(flk_program *p, double *room)
{
    equations e;
    unsigned long i;
    double at = p->from;
    shape x;

    e.diagonal = room;
    e.right = room + p->n + 1;
    e.of_first = room + 2 * (p->n + 1);
    solve_splines(p, &e);
    for (i = 0; i < p->n; i++) {
        flk_program_segment *g = &p->segment[i];

        g->coordinate = at;
        find_shape(g, 1, &x);
        at += g->length * (g->value + x.integral);
    }
}

double flk_program_end(const flk_program *p)
{
    const flk_program_segment *last = &p->segment[p->n - 1];

    return last->begin + last->length;
}

const flk_program_segment *flk_program_segment_at(const flk_program *p, double time)
{
    unsigned long low = 0, high = p->n;

    while (high - low > 1) {
        unsigned long middle = low + (high - low) / 2;

        if (p->segment[middle].begin <= time)
            low = middle;
        else
            high = middle;
    }
    return &p->segment[low];
}

/* The places within a segment at which parts of its law begin. */
static void inner_corners(const flk_program_segment *g, double inner[2])
{
    inner[0] = g->law == FLK_LAW_TRAPEZOID ? g->ramp[0] : SINE_PART;
    inner[1] = g->law == FLK_LAW_TRAPEZOID ? 1 - g->ramp[1] : 1 - SINE_PART;
}

/* The segment of a time, and the place in it.  The time of a row is rounded: one that is that of a
** corner but for rounding is at the corner, where the next part begins. */
#define ROUNDED (8 * DBL_EPSILON)

static const flk_program_segment *find_place(const flk_program *p, double time, double *u)
{
    const flk_program_segment *g = flk_program_segment_at(p, time);
    double rounded = ROUNDED * (fabs(time) + g->length), inner[2];
    int i;

    if (g < &p->segment[p->n - 1] && g[1].begin - time <= rounded) {
        *u = 0;
        return g + 1;
    }
    *u = GSL_MIN(GSL_MAX((time - g->begin) / g->length, 0), 1);
    inner_corners(g, inner);
    for (i = 0; i < 2; i++)
        if (fabs(*u - inner[i]) * g->length <= rounded)
            *u = inner[i];
    return g;
}

void flk_program_at(const flk_program *p, double time, double x[3])
{
    double u;
    const flk_program_segment *g = find_place(p, time, &u);
    shape s;

    find_shape(g, u, &s);
    if (p->is_of_speed) {
        x[0] = g->coordinate + g->length * (g->value * u + s.integral);
        x[1] = g->value + s.value;
        x[2] = s.rate / g->length;
    } else {
        x[0] = g->value + s.value;
        x[1] = s.rate / g->length;
        x[2] = s.second / (g->length * g->length);
    }
}

double flk_program_highest(const flk_program *p)
{
    double highest = 0, x[3];
    unsigned long i;
    int k;

    for (i = 0; i < p->n; i++)
        for (k = 0; k <= PARTS; k++) {
            flk_program_at(p, p->segment[i].begin + k * p->segment[i].length / PARTS, x);
            highest = GSL_MAX(highest, fabs(x[1]));
        }
    return highest;
}

double flk_program_corner(const flk_program *p, double time)
{
    const flk_program_segment *g = flk_program_segment_at(p, time);
    double inner[2], at;
    int i;

    inner_corners(g, inner);
    for (i = 0; i < 2 && (g->law == FLK_LAW_TRAPEZOID || g->law == FLK_LAW_MODIFIED_SINE); i++) {
        at = g->begin + inner[i] * g->length;
        if (at > time)
            return at;
    }
    return g == &p->segment[p->n - 1] ? flk_program_end(p) : g[1].begin;
}
