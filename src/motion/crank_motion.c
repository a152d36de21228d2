/* SPDX-License-Identifier: GPL-3.0-or-later
**
** crank_motion.c - the motion of a deck's crank, given or integrated, as a whole.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "crank_motion.h"
#include "mechanics/kind.h"

static double last_angle(const flk_crank_motion *c)
{
    fourlink_row last;

    if (c->d->drive.by_time)
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

int flk_crank_motion_open(flk_crank_motion *c, const deck *d, flk_acting *acting)
{
    const flk_machine *machine = &d->machine;
    const flk_element *spring;
    size_t i = 0;

    memset(c, 0, sizeof *c);
    c->d = d;
    flk_deck_range(d, &c->range); /* checked by the deck reader */
    c->end = last_angle(c);
    c->period = period_of(machine);
    for (; (spring = flk_machine_find(machine, &flk_spring_sort, i)) != NULL; i++)
        c->winds |= flk_spring_winds(&machine->mechanism, spring->data, c->period);
    c->corners = flk_corners_open(d);
    if (c->corners && d->drive.mode != DRIVE_GIVEN)
        c->actual = flk_actual_find(d, c->corners, acting, c->end, c->period, c->winds);
    return c->corners && (c->actual || d->drive.mode == DRIVE_GIVEN);
}

void flk_crank_motion_close(flk_crank_motion *c)
{
    flk_actual_free(c->actual);
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
        return c->d->drive.mode == DRIVE_STEADY;
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
    if (c->d->drive.by_time)
        return 1; /* the angles that it reaches depend on the branch */
    if (angle < first - tiny || angle > last + tiny)
        *at = angle + turn * ceil((first - tiny - angle) / turn);
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
    if (c->d->drive.by_time)
        return flk_actual_time(c->actual, branch);
    return flk_crank_motion_length(c, branch) < whole_length(c)
               ? flk_actual_facts_of(c->actual, branch)->end_angle
               : c->end;
}
