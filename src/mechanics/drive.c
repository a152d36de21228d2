/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drive.c - what drives a machine, if not a torque on the crank.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "drive.h"

#define DEAD 1e-7 /* of the crank's length, or of 1: K below it is 0 */

/* The place, velocity and acceleration of an end. */
static void find_end_of_drive(const fourlink_state *state, int link, const fourlink_vector *at,
                              fourlink_vector end[3])
{
    memset(end, 0, 3 * sizeof *end);
    if (link == FOURLINK_GROUND)
        end[0] = *at;
    else
        fourlink_point(state, link, at, &end[0], &end[1], &end[2]);
}

/* With r from the one end to the other, n its length and w = r / n its direction,
**
**    dn/dt = w . dr/dt,   d2n/dt2 = (dr/dt . dr/dt + r . d2r/dt2) / n - (dn/dt)^2 / n
*/
int flk_actuator_at(const flk_actuator *actuator, const fourlink_state *state,
                    flk_actuator_state *at)
{
    fourlink_vector P[3], Q[3], r[3];
    int i;

    find_end_of_drive(state, actuator->link, &actuator->at, P);
    find_end_of_drive(state, actuator->to, &actuator->to_at, Q);
    for (i = 0; i < 3; i++) {
        r[i].x = P[i].x - Q[i].x;
        r[i].y = P[i].y - Q[i].y;
    }
    at->length = flk_length(r[0].x, r[0].y);
    if (!(at->length > 0))
        return FOURLINK_NO_DIRECTION;
    at->w.x = r[0].x / at->length;
    at->w.y = r[0].y / at->length;
    at->speed = FLK_DOT(at->w, r[1]);
    at->acceleration = FLK_DOT(at->w, r[2]) +
                       gsl_pow_2(FLK_CROSS(at->w, r[1])) / at->length; /* r'.r' - n'^2, of n */
    return FOURLINK_OK;
}

/* Add a force at a point of a moving link, in the frame of link 1. */
static void add_force(int link, const fourlink_vector *at, double Fx, double Fy, flk_unit_drive *u)
{
    fourlink_load *load = &u->load[u->n_loads];

    if (link == FOURLINK_GROUND)
        return;
    memset(load, 0, sizeof *load);
    load->link = link;
    load->at = *at;
    load->force.x = Fx;
    load->force.y = Fy;
    u->n_loads++;
}

static int push_ends(const flk_actuator *actuator, const fourlink_state *state, flk_unit_drive *u)
{
    flk_actuator_state at;
    int status = flk_actuator_at(actuator, state, &at);

    if (status != FOURLINK_OK)
        return status;
    add_force(actuator->link, &actuator->at, at.w.x, at.w.y, u);
    add_force(actuator->to, &actuator->to_at, -at.w.x, -at.w.y, u);
    return FOURLINK_OK;
}

/* The slide's force on the slider at B, and the opposite one on the lever at the same point. */
static void push_slider(const fourlink_state *state, flk_unit_drive *u)
{
    const fourlink_link_state *slider = &state->link[FOURLINK_COUPLER],
                              *lever = &state->link[FOURLINK_FOLLOWER];
    fourlink_vector r, at, origin = {0, 0};

    r.x = slider->origin.x - lever->origin.x;
    r.y = slider->origin.y - lever->origin.y;
    at.x = FLK_DOT(r, lever->axis);
    at.y = FLK_CROSS(lever->axis, r);
    add_force(FOURLINK_COUPLER, &origin, slider->axis.x, slider->axis.y, u);
    add_force(FOURLINK_FOLLOWER, &at, -slider->axis.x, -slider->axis.y, u);
}

/* A slider of a group along its line, or a rocker against the link with its pin. */
static void push_output(const flk_drive *drive, const fourlink_state *state, flk_unit_drive *u)
{
    static const fourlink_vector origin = {0, 0};
    const fourlink_link_state *end = &state->link[drive->link];

    if (!drive->is_torque) {
        add_force(drive->link, &origin, end->axis.x, end->axis.y, u);
        return;
    }
    add_force(drive->link, &origin, 0, 0, u);
    u->load[0].torque = 1;
    if (drive->to > FOURLINK_GROUND) {
        add_force(drive->to, &origin, 0, 0, u);
        u->load[1].torque = -1;
    }
}

