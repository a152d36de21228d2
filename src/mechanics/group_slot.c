/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group_slot.c - groups that hang by a slot: a block runs in a slot of the slider or rocker, on the pin P
** of the carrying link, or in a slot of the carrying link, on the pin Q of the slider or rocker.
**
** e is the direction of the slot and n = J e.  The block has no mass: its forces are S n.
*/
#include <math.h>

#include "base/trig.h"
#include "group.h"
#include "group_type.h"

#define UNIT 1e-9 /* by which the length of a unit vector may differ from 1 */

int flk_group_slot_is_good(const fourlink_group *g)
{
    const fourlink_link *block = &g->body[0];
    int is_slider = g->end == FOURLINK_GROUP_SLIDES, is_own = g->hang == FOURLINK_HANGS_BY_OWN_SLOT;

    if (block->mass != 0 || block->inertia != 0 || (is_slider && g->side != 1))
        return 0;
    if (is_own && !is_slider)
        return FLK_WITHIN(g->offset, FOURLINK_LENGTH_MAX);
    return FLK_WITHIN(FLK_DOT(g->slot, g->slot) - 1, UNIT) &&
           (!is_own || g->slot.y * g->slot.y > FLK_DEAD);
}

/* Velocity of the point of a link at an arm from its origin. */
#define VELOCITY(vel, link, r)                             \
    ((vel).x = (link)->velocity.x - (link)->omega * (r).y, \
     (vel).y = (link)->velocity.y + (link)->omega * (r).x)

/* The rate of the block along the slot, for the link that has the slot: e.(v - its velocity where the
** block is). */
static double rate_in(const fourlink_link_state *block, const fourlink_link_state *link)
{
    fourlink_vector r, v;

    r.x = block->origin.x - link->origin.x;
    r.y = block->origin.y - link->origin.y;
    VELOCITY(v, link, r);
    v.x = block->velocity.x - v.x;
    v.y = block->velocity.y - v.y;
    return FLK_DOT(block->axis, v);
}

void flk_group_slide(const fourlink_mechanism *mechanism, const fourlink_state *state, int i,
                     double *slide, double *rate)
{
    const fourlink_group *g = &mechanism->design.group[i];
    const fourlink_link_state *block = &state->link[FOURLINK_ROD_OF(i)], *end = block + 1;
    const fourlink_link_state *link =
        g->hang == FOURLINK_HANGS_IN_SLOT ? &state->link[g->link] : end;
    fourlink_vector r = {0, 0};

    if (g->hang == FOURLINK_HANGS_IN_SLOT)
        FLK_TURN(r, link, g->at);
    r.x = block->origin.x - link->origin.x - r.x;
    r.y = block->origin.y - link->origin.y - r.y;
    *slide = FLK_DOT(block->axis, r);
    *rate = rate_in(block, link);
}

/* --------------------------------------------------------------------------------------------- slider
**
** With d = P - P0, u the direction of the line through P0, v and a of the carrying link where the block is,
** and omega of the slot, 0 if it is the slider's,
**
**    S = (d x e) / (u x e),   Q = P0 + S u
**    S' = (v x e) / (u x e),   w = e.(S' u - v) in a slot of the link
**    S" = (a x e - 2 w omega) / (u x e)
**
** The block is at P, or at Q.  It is dead where the slot is along the line.
*/
static double place_slider(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *u = &h->group->direction, *e = &h->rod->axis;
    double sine = FLK_CROSS(*u, *e), S;
    fourlink_vector d;

    h->end->axis = *u;
    d.x = h->rod->origin.x - pivot->x;
    d.y = h->rod->origin.y - pivot->y;
    S = FLK_CROSS(d, *e) / sine;
    h->end->origin.x = pivot->x + S * u->x;
    h->end->origin.y = pivot->y + S * u->y;
    return sine * sine;
}

static double place_slider_with_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *u = &h->group->direction, *slot = &h->group->slot;

    h->rod->axis.x = slot->x * u->x - slot->y * u->y;
    h->rod->axis.y = slot->x * u->y + slot->y * u->x;
    return place_slider(h, pivot);
}

