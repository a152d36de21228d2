/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_time.c - the motion of one branch over the time, for machines that may swing back.
**
** A step ends where the crank comes to rest: within a step it turns in one sense.  Corners of the torques may lie within
** steps; there the estimated errors make the steps short.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "actual_time.h"

#define LONGEST 0.2    /* rad, of a step */
#define SHORTEST 1e-15 /* of the duration */
#define CLOSEST 1e-9   /* ... to where there is no position */
#define ROUNDING 1e-9  /* rad */
#define FAR 1e30       /* rad: no corner */

/* The time in which the crank turns through an angle, in either sense. */
static double time_for(const flk_step *step, double angle)
{
    double speed = fabs(step->y[1]), alpha = fabs(step->k[0][1]);

    return speed > 0 || alpha > 0 ? flk_actual_time_of(speed, alpha, angle) : GSL_POSINF;
}

/* End a step where the crank comes to rest, if it passes that. */
static int shorten(const flk_path *p, flk_node *node, flk_step *step)
{
    return step->y[1] * step->next[1] < 0 ? flk_actual_cut(p, node, step, 1, 0) : FOURLINK_OK;
}

/* Take a step of this length: 1 and the factor for the next, or 0, the factor for the next try and the status. */
static int take(const flk_path *p, flk_node *node, flk_step *step, double length, double *factor,
                int *status)
{
    if (!flk_actual_attempt(p, node, step, length, factor, status))
        return 0;
    *status = shorten(p, node, step);
    if (*status >= 0)
        return 1;
    *factor = 0.5;
    return 0;
}

/* One step from the last node, of at most *h in time; *h is the length for the next. */
static int go_on(flk_path *p, double duration, double *h, flk_node *after)
{
    flk_node *node = &p->node[p->n - 1];
    double left = duration - node->t, length, factor;
    flk_equations e;
    flk_step step;
    int status;

    node->low = -FAR;
    node->high = FAR;
    node->by_time = 1;
    status = flk_actual_begin(p, node, &e, &step);
    if (status != FOURLINK_OK)
        return status;
    length = GSL_MIN(GSL_MIN(*h, time_for(&step, LONGEST)), left);
    for (; p->budget > 0; p->budget--) {
        if (take(p, node, &step, length, &factor, &status))
            break;
        length *= factor;
        if (!(length >= (status > 0 ? CLOSEST : SHORTEST) * duration))
            return status > 0 ? status : flk_actual_no_step(p, node->s, status);
    }
    if (p->budget == 0)
        return flk_actual_no_step(p, node->s, FOURLINK_OK);
    p->budget--;
    *h = length * factor;
    node->h = step.h;
    flk_actual_end_step(node, step.h, step.next, after);
    if (step.h == left)
        after->t = duration;
    return status;
}

int flk_time_run(flk_path *p, double speed, double duration)
{
    double whole, h = duration;
    flk_node node;

    p->n = 0;
    p->is_steady = 0;
    p->by_time = 1;
    p->largest = 0;
    p->status = flk_actual_whole(p, 0, &whole);
    memset(&node, 0, sizeof node);
    node.by_time = 1;
    node.speed = p->sense * speed;
    node.u = 0.5 * speed * speed;
    node.E = p->status == FOURLINK_OK ? whole * node.u : 0;
    if (!flk_actual_keep(p, &node))
        return 0;
    while (p->status == FOURLINK_OK && flk_path_end(p)->t < duration) {
        p->status = go_on(p, duration, &h, &node);
        if (p->status == FOURLINK_OK && !flk_actual_keep(p, &node))
            return 0;
    }
    return p->status == FOURLINK_OK;
}

int flk_time_at(const flk_path *p, double t, flk_actual_row *row)
{
    flk_node at;

    flk_actual_within(flk_path_before(p, 1, t), 1, t, &at);
    return flk_path_row(p, &at, row);
}

/* The first step in which the crank passes s, or comes as close as rounding. */
static const flk_node *step_to(const flk_path *p, double s)
{
    const flk_node *node, *close = NULL;

    for (node = p->node; node + 1 < p->node + p->n; node++) {
        double low = GSL_MIN(node->s, node[1].s), high = GSL_MAX(node->s, node[1].s);

        if (low <= s && s <= high)
            return node;
        if (!close && low - ROUNDING <= s && s <= high + ROUNDING)
            close = node;
    }
    return close;
}

int flk_time_find(const flk_path *p, double s, flk_actual_row *row)
{
    const flk_node *node = step_to(p, s);
    flk_node at;

    if (!node)
        return p->status != FOURLINK_OK ? p->status : FOURLINK_NO_SUCH_ANGLE;
    flk_actual_within(node, 0, s, &at);
    at.s = s;
    return flk_path_row(p, &at, row);
}

double flk_time_travel(const flk_path *p)
{
    double travel = 0;
    size_t k;

    for (k = 0; k + 1 < p->n; k++)
        travel += fabs(p->node[k + 1].s - p->node[k].s);
    return travel;
}
