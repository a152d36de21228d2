/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.c - the largest and smallest value of a column over a deck's motion.
**
** The motion is scanned in steps of a degree at most; every peak of the samples that comes near the
** highest is refined by GSL's minimisers.  Where the links stop reaching, and at the corners of the loads,
** the column's limit counts too.
*/
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_min.h>

#include "extreme.h"

#define PEAKS 8
#define MOST_STEPS 1000000

typedef struct search {
    analysis *a;
    const column *c;
    fourlink_branch branch;
    int sign;
    int periodic;       /* 1: one revolution, whose ends meet */
    double first, last; /* crank angles in the deck's unit */
    double degree;      /* a degree in that unit */
    double turn;        /* of an angle that may go on past 180 deg: a turn in its unit; else 0 */
    double last_value;  /* from which such an angle goes on */
    double size;        /* the largest magnitude of the samples */
} search;

/* The column at any angle, with its sign turned so that the extreme is a minimum; NaN where there is
** none. */
static double value_at(double angle, void *data)
{
    const search *s = data;
    const fourlink_motion *motion = &s->a->d->motion;
    double value;
    result r;

    if (s->periodic && (angle < s->first || angle > s->last))
        angle += angle < s->first ? s->last - s->first : s->first - s->last;
    fourlink_motion_at(motion, angle, &r.row);
    analysis_at(s->a, s->branch, &r.row.crank, &r);
    if (r.status != FOURLINK_OK && !column_of_crank(s->c))
        return GSL_NAN;
    value = -s->sign * column_value(s->c, &r);
    if (s->turn > 0)
        value -= s->turn * floor((value - s->last_value) / s->turn + 0.5);
    return value;
}

static void keep_best(extreme *best, double value, double angle)
{
    if (value < best->value) {
        best->value = value;
        best->angle = angle;
    }
}

/* One of GSL's minimisers, from a bracket on; the lowest point goes to `best`, the bracket shrinks. */
static void minimise(search *s, const gsl_min_fminimizer_type *type, double *low, double middle,
                     double *high, extreme *best)
{
    gsl_min_fminimizer *m = gsl_min_fminimizer_alloc(type);
    gsl_function f;
    int i;

    if (!m) {
        s->a->out_of_memory = 1;
        return;
    }
    f.function = value_at;
    f.params = s;
    if (gsl_min_fminimizer_set(m, &f, middle, *low, *high) == GSL_SUCCESS) {
        for (i = 0; i < 100; i++)
            if (gsl_min_fminimizer_iterate(m) != GSL_SUCCESS ||
                gsl_min_test_interval(gsl_min_fminimizer_x_lower(m), gsl_min_fminimizer_x_upper(m),
                                      0, 1e-13) == GSL_SUCCESS)
                break;
        *low = gsl_min_fminimizer_x_lower(m);
        *high = gsl_min_fminimizer_x_upper(m);
        keep_best(best, gsl_min_fminimizer_f_minimum(m), gsl_min_fminimizer_x_minimum(m));
    }
    gsl_min_fminimizer_free(m);
}

/* Twelve times the step times the slope, by five points (its error is of the fourth order). */
static double slope(search *s, double x, double step)
{
    return 8 * (value_at(x + step, s) - value_at(x - step, s)) -
           (value_at(x + 2 * step, s) - value_at(x - 2 * step, s));
}

/* A smooth minimum is flat: values tell its place to 1e-8 rad only.  A step of Newton's method on the
** slope tells it better. */
static void sharpen(search *s, extreme *best)
{
    double step = 0.1 * s->degree, dx = 1e-3 * s->degree, x, rise;
    double curvature =
        (slope(s, best->angle + dx, step) - slope(s, best->angle - dx, step)) / (2 * dx);

    x = best->angle - slope(s, best->angle, step) / curvature;
    rise = fabs(value_at(best->angle + step, s) - best->value);
    if (fabs(x - best->angle) < 1e-3 * s->degree &&
        value_at(x, s) <= best->value + 1e-9 * rise + 1e-15 * fabs(best->value))
        best->angle = x;
}

/* Refine the minimum between three angles, the middle one the lowest.  Brent's method ends at the
** resolution of a smooth minimum; golden sections go on to a sharp one, such as that of a transmission
** angle folded at 90 deg. */
static void refine(search *s, double low, double middle, double high, extreme *best)
{
    extreme here;

    here.value = value_at(middle, s);
    here.angle = middle;
    minimise(s, gsl_min_fminimizer_brent, &low, middle, &high, &here);
    minimise(s, gsl_min_fminimizer_goldensection, &low, here.angle, &high, &here);
    sharpen(s, &here);
    keep_best(best, here.value, here.angle);
}

/* The last angle at which the column has a value, from one at which it has towards one at which not. */
static double edge(search *s, double good, double bad)
{
    int i;

    for (i = 0; i < 100; i++) {
        double middle = 0.5 * (good + bad);

        if (gsl_isnan(value_at(middle, s)))
            bad = middle;
        else
            good = middle;
    }
    return good;
}