static double place_slider_in_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    double square;

    FLK_TURN(h->rod->axis, h->on, h->group->slot);
    square = place_slider(h, pivot);
    h->rod->origin = h->end->origin;
    return square;
}

/* Velocity or acceleration along the line from a part across the slot. */
static fourlink_vector along_line(const flk_hanging *h, double across)
{
    const fourlink_vector *u = &h->group->direction;
    double rate = across / FLK_CROSS(*u, h->rod->axis);
    fourlink_vector along;

    along.x = rate * u->x;
    along.y = rate * u->y;
    return along;
}

static void move_slider_with_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    (void)pivot;
    h->rod->k = h->end->k = 0;
    h->end->k_origin = along_line(h, FLK_CROSS(h->rod->k_origin, h->rod->axis));
}

static void move_slider_in_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    move_slider_with_slot(h, pivot);
    h->rod->k = h->on->k;
    h->rod->k_origin = h->end->k_origin;
}

static void accelerate_slider_with_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    (void)pivot;
    h->rod->alpha = h->end->alpha = 0;
    h->end->acceleration = along_line(h, FLK_CROSS(h->rod->acceleration, h->rod->axis));
}

static void accelerate_slider_in_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    double w = rate_in(h->rod, h->on);

    (void)pivot;
    h->rod->alpha = h->on->alpha;
    h->end->alpha = 0;
    h->end->acceleration =
        along_line(h, FLK_CROSS(h->rod->acceleration, h->rod->axis) - 2 * w * h->on->omega);
    h->rod->acceleration = h->end->acceleration;
}

/* ---------------------------------------------------------------------------------- rocker with a slot
**
** With r = P - D, h the offset of the slot and e = e6 its direction,
**
**    s = +- sqrt(r^2 - h^2),   r = s e + h n
**    omega6 = n.v / s,   s' = e.v + h omega6
**    alpha6 = (n.a - 2 s' omega6 + h omega6^2) / s
**
** The sine of its position is s / r: it is dead where P is at the foot of D on the slot.
*/
static double place_rocker_with_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    double offset = h->group->offset, f, square, s;
    fourlink_vector r, *e = &h->rod->axis;

    r.x = h->rod->origin.x - pivot->x;
    r.y = h->rod->origin.y - pivot->y;
    f = flk_length(r.x, r.y);
    square = (1 - offset / f) * (1 + offset / f);
    s = h->group->side * FLK_ROOT_OR_0(square);
    e->x = (s * r.x + offset * (r.y / f)) / f;
    e->y = (s * r.y - offset * (r.x / f)) / f;
    h->end->axis = *e;
    h->end->origin = *pivot;
    return f > 0 ? square : offset == 0 ? 0 : -1;
}

/* s, from D to P along the slot */
static double along_slot(const flk_hanging *h)
{
    fourlink_vector r;

    r.x = h->rod->origin.x - h->end->origin.x;
    r.y = h->rod->origin.y - h->end->origin.y;
    return FLK_DOT(h->rod->axis, r);
}

static void move_rocker_with_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    h->rod->k = h->end->k = FLK_CROSS(h->rod->axis, h->rod->k_origin) / along_slot(h);
    h->end->k_origin = *pivot;
}

static void accelerate_rocker_with_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    double omega = h->end->omega, offset = h->group->offset;
    double rate = FLK_DOT(h->rod->axis, h->rod->velocity) + offset * omega;

    h->rod->alpha = h->end->alpha = (FLK_CROSS(h->rod->axis, h->rod->acceleration) -
                                     2 * rate * omega + offset * omega * omega) /
                                    along_slot(h);
    h->end->acceleration = *pivot;
}

