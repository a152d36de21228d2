/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_step.c - one step of the actual motion.
**
** Over the angle s that the crank has passed, in the sense of the motion,
**
**    dE/ds = T_m + Q,   dt/ds = 1 / omega2,   du/ds = alpha2,   omega2^2 = 2 E / (J + I_f)
**
** E is smooth where the crank does not come near to rest.  There, and from rest, the time is the variable:
**
**    ds/dt = omega2,   domega2/dt = alpha2,   dE/dt = (T_m + Q) omega2
**
** u = omega2^2 / 2 follows from the accelerations, which need J', and E from the work, which does not: that
** (J + I_f) u = E checks both.  Where torques depend on the angle alone, E is a mere quadrature.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "actual_step.h"
#include "base/solve.h"

#define INSIDE 1e-11  /* of a cycle: corners are not touched, for torques may jump there */
#define BESIDE 5e-3   /* rad, of a change point: nearer, values are those through angles about it */
#define SHORT 1e-2    /* rad: in a motion that swings back, errors of this at least */
#define AT_LIMIT 1e-6 /* rad, from an angle that the links do not reach */
#define NO_INERTIA 1e-9 /* of that at the first row */
#define SHORTER 1e-4    /* ... and in another */
#define SLOW 1e-2       /* of speed and energy at FIRST, and of the speed with the largest energy */
#define FIRST 0.01      /* rad, from rest */

static double inside(const flk_equations *e, double s)
{
    double nothing = INSIDE * e->p->d->machine.cycle, middle = 0.5 * (e->low + e->high);

    nothing = GSL_MIN(nothing, 0.25 * (e->high - e->low));
    return s < middle ? GSL_MAX(s, e->low + nothing) : GSL_MIN(s, e->high - nothing);
}

double flk_actual_theta2(const flk_path *p, double s)
{
    const fourlink_motion *motion = &p->d->motion;

    return motion->from * motion->angle_unit + p->sense * s;
}

/* The machine at a speed in the sense of the motion; alpha2 and push in that sense. */
int flk_actual_push(const flk_path *p, const flk_machine_place *place, double speed,
                    flk_machine_push *push)
{
    int status = flk_machine_push_at(&p->machine, place, p->sense * speed, p->acting, push);

    push->push *= p->sense;
    push->alpha2 *= p->sense;
    return status;
}

/* y = E, t, u over s */
static int over_angle(const flk_equations *e, double s, const double *y, double *dy)
{
    flk_machine_place place;
    flk_machine_push push;
    double speed;
    int status;

    if (!(y[0] > 0))
        return FLK_TO_REST;
    status = flk_machine_at(&e->p->machine, e->p->branch, flk_actual_theta2(e->p, s), &place);
    if (status != FOURLINK_OK)
        return status;
    speed = sqrt(2 * y[0] / place.whole);
    status = flk_actual_push(e->p, &place, speed, &push);
    dy[0] = push.push;
    dy[1] = 1 / speed;
    dy[2] = push.alpha2;
    return status;
}

/* y = s, speed, E over t */
static int over_time(const flk_equations *e, double s, const double *y, double *dy)
{
    flk_machine_place place;
    flk_machine_push push;
    int status = flk_machine_at(&e->p->machine, e->p->branch, flk_actual_theta2(e->p, s), &place);

    if (status == FOURLINK_OK)
        status = flk_actual_push(e->p, &place, y[1], &push);
    if (status != FOURLINK_OK)
        return status;
    dy[0] = y[1];
    dy[1] = push.alpha2;
    dy[2] = push.push * y[1];
    return status;
}

/* rad passed since the nearest change point, < 0 before it; infinite if the mechanism has none. */
static double after_change(const flk_path *p, double s)
{
    const fourlink_mechanism *mechanism = &p->d->machine.mechanism;
    double folded = fourlink_slides((int)mechanism->design.kind, FOURLINK_FOLLOWER) ? -M_PI_2 : 0;
    double nearest = GSL_POSINF;
    int i;

    for (i = 0; i < 2; i++) {
        double turns = (flk_actual_theta2(p, s) - folded - i * M_PI) / (2 * M_PI);
        double after = p->sense * 2 * M_PI * (turns - floor(turns + 0.5));

        if ((i ? mechanism->change_stretched : mechanism->change_folded) &&
            fabs(after) < fabs(nearest))
            nearest = after;
    }
    return nearest;
}

#define PLACES 6

/* 1 near a change point: where values are taken, in rad passed, and their weights (Lagrange), as the motion of the links,
** which is smooth, is lost in rounding there. */
static int is_near_change(const flk_path *p, double s, double *places, double *weights)
{
    static const double nodes[PLACES] = {-3 * BESIDE, -2 * BESIDE, -BESIDE,
                                         BESIDE,      2 * BESIDE,  3 * BESIDE};
    double after = after_change(p, s);
    int i, k;

    if (!(fabs(after) < BESIDE))
        return 0;
    for (i = 0; i < PLACES; i++) {
        places[i] = s - after + nodes[i];
        weights[i] = 1;
        for (k = 0; k < PLACES; k++)
            weights[i] *= k == i ? 1 : (after - nodes[k]) / (nodes[i] - nodes[k]);
    }
    return 1;
}

