/* SPDX-License-Identifier: GPL-3.0-or-later
**
** crank_motion.c - the motion of a deck's crank, given or integrated: as a whole, and in pieces within which
** all columns are smooth.
**
** A piece ends where a load's curve or window has a corner, at dead positions and change points, where links
** lie in one line or nearly so, where a run-up ends, and where the crank is at rest.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "crank_motion.h"
#include "mechanics/kind.h"
#include "mechanics/spring.h"

#define SHORT 0.5 /* rad, of a piece of rows by time */

static double last_angle(const flk_crank_motion *c)
{
    fourlink_row last;

    if (c->d->mode.by_time)
        return c->d->motion.to;
    fourlink_motion_row(&c->d->motion, &c->range, c->range.n_rows - 1, &last);
    return c->range.stops ? c->range.stop_angle : last.angle;
}

static double period_of(const flk_machine *machine)
{
    const fourlink_mechanism *mechanism = &machine->mechanism;
    double turns = mechanism->change_stretched != mechanism->change_folded ? 2 : 1;

    return GSL_MAX(machine->cycle, turns * 2 * M_PI);
}

int flk_crank_motion_open(flk_crank_motion *c, const deck *d, flk_acting *acting,
                          flk_actual *actual)
{
    const flk_machine *machine = &d->machine;
    const flk_element *spring;
    size_t i = 0;

    memset(c, 0, sizeof *c);
    c->d = d;
    flk_deck_range(d, &c->range); /* checked by the deck reader */
    c->end = last_angle(c);
    c->period = period_of(machine);
    for (; (spring = flk_machine_find(machine, &flk_spring_type, i)) != NULL; i++)
        c->winds |= flk_spring_winds(&machine->mechanism, spring->data, c->period);
    c->corners = flk_corners_open(d);
    c->actual = actual;
    c->is_shared = actual != NULL;
    if (c->corners && !actual && d->mode.kind != MODE_GIVEN)
        c->actual = flk_actual_open(d, c->corners, acting, c->end, c->period, c->winds);
    return c->corners && (c->actual || d->mode.kind == MODE_GIVEN) &&
           (!d->open || flk_actual_prepare(c->actual, FOURLINK_OPEN) == FOURLINK_OK) &&
           (!d->crossed || flk_actual_prepare(c->actual, FOURLINK_CROSSED) == FOURLINK_OK);
}

void flk_crank_motion_close(flk_crank_motion *c)
{
    flk_actual_free(c->is_shared ? NULL : c->actual);
    flk_corners_close(c->corners);
}

int flk_crank_motion_stops(const flk_crank_motion *c, fourlink_branch branch)
{
    const flk_actual_facts *f = flk_actual_facts_of(c->actual, branch);

    return f && f->status == FOURLINK_TOO_LONG;
}

int flk_crank_motion_repeats(const flk_crank_motion *c)
{
    const fourlink_motion *motion = &c->d->motion;

    if (c->actual)
        return c->d->mode.kind == MODE_STEADY;
    return !c->winds && motion->run_up <= 0 && !c->range.stops &&
           (motion->acceleration == 0 || motion->hold);
}

int flk_crank_motion_is_periodic(const flk_crank_motion *c)
{
    const fourlink_mechanism *mechanism = &c->d->machine.mechanism;

    return c->d->one_revolution && flk_crank_motion_repeats(c) &&
           mechanism->change_stretched == mechanism->change_folded;
}

/* Larger angles have too few digits left after their turns. */
#define ANGLE_MAX 1e9 /* rad, as in decks */

int flk_crank_motion_find_angle(const flk_crank_motion *c, double angle, double *at)
{
    const fourlink_motion *motion = &c->d->motion;
    double turn = c->period / motion->angle_unit, tiny = 1e-9 * turn;
    double first = GSL_MIN(motion->from, c->end), last = GSL_MAX(motion->from, c->end);

    if (!FLK_WITHIN(angle * motion->angle_unit, ANGLE_MAX))
        return 0;
    *at = angle;
    if (c->d->mode.by_time)
        return 1; /* the angles that it reaches depend on the branch */
    if (angle < first - tiny || angle > last + tiny)
        *at = angle - turn * flk_cycle_count(angle + tiny - first, turn);
    return first - tiny <= *at && *at <= last + tiny;
}

static double whole_length(const flk_crank_motion *c)
{
    return fabs(c->end - c->d->motion.from) * c->d->motion.angle_unit;
}

double flk_crank_motion_length(const flk_crank_motion *c, fourlink_branch branch)
{
    return c->actual ? flk_actual_length(c->actual, branch) : whole_length(c);
}

double flk_crank_motion_end(const flk_crank_motion *c, fourlink_branch branch)
{
    if (c->d->mode.by_time)
        return flk_actual_time(c->actual, branch);
    return flk_crank_motion_length(c, branch) < whole_length(c)
               ? flk_actual_facts_of(c->actual, branch)->end_angle
               : c->end;
}

/* ---------------------------------------------------------------------------------------------- pieces */

static double direction(const flk_crank_motion *crank_motion)
{
    return crank_motion->end < crank_motion->d->motion.from ? -1 : 1;
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

static void find_direction(const flk_pieces *x, int has_loads, flk_direction *p)
{
    const fourlink_motion *motion = &x->crank_motion->d->motion;

    p->corners = x->crank_motion->corners;
    p->branch = x->branch;
    p->from = motion->from * motion->angle_unit;
    p->sense = direction(x->crank_motion);
    p->has_loads = has_loads;
}

/* The next end after `after`; without loads, the next end for columns of the motion alone. */
static double next_end(const flk_pieces *x, double after, int has_loads, flk_piece_end *end)
{
    const fourlink_motion *motion = &x->crank_motion->d->motion;
    double more[2], at;
    flk_direction p;

    find_direction(x, has_loads, &p);
    more[0] = motion->run_up * motion->angle_unit; /* 0 is passed */
    more[1] = x->period;
    at = flk_corners_next(&p, after, more, 2, end);
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
    flk_direction p;

    find_direction(x, 0, &p);
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
    if (x->crank_motion->d->mode.by_time)
        return next_by_time(x->length, piece);
    piece->begin = piece->to > 0 ? piece->end : first_end(x);
    piece->from = piece->to;
    piece->to = next_end(x, piece->from, x->has_loads, &piece->end);
    return 1;
}
