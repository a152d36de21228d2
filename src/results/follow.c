/* SPDX-License-Identifier: GPL-3.0-or-later
**
** follow.c - columns along the motion of a branch, piece by piece.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "follow.h"

#define INSIDE 5e-11  /* rad, from an end into the piece */
#define CLOSE 1e-6    /* rad, of the end of a piece and that of a period */
#define MOST_ROWS 4e6 /* of a walk without loads: a second or two */

void flk_follow_all(flk_follower *f)
{
    f->motion.length += f->skipped;
    f->skipped = 0;
}

static void skip_periods(flk_follower *f)
{
    f->motion.period =
        flk_crank_motion_repeats(&f->a->crank_motion) ? f->a->crank_motion.period : GSL_POSINF;
    if (f->motion.length < 3 * f->motion.period)
        return;
    f->skipped = f->motion.period * (floor(f->motion.length / f->motion.period) - 2);
    f->motion.length -= f->skipped;
}

void flk_follow(flk_follower *f, flk_analysis *a, fourlink_branch branch)
{
    const flk_crank_motion *crank_motion = &a->crank_motion;

    memset(f, 0, sizeof *f);
    f->a = a;
    f->branch = branch;
    a->rows_left = MOST_ROWS;
    f->motion.crank_motion = crank_motion;
    f->motion.branch = branch;
    f->motion.has_loads = crank_motion->actual != NULL;
    f->motion.length = flk_crank_motion_length(crank_motion, branch);
    skip_periods(f);
    f->from = a->d->motion.from;
    f->end = flk_crank_motion_end(crank_motion, branch);
    f->per_rad = (f->end < f->from ? -1 : 1) / a->d->motion.angle_unit;
    if (a->d->drive.by_time) {
        f->from = 0;
        f->per_rad = f->motion.length > 0 ? f->end / f->motion.length : 0;
    }
}

int flk_follow_next(flk_follower *f)
{
    return flk_pieces_next(&f->motion, &f->piece);
}

double flk_follow_skips(const flk_follower *f)
{
    return f->skipped > 0 && fabs(f->piece.to - f->motion.period) < CLOSE
               ? floor(f->skipped / f->motion.period + 0.5)
               : 0;
}

int flk_follow_is_root(flk_piece_end end)
{
    return end == FLK_END_ROOT || end == FLK_END_DEAD || end == FLK_END_CHANGE_REST;
}

int flk_follow_has_limit(flk_piece_end end)
{
    return end == FLK_END_DEAD || end == FLK_END_CHANGE || end == FLK_END_CHANGE_REST;
}

double flk_follow_corner(const flk_follower *f, double s)
{
    double length = f->piece.to - f->piece.from;

    return s <= 0    ? f->piece.from
           : s >= 1  ? f->piece.to
           : s < 0.5 ? f->piece.from + length * gsl_pow_2(sin(M_PI_2 * s))
                     : f->piece.to - length * gsl_pow_2(sin(M_PI_2 * (1 - s)));
}

double flk_follow_inside(const flk_follower *f, double s)
{
    double inside = GSL_MIN_DBL(INSIDE, (f->piece.to - f->piece.from) / 4);

    return s <= 0   ? f->piece.from + inside
           : s >= 1 ? f->piece.to - inside
                    : flk_follow_corner(f, s);
}

double flk_follow_passed(const flk_follower *f, double s)
{
    int is_end_of_motion =
        (s <= 0 && f->piece.from <= 0) || (s >= 1 && f->piece.to >= f->motion.length);

    return is_end_of_motion ? flk_follow_corner(f, s) : flk_follow_inside(f, s);
}

double flk_follow_rate(const flk_follower *f, double s)
{
    return (f->piece.to - f->piece.from) * M_PI_2 * sin(M_PI * s);
}

double flk_follow_angle(const flk_follower *f, double passed)
{
    if (passed >= f->motion.length)
        return f->end;
    return f->from + f->per_rad * (passed > f->motion.period ? passed + f->skipped : passed);
}

double flk_follow_crank(const flk_follower *f, double angle)
{
    flk_row row;

    if (!f->a->d->drive.by_time)
        return angle;
    flk_analysis_at_time(f->a, 0, f->branch, angle, &row);
    return row.at.row.angle;
}

/* What a row costs, in rows without loads. */
static double cost_of_row(const flk_analysis *a)
{
    return 1 + (double)a->d->machine.n_loads / 15 + (a->d->machine.has_friction ? 20 : 0);
}

int flk_follow_is_over(const flk_follower *f)
{
    return f->a->rows_left <= 0;
}

void flk_follow_row(const flk_follower *f, int needs, double passed, flk_row *row)
{
    double angle = flk_follow_angle(f, passed);

    if (flk_follow_is_over(f)) {
        memset(row, 0, sizeof *row);
        row->at.status = FOURLINK_LONG_SEARCH;
        return;
    }
    f->a->rows_left -= cost_of_row(f->a);
    if (f->a->d->drive.by_time)
        flk_analysis_at_time(f->a, needs, f->branch, angle, row);
    else
        flk_analysis_at_angle(f->a, needs, f->branch, angle, row);
}

int flk_follow_is_reached(const flk_follower *f)
{
    flk_row row;

    flk_follow_row(f, 0, 0.5 * (f->piece.from + f->piece.to), &row);
    return row.at.status == FOURLINK_OK;
}

/* ------------------------------------------------------------------------------------------- a column */

void flk_follow_column(flk_follower *f, flk_followed *t, const flk_column *c)
{
    memset(t, 0, sizeof *t);
    t->c = c;
    if (flk_column_quantity(c) == QUANTITY_ANGLE)
        t->turn = flk_unit_from_si(2 * M_PI, f->a->d->units[QUANTITY_ANGLE].unit);
    t->last = t->first = GSL_NAN;
    t->bound = flk_column_bound(c);
    t->is_noise = (flk_column_flags(c) & FOURLINK_OF_ROUNDING) != 0;
    f->motion.has_loads |= !flk_column_is_of_motion(c);
}

double flk_followed_value(const flk_follower *f, const flk_followed *t, double s)
{
    flk_row row;

    flk_follow_row(f, flk_column_need(t->c), flk_follow_passed(f, s), &row);
    return flk_column_value(t->c, &row);
}

/* The whole turns of an angle from one value to another, in its unit. */
static double whole_turns(const flk_followed *t, double from, double to)
{
    return t->turn * floor((to - from) / t->turn + 0.5);
}

double flk_followed_nearest(const flk_followed *t, double value, double near)
{
    return t->turn > 0 && !gsl_isnan(near) ? value + whole_turns(t, value, near) : value;
}

double flk_followed_per_period(const flk_followed *t)
{
    return t->turn > 0 && !t->restarts && !gsl_isnan(t->first + t->last)
               ? whole_turns(t, t->first, t->last)
               : 0;
}

double flk_followed_behind_gap(const flk_followed *t, const flk_follower *f)
{
    return t->turn > 0 && flk_crank_motion_is_periodic(&f->a->crank_motion) &&
                   !gsl_isnan(t->first + t->last)
               ? whole_turns(t, t->last, t->first)
               : 0;
}

double flk_followed_change(const flk_followed *t, double from, double to)
{
    double d = (to - from) / t->turn;

    return fabs(d - floor(d + 0.5));
}

/* Where a force passes through zero its direction jumps by half a turn. */
#define HALF_TURN (0.5 - 1e-6)

int flk_followed_turns_over(const flk_followed *t, double from, double to)
{
    return flk_followed_change(t, from, to) > HALF_TURN;
}
