/* SPDX-License-Identifier: GPL-3.0-or-later
**
** coordinate_search.c - the crank angle of a coordinate for which there is no closed form: of a slider or
** rocker of a group, of the length of an actuator on it, on the coupler, between two moving links.
**
** Along a stretch the coordinate only rises or only falls, so a value has one crank angle in it, between
** two nodes: values at crank angles that are found once for a stretch.  From there by Newton's method, as K
** is known, or by halves where that leaves the bracket or does not get on:
**
**    theta2 <- theta2 - (q - value) / K
**
** The error of the angle is that of q, over K.
*/
#include <float.h>
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/trig.h"
#include "coordinate_search.h"

#define PARTS 8 /* of the way between two nodes, in each of which an angle turns less than once */
#define FAR \
    1e3 /* of the crank and the least value of a stretch: a slider on its way beyond all bounds */
#define BACK 1e-6 /* rad: an angle that rounding turns back */
#define BESIDE \
    1e-9 /* of a stretch: beside an end where pins meet, so that a link has no direction */
#define ROUNDED 1e-12 /* of the value and the crank, or 1: what may be rounding error */
#define MOST_STEPS 200

int flk_search_has_to(const flk_actuator *actuator, fourlink_kind kind)
{
    int link = actuator->link == FOURLINK_GROUND ? actuator->to : actuator->link;

    return (actuator->link != FOURLINK_GROUND && actuator->to != FOURLINK_GROUND) ||
           !(link == FOURLINK_CRANK ||
             (link == FOURLINK_FOLLOWER && !fourlink_slides((int)kind, FOURLINK_FOLLOWER)));
}

int flk_search_groups(int link)
{
    return link > FOURLINK_FOLLOWER ? (link - FOURLINK_ROD_OF(0)) / 2 + 1 : 0;
}

void flk_search_reduce(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                       fourlink_mechanism *reduced)
{
    *reduced = *mechanism;
    reduced->design.n_groups = q->n_groups;
}

/* ------------------------------------------------------------------------------------------ the stretch */

/* The value at a crank angle of a stretch, at its ends too. */
static double value_in_stretch(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                               fourlink_branch branch, const flk_stretch *s, double theta2)
{
    double value = flk_coordinate_value(q, mechanism, branch, theta2);
    double beside = BESIDE * (s->theta2_to - s->theta2_from);

    if (!gsl_finite(value))
        value = flk_coordinate_value(q, mechanism, branch,
                                     theta2 < s->theta2_to - beside ? theta2 + beside
                                                                    : theta2 - beside);
    return value;
}

/* An angle moved by whole turns to what follows `last` on a side. */
static double follow(double last, int side, double value)
{
    return last + side * flk_cycle_place(side * (value - last), -BACK, 2 * M_PI);
}

/* Where a stretch ends on one side: at `end`, or where a slider is too far on the way to it, from a
** place near by. */
static double find_near_end(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, double far, double near, double end)
{
    double at;

    if (fabs(flk_coordinate_value(q, mechanism, branch, end)) <= far)
        return end;
    for (;;) {
        at = 0.5 * (near + end);
        if (at == near || at == end)
            return near;
        if (fabs(flk_coordinate_value(q, mechanism, branch, at)) <= far)
            near = at;
        else
            end = at;
    }
}

static void end_where_far(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                          fourlink_branch branch, flk_stretch *s)
{
    double way = s->theta2_to - s->theta2_from, nearest = s->theta2_from, theta2, far;
    double least = GSL_POSINF, value;
    int i;

    for (i = 0; i <= FLK_STRETCH_PARTS; i++) {
        theta2 = s->theta2_from + way * i / FLK_STRETCH_PARTS;
        value = fabs(flk_coordinate_value(q, mechanism, branch, theta2));
        if (value < least) {
            least = value;
            nearest = theta2;
        }
    }
    far = FAR * (mechanism->design.link[FOURLINK_CRANK].length + least);
    s->theta2_from = find_near_end(q, mechanism, branch, far, nearest, s->theta2_from);
    s->theta2_to = find_near_end(q, mechanism, branch, far, nearest, s->theta2_to);
}

void flk_search_prepare(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                        fourlink_branch branch, flk_stretch *s)
{
    int n = FLK_STRETCH_PARTS * PARTS, i;
    double theta2, last = 0, value;

    if (!q->is_angle)
        end_where_far(q, mechanism, branch, s);
    for (i = 0; i <= n; i++) {
        theta2 = i == n ? s->theta2_to
                        : s->theta2_from + 0.5 * (s->theta2_to - s->theta2_from) *
                                               (1 - flk_cosine(M_PI * i / n));
        value = value_in_stretch(q, mechanism, branch, s, theta2);
        last = i && q->is_angle ? follow(last, s->side, value) : value;
        if (i % PARTS == 0) {
            s->node[i / PARTS].theta2 = theta2;
            s->node[i / PARTS].value = last;
        }
    }
    s->from = s->node[0].value;
    s->to = last;
}

/* --------------------------------------------------------------------------------------------- whole turns
**
** A stretch that is a whole turn may begin anywhere in it (build_prescribed.c), while its nodes stay where
** they are: n turns of theta2 add n times what the coordinate turns in each.
*/
static double turn_of(const flk_stretch *s)
{
    return s->node[FLK_STRETCH_PARTS].theta2 - s->node[0].theta2;
}

