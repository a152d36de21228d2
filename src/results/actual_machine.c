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
#include "deck/schema.h"
#include "mechanics/inertia.h"
#include "mechanics/kind.h"

#define STEPS 20 /* of the secant */

void flk_machine_of(const deck *d, fourlink_branch branch, fourlink_load *loads,
                    unsigned long n_loads, flk_machine *m)
{
    unsigned long i;

    m->d = d;
    m->branch = branch;
    m->loads = loads;
    m->n_loads = n_loads;
    m->motor = d->drive.motor;
    m->flywheel = d->drive.flywheel;
    m->inertia = m->flywheel + m->motor.ratio * m->motor.ratio * m->motor.inertia;
    m->has_angles = 0;
    m->has_speeds = flk_deck_needs_motion(d);
    for (i = 0; i < d->n_springs; i++)
        m->has_angles |= d->springs[i].spring.is_torsional;
    for (i = 0; i < d->n_loads; i++)
        m->has_angles |= d->variations[i].law.over == OVER_THETA4;
}

int flk_machine_at(const flk_machine *m, double theta2, flk_machine_place *place)
{
    fourlink_crank crank = {0, 1, 0};
    int status;

    crank.theta2 = theta2;
    status = flk_mechanism_move(&m->d->mechanism, m->branch, &crank, m->has_angles, &place->state);
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

/* All loads at the actual speeds. */
static int set_loads(const flk_machine *m, const flk_machine_place *place, double omega2,
                     fourlink_state *moving)
{
    double gas;

    if (!m->has_speeds) {
        flk_deck_set_loads(m->d, m->branch, place->state.link[FOURLINK_CRANK].theta, m->loads,
                           NULL);
        return FOURLINK_OK;
    }
    *moving = place->state;
    fourlink_velocity(&m->d->mechanism, omega2, moving);
    return flk_deck_set_moving_loads(m->d, moving, m->loads, &gas);
}

int flk_machine_push_at(const flk_machine *m, const flk_machine_place *place, double omega2,
                        flk_machine_push *push)
{
    double turning = place->half_slope * omega2 * omega2;
    fourlink_state moving;
    int status = set_loads(m, place, omega2, &moving);

    if (status != FOURLINK_OK)
        return status;
    push->T_motor = flk_motor_torque(&m->motor, omega2);
    push->push =
        push->T_motor + flk_inertia_push(&m->d->mechanism, &place->state, m->loads, m->n_loads);
    push->alpha2 = (push->push - turning) / place->whole;
    if (!m->d->has_friction)
        return FOURLINK_OK;
    status = find_alpha(m, place, &moving, push);
    push->push = place->whole * push->alpha2 + turning;
    return status;
}
