/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_path.c - the motion of one branch from a given energy: steps of the integration, and any angle between them.
**
** Steps are over the angle (actual_step.c).  The angle at which the energy would vanish is about E / |dE/ds| away; where
** that is close, and from rest, they are over the time.
**
** Steps end where torques have corners.  Rows lie within steps: they do not depend on each other, nor on the interval
** between them.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "actual_path.h"
#include "base/solve.h"

#define NEAR_REST 0.05  /* rad, to where the energy would vanish */
#define LONGEST 0.5     /* rad, of a step */
#define SHORTEST 1e-13  /* of the angle passed */
#define CLOSEST 1e-9    /* rad, to where there is no position */
#define AT_REST 1e-16   /* of the largest energy */
#define DIFFERENCE 1e-5 /* of the speed, for a derivative */

/* Begin the next step: over time, if the crank is near to rest. */
static int choose(flk_path *p, flk_node *node, flk_equations *e, flk_step *step)
{
    int status;

    node->by_time = !(node->E > 0);
    status = flk_actual_begin(p, node, e, step);
    if (node->by_time || (status == FOURLINK_OK && node->E > NEAR_REST * fabs(step->k[0][0])))
        return status;
    node->by_time = 1;
    return flk_actual_begin(p, node, e, step);
}

/* End a step over time where the crank comes to rest, or at the end of the piece, if it passes them. */
static int shorten(const flk_path *p, flk_node *node, flk_step *step)
{
    int status = FOURLINK_OK;

    if (step->next[1] <= 0)
        status = flk_actual_cut(p, node, step, 1, 0);
    if (status == FOURLINK_OK && step->next[0] > node->high)
        status = flk_actual_cut(p, node, step, 0, node->high);
    return status;
}

/* The length of the next step, in angle, of at most h. */
static double first_length(const flk_node *node, const flk_step *step, double h)
{
    double left = node->high - node->s, length = GSL_MIN(h, LONGEST);

    if (node->by_time && step->k[0][1] < 0) /* a little farther than to rest */
        length = GSL_MIN(length, 1.5 * gsl_pow_2(step->y[1]) / (-2 * step->k[0][1]));
    return length >= left ? left : length > 0.5 * left ? 0.5 * left : length;
}

/* Why no step is short enough.  Where friction or a motor changes its torque at rest, none reaches it. */
static int why_not(const flk_path *p, const flk_node *node, const flk_step *step, int of_step)
{
    double alpha = step->k[0][1];
    int status = flk_actual_no_step(p, node->s, of_step);

    return status == FOURLINK_TOO_LONG && node->by_time && alpha < 0 &&
                   gsl_pow_2(node->speed) < -2 * alpha * CLOSEST
               ? FOURLINK_STALLS
               : status;
}

/* Take a step of this length, in angle: 1 and the factor for the next, or 0, the factor for the next try and the
** status. */
static int take(const flk_path *p, flk_node *node, flk_step *step, double length, double *factor,
                int *status)
{
    double h = node->by_time ? flk_actual_time_of(step->y[1], step->k[0][1], length) : length;

    if (!flk_actual_attempt(p, node, step, h, factor, status))
        return 0;
    if (node->by_time)
        *status = shorten(p, node, step);
    if (*status >= 0)
        return 1;
    *factor = 0.5;
    return 0;
}

/* One step from the last node, of at most *h in angle; *h is the length for the next. */
static int go_on(flk_path *p, double *h, flk_node *after)
{
    flk_node *node = &p->node[p->n - 1];
    double length, factor;
    flk_equations e;
    flk_step step;
    int status = choose(p, node, &e, &step);

    if (status != FOURLINK_OK)
        return status;
    if (node->by_time && node->E <= 0 && !(step.k[0][1] > 0))
        return FOURLINK_DOES_NOT_START;
    length = first_length(node, &step, *h);
    for (; p->budget > 0; p->budget--) {
        if (take(p, node, &step, length, &factor, &status))
            break;
        length *= factor;
        if (!(length >= (status > 0 ? CLOSEST : SHORTEST * (1 + node->s))))
            return status > 0 ? status : why_not(p, node, &step, status);
    }
    if (p->budget == 0)
        return flk_actual_no_step(p, node->s, FOURLINK_OK);
    p->budget--;
    node->h = step.h;
    flk_actual_end_step(node, step.h, step.next, after);
    if (!node->by_time && length == node->high - node->s)
        after->s = node->high;
    if (node->by_time && after->speed <= 0)
        after->E = 0;
    *h = length * factor;
    return status;
}

/* A crank may creep into an equilibrium, or torques change where it comes to rest, friction for one: it is at rest
** when nothing is left of its energy. */
static int comes_to_rest(const flk_path *p, const flk_node *before, const flk_node *after)
{
    return after->E <= 0 || (after->E < before->E && after->E <= AT_REST * p->largest);
}

