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

#define SHORT 0.5 /* rad, of a piece of rows by time */

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
    return a->actual ? flk_actual_length(a->actual, branch) : whole_length(a);
}

double flk_pieces_end(const flk_analysis *a, fourlink_branch branch)
{
    if (a->d->drive.by_time)
        return flk_actual_time(a->actual, branch);
    return flk_pieces_length(a, branch) < whole_length(a)
               ? flk_actual_facts_of(a->actual, branch)->end_angle
               : flk_analysis_end(a);
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

static void find_corners(const flk_analysis *a, int has_loads, flk_corners *c)
{
    c->d = a->d;
    c->jumps = &a->jumps;
    c->sense = direction(a);
    c->has_loads = has_loads;
}

/* The next end behind `after`; without those of loads that of columns of the motion alone. */
static double next_end(const flk_analysis *a, double length, double period, double after,
                       int has_loads, flk_piece_end *end)
{
    double more[2], at;
    flk_corners c;

    find_corners(a, has_loads, &c);
    more[0] = a->d->motion.run_up * a->d->motion.angle_unit; /* 0 is passed */
    more[1] = period;
    at = flk_corners_next(&c, after, more, 2, end);
    if (at < length - FLK_CORNERS_CLOSE(length))
        return at;
    if (at > length + FLK_CORNERS_CLOSE(length))
        *end = FLK_END_PLAIN;
    *end = join(ending(a, length), *end);
    return length;
}

/* What is at the beginning of the motion. */
static flk_piece_end first_end(const flk_analysis *a)
{
    flk_corners c;

    find_corners(a, 1, &c);
    return join(beginning(a), flk_corners_first(&c));
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
    flk_piece_end end;

    if (!(piece->to < length))
        return 0;
    if (a->d->drive.by_time)
        return next_by_time(length, piece);
    piece->begin = piece->to > 0 ? piece->end : first_end(a);
    piece->from = piece->to;
    piece->to = next_end(a, length, period, piece->from, 1, &piece->end);
    if (piece->from >= piece->motion_to - FLK_CORNERS_CLOSE(length)) {
        piece->motion_from = piece->from;
        piece->motion_to = next_end(a, length, period, piece->from, a->actual != NULL, &end);
    }
    return 1;
}
