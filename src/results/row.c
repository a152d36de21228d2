/* SPDX-License-Identifier: GPL-3.0-or-later
**
** row.c - a deck at work: all that is known of one crank position on one branch.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "row.h"

const char *branch_name(fourlink_branch branch)
{
    return branch == FOURLINK_OPEN ? "open" : "crossed";
}

int analysis_possible(const deck *d)
{
    int slider_crank = d->design.kind == FOURLINK_SLIDER_CRANK;
    fourlink_rod rod;

    return (d->has_forces ? NEED_FORCES : 0) |
           (slider_crank && d->has_forces && fourlink_rod_masses(&d->mechanism, &rod) == FOURLINK_OK
                ? NEED_ENGINE
                : 0) |
           (slider_crank && d->design.offset == 0 ? NEED_SERIES : 0) |
           (slider_crank ? NEED_KLEIN : 0) | NEED_EXTRAS | (d->has_forces ? NEED_SUPERPOSITION : 0);
}

int analysis_open(analysis *a, const deck *d, int needs)
{
    memset(a, 0, sizeof *a);
    a->d = d;
    a->needs = needs;
    a->n_loads = d->n_loads + (d->gas.area > 0 ? 1 : 0);
    a->loads = calloc(a->n_loads + 1, sizeof *a->loads);
    if (!a->loads)
        return 0;
    return fourlink_motion_range(&d->motion, &a->range) == FOURLINK_OK; /* deck_read has tried it */
}

void analysis_close(analysis *a)
{
    free(a->loads);
    memset(a, 0, sizeof *a);
}

void analysis_at(analysis *a, fourlink_branch branch, const fourlink_crank *crank, result *r)
{
    const fourlink_mechanism *mechanism = &a->d->mechanism;
    int (*analyse)(const fourlink_mechanism *, fourlink_branch, const fourlink_crank *,
                   const fourlink_load *, unsigned long, fourlink_state *, fourlink_forces *) =
        a->d->solver == SOLVER_DYAD ? fourlink_analyse_dyad : fourlink_analyse;
    double gas = 0;
    int forces = (a->needs & (NEED_FORCES | NEED_SUPERPOSITION)) != 0;

    r->branch = branch;
    r->status = FOURLINK_OK;
    if (forces || (a->needs & NEED_ENGINE))
        r->status = fourlink_deck_loads(a->d, branch, crank->theta2, a->loads, &gas);
    if (r->status == FOURLINK_OK)
        r->status = analyse(mechanism, branch, crank, a->loads, a->n_loads, &r->state,
                            forces ? &r->forces : NULL);
    if (r->status == FOURLINK_OK && (a->needs & NEED_ENGINE))
        r->status = fourlink_engine_method(mechanism, &r->state, gas, a->loads, a->d->n_loads,
                                           a->d->approximation, &r->engine);
    if (r->status == FOURLINK_OK && (a->needs & NEED_SERIES))
        r->status = fourlink_textbook_series(mechanism, &r->state, &r->series);
    if (r->status == FOURLINK_OK && (a->needs & NEED_KLEIN))
        r->status = fourlink_klein_construction(mechanism, &r->state, &r->klein);
    if (r->status == FOURLINK_OK && (a->needs & NEED_EXTRAS))
        extras_of_motion(mechanism, &r->state, &r->extras);
    if (r->status == FOURLINK_OK && (a->needs & NEED_EXTRAS) && forces)
        extras_of_forces(mechanism, &r->state, &r->forces, &r->extras);
    if (r->status == FOURLINK_OK && (a->needs & NEED_SUPERPOSITION))
        r->status = extras_superposition(mechanism, &r->state, a->loads, a->n_loads, &r->forces,
                                         &r->extras);
}

void analysis_row(analysis *a, fourlink_branch branch, unsigned long i, result *r)
{
    fourlink_motion_row(&a->d->motion, &a->range, i, &r->row);
    analysis_at(a, branch, &r->row.crank, r);
}

double analysis_end(const analysis *a)
{
    fourlink_row last;

    fourlink_motion_row(&a->d->motion, &a->range, a->range.n_rows - 1, &last);
    return a->range.stops ? a->range.stop_angle : last.angle;
}

int analysis_is_periodic(const analysis *a)
{
    const deck *d = a->d;

    return d->one_revolution && d->motion.run_up <= 0 && !a->range.stops &&
           (d->motion.acceleration == 0 || d->motion.hold) &&
           d->mechanism.change_stretched == d->mechanism.change_folded;
}

void analysis_spread(const analysis *a, int k, int steps, fourlink_row *row)
{
    double from = a->d->motion.from;

    fourlink_motion_at(&a->d->motion, from + (analysis_end(a) - from) * k / steps, row);
}

/* The angle after which all is as before: that of the cycle, a turn at least, and two where one change
** point lets the links come back on the other side. */
static double period(const deck *d)
{
    double turns = d->mechanism.change_stretched != d->mechanism.change_folded ? 2 : 1;

    return d->cycle > turns * 2 * M_PI ? d->cycle : turns * 2 * M_PI;
}

int analysis_find_angle(const analysis *a, double angle, double *at)
{
    const fourlink_motion *motion = &a->d->motion;
    double turn = period(a->d) / motion->angle_unit, tiny = 1e-9 * turn, end = analysis_end(a);
    double first = motion->from < end ? motion->from : end,
           last = motion->from < end ? end : motion->from;

    *at = angle;
    if (angle < first - tiny || angle > last + tiny)
        *at = angle + turn * ceil((first - tiny - angle) / turn);
    return *at <= last + tiny;
}