/* --------------------------------------------------------------- rocker with its pin in a slot of the link
**
** With r the rocker, e6 its axis from its pin D to Q, v and a of the carrying link at Q, omega and alpha
** its own,
**
**    c = n.(P - D) / r,   e6 = c n +- sqrt(1 - c^2) e,   Q = D + r e6
**    omega6 = n.v / (r e.e6),   w = e.(r omega6 J e6 - v)
**    alpha6 = (n.a + 2 w omega + r omega6^2 n.e6) / (r e.e6)
**
** It is dead where the rocker is square to the slot.
*/
static double place_rocker_in_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    double r = h->group->length, c, square, s;
    fourlink_vector n, d, *e = &h->rod->axis;

    FLK_TURN(*e, h->on, h->group->slot);
    FLK_TURN_LEFT(n, *e);
    d.x = h->rod->origin.x - pivot->x;
    d.y = h->rod->origin.y - pivot->y;
    c = FLK_DOT(n, d) / r;
    square = (1 - c) * (1 + c);
    s = h->group->side * FLK_ROOT_OR_0(square);
    h->end->axis.x = c * n.x + s * e->x;
    h->end->axis.y = c * n.y + s * e->y;
    h->end->origin = *pivot;
    h->rod->origin.x = pivot->x + r * h->end->axis.x;
    h->rod->origin.y = pivot->y + r * h->end->axis.y;
    return square;
}

static void move_rocker_in_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *e = &h->rod->axis, *e6 = &h->end->axis;
    double r = h->group->length;

    h->end->k = FLK_CROSS(*e, h->rod->k_origin) / (r * FLK_DOT(*e, *e6));
    h->end->k_origin = *pivot;
    h->rod->k = h->on->k;
    h->rod->k_origin.x = -r * h->end->k * e6->y;
    h->rod->k_origin.y = r * h->end->k * e6->x;
}

static void accelerate_rocker_in_slot(const flk_hanging *h, const fourlink_vector *pivot)
{
    const fourlink_vector *e = &h->rod->axis, *e6 = &h->end->axis;
    double r = h->group->length, w = rate_in(h->rod, h->on), omega = h->end->omega;

    h->end->alpha = (FLK_CROSS(*e, h->rod->acceleration) + 2 * w * h->on->omega +
                     r * omega * omega * FLK_CROSS(*e, *e6)) /
                    (r * FLK_DOT(*e, *e6));
    h->end->acceleration = *pivot;
    h->rod->alpha = h->on->alpha;
    h->rod->acceleration.x = -r * (h->end->alpha * e6->y + omega * omega * e6->x);
    h->rod->acceleration.y = r * (h->end->alpha * e6->x - omega * omega * e6->y);
}

/* ---------------------------------------------------------------------------------------------- forces
**
** The block is on slider or rocker at the arm rho from its origin:
**
**    slider   S u.n = u.f6
**    rocker   S rho x n = M6
*/
static fourlink_vector slot_force(const fourlink_vector *e, double S)
{
    fourlink_vector F;

    F.x = -S * e->y;
    F.y = S * e->x;
    return F;
}

static fourlink_vector solve_slider(const fourlink_group *group, const fourlink_link_state *rod,
                                    const fourlink_link_state *end, const flk_body body[2])
{
    const fourlink_vector *u = &group->direction, *e = &rod->axis;

    (void)end;
    return slot_force(e, FLK_DOT(*u, body[1].force) / FLK_CROSS(*e, *u));
}

static fourlink_vector solve_rocker(const fourlink_group *group, const fourlink_link_state *rod,
                                    const fourlink_link_state *end, const flk_body body[2])
{
    fourlink_vector rho;

    (void)group;
    rho.x = rod->origin.x - end->origin.x;
    rho.y = rod->origin.y - end->origin.y;
    return slot_force(&rod->axis, FLK_MOMENT_ABOUT_ORIGIN(&body[1]) / FLK_DOT(rho, rod->axis));
}

const flk_group_type flk_slider_with_slot = {place_slider_with_slot, move_slider_with_slot,
                                             accelerate_slider_with_slot, solve_slider};
const flk_group_type flk_slider_in_slot = {place_slider_in_slot, move_slider_in_slot,
                                           accelerate_slider_in_slot, solve_slider};
const flk_group_type flk_rocker_with_slot = {place_rocker_with_slot, move_rocker_with_slot,
                                             accelerate_rocker_with_slot, solve_rocker};
const flk_group_type flk_rocker_in_slot = {place_rocker_in_slot, move_rocker_in_slot,
                                           accelerate_rocker_in_slot, solve_rocker};
