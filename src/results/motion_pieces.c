/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motion_pieces.c - the motion of a deck in pieces within which all columns are smooth.
**
** A piece ends where a load's curve or window has a corner, at dead positions and change points, where links
** lie in one line or nearly so, where a run-up ends, and where the crank is at rest.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "motion_pieces.h"

/* Ends that are closer, in rad, are one. */
#define CLOSEST 1e-9
#define SHORT 0.5 /* rad, of a piece of rows by time */

typedef struct search {
    const flk_analysis *a;
    double after; /* rad passed: the next end behind this is wanted */
    double at;    /* the nearest so far, and what it is */
    flk_piece_end end;
} search;

static double direction(const flk_analysis *a)
{
    return flk_analysis_end(a) < a->d->motion.from ? -1 : 1;
}

static double whole_length(const flk_analysis *a)
{
    return fabs(flk_analysis_end(a) - a->d->motion.from) * a->d->motion.angle_unit;
}

double flk_pieces_length(const flk_analysis *a, fourlink_branch branch)
{
    return a->actual ? flk_actual_length(a, branch) : whole_length(a);
}

double flk_pieces_end(const flk_analysis *a, fourlink_branch branch)
{
    if (a->d->drive.by_time)
        return flk_actual_time(a, branch);
    return flk_pieces_length(a, branch) < whole_length(a)
               ? flk_actual_facts_of(a, branch)->end_angle
               : flk_analysis_end(a);
}

static void offer(search *s, double passed, flk_piece_end end)
{
    double closest = CLOSEST + 1e-14 * passed;

    if (passed <= s->after + closest)
        return;
    if (passed < s->at - closest)
        s->at = passed;
    else if (passed > s->at + closest || end < s->end)
        return;
    s->end = end;
}

/* An end at this crank angle and all that are whole periods away. */
static void offer_angle(search *s, double theta2, double period, flk_piece_end end)
{
    double from = s->a->d->motion.from * s->a->d->motion.angle_unit;
    double passed = direction(s->a) * (theta2 - from);

    offer(s, passed + period * ceil((s->after + CLOSEST + 1e-14 * s->after - passed) / period),
          end);
}

static void offer_curve(search *s, const curve *c)
{
    size_t i;

    for (i = 0; i < c->n; i++)
        offer_angle(s, c->x[i], s->a->d->cycle, FLK_END_PLAIN);
}

static void offer_loads(search *s)
{
    const deck *d = s->a->d;
    unsigned long i;

    offer_curve(s, &d->gas.indicator);
    for (i = 0; i < d->n_loads; i++) {
        if (d->variations[i].law.over)
            continue; /* jumps.c */
        offer_curve(s, &d->variations[i].law.back_torque);
        offer_curve(s, &d->variations[i].law.back_force[0]);
        offer_curve(s, &d->variations[i].torque);
        offer_curve(s, &d->variations[i].force[0]);
        if (d->variations[i].is_windowed) {
            offer_angle(s, d->variations[i].from, d->cycle, FLK_END_PLAIN);
            offer_angle(s, d->variations[i].to, d->cycle, FLK_END_PLAIN);
        }
    }
}

/* Dead positions are the ends of the reachable ranges; change points are where a range could end, at 0 and
** 180 deg or at +-90 deg, as are the positions that come near to one line. */
static void offer_positions(search *s)
{
    const fourlink_mechanism *mechanism = &s->a->d->mechanism;
    double line = fourlink_slides((int)mechanism->design.kind, FOURLINK_FOLLOWER) ? -M_PI_2 : 0;
    fourlink_reach reach;
    int i;

    fourlink_reach_of(mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++)
        if (reach.to[i] - reach.from[i] < 2 * M_PI * (1 - 1e-15)) {
            offer_angle(s, reach.from[i], 2 * M_PI, FLK_END_DEAD);
            offer_angle(s, reach.to[i], 2 * M_PI, FLK_END_DEAD);
        }
    offer_angle(s, line, 2 * M_PI, mechanism->change_folded ? FLK_END_CHANGE : FLK_END_PLAIN);
    offer_angle(s, line + M_PI, 2 * M_PI,
                mechanism->change_stretched ? FLK_END_CHANGE : FLK_END_PLAIN);
}

