/* SPDX-License-Identifier: GPL-3.0-or-later
**
** view.c - what of a deck is to be shown.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "view.h"

/* The last crank angle of a motion, in its unit. */
static double end_of(const fourlink_motion *motion, const fourlink_range *range)
{
    fourlink_row last;

    fourlink_motion_row(motion, range, range->n_rows - 1, &last);
    return range->stops ? range->stop_angle : last.angle;
}

void view_take(view *v, fourlink_results *results)
{
    int q;

    memset(v, 0, sizeof *v);
    v->results = results;
    v->deck = fourlink_results_deck(results);
    fourlink_deck_problem(v->deck, &v->problem);
    v->mechanism = &v->problem.mechanism;
    v->design = &v->mechanism->design;
    fourlink_kind_of((int)v->design->kind, &v->kind);
    if (v->problem.open)
        v->branches[v->n_branches++] = FOURLINK_OPEN;
    if (v->problem.crossed)
        v->branches[v->n_branches++] = FOURLINK_CROSSED;
    fourlink_motion_range(&v->problem.motion, &v->range);
    v->end = end_of(&v->problem.motion, &v->range);
    v->range.n_rows = v->problem.n_rows;
    for (q = 0; q < QUANTITY_COUNT; q++)
        fourlink_deck_unit(v->deck, flk_quantities[q].name, &v->units[q]);
    fourlink_results_list(results, FOURLINK_COLUMNS, &v->columns, &v->n_columns);
}

int view_reopen(const fourlink_source *source, const char *origin, const char *const *further,
                int n, fourlink_results **results, fourlink_mistake *mistake)
{
    fourlink_change *changes = malloc((source->n_changes + 2) * sizeof *changes);
    fourlink_source other = *source;
    int status, i;

    if (!changes)
        return FOURLINK_NO_MEMORY;
    if (source->n_changes)
        memcpy(changes, source->changes, source->n_changes * sizeof *changes);
    for (i = 0; i < n; i++) {
        changes[other.n_changes].origin = origin;
        changes[other.n_changes++].assignment = further[i];
    }
    other.changes = changes;
    other.whole_cycle = 1;
    status = fourlink_results_open(&other, 1, results, mistake, NULL);
    free(changes);
    return status;
}

int view_read(const view *v, quantity q, text value, text words, double *number,
              char message[MESSAGE_SIZE])
{
    quantity_value read;
    unit own;

    own.up = v->units[q].up;
    own.down = v->units[q].down;
    own.dim = flk_quantities[q].dim;
    if (!flk_quantity_read(value, words, q, own, &read, message))
        return 0;
    *number = flk_unit_from_si(read.si, own);
    return 1;
}

double view_value(const view *v, quantity q, double si)
{
    return si * v->units[q].down / v->units[q].up;
}

double view_si(const view *v, quantity q, double value)
{
    return value * v->units[q].up / v->units[q].down;
}

double view_torque_rounding(const view *v, const fourlink_forces *forces)
{
    if (v->problem.mode == FOURLINK_MODE_GIVEN)
        return 0;
    return 1e-12 * v->design->link[FOURLINK_CRANK].length * gsl_hypot(forces->F12x, forces->F12y);
}

double view_driving_torque(const view *v, const fourlink_forces *forces)
{
    return fabs(forces->Ts) < view_torque_rounding(v, forces) ? 0 : forces->Ts;
}
