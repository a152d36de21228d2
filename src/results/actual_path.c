/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_path.c - the motion of one branch from a given energy: steps of the integration, and any angle between them.
**
** Over the angle s that the crank has passed, in the sense of the motion,
**
**    dE/ds = T_m + Q,   dt/ds = 1 / omega2,   du/ds = alpha2,   omega2^2 = 2 E / (J + I_f)
**
** E is smooth where the crank does not come near to rest.  The angle at which E would vanish is about E / |dE/ds| away;
** where that is close, and from rest, the time is the variable:
**
**    ds/dt = omega2,   domega2/dt = alpha2,   dE/dt = (T_m + Q) omega2
**
** u = omega2^2 / 2 follows from the accelerations, which need J', and E from the work, which does not: that
** (J + I_f) u = E checks both.  Where torques depend on the angle alone, E is a mere quadrature.
**
** Steps end where torques have corners.  Rows lie within steps: they do not depend on each other, nor on the interval
** between them.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "actual_path.h"
#include "analysis.h"
#include "motion_pieces.h"

#define NEAR_REST 0.05 /* rad, to where the energy would vanish */
#define LONGEST 0.5    /* rad, of a step */
#define SHORTEST 1e-13 /* of the angle passed */
#define CLOSEST 1e-9   /* rad, to where there is no position */
#define MOST_NODES 200000UL
#define INSIDE 1e-11 /* of a cycle: corners are not touched, for torques may jump there */
#define BESIDE 1e-5  /* rad: a change point has no position, but means of those beside it */
#define ITERATIONS 60
#define DIFFERENCE 1e-5 /* of the speed, for a derivative */
#define TO_REST (-1)    /* a status: the energy vanishes within a step */

/* Equations of a step. */
typedef struct equations {
    const flk_path *p;
    double low, high;
} equations;

static double inside(const equations *e, double s)
{
    double nothing = INSIDE * e->p->a->d->cycle, middle = 0.5 * (e->low + e->high);

    nothing = GSL_MIN(nothing, 0.25 * (e->high - e->low));
    return s < middle ? GSL_MAX(s, e->low + nothing) : GSL_MIN(s, e->high - nothing);
}

static double theta2_of(const flk_path *p, double s)
{
    const fourlink_motion *motion = &p->a->d->motion;

    return motion->from * motion->angle_unit + p->sense * s;
}

/* The machine at a speed in the sense of the motion; alpha2 and push in that sense. */
static int push_at(const flk_path *p, const flk_machine_place *place, double speed,
                   flk_machine_push *push)
{
    int status = flk_machine_push_at(&p->machine, place, p->sense * speed, push);

    push->push *= p->sense;
    push->alpha2 *= p->sense;
    return status;
}

/* y = E, t, u over s */
static int over_angle(const equations *e, double s, const double *y, double *dy)
{
    flk_machine_place place;
    flk_machine_push push;
    double speed;
    int status;

    if (!(y[0] > 0))
        return TO_REST;
    status = flk_machine_at(&e->p->machine, theta2_of(e->p, s), &place);
    if (status != FOURLINK_OK)
        return status;
    speed = sqrt(2 * y[0] / place.whole);
    status = push_at(e->p, &place, speed, &push);
    dy[0] = push.push;
    dy[1] = 1 / speed;
    dy[2] = push.alpha2;
    return status;
}

/* y = s, speed, E over t */
static int over_time(const equations *e, double s, const double *y, double *dy)
{
    flk_machine_place place;
    flk_machine_push push;
    int status = flk_machine_at(&e->p->machine, theta2_of(e->p, s), &place);

    if (status == FOURLINK_OK)
        status = push_at(e->p, &place, y[1], &push);
    if (status != FOURLINK_OK)
        return status;
    dy[0] = y[1];
    dy[1] = push.alpha2;
    dy[2] = push.push * y[1];
    return status;
}

/* Either of them at a change point. */
static int between(int (*f)(const equations *, double, const double *, double *),
                   const equations *e, double s, const double *y, double *dy)
{
    double before[3], after[3];
    int status, i;

    status = f(e, s, y, dy);
    if (status != FOURLINK_CHANGE_POINT)
        return status;
    status = f(e, s - BESIDE, y, before);
    if (status == FOURLINK_OK)
        status = f(e, s + BESIDE, y, after);
    for (i = 0; i < 3 && status == FOURLINK_OK; i++)
        dy[i] = 0.5 * (before[i] + after[i]);
    return status;
}

