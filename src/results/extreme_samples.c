/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme_samples.c - samples of all columns in a stretch of the motion, and the best values found.
**
** A piece of the motion is sampled over a parameter s in which square roots at its ends are smooth:
**
**    passed = from + (to - from) s^2, or (to - from) (1 - (1 - s)^2), or (to - from) (1 - cos(pi s)) / 2
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "extreme_search.h"

#define INSIDE 5e-11         /* rad, from a corner into the piece beside it */
#define CLOSE_TO_CHANGE 1e-4 /* rad */
#define CLOSE_TURNS 1e-10    /* of a value: equal in two turns of an integrated motion */
#define MOST_ROWS 4e6        /* of a search, of a deck without loads: a second or two */

/* Of a motion that repeats the first period and the last are searched. */
static void skip_periods(flk_search *x)
{
    x->motion.period = flk_course_repeats(&x->a->course) ? x->a->course.period : GSL_POSINF;
    x->skipped = 0;
    if (x->motion.length < 3 * x->motion.period)
        return;
    x->skipped = x->motion.period * (floor(x->motion.length / x->motion.period) - 2);
    x->motion.length -= x->skipped;
}

/* What a row costs, in rows without loads. */
static double cost_of_row(const flk_analysis *a)
{
    return 1 + (double)a->d->machine.n_loads / 15 + (a->d->machine.has_friction ? 20 : 0);
}

int flk_search_is_over(const flk_search *x)
{
    return x->a->rows_left <= 0;
}

void flk_search_begin(flk_search *x)
{
    x->a->rows_left = MOST_ROWS;
    x->motion.course = &x->a->course;
    x->motion.branch = x->branch;
    x->motion.has_loads = x->a->course.actual != NULL;
    x->motion.length = flk_course_length(&x->a->course, x->branch);
    skip_periods(x);
    x->from = x->a->d->motion.from;
    x->end = flk_course_end(&x->a->course, x->branch);
    x->per_rad = (x->end < x->from ? -1 : 1) / x->a->d->motion.angle_unit;
    if (x->a->d->drive.by_time) {
        x->from = 0;
        x->per_rad = x->motion.length > 0 ? x->end / x->motion.length : 0;
    }
    memset(&x->piece, 0, sizeof x->piece);
}

int flk_search_next(flk_search *x)
{
    return flk_pieces_next(&x->motion, &x->piece);
}

int flk_search_is_root(flk_piece_end end)
{
    return end == FLK_END_ROOT || end == FLK_END_DEAD || end == FLK_END_CHANGE_REST;
}

/* The share of the piece that is passed at a parameter. */
static double share(const flk_search *x, double s)
{
    if (flk_search_is_root(x->piece.begin) && flk_search_is_root(x->piece.end))
        return 0.5 - 0.5 * cos(M_PI * s);
    return flk_search_is_root(x->piece.begin) ? s * s
           : flk_search_is_root(x->piece.end) ? s * (2 - s)
                                              : s;
}

double flk_search_passed(const flk_search *x, double s)
{
    double from = x->piece.from, length = x->piece.to - from;

    if (s <= 0 && from > 0)
        return from + GSL_MIN_DBL(INSIDE, length / 4);
    if (s >= 1)
        return x->piece.to < x->motion.length ? x->piece.to - GSL_MIN_DBL(INSIDE, length / 4)
                                              : x->piece.to;
    return from + length * share(x, s);
}

double flk_search_rate(const flk_search *x, double s)
{
    double length = x->piece.to - x->piece.from;

    if (flk_search_is_root(x->piece.begin) && flk_search_is_root(x->piece.end))
        return length * 0.5 * M_PI * sin(M_PI * s);
    return flk_search_is_root(x->piece.begin) ? length * 2 * s
           : flk_search_is_root(x->piece.end) ? length * 2 * (1 - s)
                                              : length;
}

double flk_search_angle(const flk_search *x, double passed)
{
    if (passed >= x->motion.length)
        return x->end;
    return x->from + x->per_rad * (passed > x->motion.period ? passed + x->skipped : passed);
}

