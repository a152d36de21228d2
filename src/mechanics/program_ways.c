/* SPDX-License-Identifier: GPL-3.0-or-later
**
** program_ways.c - where a program goes: its ways, on each of which the coordinate only rises or only
** falls, and how it leaves a place at rest.
*/
#include <math.h>
#include <stddef.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "program.h"

#define PARTS \
    16 /* of the way to the next corner of a program, to see where the coordinate turns back */

#define CLOSE_TIMES 1e-12 /* of the time of a program: two that are closer count as one */

/* What is sought along a program: a value, or with `is_rest` where the speed is 0. */
typedef struct program_search {
    const flk_program *program;
    double value;
    int is_rest;
} program_search;

static double program_past(double time, void *data)
{
    const program_search *s = data;
    double x[3];

    flk_program_at(s->program, time, x);
    return s->is_rest ? x[1] : x[0] - s->value;
}

static double find_between(program_search *s, double from, double to)
{
    flk_bracket b = flk_bracket_of(from, to, program_past(from, s), program_past(to, s));

    return flk_find_zero(program_past, s, &b, 0);
}

double flk_program_way(const flk_program *p, double from)
{
    double close = CLOSE_TIMES * (flk_program_end(p) - p->segment[0].begin);
    double to = flk_program_corner(p, from + close), step = (to - from) / PARTS, low, high;
    program_search s;
    int i;

    s.program = p;
    s.value = 0;
    s.is_rest = 1;
    for (i = 0; i < PARTS; i++) {
        low = from + (i ? i : 1.0 / PARTS) * step; /* the ends may be at rest */
        high = from + (i + 1 < PARTS ? i + 1 : PARTS - 1.0 / PARTS) * step;
        if (program_past(low, &s) * program_past(high, &s) < 0)
            return find_between(&s, low, high);
    }
    return to;
}

int flk_program_pass(const flk_program *p, double value, double *time)
{
    double end = flk_program_end(p), from, to;
    program_search s;

    s.program = p;
    s.value = value;
    s.is_rest = 0;
    for (from = p->segment[0].begin; from < end; from = to) {
        to = flk_program_way(p, from);
        if (program_past(from, &s) * program_past(to, &s) <= 0) {
            *time = find_between(&s, from, to);
            return 1;
        }
    }
    return 0;
}

void flk_program_limits(const flk_program *p, flk_program_reach *r)
{
    double end = flk_program_end(p), from, to, x[3], before;

    flk_program_at(p, p->segment[0].begin, x);
    r->low = r->high = before = x[0];
    r->travel = 0;
    for (from = p->segment[0].begin; from < end; from = to) {
        to = flk_program_way(p, from);
        flk_program_at(p, to, x);
        r->low = GSL_MIN(r->low, x[0]);
        r->high = GSL_MAX(r->high, x[0]);
        r->travel += fabs(x[0] - before);
        before = x[0];
    }
}

/* -------------------------------------------------------------------------------------------- from rest */

/* What a law begins with: s = c u^n.  Its end is its beginning turned. */
static const struct {
    int n;
    double c; /* 0: not asked for */
} leads[FLK_LAW_COUNT] = {
    {1, 0},                                     /* spline */
    {2, 0},                                     /* harmonic */
    {3, 4 * M_PI *M_PI / 6},                    /* cycloidal */
    {3, 10},                                    /* 3-4-5 */
    {4, 35},                                    /* 4-5-6-7 */
    {3, 8 * M_PI *M_PI *M_PI / 3 / (4 + M_PI)}, /* modified-sine */
    {2, 0},                                     /* cubic */
    {2, 0},                                     /* trapezoid */
    {1, 0}                                      /* linear */
};

int flk_program_from_rest(const flk_program *p, double time, double *c)
{
    const flk_program_segment *g = flk_program_segment_at(p, time);
    double u = (time - g->begin) / g->length, T = g->length;
    int is_end = u > 1 - CLOSE_TIMES, n = leads[g->law].n;

    *c = 0;
    if (g->rise == 0 && g->law != FLK_LAW_SPLINE && (!p->is_of_speed || g->value == 0))
        return 1; /* it stays */
    if (!is_end && u > CLOSE_TIMES)
        return 0;
    if (p->is_of_speed) {
        if (n < 2 || g->value + (is_end ? g->rise : 0) != 0)
            return 0;
        *c = n == 2 ? GSL_NAN : n == 3 ? g->rise * leads[g->law].c / (4 * T * T * T) : 0;
        return 1;
    }
    *c = n == 4 ? (is_end ? -1 : 1) * g->rise * leads[g->law].c / (T * T * T * T) : GSL_NAN;
    return n > 2;
}