static int derive_over_angle(void *context, double x, const double *y, double *dy)
{
    const equations *e = context;

    return between(over_angle, e, inside(e, x), y, dy);
}

static int derive_over_time(void *context, double x, const double *y, double *dy)
{
    const equations *e = context;

    (void)x;
    return between(over_time, e, inside(e, y[0]), y, dy);
}

/* J + I_f at an angle, of a change point beside it. */
static int whole_at(const flk_path *p, double s, double *whole)
{
    flk_machine_place place;
    int status = flk_machine_at(&p->machine, theta2_of(p, s), &place);

    if (status == FOURLINK_CHANGE_POINT)
        status = flk_machine_at(&p->machine, theta2_of(p, s + BESIDE), &place);
    *whole = place.whole;
    return status;
}

/* Set the equations and the beginning of a step at a node. */
static int begin(const flk_path *p, flk_node *node, equations *e, flk_step *step)
{
    double whole;
    int status;

    e->p = p;
    e->low = node->low;
    e->high = node->high;
    step->context = e;
    if (node->by_time) {
        status = whole_at(p, node->s, &whole);
        if (status != FOURLINK_OK)
            return status;
        step->f = derive_over_time;
        step->x = node->t;
        step->y[0] = node->s;
        step->y[1] = node->speed = sqrt(2 * node->E / whole);
        step->y[2] = node->E;
    } else {
        step->f = derive_over_angle;
        step->x = node->s;
        step->y[0] = node->E;
        step->y[1] = node->t;
        step->y[2] = node->u;
    }
    return step->f(e, step->x, step->y, step->k[0]);
}

/* The time in which the crank turns through an angle from a speed, if its acceleration is constant. */
static double time_of(double speed, double alpha, double angle)
{
    double square = speed * speed + 2 * alpha * angle;
    double sum = speed + sqrt(GSL_MAX(square, 0));

    return sum > 0 ? 2 * angle / sum : 0;
}

/* The part of a step at which y[i], which it passes, has a value, by false position that halves the residual of an end
** that stays (the Illinois method). */
static double part_at(const flk_curve_of_step *within, int i, double change)
{
    double low = 0, high = 1, f_low = -change, f_high = flk_step_change(within, i, 1) - change;
    double part = 1, f;
    int k, side = 0;

    for (k = 0; k < ITERATIONS && high - low > 2e-16 * high && f_high != f_low; k++) {
        part = low - f_low * (high - low) / (f_high - f_low);
        if (!(part > low && part < high))
            break;
        f = flk_step_change(within, i, part) - change;
        if (f == 0)
            break;
        if ((f < 0) == (f_low < 0)) {
            low = part;
            f_low = f;
            f_high *= side == -1 ? 0.5 : 1;
            side = -1;
        } else {
            high = part;
            f_high = f;
            f_low *= side == 1 ? 0.5 : 1;
            side = 1;
        }
    }
    return part;
}

static int keep(flk_path *p, const flk_node *node)
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
        scale[0] = fabs(next[0] - y[0]);
        scale[1] = GSL_MAX(fabs(next[1]), y[1]);
        scale[2] = GSL_MAX(p->largest, fabs(next[2]));
    } else {
        scale[0] = GSL_MAX(0.01 * p->largest, next[0]);
        scale[1] = next[1];
        scale[2] = GSL_MAX(y[2], next[2]);
    }
    for (i = 0; i < FLK_UNKNOWNS; i++)
        sum += gsl_pow_2(error[i] / scale[i]);
    return sqrt(sum / FLK_UNKNOWNS) / p->tolerance;
}

/* Begin the next step: over time, if the crank is near to rest. */
static int choose(flk_path *p, flk_node *node, equations *e, flk_step *step)
{
    int status;

    node->by_time = !(node->E > 0);
    status = begin(p, node, e, step);
    if (node->by_time || (status == FOURLINK_OK && node->E > NEAR_REST * fabs(step->k[0][0])))
        return status;
    node->by_time = 1;
    return begin(p, node, e, step);
}

/* Take a step of this length: its error, or a status. */
static int try(const flk_path *p, const flk_node *node, flk_step *step, double h, double *size)
{
    double error[FLK_UNKNOWNS];
    int status;

    step->h = h;
    status = flk_step_take(step, error);
    if (status == FOURLINK_OK)
        *size = error_of(p, node, step, error);
    return status;
}

