/* SPDX-License-Identifier: GPL-3.0-or-later
**
** instant.c - any instant of a path: within the steps that path.c made.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "path.h"

#define ROUNDING 1e-9 /* rad */

const flk_node *flk_path_end(const flk_path *p)
{
    return &p->node[p->n - 1];
}

/* The last node at or before a value of an increasing unknown; -1: the time. */
static const flk_node *node_before(const flk_path *p, int i, double value)
{
    size_t low = 0, high = p->n;

    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        const flk_node *node = &p->node[middle];

        if ((i < 0 ? node->t : node->y[i]) <= value)
            low = middle;
        else
            high = middle;
    }
    return &p->node[low];
}

/* The first step in which a swinging crank passes s, to rounding; null if it does not. */
static const flk_node *step_to(const flk_path *p, double s)
{
    const flk_node *node, *close = NULL;

    for (node = p->node; node + 1 < p->node + p->n; node++) {
        double from = node->y[FLK_PASSED], to = node[1].y[FLK_PASSED];
        double low = GSL_MIN(from, to), high = GSL_MAX(from, to);

        if (low <= s && s <= high)
            return node;
        if (!close && low - ROUNDING <= s && s <= high + ROUNDING)
            close = node;
    }
    return close;
}

/* The state after s within the step that begins at a node. */
static void node_at_angle(const flk_node *node, double s, flk_node *at)
{
    double change = s - node->y[FLK_PASSED], whole, part, most;

    *at = *node;
    if (node->h == 0)
        return;
    whole = node[1].y[FLK_PASSED] - node->y[FLK_PASSED];
    change = GSL_MAX(GSL_MIN(change, GSL_MAX(0, whole)), GSL_MIN(0, whole));
    if (change == 0)
        return;
    most = (node[1].t - node->t) / node->h;
    part = flk_node_part(node, FLK_PASSED, node->y[FLK_PASSED] + change, GSL_MIN(most, 1));
    flk_node_within(node, GSL_MAX(0, GSL_MIN(part, 1)), at);
}

int flk_path_row(const flk_path *p, const flk_node *at, flk_actual_row *row)
{
    const flk_equation *e = &p->equation;
    double theta2 = flk_equation_theta2(e, at->y[FLK_PASSED]), speed = at->y[FLK_SPEED];
    flk_machine_place place;
    flk_machine_torque torque;
    int status = flk_machine_at(&e->machine, e->branch, theta2, &place);

    if (status == FOURLINK_OK)
        status = flk_equation_torque(e, &place, speed, &torque);
    if (status != FOURLINK_OK)
        return status;
    row->crank.theta2 = theta2;
    row->crank.omega2 = e->sense * speed;
    row->crank.alpha2 = at->is_at_rest ? 0 : e->sense * torque.alpha2;
    row->time = at->t;
    row->T_motor = torque.T_motor;
    row->J = place.J;
    row->energy = 0.5 * place.total * speed * speed;
    row->energy_residual =
        p->largest > 0 ? (row->energy - at->y[FLK_ENERGY] + at->residual) / p->largest : 0;
    return FOURLINK_OK;
}

int flk_path_node_at(const flk_path *p, double s, flk_node *at)
{
    const flk_node *node = p->swings ? step_to(p, s) : node_before(p, FLK_PASSED, s);

    if (!node)
        return p->status != FOURLINK_OK ? p->status : FOURLINK_NO_SUCH_ANGLE;
    node_at_angle(node, s, at);
    at->y[FLK_PASSED] = s;
    return FOURLINK_OK;
}

int flk_path_at(const flk_path *p, double s, flk_actual_row *row)
{
    flk_node at;
    int status = flk_path_node_at(p, s, &at);

    return status == FOURLINK_OK ? flk_path_row(p, &at, row) : status;
}

int flk_path_at_time(const flk_path *p, double t, flk_actual_row *row)
{
    const flk_node *node = node_before(p, -1, t);
    flk_node at = *node;

    if (node->h > 0)
        flk_node_within(node, (t - node->t) / node->h, &at);
    at.t = t;
    return flk_path_row(p, &at, row);
}

double flk_path_travel(const flk_path *p)
{
    double travel = 0;
    size_t k;

    for (k = 0; k + 1 < p->n; k++)
        travel += fabs(p->node[k + 1].y[FLK_PASSED] - p->node[k].y[FLK_PASSED]);
    return travel;
}
