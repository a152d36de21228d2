/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pieces.c - the motion of a deck in pieces within which all columns are smooth.
**
** A piece ends where a load's curve or window has a corner, at dead positions and change points, where links
** lie in one line or nearly so, where a run-up ends, and where the crank is at rest.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "pieces.h"

#define SHORT 0.5 /* rad, of a piece of rows by time */

static double direction(const flk_crank_motion *crank_motion)
{
    return crank_motion->end < crank_motion->d->motion.from ? -1 : 1;
}

static double whole_length(const flk_crank_motion *crank_motion)
{
    return fabs(crank_motion->end - crank_motion->d->motion.from) *
           crank_motion->d->motion.angle_unit;
}

/* How the crank starts or ends: from rest, its speed grows as the root of the angle. */
static flk_piece_end end_of_motion(const flk_crank_motion *crank_motion, double angle)
{
    fourlink_row row;

    fourlink_motion_at(&crank_motion->d->motion, angle, &row);
    return row.crank.omega2 == 0 && row.crank.alpha2 != 0 && !crank_motion->d->motion.hold
               ? FLK_END_ROOT
               : FLK_END_PLAIN;
}

static flk_piece_end beginning(const flk_crank_motion *crank_motion)
{
    if (crank_motion->actual)
        return flk_actual_from_rest(crank_motion->d) ? FLK_END_ROOT : FLK_END_PLAIN;
    return end_of_motion(crank_motion, crank_motion->d->motion.from);
}

/* The end of the motion at a length; an actual motion that is shorter than its rows has stalled. */
static flk_piece_end ending(const flk_crank_motion *crank_motion, double length)
{
    if (crank_motion->actual)
        return length < whole_length(crank_motion) && !flk_crank_motion_repeats(crank_motion)
                   ? FLK_END_ROOT
                   : FLK_END_PLAIN;
    return end_of_motion(crank_motion, crank_motion->end);
}

/* Combine an end of the motion with that of its position. */
static flk_piece_end join(flk_piece_end of_motion, flk_piece_end of_position)
{
    if (of_position == FLK_END_CHANGE && of_motion == FLK_END_ROOT)
        return FLK_END_CHANGE_REST;
    return of_position == FLK_END_PLAIN ? of_motion : of_position;
}

/* The speed of the crank. */
static double speed_at(void *host, double passed)
{
    const flk_pieces *x = host;
    double angle = x->crank_motion->d->motion.from +
                   direction(x->crank_motion) * passed / x->crank_motion->d->motion.angle_unit;
    flk_actual_row actual;
    fourlink_row row;

    if (x->crank_motion->actual)
        return flk_actual_at(x->crank_motion->actual, x->branch, angle, &actual) == FOURLINK_OK
                   ? actual.crank.omega2
                   : GSL_NAN;
    fourlink_motion_at(&x->crank_motion->d->motion, angle, &row);
    return row.crank.omega2;
}

static void find_passage(const flk_pieces *x, int has_loads, flk_passage *p)
{
    const fourlink_motion *motion = &x->crank_motion->d->motion;

    p->corners = x->crank_motion->corners;
    p->branch = x->branch;
    p->from = motion->from * motion->angle_unit;
    p->sense = direction(x->crank_motion);
    p->has_loads = has_loads;
    p->speed = speed_at;
    p->host = (void *)x;
}

/* The next end after `after`; without loads, the next end for columns of the motion alone. */
static double next_end(const flk_pieces *x, double after, int has_loads, flk_piece_end *end)
{
    const fourlink_motion *motion = &x->crank_motion->d->motion;
    double more[2], at;
    flk_passage p;

    find_passage(x, has_loads, &p);
    more[0] = motion->run_up * motion->angle_unit; /* 0 is passed */
    more[1] = x->period;
    at = flk_corners_next(&p, after, x->length, more, 2, end);
    if (at < x->length - FLK_CORNERS_CLOSE(x->length))
        return at;
    if (at > x->length + FLK_CORNERS_CLOSE(x->length))
        *end = FLK_END_PLAIN;
    *end = join(ending(x->crank_motion, x->length), *end);
    return x->length;
}

/* The kind of end at the beginning of the motion. */
static flk_piece_end first_end(const flk_pieces *x)
{
    flk_passage p;

    find_passage(x, 0, &p);
    return join(beginning(x->crank_motion), flk_corners_first(&p));
}

/* Rows by time: corners are not known, so pieces are short. */
static int next_by_time(double length, flk_piece *piece)
{
    piece->begin = piece->end = FLK_END_PLAIN;
    piece->from = piece->to;
    piece->to = piece->from + 2 * SHORT < length ? piece->from + SHORT : length;
    return 1;
}

int flk_pieces_next(const flk_pieces *x, flk_piece *piece)
{
    if (!(piece->to < x->length))
        return 0;
    if (x->crank_motion->d->drive.by_time)
        return next_by_time(x->length, piece);
    piece->begin = piece->to > 0 ? piece->end : first_end(x);
    piece->from = piece->to;
    piece->to = next_end(x, piece->from, x->has_loads, &piece->end);
    return 1;
}