/* Values within a step that has been taken. */
static int fill(flk_step *step, flk_curve_of_step *within)
{
    int status = flk_step_end(step);

    return status == FOURLINK_OK ? flk_step_within(step, within) : status;
}

/* End a step over time where the crank comes to rest, or at the end of the piece, if it passes them. */
static int shorten(const flk_path *p, flk_node *node, flk_step *step)
{
    double size;
    int status = FOURLINK_OK;

    if (step->next[1] <= 0) {
        status = try(p, node, step, step->h * part_at(&node->within, 1, -step->y[1]), &size);
        step->next[1] = 0;
        if (status == FOURLINK_OK)
            status = fill(step, &node->within);
    }
    if (status == FOURLINK_OK && step->next[0] > node->high) {
        status =
            try(p, node, step, step->h * part_at(&node->within, 0, node->high - node->s), &size);
        step->next[0] = node->high;
        if (status == FOURLINK_OK)
            status = fill(step, &node->within);
    }
    return status;
}

static void end_step(const flk_node *node, double h, const double *next, flk_node *after)
{
    after->low = node->low;
    after->high = node->high;
    after->by_time = node->by_time;
    after->h = 0;
    if (node->by_time) {
        after->s = next[0];
        after->t = node->t + h;
        after->u = 0.5 * next[1] * next[1];
        after->E = next[1] > 0 ? next[2] : 0;
    } else {
        after->s = node->s + h;
        after->E = next[0];
        after->t = next[1];
        after->u = next[2];
    }
}

/* The length of the next step, in angle, of at most h. */
static double first_length(const flk_node *node, const flk_step *step, double h)
{
    double left = node->high - node->s, length = GSL_MIN(h, LONGEST);

    if (node->by_time && step->k[0][1] < 0) /* a little farther than to rest */
        length = GSL_MIN(length, 1.5 * gsl_pow_2(step->y[1]) / (-2 * step->k[0][1]));
    return length >= left ? left : length > 0.5 * left ? 0.5 * left : length;
}

/* One step from the last node, of at most *h in angle; *h is the length for the next. */
static int go_on(flk_path *p, double *h, flk_node *after)
{
    flk_node *node = &p->node[p->n - 1];
    double length, size;
    equations e;
    flk_step step;
    int status = choose(p, node, &e, &step);

    if (status != FOURLINK_OK)
        return status;
    if (node->by_time && node->E <= 0 && !(step.k[0][1] > 0))
        return FOURLINK_DOES_NOT_START;
    length = first_length(node, &step, *h);
    for (;;) {
        status = try(p, node, &step,
                     node->by_time ? time_of(step.y[1], step.k[0][1], length) : length, &size);
        if (status == FOURLINK_OK && size <= 1)
            status = fill(&step, &node->within);
        if (status == FOURLINK_OK && size <= 1)
            break;
        if (status != FOURLINK_OK)
            size = 1e8;
        length *= GSL_MAX(0.2, 0.9 * pow(size, -0.125));
        if (length < (status > 0 ? CLOSEST : SHORTEST * (1 + node->s)))
            return status > 0 ? status : FOURLINK_TOO_LONG;
    }
    if (node->by_time)
        status = shorten(p, node, &step);
    node->h = step.h;
    end_step(node, step.h, step.next, after);
    if (!node->by_time && length == node->high - node->s)
        after->s = node->high;
    *h = length * GSL_MIN(5, 0.9 * pow(GSL_MAX(size, 1e-10), -0.125));
    return status;
}

static int run_piece(flk_path *p, double *h)
{
    flk_node after;

    while (p->node[p->n - 1].s < p->node[p->n - 1].high) {
        p->status = p->n < MOST_NODES ? go_on(p, h, &after) : FOURLINK_TOO_LONG;
        if (p->status != FOURLINK_OK || !keep(p, &after))
            return 0;
        if (after.E <= 0 && after.s < after.high) {
            p->status = FOURLINK_STALLS;
            return 0;
        }
    }
    return 1;
}

