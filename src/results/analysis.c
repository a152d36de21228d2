/* SPDX-License-Identifier: GPL-3.0-or-later
**
** analysis.c - analysis of a deck: all results at one crank position on one branch.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "analysis.h"
#include "deck/synthesis.h"
#include "deck/found.h"
#include "mechanics/kind.h"
#include "mechanics/mechanism.h"

/* There is no time for a crank at rest, or for one held at a speed and an acceleration. */
static int has_time(const deck *d)
{
    const fourlink_motion *motion = &d->motion;

    if (d->drive.mode != DRIVE_GIVEN)
        return 1;
    return motion->acceleration != 0 ? !motion->hold : motion->speed != 0;
}

/* What can be computed for a deck. */
static int possible(const deck *d)
{
    int needs = NEED_DERIVED | NEED_ANGLES | (has_time(d) ? NEED_TIME : 0) |
                (d->has_forces ? NEED_FORCES | NEED_SUPERPOSITION : 0) |
                (flk_machine_count(&d->machine, &flk_gas_type) ? NEED_GAS : 0) |
                (d->machine.has_friction ? NEED_LOSSES | NEED_RUBBING : 0) |
                (d->drive.mode != DRIVE_GIVEN ? NEED_ACTUAL : 0) |
                (d->synthesis && d->synthesis->function.wanted ? NEED_WANTED : 0);
    fourlink_rod rod;
    int status = fourlink_rod_masses(&d->machine.mechanism, &rod);

    if (status == FOURLINK_NOT_AN_ENGINE)
        return needs;
    needs |= d->balance.is_there ? NEED_BALANCE : 0;
    return needs | NEED_KLEIN | (d->machine.mechanism.design.offset == 0 ? NEED_SERIES : 0) |
           (d->has_forces && status != FOURLINK_ROD_OFF_LINE ? NEED_ENGINE | NEED_GAS : 0);
}

int flk_analysis_open(flk_analysis *a, const deck *d)
{
    memset(a, 0, sizeof *a);
    a->d = d;
    a->possible = possible(d);
    a->acting.load = calloc(d->machine.n_loads + 1, sizeof *a->acting.load);
    return a->acting.load && flk_crank_motion_open(&a->crank_motion, d, &a->acting);
}

void flk_analysis_close(flk_analysis *a)
{
    flk_crank_motion_close(&a->crank_motion);
    free(a->acting.load);
    free(a->turning_memory);
    memset(a, 0, sizeof *a);
}

/* Compute the motion, and with `forces` the loads and forces; returns a status. */
static int compute(flk_analysis *a, int needs, int forces, const fourlink_crank *crank,
                   fourlink_instant *at)
{
    const flk_machine *machine = &a->d->machine;
    int closed_form = a->is_fast || a->d->solver == SOLVER_DYAD;
    int angles = machine->needs_angles || (needs & NEED_ANGLES);
    int status = flk_mechanism_move(&machine->mechanism, at->branch, crank, angles, &at->state);

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

/* Compute what textbooks derive. */
static int derive(flk_analysis *a, int needs, int forces, const fourlink_crank *crank,
                  const fourlink_instant *at, flk_derived *derived)
{
    const fourlink_mechanism *mechanism = &a->d->machine.mechanism;

    if (needs & NEED_DERIVED)
        flk_derive_from_motion(mechanism, &at->state, derived);
    if (needs & NEED_RUBBING)
        flk_derive_rubbing(mechanism, &at->state, a->d->pin_radius, derived);
    if (needs & NEED_WANTED)
        derived->structural_error = at->branch == a->d->synthesis->chosen->branch
                                        ? flk_synthesis_error(a->d->synthesis, crank->theta2)
                                        : FLK_UNDEFINED;
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
    if (at->status == FOURLINK_OK && (needs & NEED_ENGINE)) {
        at->status = fourlink_engine_method(mechanism, &at->state, 0, a->acting.load,
                                            machine->n_loads, a->d->approximation, &row->engine);
        row->engine.gas_force = at->gas_force; /* which is among the loads */
    }
    if (at->status == FOURLINK_OK && (needs & NEED_SERIES))
        at->status = fourlink_textbook_series(mechanism, &at->state, &row->series);
    if (at->status == FOURLINK_OK && (needs & NEED_KLEIN))
        at->status = fourlink_klein_construction(mechanism, &at->state, &row->klein);
    if (at->status == FOURLINK_OK)
        at->status = derive(a, needs, forces, crank, at, &row->derived);
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
    take_actual(a, needs, branch,
                flk_actual_at_time(a->crank_motion.actual, branch, time, &row->actual), row);
}

void flk_analysis_row(flk_analysis *a, int needs, fourlink_branch branch, unsigned long i,
                      flk_row *row)
{
    if (a->d->drive.by_time) {
        flk_analysis_at_time(a, needs, branch, flk_deck_time(a->d, i), row);
        return;
    }
    fourlink_motion_row(&a->d->motion, &a->crank_motion.range, i, &row->at.row);
    if (a->crank_motion.actual) {
        flk_analysis_at_angle(a, needs, branch, row->at.row.angle, row);
        return;
    }
    flk_analysis_at(a, needs, branch, &row->at.row.crank, row);
}

void flk_analysis_at_angle(flk_analysis *a, int needs, fourlink_branch branch, double angle,
                           flk_row *row)
{
    if (a->crank_motion.actual) {
        take_actual(a, needs, branch,
                    flk_actual_at(a->crank_motion.actual, branch, angle, &row->actual), row);
        return;
    }
    fourlink_motion_at(&a->d->motion, angle, &row->at.row);
    flk_analysis_at(a, needs, branch, &row->at.row.crank, row);
}