/* The limit of the column where the links stop reaching, between two angles, at the first of which it has
** a value.  1, or 0 if it grows beyond all bounds there.
**
** With x the distance from the dead position, positions go as v0 + c sqrt(x), so that 2 v(x) - v(4 x) is v0
** but for terms of the order of x; velocities, accelerations and forces grow as a negative power of x. */
static int limit_at_edge(search *s, double good, double bad, extreme *limit)
{
    double x = (bad > good ? -1e-7 : 1e-7) * s->degree, far = good, v1, v2;

    good = edge(s, good, bad);
    v1 = value_at(good + x, s);
    v2 = value_at(good + 4 * x, s);
    limit->value = 2 * v1 - v2;
    if (fabs(limit->value) < 1e-4 * fabs(v1))
        limit->value = 0; /* of a transmission angle nothing else is left */
    limit->angle = good;
    if (gsl_isnan(limit->value)) {
        limit->value = value_at(good, s);
        return 1;
    }
    return fabs(limit->value - v2) <= fabs(v2 - value_at(far, s)) + 1e-9 * fabs(v2);
}

/* Keep the lowest angles of a list, the lowest first. */
static void keep_lowest(extreme *list, int *n, double value, double angle)
{
    int i;

    if (*n == PEAKS && value >= list[PEAKS - 1].value)
        return;
    if (*n < PEAKS)
        (*n)++;
    for (i = *n - 1; i > 0 && list[i - 1].value > value; i--)
        list[i] = list[i - 1];
    list[i].value = value;
    list[i].angle = angle;
}

/* Both sides of an angle of the cycle, wherever the motion comes by. */
static void look_at(search *s, double theta2, extreme *best)
{
    double rad = s->a->d->motion.angle_unit, cycle = s->a->d->cycle / rad, side = 1e-9 / rad;
    double x = theta2 / rad;

    for (x += cycle * ceil((s->first - x) / cycle); x <= s->last; x += cycle) {
        double before = value_at(x - side, s), after = value_at(x + side, s);

        if (x - side >= s->first && !gsl_isnan(before))
            keep_best(best, before, x);
        if (x + side <= s->last && !gsl_isnan(after))
            keep_best(best, after, x);
    }
}

static void look_at_curve(search *s, const curve *c, extreme *best)
{
    size_t i;

    for (i = 0; i < c->n; i++)
        look_at(s, c->x[i], best);
}

/* The corners of the loads, which a scan may step over: the ends of their windows, the points of their
** curves. */
static void look_at_corners(search *s, extreme *best)
{
    const deck *d = s->a->d;
    unsigned long i;

    look_at_curve(s, &d->gas.indicator, best);
    for (i = 0; i < d->n_loads; i++) {
        look_at_curve(s, &d->variations[i].torque, best);
        if (d->variations[i].is_windowed) {
            look_at(s, d->variations[i].from, best);
            look_at(s, d->variations[i].to, best);
        }
    }
}

/* A step for each degree; not fewer than 360, and where there are very many revolutions no more than can be
** waited for. */
static long steps_of(double degrees)
{
    if (degrees <= 0)
        return 0;
    if (degrees > MOST_STEPS)
        return MOST_STEPS;
    return degrees > 360 ? (long)ceil(degrees - 1e-6) : 360;
}

static void set_range(search *s)
{
    const deck *d = s->a->d;
    double end = analysis_end(s->a);

    s->periodic = analysis_is_periodic(s->a);
    s->first = d->motion.from < end ? d->motion.from : end;
    s->last = d->motion.from < end ? end : d->motion.from;
    s->degree = M_PI / 180 / d->motion.angle_unit;
    s->turn = 0;
    s->last_value = 0;
    s->size = 0;
}

/* Start to follow an angle past 180 deg. */
static void follow(search *s, double value)
{
    const unit *u = &s->a->d->units[QUANTITY_ANGLE].unit;

    if (column_quantity(s->c) == QUANTITY_ANGLE && !gsl_isnan(value)) {
        s->turn = flk_unit_from_si(2 * M_PI, *u);
        s->last_value = value;
    }
}

/* One revolution has its extremes between its first angle and its last, which are one position. */
static double in_revolution(const search *s, double angle)
{
    double turn = s->last - s->first, close = 1e-6 * s->degree;

    if (!s->periodic)
        return angle;
    angle += angle < s->first - close ? turn : angle > s->last + close ? -turn : 0;
    return fabs(angle - s->first) < close || fabs(angle - s->last) < close ? s->a->d->motion.from
                                                                           : angle;
}

/* Where a scan begins: at the first row, and in a revolution with a gap behind the last gap before it, so
** that an angle is the same at both ends of the revolution.  An angle is followed from the first row. */
static double scan_from(search *s, double step, long steps)
{
    double from = s->a->d->motion.from, value = value_at(from, s);
    long i;

    follow(s, value);
    if (!s->periodic || gsl_isnan(value))
        return from;
    for (i = 1; i < steps; i++) {
        value = value_at(from - (double)i * step, s);
        if (gsl_isnan(value))
            return from - (double)(i - 1) * step;
        s->last_value = value;
    }
    follow(s, value_at(from, s));
    return from;
}

