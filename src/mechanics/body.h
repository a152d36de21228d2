/* SPDX-License-Identifier: GPL-3.0-or-later
**
** body.h - a moving link cut free of the others: the right-hand sides of its equations, its virtual work.
*/
#ifndef FOURLINK_MECHANICS_BODY_H
#define FOURLINK_MECHANICS_BODY_H

#include <math.h>

#include "kind.h"

static double flk_larger(double x, double y)
{
    return x > y ? x : y;
}

/* The size of the terms of u . v, whose sum may be mere rounding error. */
static double flk_dot_size(fourlink_vector u, fourlink_vector v)
{
    return fabs(u.x * v.x) + fabs(u.y * v.y);
}

static void flk_apply_load(const fourlink_load *load, const fourlink_link_state *link,
                           flk_body *body)
{
    fourlink_vector F, r, k;
    double by_force, by_torque = load->torque * link->k;

    FLK_PLACE_LOAD(load, link, r, F, k);
    by_force = FLK_DOT(F, k);
    r.x -= body->arm.x;
    r.y -= body->arm.y;
    body->force.x -= F.x;
    body->force.y -= F.y;
    body->moment -= load->torque + FLK_CROSS(r, F);
    body->work += by_force + by_torque;
    body->largest = flk_larger(body->largest, flk_larger(flk_dot_size(F, k), fabs(by_torque)));
}

/* Right-hand sides (ME3491 eqs. 1 to 11) and terms of virtual work.  The coupler's a_G includes the
** acceleration of B, which the ME3491 program omits. */
static void flk_cut_link(const fourlink_link *data, const fourlink_link_state *link,
                         const fourlink_vector *gravity, flk_body *body)
{
    double turning = data->inertia * link->alpha;
    double by_weight, by_inertia, by_turning;
    fourlink_vector r, a, k;

    FLK_PLACE_MASS(data, link, r, k, a);
    by_weight = data->mass * FLK_DOT(*gravity, k);
    by_inertia = data->mass * FLK_DOT(a, k);
    by_turning = turning * link->k;
    body->arm = r;
    body->force.x = data->mass * (a.x - gravity->x);
    body->force.y = data->mass * (a.y - gravity->y);
    body->moment = turning;
    body->work = by_weight - by_inertia - by_turning;
    body->largest = flk_larger(
        data->mass * flk_larger(flk_dot_size(*gravity, k), flk_dot_size(a, k)), fabs(by_turning));
}

#endif
