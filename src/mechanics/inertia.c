/* SPDX-License-Identifier: GPL-3.0-or-later
**
** inertia.c - the machine as one mass that turns with the crank.
**
** With the velocities v_G, k at unit crank speed, and the accelerations a_G, alpha at constant unit speed,
** the kinetic energy is J omega2^2 / 2, and
**
**    J     = sum m v_G.v_G + I k^2
**    J'    = 2 sum m v_G.a_G + I k alpha
**    Q     = sum F.v_P + T k + W.v_G
**    J alpha2 + J' omega2^2 / 2 = Ts + Q
**
** The last is Lagrange's equation for one coordinate, theta2.
*/
#include <string.h>

#include "inertia.h"
#include "kind.h"

static void add_link(const fourlink_link *data, const fourlink_link_state *link, double *J,
                     double *turning)
{
    fourlink_vector r, k, a;

    FLK_PLACE_MASS(data, link, r, k, a);
    *J += data->mass * FLK_DOT(k, k) + data->inertia * link->k * link->k;
    *turning += data->mass * FLK_DOT(k, a) + data->inertia * link->k * link->alpha;
}

/* The loop over three links, with sums in locals, is the one that takes time. */
void flk_inertia_of_motion(const fourlink_mechanism *mechanism, const fourlink_state *state,
                           double *J, double *turning)
{
    double inertia = 0, half_slope = 0;
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        add_link(&mechanism->design.link[i], &state->link[i], &inertia, &half_slope);
    for (; i <= FLK_LAST_LINK(mechanism); i++)
        add_link(FLK_LINK(mechanism, i), &state->link[i], &inertia, &half_slope);
    *J = inertia;
    *turning = half_slope;
}

int fourlink_inertia(const fourlink_mechanism *mechanism, const fourlink_state *state, double *J,
                     double *slope)
{
    const flk_kind *kind;
    fourlink_state unit;
    double half, inertia;
    int status = flk_kind_find(mechanism, J, &kind);

    if (status != FOURLINK_OK)
        return status;
    if (!state)
        return FOURLINK_NULL;
    FLK_COPY_STATE(mechanism, &unit, state);
    fourlink_velocity(mechanism, 1, &unit);
    fourlink_acceleration(mechanism, 0, &unit);
    flk_inertia_of_motion(mechanism, &unit, &inertia, &half);
    *J = inertia;
    if (slope)
        *slope = 2 * half;
    return FOURLINK_OK;
}

static double by_weight(const fourlink_link *data, const fourlink_link_state *link,
                        const fourlink_vector *g)
{
    fourlink_vector r, k;

    FLK_TURN(r, link, data->cg);
    FLK_UNIT_VELOCITY(k, link, r);
    return data->mass * FLK_DOT(*g, k);
}

double flk_inertia_force(const fourlink_mechanism *mechanism, const fourlink_state *state,
                         const fourlink_load *loads, unsigned long n_loads)
{
    const fourlink_vector *g = &mechanism->design.gravity;
    fourlink_vector r, F, k;
    double Q = 0;
    unsigned long n;
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        Q += by_weight(&mechanism->design.link[i], &state->link[i], g);
    for (; i <= FLK_LAST_LINK(mechanism); i++)
        Q += by_weight(FLK_LINK(mechanism, i), &state->link[i], g);
    for (n = 0; n < n_loads; n++) {
        const fourlink_link_state *link = &state->link[loads[n].link];

        FLK_PLACE_LOAD(&loads[n], link, r, F, k);
        Q += FLK_DOT(F, k) + loads[n].torque * link->k;
    }
    return Q;
}

int fourlink_generalised_force(const fourlink_mechanism *mechanism, const fourlink_state *state,
                               const fourlink_load *loads, unsigned long n_loads, double *Q)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, Q, &kind);

    if (status == FOURLINK_OK)
        status = state ? flk_check_loads(mechanism, loads, n_loads) : FOURLINK_NULL;
    if (status == FOURLINK_OK)
        *Q = flk_inertia_force(mechanism, state, loads, n_loads);
    return status;
}