/* Scan the motion: the lowest samples that stand below their neighbours, and the limits at the edges of
** reach.  `unbounded` is set if the column has no limit at one of these. */
static int scan(search *s, double step, long steps, extreme peaks[PEAKS], extreme *best,
                int *unbounded)
{
    double before, now, after;
    double from = scan_from(s, step, steps);
    extreme limit;
    int n = 0;
    long i;

    now = value_at(from, s);
    before = s->periodic ? value_at(from - step, s) : GSL_NAN;
    for (i = 0; i <= steps - s->periodic; i++) {
        double x = from + (double)i * step;
        int goes_on = i < steps || s->periodic, came = i > 0 || s->periodic;

        if (gsl_isnan(now))
            s->turn = 0; /* a gap: the angle starts anew */
        if (fabs(now) > s->size)
            s->size = fabs(now);
        after = goes_on ? value_at(x + step, s) : GSL_NAN;
        /* a NaN on one side is an end */
        if (!gsl_isnan(now) && !(before < now) && !(after < now))
            keep_lowest(peaks, &n, now, x);
        if (!gsl_isnan(now) && gsl_isnan(after) && goes_on) {
            *unbounded |= !limit_at_edge(s, x, x + step, &limit) && limit.value < now;
            keep_best(best, limit.value, in_revolution(s, limit.angle));
        }
        if (!gsl_isnan(now) && gsl_isnan(before) && came) {
            *unbounded |= !limit_at_edge(s, x, x - step, &limit) && limit.value < now;
            keep_best(best, limit.value, in_revolution(s, limit.angle));
        }
        before = now;
        now = after;
        if (s->turn == 0)
            follow(s, now);
        else if (!gsl_isnan(now))
            s->last_value = now;
    }
    return n;
}

static void refine_peak(search *s, double step, const extreme *peak, extreme *best)
{
    double x = peak->angle, low = x - step, high = x + step;

    follow(s, peak->value); /* the scan may have ended in a gap */
    keep_best(best, peak->value, x);
    if (low < s->first && !s->periodic) { /* at an end: is there a minimum just inside it? */
        low = s->first;
        x = s->first + 1e-3 * step;
    }
    if (high > s->last && !s->periodic) {
        high = s->last;
        x = s->last - 1e-3 * step;
    }
    if (gsl_isnan(value_at(low, s)))
        low = edge(s, x, low);
    if (gsl_isnan(value_at(high, s)))
        high = edge(s, x, high);
    if (low < x && x < high && !column_of_rounding(s->c) && value_at(x, s) < value_at(low, s) &&
        value_at(x, s) < value_at(high, s))
        refine(s, low, x, high, best);
}

/* Of values that are equal but for rounding the one that the motion comes by first. */
static void keep_first(const search *s, extreme *best, const extreme *found)
{
    double from = s->a->d->motion.from, close = 1e-12 * s->size;
    double angle = in_revolution(s, found->angle);

    if (found->value < best->value - close ||
        (found->value <= best->value + close && fabs(angle - from) < fabs(best->angle - from)))
        best->angle = angle;
    if (found->value < best->value)
        best->value = found->value;
}

extreme_result extreme_find(analysis *a, const column *c, fourlink_branch branch, int sign,
                            extreme *found)
{
    extreme peaks[PEAKS], best, found_here;
    int n, k, unbounded = 0;
    double step;
    long steps;
    search s;

    s.a = a;
    s.c = c;
    s.branch = branch;
    s.sign = sign;
    set_range(&s);
    steps = steps_of((s.last - s.first) / s.degree);
    step = steps ? (s.last - s.first) / (double)steps : 0;
    best.value = GSL_POSINF;
    best.angle = s.first;
    n = scan(&s, a->d->motion.from > s.first ? -step : step, steps, peaks, &best, &unbounded);
    if (!n && s.periodic && s.turn > 0) { /* an angle that goes on: its ends do not meet */
        set_range(&s);
        s.periodic = 0;
        n = scan(&s, a->d->motion.from > s.first ? -step : step, steps, peaks, &best, &unbounded);
    }
    if (!n)
        return EXTREME_NONE;
    for (k = 0; k < n; k++) {
        found_here.value = GSL_POSINF;
        found_here.angle = peaks[k].angle;
        refine_peak(&s, step, &peaks[k], &found_here);
        keep_first(&s, &best, &found_here);
    }
    if (s.last > s.first && (column_need(c) & (NEED_FORCES | NEED_ENGINE)))
        look_at_corners(&s, &best);
    found->value = -sign * best.value;
    found->angle = best.angle;
    if (unbounded || fabs(found->value) >= column_bound(c))
        return EXTREME_UNBOUNDED;
    return EXTREME_FOUND;
}