/* How the crank starts or ends: at rest it speeds up as the root of the angle. */
static flk_piece_end end_of_motion(const flk_analysis *a, double angle)
{
    fourlink_row row;

    fourlink_motion_at(&a->d->motion, angle, &row);
    return row.crank.omega2 == 0 && row.crank.alpha2 != 0 && !a->d->motion.hold ? FLK_END_ROOT
                                                                                : FLK_END_PLAIN;
}

static flk_piece_end beginning(const flk_analysis *a)
{
    if (a->actual)
        return flk_actual_from_rest(a->d) ? FLK_END_ROOT : FLK_END_PLAIN;
    return end_of_motion(a, a->d->motion.from);
}

/* The end at a length; an actual motion that is shorter than its rows stalls. */
static flk_piece_end ending(const flk_analysis *a, double length)
{
    if (a->actual)
        return length < whole_length(a) && !flk_analysis_repeats(a) ? FLK_END_ROOT : FLK_END_PLAIN;
    return end_of_motion(a, flk_analysis_end(a));
}

/* An end of the motion at a position that has an end of its own. */
static flk_piece_end join(flk_piece_end of_motion, flk_piece_end of_position)
{
    if (of_position == FLK_END_CHANGE && of_motion == FLK_END_ROOT)
        return FLK_END_CHANGE_REST;
    return of_position == FLK_END_PLAIN ? of_motion : of_position;
}

/* The next end behind `after`. */
static double next_end(const flk_analysis *a, double length, double period, double after,
                       flk_piece_end *end)
{
    search s;
    size_t i;

    s.a = a;
    s.after = after;
    s.at = GSL_POSINF;
    s.end = FLK_END_NOWHERE;
    offer_loads(&s);
    offer_positions(&s);
    for (i = 0; i < a->jumps.n; i++)
        offer_angle(&s, a->jumps.theta2[i], a->jumps.period, FLK_END_PLAIN);
    if (a->d->motion.run_up > 0)
        offer(&s, a->d->motion.run_up * a->d->motion.angle_unit, FLK_END_PLAIN);
    offer(&s, period, FLK_END_PLAIN);
    if (s.at >= length - CLOSEST - 1e-14 * length) {
        *end = s.at <= length + CLOSEST + 1e-14 * length ? s.end : FLK_END_PLAIN;
        *end = join(ending(a, length), *end);
        return length;
    }
    *end = s.end;
    return s.at;
}

/* What is at the beginning of the motion. */
static flk_piece_end first_end(const flk_analysis *a)
{
    search s;

    s.a = a;
    s.after = -3 * CLOSEST;
    s.at = 2 * CLOSEST;
    s.end = FLK_END_PLAIN;
    offer_positions(&s);
    return join(beginning(a), s.at > CLOSEST ? FLK_END_PLAIN : s.end);
}

/* Rows by time: corners are not known, so pieces are short. */
static int next_by_time(double length, flk_piece *piece)
{
    piece->begin = piece->end = FLK_END_PLAIN;
    piece->from = piece->to;
    piece->to = piece->from + 2 * SHORT < length ? piece->from + SHORT : length;
    return 1;
}

int flk_pieces_next(const flk_analysis *a, double length, double period, flk_piece *piece)
{
    if (piece->to >= length)
        return 0;
    if (a->d->drive.by_time)
        return next_by_time(length, piece);
    piece->begin = piece->to > 0 ? piece->end : first_end(a);
    piece->from = piece->to;
    piece->to = next_end(a, length, period, piece->from, &piece->end);
    return 1;
}