/* Either of the equations, there too. */
static int between(int (*f)(const flk_equations *, double, const double *, double *),
                   const flk_equations *e, double s, const double *y, double *dy)
{
    double places[PLACES], weights[PLACES], values[3], sum[3] = {0, 0, 0};
    int i, k, status;

    if (!is_near_change(e->p, s, places, weights))
        return f(e, s, y, dy);
    for (i = 0; i < PLACES; i++) {
        status = f(e, places[i], y, values);
        if (status != FOURLINK_OK)
            return status;
        for (k = 0; k < 3; k++)
            sum[k] += weights[i] * values[k];
    }
    for (k = 0; k < 3; k++)
        dy[k] = sum[k];
    return FOURLINK_OK;
}

static int derive_over_angle(void *context, double x, const double *y, double *dy)
{
    const flk_equations *e = context;

    return between(over_angle, e, inside(e, x), y, dy);
}

static int derive_over_time(void *context, double x, const double *y, double *dy)
{
    const flk_equations *e = context;

    (void)x;
    return between(over_time, e, inside(e, y[0]), y, dy);
}

/* J + I_f at an angle, near a change point too. */
int flk_actual_whole(const flk_path *p, double s, double *whole)
{
    double places[PLACES], weights[PLACES], sum = 0;
    flk_machine_place place;
    int n = is_near_change(p, s, places, weights) ? PLACES : 1, i, status;

    for (i = 0; i < n; i++) {
        status = flk_machine_at(&p->machine, p->branch, flk_actual_theta2(p, n > 1 ? places[i] : s),
                                &place);
        if (status != FOURLINK_OK)
            return status;
        sum += n > 1 ? weights[i] * place.whole : place.whole;
    }
    *whole = sum;
    return FOURLINK_OK;
}

int flk_actual_no_step(const flk_path *p, double s, int status)
{
    double before, here, after;

    if (flk_actual_whole(p, s - AT_LIMIT, &before) != FOURLINK_OK ||
        flk_actual_whole(p, s + AT_LIMIT, &after) != FOURLINK_OK)
        return FOURLINK_DEAD_POSITION;
    if (flk_actual_whole(p, 0, &here) == FOURLINK_OK && GSL_MIN(before, after) < NO_INERTIA * here)
        return FOURLINK_NO_INERTIA;
    return status == FLK_NOT_FINITE ? FOURLINK_OVERFLOW : FOURLINK_TOO_LONG;
}

/* Set the flk_equations and the beginning of a step at a node. */
int flk_actual_begin(const flk_path *p, flk_node *node, flk_equations *e, flk_step *step)
{
    double whole = 1;
    int status;

    e->p = p;
    e->low = node->low;
    e->high = node->high;
    step->context = e;
    if (node->by_time) {
        status = flk_actual_whole(p, node->s, &whole);
        if (status != FOURLINK_OK)
            return status;
        step->f = derive_over_time;
        step->x = node->t;
        step->y[0] = node->s;
        if (!p->by_time)
            node->speed = sqrt(2 * node->E / whole);
        step->y[1] = node->speed;
        step->y[2] = node->E;
    } else {
        step->f = derive_over_angle;
        step->x = node->s;
        step->y[0] = node->E;
        step->y[1] = node->t;
        step->y[2] = node->u;
    }
    status = step->f(e, step->x, step->y, step->k[0]);
    if (node->by_time && status == FOURLINK_OK) {
        e->slow = SLOW * sqrt(2 * (p->largest / whole + FIRST * fabs(step->k[0][1])));
        e->little = SLOW * FIRST * whole * fabs(step->k[0][1]);
    }
    return status;
}

/* The time in which the crank turns through an angle from a speed, if its acceleration is constant. */
double flk_actual_time_of(double speed, double alpha, double angle)
{
    double square = speed * speed + 2 * alpha * angle;
    double sum = speed + sqrt(GSL_MAX(square, 0));

    return sum > 0 ? 2 * angle / sum : 0;
}

/* What a value changes within a step, less a change that is sought. */
typedef struct passing {
    const flk_curve_of_step *within;
    int i;
    double change;
} passing;

static double passed_by(double part, void *data)
{
    const passing *x = data;

    return flk_step_change(x->within, x->i, part) - x->change;
}

/* The part of a step at which y[i], which it passes, has a value. */
double flk_actual_part(const flk_curve_of_step *within, int i, double change)
{
    flk_bracket b;
    passing x;

    x.within = within;
    x.i = i;
    x.change = change;
    b = flk_bracket_of(0, 1, -change, passed_by(1, &x));
    return flk_find_zero(passed_by, &x, &b, 0);
}

int flk_actual_keep(flk_path *p, const flk_node *node)
{
    if (p->n == p->room) {
        size_t room = p->room ? 2 * p->room : 128;
        flk_node *more = realloc(p->node, room * sizeof *more);

        if (!more) {
            p->no_memory = 1;
            return 0;
        }
        p->node = more;
        p->room = room;
    }
    p->node[p->n++] = *node;
    p->largest = GSL_MAX(p->largest, node->E);
    return 1;
}