double flk_search_corner(const flk_search *x, double s)
{
    return flk_search_angle(x, s <= 0   ? x->piece.from
                               : s >= 1 ? x->piece.to
                                        : flk_search_passed(x, s));
}

void flk_search_row_at(const flk_search *x, int needs, double angle, flk_row *row)
{
    if (flk_search_is_over(x)) {
        memset(row, 0, sizeof *row);
        row->at.status = FOURLINK_LONG_SEARCH;
        return;
    }
    x->a->rows_left -= cost_of_row(x->a);
    if (x->a->d->drive.by_time)
        flk_analysis_at_time(x->a, needs, x->branch, angle, row);
    else
        flk_analysis_at_angle(x->a, needs, x->branch, angle, row);
}

double flk_search_crank(const flk_search *x, double angle)
{
    flk_row row;

    if (!x->a->d->drive.by_time)
        return angle;
    flk_analysis_at_time(x->a, 0, x->branch, angle, &row);
    return row.at.row.angle;
}

void flk_search_compute(const flk_search *x, int needs, double passed, flk_row *row)
{
    flk_search_row_at(x, needs, flk_search_angle(x, passed), row);
}

int flk_search_is_reached(const flk_search *x)
{
    flk_row row;

    flk_search_compute(x, 0, 0.5 * (x->piece.from + x->piece.to), &row);
    return row.at.status == FOURLINK_OK;
}

double flk_search_leap(const flk_tracked *t, double from, double to)
{
    double d = (to - from) / t->turn;

    return fabs(d - floor(d + 0.5));
}

/* A force that passes through zero turns over at once: its direction is not continuous there. */
#define HALF_TURN (0.5 - 1e-6)

int flk_search_turns_over(const flk_tracked *t, double from, double to)
{
    return flk_search_leap(t, from, to) > HALF_TURN;
}

void flk_search_track(const flk_search *x, flk_tracked *t, const flk_column *c)
{
    memset(t, 0, sizeof *t);
    t->c = c;
    if (flk_column_quantity(c) == QUANTITY_ANGLE)
        t->turn = flk_unit_from_si(2 * M_PI, x->a->d->units[QUANTITY_ANGLE].unit);
    t->last = t->first = GSL_NAN;
    t->known[0] = GSL_NEGINF;
    t->known[1] = GSL_POSINF;
    t->bound = flk_column_bound(c);
    t->close = x->a->course.actual ? CLOSE_TURNS : FLK_SEARCH_CLOSE;
    t->is_noise = (flk_column_flags(c) & FOURLINK_OF_ROUNDING) != 0;
}

double flk_search_turns(const flk_tracked *t, double from, double to)
{
    return t->turn * floor((to - from) / t->turn + 0.5);
}

double flk_search_nearest(const flk_tracked *t, double value, double near)
{
    return value + flk_search_turns(t, value, near);
}

int flk_search_is_lost(const flk_search *x, const flk_tracked *t, double s)
{
    double passed = flk_search_passed(x, s);

    return passed - x->piece.from < t->lost[0] || x->piece.to - passed < t->lost[1];
}

double flk_search_value(const flk_search *x, const flk_tracked *t, double s, double near)
{
    double value;
    flk_row row;

    if (flk_search_is_lost(x, t, s))
        return GSL_NAN;
    flk_search_compute(x, flk_column_need(t->c), flk_search_passed(x, s), &row);
    value = flk_column_value(t->c, &row);
    if (!(t->turn > 0))
        return value;
    return flk_search_turns_over(t, near, value) ? GSL_NAN : flk_search_nearest(t, value, near);
}

double *flk_search_row(const flk_search *x, size_t column)
{
    return x->values + FLK_SEARCH_MOST_SAMPLES * column;
}

int flk_search_has_limit(flk_piece_end end)
{
    return end == FLK_END_DEAD || end == FLK_END_CHANGE || end == FLK_END_CHANGE_REST;
}

