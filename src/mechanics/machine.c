/* SPDX-License-Identifier: GPL-3.0-or-later
**
** machine.c - the mechanism with everything that determines forces and accelerations.
**
** The equation of motion is
**
**    (J + I_f) alpha2 + J' omega2^2 / 2 = T_m + Q
**
** I_f is the inertia of flywheel and rotor on the shaft outside the crank, T_m the torque of the motor, and Q
** the generalised force of loads, weights, springs, dampers and friction.  The torque on the crank is
** Ts = T_m - I_f alpha2.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "inertia.h"
#include "kind.h"
#include "friction.h"
#include "mechanism.h"
#include "machine.h"

#define STEPS 60 /* of the secant */

void flk_machine_finish(flk_machine *m)
{
    size_t i;

    m->n_loads = 0;
    m->needs_motion = m->has_friction;
    for (i = 0; i < m->n_elements; i++) {
        flk_element *e = &m->element[i];

        e->first = m->n_loads;
        m->n_loads += (unsigned long)e->n_loads;
        m->needs_motion |= e->needs_motion;
        m->needs_angles |= e->needs_angles;
    }
    m->first_friction = m->n_loads;
    m->n_loads += m->has_friction ? FOURLINK_FRICTION_LOADS : 0;
}

int flk_machine_leaves_dead(const flk_machine *m)
{
    return m->mechanism.drive && !m->has_friction;
}

size_t flk_machine_count(const flk_machine *m, const flk_element_type *type)
{
    size_t i, n = 0;

    for (i = 0; i < m->n_elements; i++)
        n += m->element[i].type == type;
    return n;
}

const flk_element *flk_machine_find(const flk_machine *m, const flk_element_type *type, size_t i)
{
    size_t k;

    for (k = 0; k < m->n_elements; k++)
        if (m->element[k].type == type && i-- == 0)
            return &m->element[k];
    return NULL;
}

/* Clear a load that is not known yet. */
static void clear_load(fourlink_load *load, int link)
{
    memset(load, 0, sizeof *load);
    load->link = link;
}

static void begin(const flk_machine *m, double omega2, flk_acting *acting)
{
    const flk_kind *kind = flk_kind_of(m->mechanism.design.kind);
    unsigned long i;

    omega2 = acting->held ? acting->held->link[FOURLINK_CRANK].omega : omega2;
    acting->sense = flk_friction_sense(omega2, &m->friction);
    acting->gas_force = 0;
    for (i = m->first_friction; i < m->n_loads; i++)
        clear_load(&acting->load[i], flk_friction_link(kind, i - m->first_friction));
}

void flk_machine_loads_at(const flk_machine *m, fourlink_branch branch, double theta2,
                          double omega2, flk_acting *acting)
{
    fourlink_state state;
    size_t k;
    int i;

    state.branch = branch;
    state.link[FOURLINK_CRANK].theta = theta2;
    begin(m, omega2, acting);
    for (k = 0; k < m->n_elements; k++) {
        const flk_element *e = &m->element[k];

        for (i = 0; i < e->n_loads && e->needs_motion; i++)
            clear_load(&acting->load[e->first + (unsigned long)i], e->link[i]);
        if (!e->needs_motion)
            e->type->act(e, m, &state, &acting->load[e->first], acting);
    }
}

/* Set the loads for a state, but those of friction to 0.  It may be at unit speed if no load depends on
** the speed. */
static int set_loads(const flk_machine *m, const fourlink_state *state, double omega2,
                     flk_acting *acting)
{
    int status = FOURLINK_OK;
    size_t k;

    begin(m, omega2, acting);
    for (k = 0; k < m->n_elements && status == FOURLINK_OK; k++) {
        const flk_element *e = &m->element[k];

        status = e->type->act(e, m, state, &acting->load[e->first], acting);
    }
    return status;
}

int flk_machine_forces(const flk_machine *m, const fourlink_state *state, int closed_form,
                       flk_acting *acting, fourlink_forces *forces, fourlink_losses *losses)
{
    const fourlink_mechanism *mechanism = &m->mechanism;
    int status = set_loads(m, state, state->link[FOURLINK_CRANK].omega, acting);

    if (status != FOURLINK_OK)
        return status;
    closed_form = closed_form && state->sine != 0; /* links 3 and 4 alone carry no force there */
    if (m->has_friction) {
        status = flk_friction_solve(mechanism, state, acting->held, acting->load, m->n_loads,
                                    &m->friction, closed_form, forces, losses);
        if (status != FOURLINK_OK)
            return status;
        memcpy(acting->load + m->first_friction, losses->load,
               losses->n_loads * sizeof *losses->load);
        return FOURLINK_OK;
    }
    status = closed_form ? fourlink_solve_dyad(mechanism, state, acting->load, m->n_loads, forces)
                         : fourlink_solve(mechanism, state, acting->load, m->n_loads, forces);
    memset(losses, 0, sizeof *losses);
    losses->Ts0 = forces->at_crank;
    losses->efficiency = 1;
    return status;
}

