/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_machine.c - the machine at one crank angle and speed: its inertia, and the torques that turn it.
**
**    (J + I_f) alpha2 + J' omega2^2 / 2 = T_m + Q
**
** I_f is the inertia of flywheel and rotor on the shaft outside the crank, T_m the torque of the motor, and Q the
** generalised force of loads, weights, springs, dampers and friction.  The torque on the crank is Ts = T_m - I_f alpha2.
*/
#include <math.h>

#include "actual_machine.h"
#include "mechanics/inertia.h"

#define STEPS 20 /* of the secant */

int flk_machine_at(const flk_machine *m, double theta2, flk_machine_place *place)
{
    fourlink_crank crank = {0, 1, 0};
    int status;

    crank.theta2 = theta2;
    status =
        fourlink_analyse_dyad(&m->d->mechanism, m->branch, &crank, NULL, 0, &place->state, NULL);
    if (status != FOURLINK_OK)
        return status;
    flk_inertia_of_motion(&m->d->mechanism, &place->state, &place->J, &place->half_slope);
    place->whole = place->J + m->inertia;
    return place->whole > 0 ? FOURLINK_OK : FOURLINK_NO_INERTIA;
}

/* The torque on the crank that an acceleration needs, less that which the shaft gives: Ts - (T_m - I_f alpha2). */
static int miss(const flk_machine *m, fourlink_state *state, double T_motor, double alpha2,
                double *value)
{
    fourlink_forces forces;
    fourlink_losses losses;
    int status;

    fourlink_acceleration(&m->d->mechanism, alpha2, state);
    status = fourlink_solve_friction(&m->d->mechanism, state, m->loads, m->n_loads, &m->d->friction,
                                     1, &forces, &losses);
    if (status == FOURLINK_OK)
        *value = forces.Ts - T_motor + m->inertia * alpha2;
    return status;
}

/* Friction depends on the pin forces, and they on alpha2: the secant from the acceleration without friction.  What is
** missed grows with alpha2, unless friction locks the mechanism. */
static int find_alpha(const flk_machine *m, const flk_machine_place *place, fourlink_state *state,
                      flk_machine_push *push)
{
    double last = push->alpha2, at, miss_last, miss_at, slope = place->whole, size;
    int i, status = miss(m, state, push->T_motor, last, &miss_last);

    at = last - (status == FOURLINK_OK ? miss_last : 0) / slope;
    size = fabs(push->push) + place->whole * fabs(at);
    for (i = 0; status == FOURLINK_OK && i < STEPS && at != last; i++) {
        status = miss(m, state, push->T_motor, at, &miss_at);
        if (status != FOURLINK_OK)
            break;
        slope = (miss_at - miss_last) / (at - last);
        if (!(slope > 0))
            return fabs(miss_at) <= 1e-11 * size ? FOURLINK_OK : FOURLINK_LOCKED;
        push->alpha2 = at;
        if (fabs(miss_at) <= 1e-15 * size)
            break;
        last = at;
        miss_last = miss_at;
        at -= miss_at / slope;
    }
    return status == FOURLINK_OK && i == STEPS && fabs(miss_last) > 1e-11 * size ? FOURLINK_LOCKED
                                                                                 : status;
}

int flk_machine_push_at(const flk_machine *m, const flk_machine_place *place, double omega2,
                        flk_machine_push *push)
{
    const fourlink_mechanism *mechanism = &m->d->mechanism;
    double turning = place->half_slope * omega2 * omega2, gas;
    fourlink_state state = place->state;
    int status;

    fourlink_velocity(mechanism, omega2, &state);
    status = flk_deck_set_moving_loads(m->d, &state, m->loads, &gas);
    if (status != FOURLINK_OK)
        return status;
    push->T_motor = flk_motor_torque(&m->motor, omega2);
    push->push = push->T_motor + flk_inertia_push(mechanism, &state, m->loads, m->n_loads);
    push->alpha2 = (push->push - turning) / place->whole;
    if (!m->d->has_friction)
        return FOURLINK_OK;
    status = find_alpha(m, place, &state, push);
    push->push = place->whole * push->alpha2 + turning;
    return status;
}
