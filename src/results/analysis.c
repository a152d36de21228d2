/* SPDX-License-Identifier: GPL-3.0-or-later
**
** analysis.c - analysis of a deck: all results at one crank position on one branch.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "analysis.h"
#include "mechanics/kind.h"

/* What can be computed for a deck. */
static int possible(const deck *d)
{
    int needs = NEED_DERIVED | (d->has_forces ? NEED_FORCES | NEED_SUPERPOSITION : 0) |
                (d->machine.first_gas < d->machine.n_loads ? NEED_GAS : 0) |
                (d->machine.has_friction ? NEED_LOSSES : 0) |
                (d->drive.mode != DRIVE_GIVEN ? NEED_ACTUAL : 0);
    fourlink_rod rod;
    int status = fourlink_rod_masses(&d->machine.mechanism, &rod);

    if (status == FOURLINK_NOT_AN_ENGINE)
        return needs;
    needs |= d->balance.is_there ? NEED_BALANCE : 0;
    return needs | NEED_KLEIN | (d->design.offset == 0 ? NEED_SERIES : 0) |
           (d->has_forces && status != FOURLINK_ROD_OFF_LINE ? NEED_ENGINE | NEED_GAS : 0);
}

/* The motion, unless it is given; 0 if out of memory. */
static int find_actual(flk_analysis *a)
{
    flk_course course;

    if (a->d->drive.mode == DRIVE_GIVEN)
        return 1;
    course.d = a->d;
    course.corners = a->corners;
    course.last = flk_analysis_end(a);
    course.period = flk_analysis_period(a->d);
    course.acting = &a->acting;
    course.winds = a->winds;
    a->actual = flk_actual_find(&course);
    return a->actual != NULL;
}

int flk_analysis_open(flk_analysis *a, const deck *d)
{
    const flk_element *spring;
    size_t i = 0;

    memset(a, 0, sizeof *a);
    a->d = d;
    a->possible = possible(d);
    flk_deck_range(d, &a->range); /* the deck's reader has checked it */
    for (; (spring = flk_machine_find(&d->machine, &flk_spring_sort, i)) != NULL; i++)
        a->winds |= flk_spring_winds(&d->machine.mechanism, spring->data, flk_analysis_period(d));
    a->acting.load = calloc(d->machine.n_loads + 1, sizeof *a->acting.load);
    a->corners = flk_corners_open(d);
    return a->acting.load != NULL && a->corners != NULL && find_actual(a);
}

void flk_analysis_close(flk_analysis *a)
{
    flk_actual_free(a->actual);
    free(a->acting.load);
    flk_corners_close(a->corners);
    free(a->turning_memory);
    memset(a, 0, sizeof *a);
}

/* The motion, and with `forces` loads and forces: a status. */
static int compute(flk_analysis *a, int needs, int forces, const fourlink_crank *crank,
                   fourlink_instant *at)
{
    const flk_machine *machine = &a->d->machine;
    int closed_form = a->is_fast || a->d->solver == SOLVER_DYAD;
    int status =
        fourlink_analyse_dyad(&machine->mechanism, at->branch, crank, NULL, 0, &at->state, NULL);

    if (status != FOURLINK_OK)
        return status;
    if (forces)
        status = flk_machine_forces(machine, &at->state, closed_form, &a->acting, &at->forces,
                                    &at->losses);
    else if (needs & (NEED_ENGINE | NEED_GAS))
        flk_machine_loads_at(machine, at->branch, crank->theta2, crank->omega2, &a->acting);
    at->gas_force = a->acting.gas_force;
    return status;
}

/* What textbooks derive. */
static int derive(flk_analysis *a, int needs, int forces, const fourlink_instant *at,
                  flk_derived *derived)
{
    const fourlink_mechanism *mechanism = &a->d->machine.mechanism;

    if (needs & NEED_DERIVED)
        flk_derive_from_motion(mechanism, &at->state, derived);
    if (needs & NEED_BALANCE)
        flk_derive_primary(mechanism, &at->state, a->d->balance.reciprocating, derived);
    if ((needs & NEED_DERIVED) && forces)
        flk_derive_from_forces(mechanism, &at->state, &at->forces, &a->acting, derived);
    if (needs & NEED_SUPERPOSITION)
        return flk_derive_superposition(mechanism, &at->state, a->acting.load,
                                        a->d->machine.n_loads, &at->forces, derived);
    return FOURLINK_OK;
}

