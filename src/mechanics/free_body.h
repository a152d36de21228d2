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

#include "body.h"

/* Free bodies of links 2, 3 and 4, with valid loads.  `closed_form` is how the forces of groups are found. */
static void flk_cut_free(const fourlink_mechanism *mechanism, const fourlink_state *state,
                         const fourlink_load *loads, unsigned long n_loads, int closed_form,
                         flk_body body[3])
{
    unsigned long n;
    int i;

    for (i = 0; i < 3; i++)
        flk_cut_link(&mechanism->design.link[i + 2], &state->link[i + 2],
                     &mechanism->design.gravity, &body[i]);
    if (mechanism->design.n_groups) {
        flk_groups_cut(mechanism, state, loads, n_loads, closed_form, body);
        return;
    }
    for (n = 0; n < n_loads; n++)
        flk_apply_load(&loads[n], &state->link[loads[n].link], &body[loads[n].link - 2]);
}

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