/* There is no row at a dead position, and close to a change point it is rounding. */
static int has_row(flk_piece_end end, double away)
{
    return !flk_search_has_limit(end) || away > (end == FLK_END_DEAD ? 0 : CLOSE_TO_CHANGE);
}

static int has_row_at(const flk_search *x, double s)
{
    double passed = flk_search_passed(x, s);

    return has_row(x->piece.begin, s <= 0 ? 0 : passed - x->piece.from) &&
           has_row(x->piece.end, s >= 1 ? 0 : x->piece.to - passed);
}

/* The value of a column at the begin or the end of the motion, where it is not defined, such as the direction of a
** force that is zero there: that just inside. */
static double value_inside(const flk_search *x, const flk_tracked *t, double s)
{
    double inside = GSL_MIN_DBL(INSIDE, (x->piece.to - x->piece.from) / 4);
    flk_row row;

    if ((s > 0 || x->piece.from > 0) && (s < 1 || x->piece.to < x->motion.length))
        return GSL_NAN;
    flk_search_compute(x, flk_column_need(t->c),
                       s > 0 ? x->piece.to - inside : x->piece.from + inside, &row);
    return flk_column_value(t->c, &row);
}

/* The value of a column in a sample, NaN where it is infinite or rounding. */
static double sample_of(const flk_search *x, const flk_tracked *t, double s, const flk_row *row)
{
    double value = flk_column_value(t->c, row);

    if (gsl_isnan(value) && row->at.status == FOURLINK_OK && t->turn > 0)
        value = value_inside(x, t, s);
    if ((t->is_noise && x->a->is_fast) || flk_search_is_lost(x, t, s) || gsl_isinf(value))
        return GSL_NAN;
    return value;
}

void flk_search_insert(flk_search *x, size_t i, double s)
{
    size_t c, behind = (x->n - i) * sizeof(double);
    double *place = x->values + i;
    flk_row row;

    flk_search_compute(x, x->needs, flk_search_passed(x, s), &row);
    if (behind)
        memmove(x->s + i + 1, x->s + i, behind);
    x->s[i] = s;
    if (row.at.status == FOURLINK_OK)
        x->closest_line = GSL_MIN_DBL(x->closest_line, fabs(row.at.state.sine));
    x->has_lock |= row.at.status == FOURLINK_LOCKED;
    x->a->rows_left -= (double)x->n_columns / 16;
    for (c = 0; c < x->n_columns; c++, place += FLK_SEARCH_MOST_SAMPLES) {
        flk_tracked *t = &x->columns[c];

        if (behind)
            memmove(place + 1, place, behind);
        *place = sample_of(x, t, s, &row);
        if (fabs(*place) > t->size && !x->is_cut)
            t->size = fabs(*place);
    }
    x->n++;
}

static void append(flk_search *x, double s)
{
    if (has_row_at(x, s))
        flk_search_insert(x, x->n, s);
}

#define HALVINGS 9 /* of the step towards an end without a row */

void flk_search_sample(flk_search *x, size_t steps)
{
    double step = (x->high - x->low) / (double)(steps ? steps : 1);
    int at_begin = x->low <= 0 && flk_search_has_limit(x->piece.begin),
        at_end = x->high >= 1 && flk_search_has_limit(x->piece.end), k;
    size_t i;

    x->n = 0;
    x->closest_line = 1;
    x->has_lock = 0;
    memset(x->halved, 0, sizeof x->halved);
    x->step = step;
    x->a->is_fast = !x->has_noise;
    for (k = HALVINGS; at_begin && k > 0; k--)
        append(x, x->low + step * pow(0.5, k));
    for (i = 0; i <= steps && !flk_search_is_over(x); i++)
        append(x, i == steps ? x->high : x->low + step * (double)i);
    for (k = 1; at_end && k <= HALVINGS; k++)
        append(x, x->high - step * pow(0.5, k));
    x->a->is_fast = 1;
}

