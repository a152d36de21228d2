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
#include "inertia.h"
#include "kind.h"

void flk_inertia_of_motion(const fourlink_mechanism *mechanism, const fourlink_state *state,
                           double *J, double *turning)
{
    int i;

    *J = *turning = 0;
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        const fourlink_link *data = &mechanism->design.link[i];
        const fourlink_link_state *link = &state->link[i];
        fourlink_vector r, k, a;

        FLK_PLACE_MASS(data, link, r, k, a);
        *J += data->mass * FLK_DOT(k, k) + data->inertia * link->k * link->k;
        *turning += data->mass * FLK_DOT(k, a) + data->inertia * link->k * link->alpha;
    }
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
    unit = *state;
    fourlink_velocity(mechanism, 1, &unit);
    fourlink_acceleration(mechanism, 0, &unit);
    flk_inertia_of_motion(mechanism, &unit, &inertia, &half);
    *J = inertia;
    if (slope)
        *slope = 2 * half;
    return FOURLINK_OK;
}

double flk_inertia_force(const fourlink_mechanism *mechanism, const fourlink_state *state,
                         const fourlink_load *loads, unsigned long n_loads)
{
    const fourlink_vector *g = &mechanism->design.gravity;
    fourlink_vector r, F, k;
    double Q = 0;
    unsigned long n;
    int i;

    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++) {
        const fourlink_link_state *link = &state->link[i];

        FLK_TURN(r, link, mechanism->design.link[i].cg);
        FLK_UNIT_VELOCITY(k, link, r);
        Q += mechanism->design.link[i].mass * FLK_DOT(*g, k);
    }
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
        status = state ? flk_check_loads(loads, n_loads) : FOURLINK_NULL;
    if (status == FOURLINK_OK)
        *Q = flk_inertia_force(mechanism, state, loads, n_loads);
    return status;
}