static double turn_of_value(const flk_stretch *s)
{
    return s->node[FLK_STRETCH_PARTS].value - s->node[0].value;
}

/* The number of the node before a crank angle; before a value. */
static int node_at(const flk_stretch *s, double theta2)
{
    int low = 0, high = FLK_STRETCH_PARTS, middle;

    while (high - low > 1) {
        middle = (low + high) / 2;
        if (s->node[middle].theta2 <= theta2)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static int node_of(const flk_stretch *s, double value)
{
    int low = 0, high = FLK_STRETCH_PARTS, middle;

    while (high - low > 1) {
        middle = (low + high) / 2;
        if (s->side * (s->node[middle].value - value) <= 0)
            low = middle;
        else
            high = middle;
    }
    return low;
}

double flk_search_in_turn(const flk_stretch *s, double theta2, double value)
{
    double n = s->is_whole ? floor((theta2 - s->node[0].theta2) / turn_of(s)) : 0;

    return n * turn_of_value(s) +
           follow(s->node[node_at(s, theta2 - n * turn_of(s))].value, s->side, value);
}

/* ------------------------------------------------------------------------------------------- the search */

/* A value that is sought between two nodes, in a bracket of crank angles that shrinks. */
typedef struct search {
    const flk_coordinate *q;
    const fourlink_mechanism *mechanism;
    fourlink_branch branch;
    const flk_stretch *stretch;
    double low, high, from, value; /* the angle is that of `from`, and less than a turn more */
} search;

/* By how much the coordinate is beyond the value, so that it rises, at an angle inside the bracket,
** which it replaces one end of; and the next angle.  Where there is no position it is the nearer end of
** the stretch. */
static double take_angle(search *x, double theta2, const flk_prescribed *unit, double *next)
{
    int side = x->stretch->side;
    double now = x->q->is_angle ? follow(x->from, side, unit->value) : unit->value;
    double beyond = side * (now - x->value), slope = side * unit->rate;

    if (beyond < 0)
        x->low = theta2;
    else
        x->high = theta2;
    *next = slope > 0 ? theta2 - beyond / slope : GSL_NAN;
    return beyond;
}

static int search_between(search *x, double *theta2, flk_prescribed *unit, fourlink_state *state)
{
    double size =
        ROUNDED *
        (fabs(x->value) + (x->q->is_angle ? 1 : x->mechanism->design.link[FOURLINK_CRANK].length));
    double next = *theta2, beyond, last = GSL_POSINF;
    int i, status = FOURLINK_NO_SUCH_ANGLE;

    for (i = 0; i < MOST_STEPS; i++) {
        if (!(next > x->low && next < x->high) && (i || !(next == x->low || next == x->high)))
            next = 0.5 * (x->low + x->high);
        if (i && (next == x->low || next == x->high))
            break;
        *theta2 = next;
        status = flk_coordinate_unit_state(x->q, x->mechanism, x->branch, *theta2, unit, state);
        if (status != FOURLINK_OK) { /* a dead position, at an end of the stretch */
            if (*theta2 - x->stretch->theta2_from < x->stretch->theta2_to - *theta2)
                x->low = *theta2;
            else
                x->high = *theta2;
            next = GSL_NAN;
            continue;
        }
        beyond = take_angle(x, *theta2, unit, &next);
        if (beyond == 0 || fabs(next - *theta2) <= 0.5 * DBL_EPSILON * (1 + fabs(*theta2)))
            break;
        if (fabs(next - *theta2) > 0.5 * last) {
            if (fabs(beyond) <= size)
                break;
            next = GSL_NAN;
        }
        last = fabs(next - *theta2);
    }
    return status;
}

int flk_search_crank(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                     fourlink_branch branch, const flk_stretch *s, double value, double *theta2,
                     flk_prescribed *unit, fourlink_state *state)
{
    double turns = s->is_whole ? floor((value - s->node[0].value) / turn_of_value(s)) : 0;
    const flk_stretch_node *node;
    fourlink_mechanism reduced;
    int status;
    search x;

    x.value = value - turns * turn_of_value(s);
    node = &s->node[node_of(s, x.value)];
    *theta2 = s->theta2_from;
    if (s->side * (x.value - node[0].value) < 0 || s->side * (node[1].value - x.value) < 0)
        return FOURLINK_NO_SUCH_ANGLE;
    x.q = q;
    x.mechanism = mechanism;
    if (mechanism->design.n_groups > q->n_groups) {
        flk_search_reduce(q, mechanism, &reduced);
        x.mechanism = &reduced;
    }
    x.branch = branch;
    x.stretch = s;
    x.low = node[0].theta2;
    x.high = node[1].theta2;
    x.from = node[0].value;
    *theta2 =
        x.low + (x.high - x.low) * (x.value - node[0].value) / (node[1].value - node[0].value);
    status = search_between(&x, theta2, unit, state);
    *theta2 += turns * turn_of(s);
    return status == FOURLINK_OK && (mechanism->design.n_groups > q->n_groups || turns != 0)
               ? flk_coordinate_unit_state(q, mechanism, branch, *theta2, unit, state)
               : status;
}
