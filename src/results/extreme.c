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
#define MINIMISER_STATE 32 /* doubles: more than any of its minimisers needs */

typedef struct search {
    flk_analysis *a;
    const flk_column *c;
    fourlink_branch branch;
    int sign;
    int periodic;       /* 1: one revolution, whose ends meet */
    double first, last; /* crank angles in the deck's unit */
    double degree;      /* a degree in that unit */
    double turn;        /* of an angle that may go on past 180 deg: a turn in its unit; else 0 */
    double last_value;  /* from which such an angle goes on */
    double size;        /* the largest magnitude of the samples */
    int left;           /* 1: a minimiser has left the angles at which there is a value */
} search;

/* The column at any angle, with its sign turned so that the extreme is a minimum; NaN where there is
** none. */
static double value_at(double angle, void *data)
{
    const search *s = data;
    double value;
    flk_row row;

    if (s->periodic && (angle < s->first || angle > s->last))
        angle += angle < s->first ? s->last - s->first : s->first - s->last;
    flk_analysis_at_angle(s->a, flk_column_need(s->c), s->branch, angle, &row);
    value = -s->sign * flk_column_value(s->c, &row);
    if (s->turn > 0)
        value -= s->turn * floor((value - s->last_value) / s->turn + 0.5);
    return value;
}

static void keep_best(flk_extreme *best, double value, double angle)
{
    if (value < best->value) {
        best->value = value;
        best->angle = angle;
    }
}

/* The column for GSL, which tells its error handler of what is not finite: this is noted here, and a
** number too large for a minimum given instead. */
static double finite_value_at(double angle, void *data)
{
    search *s = data;
    double value = value_at(angle, s);

    if (gsl_finite(value))
        return value;
    s->left = 1;
    return GSL_DBL_MAX;
}

static flk_extreme sample(search *s, double angle)
{
    flk_extreme x;

    x.value = value_at(angle, s);
    x.angle = angle;
    return x;
}

/* 1 if three samples enclose a minimum, as GSL asks for. */
static int encloses(const flk_extreme *low, const flk_extreme *middle, const flk_extreme *high)
{
    return low->angle < middle->angle && middle->angle < high->angle &&
           middle->value < low->value && middle->value < high->value && gsl_finite(low->value) &&
           gsl_finite(high->value);
}

/* One of GSL's minimisers, in memory of our own, from a bracket on that encloses a minimum; the lowest point
** goes to `best`, the bracket shrinks. */
static void minimise(search *s, const gsl_min_fminimizer_type *type, flk_extreme *low,
                     const flk_extreme *middle, flk_extreme *high, flk_extreme *best)
{
    double state[MINIMISER_STATE];
    gsl_min_fminimizer m;
    gsl_function f;
    int i;

    if (type->size > sizeof state || !encloses(low, middle, high))
        return;
    m.type = type;
    m.state = state;
    f.function = finite_value_at;
    f.params = s;
    s->left = 0;
    if (gsl_min_fminimizer_set_with_values(&m, &f, middle->angle, middle->value, low->angle,
                                           low->value, high->angle, high->value) != GSL_SUCCESS ||
        s->left)
        return;
    for (i = 0; i < 100; i++) {
        gsl_min_fminimizer before = m;
        int status = gsl_min_fminimizer_iterate(&m);

        if (s->left)
            m = before;
        if (status != GSL_SUCCESS || s->left ||
            gsl_min_test_interval(m.x_lower, m.x_upper, 0, 1e-13) == GSL_SUCCESS)
            break;
    }
    low->angle = m.x_lower;
    low->value = m.f_lower;
    high->angle = m.x_upper;
    high->value = m.f_upper;
    keep_best(best, m.f_minimum, m.x_minimum);
}

/* Twelve times the step times the slope, by five points (its error is of the fourth order). */
static double slope(search *s, double x, double step)
{
    return 8 * (value_at(x + step, s) - value_at(x - step, s)) -
           (value_at(x + 2 * step, s) - value_at(x - 2 * step, s));
}

/* A smooth minimum is flat: values tell its place to 1e-8 rad only.  A step of Newton's method on the
** slope tells it better. */
static void sharpen(search *s, flk_extreme *best)
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
static void refine(search *s, flk_extreme low, flk_extreme middle, flk_extreme high,
                   flk_extreme *best)
{
    flk_extreme here = middle;

    if (!encloses(&low, &middle, &high))
        return;
    minimise(s, gsl_min_fminimizer_brent, &low, &middle, &high, &here);
    middle = here;
    minimise(s, gsl_min_fminimizer_goldensection, &low, &middle, &high, &here);
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
static int limit_at_edge(search *s, double good, double bad, flk_extreme *limit)
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
static void keep_lowest(flk_extreme *list, int *n, double value, double angle)
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
static void look_at(search *s, double theta2, flk_extreme *best)
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

static void look_at_curve(search *s, const curve *c, flk_extreme *best)
{
    size_t i;

    for (i = 0; i < c->n; i++)
        look_at(s, c->x[i], best);
}

/* The corners of the loads, which a scan may step over: the ends of their windows, the points of their
** curves. */
static void look_at_corners(search *s, flk_extreme *best)
{
    const deck *d = s->a->d;
    unsigned long i;

    look_at_curve(s, &d->gas.indicator, best);
    for (i = 0; i < d->n_loads; i++) {
        look_at_curve(s, &d->variations[i].torque, best);
        look_at_curve(s, &d->variations[i].force[0], best);
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
    double end = flk_analysis_end(s->a);

    s->periodic = flk_analysis_is_periodic(s->a);
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

    if (flk_column_quantity(s->c) == QUANTITY_ANGLE && !gsl_isnan(value)) {
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
static int scan(search *s, double step, long steps, flk_extreme peaks[PEAKS], flk_extreme *best,
                int *unbounded)
{
    double before, now, after;
    double from = scan_from(s, step, steps);
    flk_extreme limit;
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

static void refine_peak(search *s, double step, const flk_extreme *peak, flk_extreme *best)
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
    if (!(flk_column_flags(s->c) & FOURLINK_OF_ROUNDING))
        refine(s, sample(s, low), sample(s, x), sample(s, high), best);
}

/* Of values that are equal but for rounding the one that the motion comes by first. */
static void keep_first(const search *s, flk_extreme *best, const flk_extreme *found)
{
    double from = s->a->d->motion.from, close = 1e-12 * s->size;
    double angle = in_revolution(s, found->angle);

    if (found->value < best->value - close ||
        (found->value <= best->value + close && fabs(angle - from) < fabs(best->angle - from)))
        best->angle = angle;
    if (found->value < best->value)
        best->value = found->value;
}

int flk_extreme_find(flk_analysis *a, const flk_column *c, fourlink_branch branch, int sign,
                     flk_extreme *found)
{
    flk_extreme peaks[PEAKS], best, found_here;
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
        return FOURLINK_NOT_REACHED;
    for (k = 0; k < n; k++) {
        found_here.value = GSL_POSINF;
        found_here.angle = peaks[k].angle;
        refine_peak(&s, step, &peaks[k], &found_here);
        keep_first(&s, &best, &found_here);
    }
    if (s.last > s.first && (flk_column_need(c) & (NEED_FORCES | NEED_ENGINE | NEED_GAS)))
        look_at_corners(&s, &best);
    found->value = -sign * best.value;
    found->angle = best.angle;
    if (unbounded || fabs(found->value) >= flk_column_bound(c))
        found->value = sign > 0 ? GSL_POSINF : GSL_NEGINF;
    return FOURLINK_OK;
}
