/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme.c - the largest and smallest value of a column over a deck's motion.
**
** The motion is scanned in steps of a degree at most; every peak of the samples that comes near the
** highest is refined by GSL's minimiser of Brent.
*/
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_min.h>

#include "extreme.h"

#define PEAKS 8

typedef struct search {
    analysis *a;
    const column *c;
    fourlink_branch branch;
    int sign;
    int periodic;       /* 1: one revolution, whose ends meet */
    double first, last; /* crank angles in the deck's unit */
    double turn;        /* of an angle that may go on past 180 deg: a turn in its unit; else 0 */
    double last_value;  /* from which such an angle goes on */
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
    if (r.status != FOURLINK_OK)
        return GSL_NAN;
    value = -s->sign * column_value(s->c, &r);
    if (s->turn > 0)
        value -= s->turn * floor((value - s->last_value) / s->turn + 0.5);
    return value;
}

/* One of GSL's minimisers, from a bracket on; the lowest point goes to `best`, the bracket shrinks. */
static void minimise(const gsl_min_fminimizer_type *type, gsl_function *f, double *low,
                     double middle, double *high, extreme *best)
{
    gsl_min_fminimizer *m = gsl_min_fminimizer_alloc(type);
    int i;

    if (!m)
        return;
    if (gsl_min_fminimizer_set(m, f, middle, *low, *high) == GSL_SUCCESS) {
        for (i = 0; i < 100; i++)
            if (gsl_min_fminimizer_iterate(m) != GSL_SUCCESS ||
                gsl_min_test_interval(gsl_min_fminimizer_x_lower(m), gsl_min_fminimizer_x_upper(m),
                                      0, 1e-13) == GSL_SUCCESS)
                break;
        *low = gsl_min_fminimizer_x_lower(m);
        *high = gsl_min_fminimizer_x_upper(m);
        if (gsl_min_fminimizer_f_minimum(m) < best->value) {
            best->value = gsl_min_fminimizer_f_minimum(m);
            best->angle = gsl_min_fminimizer_x_minimum(m);
        }
    }
    gsl_min_fminimizer_free(m);
}

/* Refine the minimum between three angles, the middle one the lowest.  Brent's method ends at the
** resolution of a smooth minimum; golden sections go on to a sharp one, such as that of a transmission
** angle folded at 90 deg. */
static void refine(search *s, double low, double middle, double high, extreme *best)
{
    gsl_function f;

    f.function = value_at;
    f.params = s;
    minimise(gsl_min_fminimizer_brent, &f, &low, middle, &high, best);
    minimise(gsl_min_fminimizer_goldensection, &f, &low, best->angle, &high, best);
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

int extreme_find(analysis *a, const column *c, fourlink_branch branch, int sign, extreme *found)
{
    const deck *d = a->d;
    extreme peaks[PEAKS], best;
    double step, before, now, after, span;
    long steps, i;
    int n = 0, k;
    search s;
    fourlink_row end;

    s.a = a;
    s.c = c;
    s.branch = branch;
    s.sign = sign;
    s.periodic = d->one_revolution && d->motion.run_up <= 0 &&
                 (d->motion.acceleration == 0 || d->motion.hold);
    fourlink_motion_row(&d->motion, &a->range, a->range.n_rows - 1, &end);
    s.first = d->motion.from < end.angle ? d->motion.from : end.angle;
    s.last = d->motion.from < end.angle ? end.angle : d->motion.from;
    span = s.last - s.first;
    steps = (long)ceil(span * d->motion.angle_unit / (M_PI / 180) - 1e-6);
    if (steps < 360)
        steps = span > 0 ? 360 : 0;
    step = steps ? span / (double)steps : 0;

    s.turn = 0;
    now = value_at(s.first, &s);
    if (column_quantity(c) == QUANTITY_ANGLE && !gsl_isnan(now)) {
        s.turn = 2 * M_PI * d->units[QUANTITY_ANGLE].unit.down / d->units[QUANTITY_ANGLE].unit.up;
        s.last_value = now;
    }
    before = s.periodic ? value_at(s.first - step, &s) : GSL_NAN;
    for (i = 0; i <= steps; i++) {
        after = i < steps    ? value_at(s.first + (double)(i + 1) * step, &s)
                : s.periodic ? value_at(s.last + step, &s)
                             : GSL_NAN;
        /* a NaN on one side is an end */
        if (!gsl_isnan(now) && !(before < now) && !(after < now))
            keep_lowest(peaks, &n, now, s.first + (double)i * step);
        before = now;
        now = after;
        if (!gsl_isnan(now))
            s.last_value = now;
    }
    if (!n)
        return 0;
    best = peaks[0];
    for (k = 0; k < n; k++) {
        double x = peaks[k].angle, low = x - step, high = x + step;

        s.last_value = peaks[k].value;

        if (low < s.first && !s.periodic) /* at an end: is there a minimum just inside it? */
            low = s.first, x = s.first + 1e-3 * step;
        if (high > s.last && !s.periodic)
            high = s.last, x = s.last - 1e-3 * step;
        if (!column_of_rounding(c) && value_at(x, &s) < value_at(low, &s) &&
            value_at(x, &s) < value_at(high, &s))
            refine(&s, low, x, high, &best);
    }
    found->value = -sign * best.value;
    found->angle = best.angle < s.first  ? best.angle + span
                   : best.angle > s.last ? best.angle - span
                                         : best.angle;
    return 1;
}