int flk_path_run(flk_path *p, double speed, double length)
{
    flk_node first;
    flk_piece piece = {0, 0, FLK_END_PLAIN, FLK_END_PLAIN};
    double whole, h = 0.1;

    p->n = 0;
    p->is_steady = 0;
    p->largest = 0;
    p->status = whole_at(p, 0, &whole);
    memset(&first, 0, sizeof first);
    first.u = 0.5 * speed * speed;
    first.E = p->status == FOURLINK_OK ? whole * first.u : 0;
    if (!keep(p, &first) || p->status != FOURLINK_OK)
        return 0;
    while (flk_pieces_next(p->a, length, 1e30, &piece)) {
        p->node[p->n - 1].low = piece.from;
        p->node[p->n - 1].high = piece.to;
        if (!run_piece(p, &h))
            return 0;
        if (piece.end == FLK_END_DEAD && piece.to < length) {
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

/* The last node at or before s. */
static const flk_node *node_before(const flk_path *p, double s)
{
    size_t low = 0, high = p->n;

    while (high - low > 1) {
        size_t middle = (low + high) / 2;

        if (p->node[middle].s <= s)
            low = middle;
        else
            high = middle;
    }
    return &p->node[low];
}

/* The state at s of the step that begins at a node. */
static void state_at(const flk_node *node, double s, flk_node *at)
{
    double y[FLK_UNKNOWNS], part;
    int i;

    if (node->h == 0 || s <= node->s) {
        *at = *node;
        return;
    }
    part = node->by_time ? part_at(&node->within, 0, s - node->s) : (s - node->s) / node->h;
    part = GSL_MIN(part, 1);
    for (i = 0; i < FLK_UNKNOWNS; i++)
        y[i] = flk_step_change(&node->within, i, part);
    if (node->by_time) {
        y[0] += node->s;
        y[1] += node->speed;
        y[2] += node->E;
    } else {
        y[0] += node->E;
        y[1] += node->t;
        y[2] += node->u;
    }
    end_step(node, part * node->h, y, at);
}

/* The machine at s: its speed and what turns it. */
static int machine_at(const flk_path *p, double s, flk_node *at, double *speed,
                      flk_machine_place *place, flk_machine_push *push)
{
    int status = flk_machine_at(&p->machine, theta2_of(p, s), place);

    state_at(node_before(p, s), s, at);
    if (status != FOURLINK_OK)
        return status;
    *speed = at->by_time ? sqrt(2 * at->u) : sqrt(2 * at->E / place->whole);
    return push_at(p, place, *speed, push);
}

int flk_path_at(const flk_path *p, double s, flk_actual_row *row)
{
    flk_machine_place place;
    flk_machine_push push;
    flk_node at;
    double speed;
    int status = machine_at(p, s, &at, &speed, &place, &push);

    if (status != FOURLINK_OK)
        return status;
    row->crank.theta2 = theta2_of(p, s);
    row->crank.omega2 = p->sense * speed;
    row->crank.alpha2 = p->sense * push.alpha2;
    row->time = at.t;
    row->T_motor = push.T_motor;
    row->J = place.J;
    row->energy = 0.5 * place.whole * speed * speed;
    row->energy_residual = p->largest > 0 ? (place.whole * at.u - at.E) / p->largest : 0;
    return FOURLINK_OK;
}

/* d(T_m + Q)/d(omega2) / ((J + I_f) omega2) */
static int growth_at(const flk_path *p, const flk_node *node, double s, double *growth)
{
    flk_machine_place place;
    flk_machine_push slower, faster;
    flk_node at;
    double speed;
    int status = flk_machine_at(&p->machine, theta2_of(p, s), &place);

    state_at(node, s, &at);
    if (status != FOURLINK_OK)
        return status;
    speed = at.by_time ? sqrt(2 * at.u) : sqrt(2 * at.E / place.whole);
    status = push_at(p, &place, speed * (1 - DIFFERENCE), &slower);
    if (status == FOURLINK_OK)
        status = push_at(p, &place, speed * (1 + DIFFERENCE), &faster);
    *growth = (faster.push - slower.push) / (2 * DIFFERENCE * speed) / (place.whole * speed);
    return status;
}

/* By Gauss's rule of four points within each step. */
int flk_path_growth(const flk_path *p, double *growth)
{
    static const double x[4] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                0.93056815579702629};
    static const double w[4] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                0.17392742256872693};
    double sum = 0, value;
    size_t k;
    int i, status;

    for (k = 0; k + 1 < p->n; k++) {
        double from = p->node[k].s, length = p->node[k + 1].s - from;

        for (i = 0; i < 4; i++) {
            status = growth_at(p, &p->node[k], from + x[i] * length, &value);
            if (status != FOURLINK_OK)
                return status;
            sum += w[i] * length * value;
        }
    }
    *growth = sum;
    return FOURLINK_OK;
}