void flk_analysis_at(flk_analysis *a, int needs, fourlink_branch branch,
                     const fourlink_crank *crank, flk_row *row)
{
    const flk_machine *machine = &a->d->machine;
    const fourlink_mechanism *mechanism = &machine->mechanism;
    int forces = (needs & (NEED_FORCES | NEED_SUPERPOSITION)) != 0 ||
                 (machine->needs_motion && (needs & NEED_ENGINE));
    fourlink_instant *at = &row->at;

    at->branch = branch;
    at->status = compute(a, needs, forces, crank, at);
    if (at->status == FOURLINK_OK && (needs & NEED_ENGINE))
        at->status = fourlink_engine_method(mechanism, &at->state, at->gas_force, a->acting.load,
                                            machine->first_gas, a->d->approximation, &row->engine);
    if (at->status == FOURLINK_OK && (needs & NEED_SERIES))
        at->status = fourlink_textbook_series(mechanism, &at->state, &row->series);
    if (at->status == FOURLINK_OK && (needs & NEED_KLEIN))
        at->status = fourlink_klein_construction(mechanism, &at->state, &row->klein);
    if (at->status == FOURLINK_OK)
        at->status = derive(a, needs, forces, at, &row->derived);
}

/* A row of the actual motion, or the reason why there is none. */
static void take_actual(flk_analysis *a, int needs, fourlink_branch branch, int status,
                        flk_row *row)
{
    row->at.row.crank = row->actual.crank;
    row->at.row.angle = row->actual.angle;
    row->at.row.time = row->actual.time;
    if (status != FOURLINK_OK)
        row->at.row.time = row->at.row.crank.omega2 = row->at.row.crank.alpha2 = FLK_UNDEFINED;
    if (status == FOURLINK_OK)
        flk_analysis_at(a, needs, branch, &row->at.row.crank, row);
    row->at.branch = branch;
    row->at.status = status != FOURLINK_OK ? status : row->at.status;
}

void flk_analysis_at_time(flk_analysis *a, int needs, fourlink_branch branch, double time,
                          flk_row *row)
{
    take_actual(a, needs, branch, flk_actual_at_time(a->actual, branch, time, &row->actual), row);
}

void flk_analysis_row(flk_analysis *a, int needs, fourlink_branch branch, unsigned long i,
                      flk_row *row)
{
    if (a->d->drive.by_time) {
        flk_analysis_at_time(a, needs, branch, flk_deck_time(a->d, i), row);
        return;
    }
    fourlink_motion_row(&a->d->motion, &a->range, i, &row->at.row);
    if (a->actual) {
        flk_analysis_at_angle(a, needs, branch, row->at.row.angle, row);
        return;
    }
    flk_analysis_at(a, needs, branch, &row->at.row.crank, row);
}

void flk_analysis_at_angle(flk_analysis *a, int needs, fourlink_branch branch, double angle,
                           flk_row *row)
{
    if (a->actual) {
        take_actual(a, needs, branch, flk_actual_at(a->actual, branch, angle, &row->actual), row);
        return;
    }
    fourlink_motion_at(&a->d->motion, angle, &row->at.row);
    flk_analysis_at(a, needs, branch, &row->at.row.crank, row);
}

double flk_analysis_end(const flk_analysis *a)
{
    fourlink_row last;

    if (a->d->drive.by_time)
        return a->d->motion.to;
    fourlink_motion_row(&a->d->motion, &a->range, a->range.n_rows - 1, &last);
    return a->range.stops ? a->range.stop_angle : last.angle;
}

double flk_analysis_period(const deck *d)
{
    double turns =
        d->machine.mechanism.change_stretched != d->machine.mechanism.change_folded ? 2 : 1;

    return d->machine.cycle > turns * 2 * M_PI ? d->machine.cycle : turns * 2 * M_PI;
}

int flk_analysis_stops(const flk_analysis *a, fourlink_branch branch)
{
    const flk_actual_facts *f = flk_actual_facts_of(a->actual, branch);

    return f && f->status == FOURLINK_TOO_LONG;
}

int flk_analysis_repeats(const flk_analysis *a)
{
    const fourlink_motion *motion = &a->d->motion;

    if (a->actual)
        return a->d->drive.mode == DRIVE_STEADY;
    return !a->winds && motion->run_up <= 0 && !a->range.stops &&
           (motion->acceleration == 0 || motion->hold);
}

int flk_analysis_is_periodic(const flk_analysis *a)
{
    const deck *d = a->d;

    return d->one_revolution && flk_analysis_repeats(a) &&
           d->machine.mechanism.change_stretched == d->machine.mechanism.change_folded;
}

int flk_analysis_find_angle(const flk_analysis *a, double angle, double *at)
{
    const fourlink_motion *motion = &a->d->motion;
    double turn = flk_analysis_period(a->d) / motion->angle_unit, tiny = 1e-9 * turn,
           end = flk_analysis_end(a);
    double first = motion->from < end ? motion->from : end,
           last = motion->from < end ? end : motion->from;

    *at = angle;
    if (a->d->drive.by_time)
        return 1; /* which angles it reaches depends on the branch */
    if (angle < first - tiny || angle > last + tiny)
        *at = angle + turn * ceil((first - tiny - angle) / turn);
    return first - tiny <= *at && *at <= last + tiny;
}
