/* SPDX-License-Identifier: GPL-3.0-or-later
**
** free_body.h - free bodies of the three moving links, and the check by virtual work, for both solutions of
** the nine equations and for friction.
**
** These are static functions in a header, so that the compiler can optimise each solution as a whole: they
** take most of the time of closed_form.c.
*/
#ifndef FOURLINK_FREE_BODY_H
#define FOURLINK_FREE_BODY_H

#include <float.h>
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

/* Free bodies of links 2, 3 and 4, with valid loads. */
static void flk_cut_free(const fourlink_mechanism *mechanism, const fourlink_state *state,
                         const fourlink_load *loads, unsigned long n_loads, flk_body body[3])
{
    unsigned long n;
    int i;

    for (i = 0; i < 3; i++)
        flk_cut_link(&mechanism->design.link[i + 2], &state->link[i + 2],
                     &mechanism->design.gravity, &body[i]);
    for (n = 0; n < n_loads; n++)
        flk_apply_load(&loads[n], &state->link[loads[n].link], &body[loads[n].link - 2]);
}

/* The moment equation of a link about its origin O instead of G: with f the right-hand side of its force
** equations, m that of its moment equation, and r = G - O,
**
**    M_O = m + r x f
*/
#define FLK_MOMENT_ABOUT_ORIGIN(body) ((body)->moment + FLK_CROSS((body)->arm, (body)->force))

/* Virtual work: with the velocities at unit crank speed,
**
**    Ts + sum F.v_P + sum T omega + sum W.v_G - sum (m a_G.v_G + I alpha omega) = 0
**
** gives Ts without the pin forces (ME3491, "principle of virtual work"), and checks the nine equations.
** Their Ts is the crank's own part plus F23.v_B; the residual is relative to this term too.
*/
static void flk_virtual_work(const fourlink_state *state, const flk_body body[3],
                             fourlink_forces *forces)
{
    double largest = fabs(forces->at_crank);
    const fourlink_vector *k_B = &state->link[3].k_origin;
    fourlink_vector F23, F34;
    int i;

    F23.x = forces->F23x;
    F23.y = forces->F23y;
    F34.x = forces->F34x;
    F34.y = forces->F34y;
    largest = flk_larger(largest, flk_larger(flk_dot_size(F23, *k_B), flk_dot_size(F34, *k_B)));
    forces->Ts_work = -(body[0].work + body[1].work + body[2].work);
    for (i = 0; i < 3; i++)
        largest = flk_larger(body[i].largest, largest);
    forces->residual = largest > 0 ? (forces->at_crank - forces->Ts_work) / largest : 0;
}

/* 0 for a state with NaN or infinite speeds or accelerations: they enter every term of the balance. */
static int flk_is_finite(const fourlink_forces *forces)
{
    return FLK_WITHIN(forces->at_crank - forces->Ts_work, DBL_MAX);
}

#endif