#define LEAP (1.0 / 6)
#define CLOSEST_SAMPLES 1e-7

static int leaps(const flk_search *x, size_t i)
{
    size_t c;

    for (c = 0; c < x->n_columns; c++) {
        const double *values = flk_search_row(x, c);

        if (x->columns[c].turn > 0 &&
            flk_search_leap(&x->columns[c], values[i], values[i + 1]) > LEAP)
            return 1;
    }
    return 0;
}

void flk_search_resolve_leaps(flk_search *x)
{
    size_t i;

    for (i = 0; i + 1 < x->n; i++)
        while (x->n < FLK_SEARCH_MOST_SAMPLES && x->s[i + 1] - x->s[i] > CLOSEST_SAMPLES &&
               leaps(x, i))
            flk_search_insert(x, i + 1, 0.5 * (x->s[i] + x->s[i + 1]));
}

size_t flk_search_beside(const flk_search *x, const double *values, size_t i, int side)
{
    size_t k = i, last = i;

    while (side > 0 ? k + 1 < x->n : k > 0) {
        k = side > 0 ? k + 1 : k - 1;
        if (gsl_isnan(values[k]))
            break;
        if (fabs(x->s[k] - x->s[i]) >= x->step / 16 ||
            fabs(values[k] - values[i]) > 1e-7 * fabs(values[i]))
            return k;
        if (fabs(x->s[k] - x->s[i]) >= 1e-6 * x->step)
            last = k;
    }
    return last;
}

/* ------------------------------------------------------------------------------------------- the best */

double flk_search_signed(int which, double value)
{
    return which == 0 ? value : -value;
}

/* Take the new extreme if there is none, or if it is more than the old one by more than a part of it. */
static void offer(flk_found *best, int which, const flk_found *found, double part)
{
    double close = part * GSL_MAX_DBL(fabs(found->value), fabs(best->value));

    if (gsl_isnan(found->value))
        return;
    if (!best->is_there ||
        flk_search_signed(which, found->value) >
            flk_search_signed(which, best->value) + (gsl_finite(close) ? close : 0))
        *best = *found;
}

void flk_search_offer(flk_found *best, int which, double value, double angle, double corner)
{
    flk_found found;

    found.is_there = 1;
    found.value = value;
    found.angle = angle;
    found.corner = corner;
    offer(best, which, &found, FLK_SEARCH_CLOSE);
}

void flk_search_offer_at(const flk_search *x, flk_found *best, int which, double value, double s)
{
    flk_search_offer(best, which, value, flk_search_angle(x, flk_search_passed(x, s)),
                     flk_search_corner(x, s));
}

int flk_search_is_beaten(const flk_search *x, const flk_tracked *t, int which, double value)
{
    const flk_found *best = &t->best[which];
    double here = flk_search_signed(which, value);

    return x->a->course.actual &&
           (flk_search_signed(which, t->known[which]) > here ||
            (best->is_there && flk_search_signed(which, best->value) > here));
}

void flk_search_commit(flk_tracked *t, double shift)
{
    int which;

    for (which = 0; which < 2; which++)
        if (t->here[which].is_there) {
            t->here[which].value += shift;
            offer(&t->best[which], which, &t->here[which], t->close);
        }
    memset(t->here, 0, sizeof t->here);
}

void flk_search_follow(flk_search *x, flk_tracked *t, double *values)
{
    size_t i;

    for (i = 0; i < x->n; i++) {
        if (x->piece.from <= 0 && x->low <= 0 && i == 0)
            t->first = values[i];
        if (gsl_isnan(values[i]))
            continue;
        if (!gsl_isnan(t->last) && flk_search_turns_over(t, t->last, values[i])) {
            flk_search_commit(t, 0);
            t->restarts = 1;
            t->last = values[i];
            continue;
        }
        if (!gsl_isnan(t->last))
            values[i] = flk_search_nearest(t, values[i], t->last);
        t->last = values[i];
    }
}