/* The error of a step in parts of the tolerance. */
static double error_of(const flk_path *p, const flk_node *node, const flk_step *step,
                       const double *error)
{
    const double *y = step->y, *next = step->next;
    double scale[FLK_UNKNOWNS], sum = 0;
    int i;

    if (node->by_time) {
        const flk_equations *e = step->context;

        scale[0] = GSL_MAX(fabs(next[0] - y[0]), p->by_time ? SHORT : SHORTER);
        scale[1] = GSL_MAX(GSL_MAX(fabs(next[1]), fabs(y[1])), e->slow);
        scale[2] = GSL_MAX(GSL_MAX(p->largest, fabs(next[2])), e->little);
    } else {
        scale[0] = GSL_MAX(0.01 * p->largest, next[0]);
        scale[1] = next[1];
        scale[2] = GSL_MAX(y[2], next[2]);
    }
    for (i = 0; i < FLK_UNKNOWNS; i++)
        sum += gsl_pow_2(error[i] / scale[i]);
    return sqrt(sum / FLK_UNKNOWNS) / p->tolerance;
}

static int are_finite(const double *values, int n)
{
    int i;

    for (i = 0; i < n; i++)
        if (!gsl_finite(values[i]))
            return 0;
    return 1;
}

/* Take a step of this length: its error, or a status. */
int flk_actual_try(const flk_path *p, const flk_node *node, flk_step *step, double h, double *size)
{
    double error[FLK_UNKNOWNS];
    int status;

    step->h = h;
    status = flk_step_take(step, error);
    if (status != FOURLINK_OK)
        return status;
    *size = error_of(p, node, step, error);
    return gsl_finite(*size) && are_finite(step->next, FLK_UNKNOWNS) ? FOURLINK_OK : FLK_NOT_FINITE;
}

/* Values within a step that has been taken. */
int flk_actual_fill(flk_step *step, flk_curve_of_step *within)
{
    int i, status = flk_step_end(step);

    if (status == FOURLINK_OK)
        status = flk_step_within(step, within);
    for (i = 0; i < FLK_UNKNOWNS && status == FOURLINK_OK; i++)
        if (!are_finite(within->F[i], FLK_POWERS))
            status = FLK_NOT_FINITE;
    return status;
}

#define WORST 1e8 /* of the errors of steps, in parts of the tolerance */

int flk_actual_attempt(const flk_path *p, flk_node *node, flk_step *step, double h, double *factor,
                       int *status)
{
    double size;

    *status = flk_actual_try(p, node, step, h, &size);
    if (*status == FOURLINK_OK && size <= 1)
        *status = flk_actual_fill(step, &node->within);
    if (*status == FOURLINK_OK && size <= 1) {
        *factor = GSL_MIN(5, 0.9 * pow(GSL_MAX(size, 1e-10), -0.125));
        return 1;
    }
    if (*status != FOURLINK_OK || !(size < WORST))
        size = WORST;
    *factor = GSL_MAX(0.2, 0.9 * pow(size, -0.125));
    return 0;
}

int flk_actual_cut(const flk_path *p, flk_node *node, flk_step *step, int i, double value)
{
    double size, part = flk_actual_part(&node->within, i, value - step->y[i]);
    int status = flk_actual_try(p, node, step, step->h * part, &size);

    if (status != FOURLINK_OK)
        return status;
    if (size > 1)
        return FLK_INEXACT;
    step->next[i] = value;
    return flk_actual_fill(step, &node->within);
}

void flk_actual_end_step(const flk_node *node, double h, const double *next, flk_node *after)
{
    after->low = node->low;
    after->high = node->high;
    after->by_time = node->by_time;
    after->h = 0;
    if (node->by_time) {
        after->s = next[0];
        after->t = node->t + h;
        after->speed = next[1];
        after->u = 0.5 * next[1] * next[1];
        after->E = next[2];
    } else {
        after->s = node->s + h;
        after->E = next[0];
        after->t = next[1];
        after->u = next[2];
    }
}

void flk_actual_within(const flk_node *node, int i, double value, flk_node *at)
{
    double y[FLK_UNKNOWNS], part;
    int k;

    *at = *node;
    if (node->h == 0 || value == (i == 0 ? node->s : node->t))
        return;
    part = i == 1           ? (value - node->t) / node->h
           : !node->by_time ? (value - node->s) / node->h
                            : flk_actual_part(&node->within, 0, value - node->s);
    part = GSL_MAX(0, GSL_MIN(part, 1));
    for (k = 0; k < FLK_UNKNOWNS; k++)
        y[k] = flk_step_change(&node->within, k, part);
    y[0] += node->by_time ? node->s : node->E;
    y[1] += node->by_time ? node->speed : node->t;
    y[2] += node->by_time ? node->E : node->u;
    flk_actual_end_step(node, part * node->h, y, at);
}