/* ------------------------------------------------------------------------------------------ its motion */

double flk_machine_shaft(const flk_machine *m)
{
    return m->flywheel + m->motor.ratio * m->motor.ratio * m->motor.inertia;
}

int flk_machine_at(const flk_machine *m, fourlink_branch branch, double theta2,
                   flk_machine_place *place)
{
    fourlink_crank crank = {0, 1, 0};
    int status;

    crank.theta2 = theta2;
    status = flk_mechanism_move(&m->mechanism, branch, &crank, m->needs_angles, &place->state);
    if (status != FOURLINK_OK)
        return status;
    flk_inertia_of_motion(&m->mechanism, &place->state, &place->J, &place->half_slope);
    place->total = place->J + flk_machine_shaft(m);
    return place->total > 0 ? FOURLINK_OK : FOURLINK_NO_INERTIA;
}

/* The torque on the crank that an acceleration needs, minus the torque from the shaft: Ts - (T_m - I_f
** alpha2). */
static int missing_torque(const flk_machine *m, fourlink_state *state, const flk_acting *acting,
                          double T_motor, double alpha2, double *value)
{
    fourlink_forces forces;
    fourlink_losses losses;
    int status;

    fourlink_acceleration(&m->mechanism, alpha2, state);
    status = flk_friction_solve(&m->mechanism, state, acting->held, acting->load, m->n_loads,
                                &m->friction, 1, &forces, &losses);
    if (status == FOURLINK_OK)
        *value = forces.Ts - T_motor + flk_machine_shaft(m) * alpha2;
    return status;
}

/* Friction depends on the pin forces, and these on alpha2.  The secant method starts from the acceleration
** without friction and is kept within the known bracket, because it jumps about where the missing torque has
** a kink.  The missing torque grows with alpha2, unless friction locks the mechanism. */
static int find_alpha(const flk_machine *m, const flk_machine_place *place, fourlink_state *state,
                      const flk_acting *acting, flk_machine_torque *torque)
{
    double last = torque->alpha2, at, missing_last, missing_here, slope = place->total, size, known;
    double omega2 = state->link[FOURLINK_CRANK].omega;
    flk_bracket b = flk_bracket_of(0, 0, GSL_POSINF, GSL_NEGINF);
    int i, status = missing_torque(m, state, acting, torque->T_motor, last, &missing_last);

    at = last - (status == FOURLINK_OK ? missing_last : 0) / slope;
    size = fabs(torque->net) + place->total * fabs(at);
    known =
        1e-11 * size + 1e-13 * place->J * omega2 * omega2; /* of which the net torque is the rest */
    if (status == FOURLINK_OK)
        flk_bracket_take(&b, last, missing_last, 1);
    for (i = 0; status == FOURLINK_OK && i < STEPS && at != last; i++) {
        status = missing_torque(m, state, acting, torque->T_motor, at, &missing_here);
        if (status != FOURLINK_OK)
            break;
        slope = (missing_here - missing_last) / (at - last);
        if (!(slope > 0))
            return fabs(missing_here) <= known ? FOURLINK_OK : FOURLINK_LOCKED;
        torque->alpha2 = at;
        if (fabs(missing_here) <= 1e-15 * size)
            break;
        flk_bracket_take(&b, at, missing_here, 1);
        last = at;
        missing_last = missing_here;
        at -= missing_here / slope;
        if (b.f_low < 0 && b.f_high > 0 && !(b.low < at && at < b.high))
            at = flk_bracket_next(&b);
    }
    return status == FOURLINK_OK && i == STEPS && fabs(missing_last) > known ? FOURLINK_LOCKED
                                                                             : status;
}

/* All loads at the actual speeds. */
static int move_loads(const flk_machine *m, const flk_machine_place *place, double omega2,
                      fourlink_state *moving, flk_acting *acting)
{
    if (!m->needs_motion)
        return set_loads(m, &place->state, omega2, acting);
    FLK_COPY_STATE(&m->mechanism, moving, &place->state);
    fourlink_velocity(&m->mechanism, omega2, moving);
    return set_loads(m, moving, moving->link[FOURLINK_CRANK].omega, acting);
}

int flk_machine_torque_at(const flk_machine *m, const flk_machine_place *place, double omega2,
                          flk_acting *acting, flk_machine_torque *torque)
{
    double turning = place->half_slope * omega2 * omega2;
    fourlink_state moving;
    int status = move_loads(m, place, omega2, &moving, acting);

    if (status != FOURLINK_OK)
        return status;
    torque->T_motor =
        flk_motor_torque(&m->motor, omega2, acting->held ? acting->held_speed : omega2);
    torque->net =
        torque->T_motor + flk_inertia_force(&m->mechanism, &place->state, acting->load, m->n_loads);
    torque->alpha2 = (torque->net - turning) / place->total;
    if (!m->has_friction)
        return FOURLINK_OK;
    status = find_alpha(m, place, &moving, acting, torque);
    torque->net = place->total * torque->alpha2 + turning;
    return status;
}
