/* SPDX-License-Identifier: GPL-3.0-or-later
**
** path.c - the motion of one branch from a given speed: integration steps, and any instant between them.
**
** Between two corners of the torques the machine is held in one cell, whose torques continue smoothly beyond
** its ends.  So steps may overshoot the end of a cell, or the place where the crank comes to rest; they are
** cut there on their interpolant, and the next cell begins.  Rows lie within steps: they do not depend on
** each other or on the interval between them.
**
** A path is an array of nodes in the order of time.  The first is at 0 s and 0 rad passed.  A node has the
** unknowns where a step begins, and the polynomial of that step, which holds up to the next node and may
** reach beyond it.  The last node has no step, h = 0; so has one at which the crank rests.  Unless the path
** swings, the angle passed rises from node to node too, and an angle is found as a time is, by bisection.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "mechanics/inertia.h"
#include "mechanics/kind.h"
#include "mechanics/mechanism.h"
#include "path.h"

#define LONGEST 0.35    /* rad, of a step */
#define BEYOND 1.1      /* factor by which a step may overshoot the end of a cell */
#define SHORTEST 1e-13  /* of the angle, the time or the duration: shortest step, */
#define CLOSEST 1e-9    /* ... towards a place without a position */
#define AT_LIMIT 1e-6   /* rad, from an angle that the links cannot reach */
#define CREEP 1e-6      /* of a slow speed: counts as rest */
#define NO_INERTIA 1e-9 /* of the inertia at the first row */
#define SLOW 1e-2       /* of speed and energy at FIRST, and of the speed with the largest energy */
#define STILL 1e-10     /* of a slow speed: rounding error, of any sign */
#define FIRST 0.01      /* rad, from rest */
#define SHORT 1e-2      /* rad: in a motion that swings back, errors count as of at least this */
#define SHORTER 1e-4    /* ... and in other motions */
#define FAST 0.1        /* of the largest energy: far from rest */
#define NUDGE 1e-10     /* of a speed at an end of a piece of the motor's curve */
#define WORST 1e8       /* of the errors of steps, relative to the tolerance */
#define NOT_FINITE (-1) /* a step gives no finite values */

/* A cell, and what ends it. */
typedef struct cell {
    int turning; /* 1 or -1, against the sense of the motion */
    double end;  /* rad passed, in that direction */
    flk_piece_end what;
    fourlink_state held;
    double slowest, fastest; /* rad/s, crank speeds at the ends of the piece of the motor's curve */
    double slow, little;     /* rad/s, J: errors of smaller values are relative to these */
    int goes_on;             /* 1: the last step ended within the cell, where J + I_f is `total` */
    double total;            /* kg m2 */
} cell;

typedef enum ending { IN_CELL, AT_END, AT_STOP, AT_SPEED } ending;

/* --------------------------------------------------------------------------------------------- one step */

/* The time in which the crank turns through an angle at constant acceleration. */
static double time_for(const flk_step *step, double angle)
{
    double speed = fabs(step->y[FLK_SPEED]), alpha = step->k[0][FLK_SPEED], square, sum;

    alpha = step->y[FLK_SPEED] < 0 ? -alpha : alpha;
    alpha = speed == 0 ? fabs(alpha) : alpha;
    square = speed * speed + 2 * alpha * angle;
    sum = speed + sqrt(GSL_MAX(square, 0));
    return sum > 0 ? 2 * angle / sum : GSL_POSINF;
}

/* Except near rest, the speed is computed from the energy, which is a mere quadrature and has the smaller
** error. */
static void correct(const flk_path *p, double total, flk_node *node)
{
    double E = node->y[FLK_ENERGY], *speed = &node->y[FLK_SPEED];

    if (!(E > FAST * p->largest))
        return;
    node->residual += 0.5 * total * *speed * *speed - E;
    *speed = *speed < 0 ? -sqrt(2 * E / total) : sqrt(2 * E / total);
}