/* The power of the loads at unit crank speed. */
static double power_of(const fourlink_state *state, const flk_unit_drive *u)
{
    double K = 0;
    int i;

    for (i = 0; i < u->n_loads; i++) {
        const fourlink_link_state *link = &state->link[u->load[i].link];
        fourlink_vector r, F, k;

        FLK_PLACE_LOAD(&u->load[i], link, r, F, k);
        K += FLK_DOT(F, k) + u->load[i].torque * link->k;
    }
    return K;
}

int flk_drive_is_torque(const flk_drive *drive)
{
    return drive->sort == FLK_DRIVE_TORQUE ||
           (drive->sort == FLK_DRIVE_OUTPUT && drive->is_torque) ||
           (drive->sort == FLK_DRIVE_LOAD && drive->load.torque != 0);
}

int flk_drive_unit(const flk_drive *drive, const fourlink_mechanism *mechanism,
                   const fourlink_state *state, flk_unit_drive *u)
{
    static const fourlink_vector origin = {0, 0};
    double length = mechanism->design.link[FOURLINK_CRANK].length;
    int status = FOURLINK_OK;

    u->n_loads = 0;
    switch (drive->sort) {
    case FLK_DRIVE_TORQUE:
        add_force(FOURLINK_FOLLOWER, &origin, 0, 0, u);
        u->load[0].torque = 1;
        break;
    case FLK_DRIVE_ALONG:
        add_force(FOURLINK_FOLLOWER, &origin, 1, 0, u);
        break;
    case FLK_DRIVE_SLIDE:
        push_slider(state, u);
        break;
    case FLK_DRIVE_ENDS:
        status = push_ends(drive->actuator, state, u);
        break;
    case FLK_DRIVE_OUTPUT:
        push_output(drive, state, u);
        break;
    default:
        u->load[u->n_loads++] = drive->load;
        break;
    }
    u->K = power_of(state, u);
    if (status == FOURLINK_OK && !(fabs(u->K) > DEAD * (flk_drive_is_torque(drive) ? 1 : length)))
        status = FOURLINK_INPUT_DEAD_CENTRE;
    return status;
}

int flk_drive_link(const flk_drive *drive, unsigned long i)
{
    static const int ends[2] = {FOURLINK_COUPLER, FOURLINK_FOLLOWER};
    const flk_actuator *a = drive->actuator;

    switch (drive->sort) {
    case FLK_DRIVE_SLIDE:
        return i < 2 ? ends[i] : 0;
    case FLK_DRIVE_ENDS:
        if (a->link == FOURLINK_GROUND || a->to == FOURLINK_GROUND)
            return i > 0 ? 0 : a->link == FOURLINK_GROUND ? a->to : a->link;
        return i > 1 ? 0 : i ? a->to : a->link;
    case FLK_DRIVE_OUTPUT:
        return i == 0 ? drive->link : i == 1 && drive->to > FOURLINK_GROUND ? drive->to : 0;
    case FLK_DRIVE_LOAD:
        return i > 0 ? 0 : drive->load.link;
    default:
        return i > 0 ? 0 : FOURLINK_FOLLOWER;
    }
}

int fourlink_drive_loads(const fourlink_mechanism *mechanism, const fourlink_state *state,
                         double effort, fourlink_load load[2], int *n)
{
    flk_unit_drive unit;
    int i;

    if (!mechanism || !state || !load || !n)
        return FOURLINK_NULL;
    *n = 0;
    if (!mechanism->drive ||
        flk_drive_unit(mechanism->drive, mechanism, state, &unit) == FOURLINK_NO_DIRECTION)
        return FOURLINK_OK;
    for (i = 0; i < unit.n_loads; i++) {
        load[i] = unit.load[i];
        load[i].force.x *= effort;
        load[i].force.y *= effort;
        load[i].torque *= effort;
    }
    *n = unit.n_loads;
    return FOURLINK_OK;
}
