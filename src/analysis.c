/* SPDX-License-Identifier: GPL-3.0-or-later
**
** analysis.c - a deck at work: all that is known of one crank position on one branch.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "analysis.h"

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
    if (d->n_loads)
        memcpy(a->loads, d->loads, d->n_loads * sizeof *d->loads);
    return fourlink_motion_range(&d->motion, &a->range) == FOURLINK_OK; /* deck_read has tried it */
}

void analysis_close(analysis *a)
{
    free(a->loads);
    memset(a, 0, sizeof *a);
}

/* The force of the gas on the piston, towards the crank positive: p1 A1 - p2 A2 (ME3491). */
static double gas_force(const deck_gas *gas, double theta2)
{
    double p1 = gas->indicator.n ? curve_value(&gas->indicator, theta2) : gas->pressure;

    return p1 * gas->area - gas->back_pressure * gas->back_area;
}

/* A load at this crank angle: its curve is followed, and outside its window it is nothing. */
static void set_load(const fourlink_load *load, const deck_load *variation, double cycle,
                     double theta2, fourlink_load *now)
{
    if (variation->is_windowed) {
        double after = theta2 - variation->from;

        after -= cycle * floor(after / cycle + 1e-12);
        if (after > variation->to - variation->from + 1e-12 * cycle) {
            now->force.x = now->force.y = now->torque = 0;
            return;
        }
        now->force = load->force;
        now->torque = load->torque;
    }
    if (variation->torque.n)
        now->torque = curve_value(&variation->torque, theta2);
}

/* The loads at this crank angle: curves are followed, and the gas pushes the piston from its side. */
static double set_loads(analysis *a, fourlink_branch branch, double theta2)
{
    unsigned long i;
    double gas = 0;

    for (i = 0; i < a->d->n_loads; i++)
        set_load(&a->d->loads[i], &a->d->variations[i], a->d->cycle, theta2, &a->loads[i]);
    if (a->n_loads > a->d->n_loads) {
        fourlink_load *load = &a->loads[a->d->n_loads];

        gas = gas_force(&a->d->gas, theta2);
        load->link = FOURLINK_FOLLOWER;
        load->force.x = -(double)branch * gas;
    }
    return gas;
}

void analysis_at(analysis *a, fourlink_branch branch, const fourlink_crank *crank, result *r)
{
    const fourlink_mechanism *mechanism = &a->d->mechanism;
    double gas = 0;
    int forces = (a->needs & (NEED_FORCES | NEED_SUPERPOSITION)) != 0;

    if (forces || (a->needs & NEED_ENGINE))
        gas = set_loads(a, branch, crank->theta2);
    r->branch = branch;
    r->status = fourlink_analyse(mechanism, branch, crank, a->loads, a->n_loads, &r->state,
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
