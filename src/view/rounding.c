/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rounding.c - what is rounding error, of a row, an extreme, a motion.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/scale.h"
#include "rounding.h"
#include "system/format.h"

/* Near a dead position rounding error grows with the condition number 1 / sin(mu); FORMAT_ROUNDING is so
** much larger than that of a number that smaller ones do not matter.  In the position itself the input
** gives the motion. */
#define CONDITION 1000

static double growth_of(const fourlink_state *state)
{
    double sine = state->sine == 0 ? 1 : fabs(state->sine);

    return GSL_MAX_DBL(1, 1 / (CONDITION * GSL_MIN_DBL(sine, state->group_sine)));
}

/* The deck's loads, with `all` of friction too, which comes last. */
static unsigned long count_loads(const view *v, int all)
{
    return v->problem.n_loads - (all ? 0 : FOURLINK_FRICTION_LOADS);
}

/* Loads, weights, and mass times acceleration; with `all` pin forces and friction, too. */
static double largest_force(const view *v, const fourlink_instant *now, const fourlink_load *loads,
                            int all)
{
    double largest = 0, x[9];
    fourlink_body body[FOURLINK_LINKS];
    unsigned long k;
    int i;

    fourlink_unknowns(v->mechanism, &now->forces, x);
    for (i = 0; all && i < 8; i++)
        flk_scale_take(&largest, x[i]);
    fourlink_bodies(v->mechanism, &now->state, NULL, 0, body);
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        const fourlink_body *b = &body[i];

        flk_scale_take(&largest,
                       v->design->link[i].mass * gsl_hypot(b->acceleration.x, b->acceleration.y));
        flk_scale_take(&largest, gsl_hypot(b->weight.x, b->weight.y));
    }
    for (k = 0; loads && k < count_loads(v, all); k++)
        flk_scale_take(&largest, gsl_hypot(loads[k].force.x, loads[k].force.y));
    return largest;
}

static void find_sizes(const view *v, const fourlink_instant *now, const fourlink_load *loads,
                       int all, double sizes[QUANTITY_COUNT])
{
    flk_scale scale = {0, 0, 0, 0};
    double growth = growth_of(&now->state);
    unsigned long k;
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        flk_scale_take(&scale.length, v->design->link[i].length);
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        const fourlink_link_state *link = &now->state.link[i];

        flk_scale_take(&scale.speed, link->omega);
        flk_scale_take(&scale.acceleration, link->alpha);
        flk_scale_take(&scale.acceleration, link->omega * link->omega);
    }
    if (v->problem.has_forces)
        scale.force = largest_force(v, now, loads, all);
    for (i = 0; i < QUANTITY_COUNT; i++)
        sizes[i] = growth * flk_scale_of(&scale, (quantity)i);
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER && v->problem.has_forces; i++)
        flk_scale_take(&sizes[QUANTITY_TORQUE],
                       v->design->link[i].inertia * now->state.link[i].alpha);
    for (k = 0; loads && k < count_loads(v, all); k++)
        flk_scale_take(&sizes[QUANTITY_TORQUE], loads[k].torque);
    flk_scale_take(&sizes[QUANTITY_POWER], sizes[QUANTITY_TORQUE] * scale.speed);
}

void view_find_sizes(const view *v, const fourlink_instant *now, const fourlink_load *loads,
                     double sizes[QUANTITY_COUNT])
{
    find_sizes(v, now, loads, 1, sizes);
}

/* The same for a column.  Beside a lock pin forces have no bound: they say nothing of the rounding error of a
** column that has no friction in it. */
static double size_of(const view *v, const fourlink_value *column, const fourlink_instant *now,
                      const fourlink_load *loads)
{
    double sizes[QUANTITY_COUNT], own;
    quantity q = flk_quantity_find(column->quantity);
    int has_friction =
        column->flags & FOURLINK_OF_FORCES && !(column->flags & FOURLINK_FRICTIONLESS);

    if (fourlink_results_size(v->results, column->handle, now, &own) == FOURLINK_OK)
        return growth_of(&now->state) * own;
    find_sizes(v, now, loads, has_friction || !v->problem.has_friction, sizes);
    return view_value(v, q, sizes[q]);
}

void view_settle_row(const view *v, const fourlink_instant *now, const fourlink_load *loads,
                     double *values)
{
    unsigned long j;

    for (j = 0; j < v->n_columns; j++)
        if (!(v->columns[j].flags & (FOURLINK_OF_ROUNDING | FOURLINK_CRANK_ANGLE)))
            values[j] = format_settled(values[j], size_of(v, &v->columns[j], now, loads));
}

double view_rounding(const view *v, const char *of, double omega)
{
    static const struct {
        quantity q;
        int is_length, power; /* omega^power, times the length of the crank */
    } measures[] = {{QUANTITY_ANGULAR_SPEED, 0, 1},
                    {QUANTITY_ANGULAR_ACCELERATION, 0, 2},
                    {QUANTITY_SPEED, 1, 1},
                    {QUANTITY_ACCELERATION, 1, 2}};
    double length = v->design->link[FOURLINK_CRANK].length, size;
    size_t i;

    for (i = 0; i < sizeof measures / sizeof measures[0]; i++)
        if (strcmp(of, flk_quantities[measures[i].q].name) == 0) {
            size = pow(omega, measures[i].power) * (measures[i].is_length ? length : 1);
            return FORMAT_ROUNDING * fabs(view_value(v, measures[i].q, size));
        }
    return 0;
}

/* 1 if an extreme is rounding error beside the values of its row. */
static int is_rounding(const view *v, const fourlink_value *x)
{
    fourlink_load loads[VIEW_LOADS];
    int is_few = v->problem.n_loads <= VIEW_LOADS;
    fourlink_instant now;

    if (!x->has_angle || fourlink_results_at(v->results, (fourlink_branch)x->branch, x->angle, NULL,
                                             &now, is_few ? loads : NULL) != FOURLINK_OK)
        return 0;
    return format_settled(x->value, size_of(v, x, &now, is_few ? loads : NULL)) == 0;
}

fourlink_value view_settled(const view *v, const fourlink_value *extreme)
{
    fourlink_value x = *extreme;

    if (x.value != 0 && ((v->problem.mode == FOURLINK_MODE_GIVEN &&
                          fabs(x.value) < view_rounding(v, x.quantity, v->problem.motion.speed)) ||
                         is_rounding(v, &x))) {
        x.value = 0;
        x.has_angle = 0;
    }
    return x;
}

double view_torque_rounding(const view *v, const fourlink_forces *forces)
{
    if (v->problem.mode == FOURLINK_MODE_GIVEN)
        return 0;
    return FORMAT_ROUNDING * v->design->link[FOURLINK_CRANK].length *
           gsl_hypot(forces->F12x, forces->F12y);
}

double view_driving_torque(const view *v, const fourlink_forces *forces)
{
    return fabs(forces->Ts) < view_torque_rounding(v, forces) ? 0 : forces->Ts;
}