static int run_piece(flk_path *p, double *h)
{
    flk_node after;

    while (p->node[p->n - 1].s < p->node[p->n - 1].high) {
        p->status = go_on(p, h, &after);
        if (p->status != FOURLINK_OK || !flk_actual_keep(p, &after))
            return 0;
        if (after.s < after.high && comes_to_rest(p, &p->node[p->n - 2], &after)) {
            p->status = FOURLINK_STALLS;
            return 0;
        }
    }
    return 1;
}

/* Where the torques have their next corner, or the path its end. */
static double next_corner(const flk_path *p, double after, double length, flk_piece_end *end)
{
    flk_corners c;
    double at;

    c.d = p->d;
    c.jumps = p->jumps;
    c.sense = p->sense;
    c.has_loads = 1;
    at = flk_corners_next(&c, after, NULL, 0, end);
    return at < length - FLK_CORNERS_CLOSE(length) ? at : length;
}

int flk_path_run(flk_path *p, double speed, double length)
{
    double whole, h = 0.1, at, next;
    flk_piece_end end;
    flk_node first;

    p->n = 0;
    p->is_steady = 0;
    p->largest = 0;
    p->status = flk_actual_whole(p, 0, &whole);
    memset(&first, 0, sizeof first);
    first.u = 0.5 * speed * speed;
    first.E = p->status == FOURLINK_OK ? whole * first.u : 0;
    if (!flk_actual_keep(p, &first) || p->status != FOURLINK_OK)
        return 0;
    for (at = 0; at < length; at = next) {
        next = next_corner(p, at, length, &end);
        p->node[p->n - 1].low = at;
        p->node[p->n - 1].high = next;
        if (!run_piece(p, &h))
            return 0;
        if (end == FLK_END_DEAD && next < length) {
            p->status = FOURLINK_DEAD_POSITION;
            return 0;
        }
    }
    return 1;
}

const flk_node *flk_path_end(const flk_path *p)
{
    return &p->node[p->n - 1];
}

const flk_node *flk_path_before(const flk_path *p, int i, double value)
{
    size_t low = 0, high = p->n;

    while (high - low > 1) {
        size_t middle = (low + high) / 2;

        if ((i ? p->node[middle].t : p->node[middle].s) <= value)
            low = middle;
        else
            high = middle;
    }
    return &p->node[low];
}

int flk_path_row(const flk_path *p, const flk_node *at, flk_actual_row *row)
{
    flk_machine_place place;
    flk_machine_push push;
    double theta2 = flk_actual_theta2(p, at->s), speed;
    int status = flk_machine_at(&p->machine, theta2, &place);

    if (status != FOURLINK_OK)
        return status;
    speed = at->by_time ? at->speed : sqrt(2 * at->E / place.whole);
    status = flk_actual_push(p, &place, speed, &push);
    if (status != FOURLINK_OK)
        return status;
    row->crank.theta2 = theta2;
    row->crank.omega2 = p->sense * speed;
    row->crank.alpha2 = p->sense * push.alpha2;
    row->time = at->t;
    row->T_motor = push.T_motor;
    row->J = place.J;
    row->energy = 0.5 * place.whole * speed * speed;
    row->energy_residual = p->largest > 0 ? (place.whole * at->u - at->E) / p->largest : 0;
    return FOURLINK_OK;
}

int flk_path_at(const flk_path *p, double s, flk_actual_row *row)
{
    flk_node at;

    flk_actual_within(flk_path_before(p, 0, s), 0, s, &at);
    at.s = s;
    return flk_path_row(p, &at, row);
}

/* d(T_m + Q)/d(omega2) / ((J + I_f) omega2) */
static void growth_at(double s, void *data, double *growth)
{
    const flk_path *p = *(const flk_path *const *)data;
    flk_machine_place place;
    flk_machine_push slower, faster;
    flk_node at;
    double speed;

    *growth = GSL_NAN;
    if (flk_machine_at(&p->machine, flk_actual_theta2(p, s), &place) != FOURLINK_OK)
        return;
    flk_actual_within(flk_path_before(p, 0, s), 0, s, &at);
    speed = at.by_time ? at.speed : sqrt(2 * at.E / place.whole);
    if (flk_actual_push(p, &place, speed * (1 - DIFFERENCE), &slower) != FOURLINK_OK ||
        flk_actual_push(p, &place, speed * (1 + DIFFERENCE), &faster) != FOURLINK_OK)
        return;
    *growth = (faster.push - slower.push) / (2 * DIFFERENCE * speed) / (place.whole * speed);
}

double flk_path_growth(const flk_path *p)
{
    double growth = 0;
    flk_integral here;
    size_t k;

    for (k = 0; k + 1 < p->n; k++) {
        flk_integrate(growth_at, &p, 1, p->node[k].s, p->node[k + 1].s, &here);
        growth += here.value;
    }
    return growth;
}