/* Set the beginning of a step at a node.  Within a cell it takes the derivatives from the end of the last
** step, which the correction hardly changes. */
static int begin(flk_path *p, flk_node *node, cell *c, flk_step *step)
{
    double alpha;
    int status = c->goes_on ? FOURLINK_OK
                            : flk_equation_inertia(&p->equation, node->y[FLK_PASSED], &c->total);

    if (status != FOURLINK_OK)
        return status;
    correct(p, c->total, node);
    step->f = flk_equation_derive;
    step->context = &p->equation;
    step->x = node->t;
    memcpy(step->y, node->y, sizeof step->y);
    if (c->goes_on) {
        memcpy(step->k[0], step->k[FLK_STAGE_AT_END], sizeof step->k[0]);
        step->k[0][FLK_PASSED] = step->y[FLK_SPEED];
    } else {
        status = flk_equation_derive(&p->equation, node->t, step->y, step->k[0]);
    }
    alpha = fabs(step->k[0][FLK_SPEED]);
    c->slow = SLOW * sqrt(2 * (p->largest / c->total + FIRST * alpha));
    c->little = SLOW * FIRST * c->total * alpha;
    return status;
}

/* The error of a step relative to the tolerance. */
static double error_of(const flk_path *p, const cell *c, const flk_step *step, const double *error)
{
    const double *y = step->y, *next = step->next;
    double scale[FLK_UNKNOWNS], sum = 0;
    int i;

    scale[FLK_PASSED] =
        GSL_MAX(fabs(next[FLK_PASSED] - y[FLK_PASSED]), p->swings ? SHORT : SHORTER);
    scale[FLK_SPEED] = GSL_MAX(GSL_MAX(fabs(next[FLK_SPEED]), fabs(y[FLK_SPEED])), c->slow);
    scale[FLK_ENERGY] = GSL_MAX(GSL_MAX(p->largest, fabs(next[FLK_ENERGY])), c->little);
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

/* Try a step of this length, with the values within it.  Returns its error, or a status. */
static int try_step(const flk_path *p, cell *c, flk_step *step, double h, flk_curve_of_step *within,
                    double *size)
{
    double error[FLK_UNKNOWNS];
    int status, i;

    step->h = h;
    status = flk_step_take(step, error);
    if (status != FOURLINK_OK)
        return status == FOURLINK_BAD_NUMBER ? NOT_FINITE : status;
    *size = error_of(p, c, step, error);
    if (!gsl_finite(*size) || !are_finite(step->next, FLK_UNKNOWNS))
        return NOT_FINITE;
    if (*size > 1)
        return FOURLINK_OK;
    status = flk_step_end(step);
    c->total = p->equation.total;
    if (status == FOURLINK_OK)
        status = flk_step_within(step, within);
    for (i = 0; i < FLK_UNKNOWNS && status == FOURLINK_OK; i++)
        if (!are_finite(within->F[i], FLK_POWERS))
            status = NOT_FINITE;
    return status;
}

/* Why no step from s is short enough: a dead position, where J is unbounded; nothing that moves there has
** mass; no step gives finite values; otherwise too many steps. */
static int why_none(const flk_path *p, double s, int status)
{
    const flk_equation *e = &p->equation;
    double before, here, after;

    if (flk_equation_inertia(e, s - AT_LIMIT, &before) != FOURLINK_OK ||
        flk_equation_inertia(e, s + AT_LIMIT, &after) != FOURLINK_OK)
        return FOURLINK_DEAD_POSITION;
    if (flk_equation_inertia(e, 0, &here) == FOURLINK_OK &&
        GSL_MIN(before, after) < NO_INERTIA * here)
        return FOURLINK_NO_INERTIA;
    return status == NOT_FINITE ? FOURLINK_OVERFLOW : FOURLINK_TOO_LONG;
}

/* The longest step to try: slightly beyond the end of the cell, or rest. */
static double longest(const flk_step *step, const cell *c)
{
    double left = fabs(c->end - step->y[FLK_PASSED]);
    double h = time_for(step, GSL_MIN(LONGEST, BEYOND * left));
    double speed = c->turning * step->y[FLK_SPEED], alpha = c->turning * step->k[0][FLK_SPEED];

    return alpha < 0 && speed > STILL * c->slow ? GSL_MIN(h, -1.5 * speed / alpha) : h;
}

/* The shortest step to try: this fraction of the angle, of the elapsed time, of the duration. */
static double shortest(const flk_path *p, const flk_step *step, double part, double left)
{
    double by_angle = time_for(step, part * (FIRST + fabs(step->y[FLK_PASSED])));

    if (p->swings)
        return part * (step->x + left);
    return step->x > 0 ? GSL_MIN(by_angle, part * step->x) : by_angle;
}

/* Take one step from a node, of at most *h; *h returns the length for the next. */
static int advance_node(flk_path *p, flk_node *node, cell *c, double left, double *h,
                        flk_step *step)
{
    double size, factor, length, s = node->y[FLK_PASSED];
    int status = begin(p, node, c, step);

    if (status != FOURLINK_OK)
        return status;
    length = GSL_MIN(GSL_MIN(*h > 0 ? *h : time_for(step, 0.1), longest(step, c)), left);
    for (; p->budget > 0; p->budget--) {
        status = try_step(p, c, step, length, &node->within, &size);
        if (status == FOURLINK_OK && size <= 1) {
            *h = length * GSL_MIN(5, 0.9 * pow(GSL_MAX(size, 1e-10), -0.125));
            node->h = length;
            p->budget--;
            return FOURLINK_OK;
        }
        size = status != FOURLINK_OK || !(size < WORST) ? WORST : size;
        factor = GSL_MAX(0.2, 0.9 * pow(size, -0.125));
        length *= factor;
        if (!(length >= shortest(p, step, status > 0 ? CLOSEST : SHORTEST, left)))
            return status > 0 ? status : why_none(p, s, status);
    }
    return why_none(p, s, FOURLINK_OK);
}

/* ---------------------------------------------------------------------------------- where a step is cut */

/* The change of an unknown within a step, minus the change sought; the slope of the speed. */
typedef struct passing {
    const flk_curve_of_step *within;
    int i;
    double change;
} passing;

static double passed_by(double part, void *data)
{
    const passing *x = data;
    double slope;

    return flk_step_change(x->within, x->i, part, &slope) - x->change;
}

static double slope_of_speed(double part, void *data)
{
    const passing *x = data;
    double slope;

    flk_step_change(x->within, FLK_SPEED, part, &slope);
    return slope;
}

double flk_node_part(const flk_node *node, int i, double value, double most)
{
    flk_bracket b;
    passing x;

    x.within = &node->within;
    x.i = i;
    x.change = value - node->y[i];
    b = flk_bracket_of(0, most, -x.change, passed_by(most, &x));
    return flk_find_zero(passed_by, &x, &b, 0);
}

double flk_node_peak(const flk_node *node, double from, double to)
{
    flk_bracket b;
    passing x;

    x.within = &node->within;
    b = flk_bracket_of(from, to, slope_of_speed(from, &x), slope_of_speed(to, &x));
    return b.f_low * b.f_high < 0 ? flk_find_zero(slope_of_speed, &x, &b, 0) : to;
}

void flk_node_within(const flk_node *node, double part, flk_node *at)
{
    double slope;
    int i;

    at->t = node->t + part * node->h;
    for (i = 0; i < FLK_UNKNOWNS; i++)
        at->y[i] = node->y[i] + flk_step_change(&node->within, i, part, &slope);
    at->residual = node->residual;
    at->h = 0;
    at->is_at_rest = 0;
}

/* Cut a step where unknown i crosses a value, if that is before *part. */
static int cut(const flk_node *node, int i, double value, int rises, double *part)
{
    flk_node at;

    flk_node_within(node, *part, &at);
    if (rises ? !(at.y[i] > value) : !(at.y[i] < value))
        return 0;
    *part = flk_node_part(node, i, value, *part);
    return 1;
}

/* The node at the end of a step, or where it first leaves the cell, and why.  A speed with a peak may
** leave the cell and return.  One that begins at an end of the piece of the motor's curve leaves it only
** when it is clear of that: with its peak there it would be cut again and again, and time would stand
** still. */
static ending end_step(const flk_path *p, const flk_node *node, const cell *c, flk_node *after)
{
    double sense = p->equation.sense, part = flk_node_peak(node, 0, 1);
    double low = sense > 0 ? c->slowest : -c->fastest, high = sense > 0 ? c->fastest : -c->slowest;
    double speed = node->y[FLK_SPEED], clear = NUDGE * fabs(speed);
    ending why = IN_CELL;

    if (speed - low < clear)
        low = speed - clear;
    if (high - speed < clear)
        high = speed + clear;
    for (;; part = 1) {
        if (fabs(node->y[FLK_SPEED]) > STILL * c->slow &&
            cut(node, FLK_SPEED, 0, c->turning < 0, &part))
            why = AT_STOP;
        if (cut(node, FLK_PASSED, c->end, c->turning > 0, &part))
            why = AT_END;
        if (cut(node, FLK_SPEED, high, 1, &part) || cut(node, FLK_SPEED, low, 0, &part))
            why = AT_SPEED;
        if (part == 1 || why != IN_CELL)
            break;
    }
    flk_node_within(node, part, after);
    if (why == AT_END)
        after->y[FLK_PASSED] = c->end;
    if (why == AT_STOP)
        after->y[FLK_SPEED] = 0;
    return why;
}

/* ----------------------------------------------------------------------------------------- cell by cell */

static int keep_node(flk_path *p, const flk_node *node)
{
    if (p->n == p->room) {
        size_t room = p->room ? 2 * p->room : 128;
        flk_node *more = realloc(p->node, room * sizeof *more);

        if (!more) {
            p->no_memory = 1;
            p->status = FOURLINK_NO_MEMORY;
            return 0;
        }
        p->node = more;
        p->room = room;
    }
    p->node[p->n++] = *node;
    p->largest = GSL_MAX(p->largest, node->y[FLK_ENERGY]);
    return 1;
}

/* The acceleration at a node, in the sense of the motion; 0 if there is none. */
static double acceleration_at(flk_path *p, const flk_node *node)
{
    double dy[FLK_UNKNOWNS];

    return flk_equation_derive(&p->equation, node->t, node->y, dy) == FOURLINK_OK ? dy[FLK_SPEED]
                                                                                  : 0;
}

/* Hold the piece of the motor's curve that the speed enters. */
static void hold_speed(flk_path *p, const flk_node *node, cell *c)
{
    const fourlink_motor *motor = &p->equation.machine.motor;
    flk_acting *acting = p->equation.acting;
    double speed = p->equation.sense * node->y[FLK_SPEED], alpha;

    acting->held_speed = speed;
    flk_motor_piece(motor, speed, &c->slowest, &c->fastest);
    if (!gsl_finite(c->slowest) && !gsl_finite(c->fastest))
        return;
    alpha = p->equation.sense * acceleration_at(p, node);
    acting->held_speed += NUDGE * (fabs(speed) + GSL_DBL_MIN) * GSL_SIGN(alpha);
    flk_motor_piece(motor, acting->held_speed, &c->slowest, &c->fastest);
}

/* Enter the cell into which the crank turns from a node. */
static int enter(flk_path *p, const flk_node *node, int turning, double length, cell *c)
{
    flk_equation *e = &p->equation;
    double s = node->y[FLK_PASSED];
    fourlink_crank crank = {0, 0, 0};
    flk_direction direction;
    int status;

    direction.corners = p->corners;
    direction.branch = e->branch;
    direction.from = e->from;
    direction.sense = e->sense * turning;
    direction.has_loads = 1;
    c->turning = turning;
    c->goes_on = 0;
    c->end = turning * flk_corners_next(&direction, turning * s, NULL, 0, &c->what);
    crank.theta2 = flk_equation_theta2(e, 0.5 * (s + c->end));
    crank.omega2 = direction.sense;
    status = flk_mechanism_move(&e->machine.mechanism, e->branch, &crank, 1, &c->held);
    if (status != FOURLINK_OK)
        return status;
    if (turning > 0 && c->end > length - FLK_CORNERS_CLOSE(length)) {
        c->end = length;
        c->what = FLK_END_PLAIN;
    }
    e->acting->held = &c->held;
    hold_speed(p, node, c);
    return FOURLINK_OK;
}

/* A crank may creep into an equilibrium: it counts as at rest when almost no speed is left. */
static int creeps(const cell *c, const flk_node *before, const flk_node *after)
{
    double speed = fabs(after->y[FLK_SPEED]);

    return speed < fabs(before->y[FLK_SPEED]) && speed <= CREEP * c->slow;
}

/* The direction in which the crank turns from a node: 0 if it stays at rest. */
static int turns_to(flk_path *p, const flk_node *node)
{
    double speed = node->y[FLK_SPEED], alpha;

    if (speed != 0)
        return speed < 0 ? -1 : 1;
    p->equation.acting->held = NULL;
    alpha = acceleration_at(p, node);
    return alpha > 0 ? 1 : alpha < 0 && p->swings ? -1 : 0;
}

/* Integrate through a cell, up to its end, a length or a duration: FOURLINK_OK, or why the crank stops
** there. */
static int run_cell(flk_path *p, cell *c, double duration, double *h)
{
    flk_node after;
    flk_step step;
    ending why = IN_CELL;
    int status;

    while (why == IN_CELL && flk_path_end(p)->t < duration) {
        flk_node *node = &p->node[p->n - 1];

        status = advance_node(p, node, c, duration - node->t, h, &step);
        if (status != FOURLINK_OK)
            return status;
        why = end_step(p, node, c, &after);
        c->goes_on = why == IN_CELL;
        if (why == IN_CELL && step.h == duration - node->t)
            after.t = duration;
        if (why == AT_STOP && !p->swings)
            after.y[FLK_ENERGY] = 0;
        if (!keep_node(p, &after))
            return FOURLINK_NO_MEMORY;
        if (!p->swings && (why == AT_STOP || creeps(c, &p->node[p->n - 2], &after)))
            return FOURLINK_STALLS;
    }
    return why == AT_END && (c->what == FLK_END_DEAD || c->what == FLK_END_POLE)
               ? FOURLINK_DEAD_POSITION
               : FOURLINK_OK;
}

/* Start at a speed, in the sense of the motion. */
static int begin_path(flk_path *p, double speed)
{
    flk_node node;
    double total;

    p->n = 0;
    p->is_steady = 0;
    p->largest = 0;
    p->status = flk_equation_inertia(&p->equation, 0, &total);
    memset(&node, 0, sizeof node);
    node.y[FLK_SPEED] = speed;
    node.y[FLK_ENERGY] = p->status == FOURLINK_OK ? 0.5 * total * speed * speed : 0;
    return keep_node(p, &node) && p->status == FOURLINK_OK;
}

/* Enter the cell into which the crank turns from a node; 0 if it stays at rest there.  A load with other
** values where its variable falls can push to rest from both sides. */
static int leave(flk_path *p, const flk_node *node, double length, cell *c)
{
    int turning = turns_to(p, node);

    if (turning == 0)
        return 0;
    p->status = enter(p, node, turning, length, c);
    return p->status != FOURLINK_OK || node->y[FLK_SPEED] != 0 ||
           turning * acceleration_at(p, node) > 0;
}

/* Stay at rest: no torque changes any more. */
static void rest(flk_path *p, double duration)
{
    flk_node node = *flk_path_end(p);

    node.h = 0;
    node.is_at_rest = 1;
    keep_node(p, &node);
    node.t = duration;
    keep_node(p, &node);
}

static int run_path(flk_path *p, double speed, double length, double duration)
{
    double h = 0;
    cell c;

    if (!begin_path(p, speed))
        return 0;
    while (p->status == FOURLINK_OK && flk_path_end(p)->y[FLK_PASSED] < length &&
           flk_path_end(p)->t < duration) {
        int leaves = leave(p, flk_path_end(p), length, &c);

        if (leaves && p->status == FOURLINK_OK)
            p->status = run_cell(p, &c, duration, &h);
        else if (!leaves && p->swings)
            rest(p, duration);
        else if (!leaves)
            p->status = FOURLINK_DOES_NOT_START;
        p->equation.acting->held = NULL;
    }
    return p->status == FOURLINK_OK;
}

int flk_path_run(flk_path *p, double speed, double length)
{
    p->swings = 0;
    return run_path(p, speed, length, GSL_POSINF);
}

int flk_path_run_for(flk_path *p, double speed, double duration)
{
    p->swings = 1;
    return run_path(p, p->equation.sense * speed, GSL_POSINF, duration);
}
