/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spring.c - springs and dampers between two links, or between a link and the ground.
**
** Between P of link i and Q of link j, with L = |Q - P|, e = (Q - P) / L and dL/dt = e . (v_Q - v_P),
**
**    T = T0 + k (L - L0) + c dL/dt,   T e on i at P,   -T e on j at Q
**
** and for a torsional spring, with the angle phi = theta_i - theta_j,
**
**    T = T0 + k (phi - phi0) + c dphi/dt,   -T on i,   T on j
**
** The energy is k s^2 / 2 + T0 s, s = L - L0 or phi - phi0.  A buffer acts only where s < 0, a rope only
** where s > 0.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/trig.h"
#include "kind.h"
#include "spring.h"
#include "turns.h"
#include "switch.h"

/* Find the position and velocity of an end of a spring. */
static void find_end(const fourlink_state *state, int link, const fourlink_vector *at,
                     fourlink_vector *place, fourlink_vector *velocity)
{
    if (link != FOURLINK_GROUND) {
        fourlink_point(state, link, at, place, velocity, NULL);
        return;
    }
    *place = *at;
    velocity->x = velocity->y = 0;
}

/* Add a force and a moment on a link. */
static void add_end_load(int link, const fourlink_vector *at, double Fx, double Fy, double torque,
                         fourlink_spring_state *s)
{
    fourlink_load *load = &s->load[s->n_loads];

    if (link == FOURLINK_GROUND) {
        s->ground.x = Fx;
        s->ground.y = Fy;
        s->ground_moment = torque + at->x * Fy - at->y * Fx;
        return;
    }
    load->link = link;
    load->at = *at;
    load->force.x = Fx;
    load->force.y = Fy;
    load->torque = torque;
    s->n_loads++;
}

static double omega_of(const fourlink_state *state, int link)
{
    return link == FOURLINK_GROUND ? 0 : state->link[link].omega;
}

static double angle_between(const fourlink_mechanism *mechanism, const fourlink_state *state,
                            const fourlink_spring *spring)
{
    return flk_turns_angle(mechanism, state, spring->link) -
           flk_turns_angle(mechanism, state, spring->to);
}

/* s, the length or angle minus the free one. */
static double stretch_of(const fourlink_mechanism *mechanism, const fourlink_state *state,
                         const fourlink_spring *spring)
{
    fourlink_vector P, Q, v;

    if (spring->is_torsional)
        return angle_between(mechanism, state, spring) +
               spring->turns[state->branch == FOURLINK_OPEN ? 0 : 1] - spring->free_length;
    find_end(state, spring->link, &spring->at, &P, &v);
    find_end(state, spring->to, &spring->to_at, &Q, &v);
    return flk_length(Q.x - P.x, Q.y - P.y) - spring->free_length;
}

/* 1 if a buffer or a rope does not act. */
static int is_slack(const fourlink_mechanism *mechanism, const fourlink_state *state,
                    const fourlink_spring *spring)
{
    return spring->only == FOURLINK_PUSHES  ? !(stretch_of(mechanism, state, spring) < 0)
           : spring->only == FOURLINK_PULLS ? !(stretch_of(mechanism, state, spring) > 0)
                                            : 0;
}

static int linear_at(const fourlink_state *state, const fourlink_spring *spring, int slack,
                     fourlink_spring_state *s)
{
    fourlink_vector P, Q, v_P, v_Q, e, zero = {0, 0};
    double k = spring->stiffness, past;

    find_end(state, spring->link, &spring->at, &P, &v_P);
    find_end(state, spring->to, &spring->to_at, &Q, &v_Q);
    e.x = Q.x - P.x;
    e.y = Q.y - P.y;
    s->length = flk_length(e.x, e.y);
    if (s->length > 0) {
        e.x /= s->length;
        e.y /= s->length;
    } else {
        if (!slack &&
            (spring->preload != 0 || (spring->free_length != 0 && k != 0) || spring->damping != 0))
            return FOURLINK_NO_DIRECTION;
        e = zero;
    }
    v_Q.x -= v_P.x;
    v_Q.y -= v_P.y;
    past = s->length - spring->free_length;
    s->rate = FLK_DOT(e, v_Q);
    s->force = slack ? 0 : spring->preload + k * past + spring->damping * s->rate;
    s->energy = slack ? 0 : 0.5 * k * past * past + spring->preload * past;
    add_end_load(spring->link, &spring->at, s->force * e.x, s->force * e.y, 0, s);
    add_end_load(spring->to, &spring->to_at, -s->force * e.x, -s->force * e.y, 0, s);
    return FOURLINK_OK;
}

static void torsional_at(const fourlink_mechanism *mechanism, const fourlink_state *state,
                         const fourlink_spring *spring, int slack, fourlink_spring_state *s)
{
    fourlink_vector zero = {0, 0};
    double past;

    s->length = angle_between(mechanism, state, spring) +
                spring->turns[state->branch == FOURLINK_OPEN ? 0 : 1];
    past = s->length - spring->free_length;
    s->rate = omega_of(state, spring->link) - omega_of(state, spring->to);
    s->force = slack ? 0 : spring->preload + spring->stiffness * past + spring->damping * s->rate;
    s->energy = slack ? 0 : 0.5 * spring->stiffness * past * past + spring->preload * past;
    add_end_load(spring->link, &zero, 0, 0, -s->force, s);
    add_end_load(spring->to, &zero, 0, 0, s->force, s);
}

/* The loads of a spring in a state, within the cell of another state. */
static int spring_in(const fourlink_mechanism *mechanism, const fourlink_state *state,
                     const fourlink_state *held, const fourlink_spring *spring,
                     fourlink_spring_state *at)
{
    int slack = is_slack(mechanism, held, spring), status = FOURLINK_OK;

    memset(at, 0, sizeof *at);
    if (spring->is_torsional)
        torsional_at(mechanism, state, spring, slack, at);
    else
        status = linear_at(state, spring, slack, at);
    at->power = -at->force * at->rate;
    return status;
}

int fourlink_spring_at(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       const fourlink_spring *spring, fourlink_spring_state *at)
{
    const flk_kind *kind;
    fourlink_spring_state s;
    int status = flk_kind_find(mechanism, at, &kind);

    if (status == FOURLINK_OK)
        status = state && spring ? spring_in(mechanism, state, state, spring, &s) : FOURLINK_NULL;
    if (status == FOURLINK_OK)
        *at = s;
    return status;
}

static const fourlink_branch branches[2] = {FOURLINK_OPEN, FOURLINK_CROSSED};

static int check_spring(const fourlink_spring *spring)
{
    if (spring->link < FOURLINK_GROUND || spring->link > FOURLINK_FOLLOWER ||
        spring->to < FOURLINK_GROUND || spring->to > FOURLINK_FOLLOWER)
        return FOURLINK_BAD_LINK;
    if (!FLK_BOTH_WITHIN(spring->at, FOURLINK_LENGTH_MAX) ||
        !FLK_BOTH_WITHIN(spring->to_at, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(spring->stiffness, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(spring->free_length, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(spring->preload, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(spring->damping, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    return spring->link == spring->to || spring->damping < 0 || spring->only < 0 ||
                   spring->only > FOURLINK_PULLS
               ? FOURLINK_BAD_SPRING
               : FOURLINK_OK;
}

#define BESIDE \
    1e-6 /* of the reachable range, and rad: a position that is neither dead nor a change point */

/* The four links alone, which have positions where groups cannot be assembled. */
static fourlink_mechanism without_groups(const fourlink_mechanism *mechanism)
{
    fourlink_mechanism bare = *mechanism;

    bare.design.n_groups = 0;
    return bare;
}

/* The first reachable crank angle from 0, or one just after it. */
static double first_reached(const fourlink_mechanism *mechanism)
{
    fourlink_reach reach;
    double first = GSL_POSINF;
    int i;

    fourlink_reach_of(mechanism, &reach);
    for (i = 0; i < reach.n_ranges; i++) {
        double from = reach.from[i] + BESIDE * (reach.to[i] - reach.from[i]);

        if (from < BESIDE && BESIDE < reach.to[i])
            return BESIDE;
        from = flk_cycle_place(from, 0, 2 * M_PI);
        first = from < first ? from : first;
    }
    return first;
}

int fourlink_spring_prepare(const fourlink_mechanism *mechanism, fourlink_spring *spring)
{
    const flk_kind *kind;
    fourlink_mechanism bare;
    fourlink_state state;
    int status = flk_kind_find(mechanism, spring, &kind), i;

    if (status == FOURLINK_OK)
        status = check_spring(spring);
    if (status == FOURLINK_OK)
        bare = without_groups(mechanism);
    for (i = 0; i < 2 && status == FOURLINK_OK; i++) {
        spring->turns[i] = 0;
        if (spring->is_torsional && fourlink_position(&bare, branches[i], first_reached(mechanism),
                                                      &state) == FOURLINK_OK) {
            double angle = angle_between(mechanism, &state, spring) - spring->free_length;

            spring->turns[i] = -2 * M_PI * flk_cycle_nearest(angle, 2 * M_PI);
        }
    }
    return status;
}

int flk_spring_winds(const fourlink_mechanism *mechanism, const fourlink_spring *spring,
                     double period)
{
    double theta2 = first_reached(mechanism);
    fourlink_mechanism bare = without_groups(mechanism);
    fourlink_state first, last;
    int i, winds = 0;

    for (i = 0; i < 2 && spring->is_torsional && (spring->stiffness != 0 || spring->only); i++)
        winds |= fourlink_position(&bare, branches[i], theta2, &first) == FOURLINK_OK &&
                 fourlink_position(&bare, branches[i], theta2 + period, &last) == FOURLINK_OK &&
                 fabs(angle_between(mechanism, &last, spring) -
                      angle_between(mechanism, &first, spring)) > 1;
    return winds;
}

static int apply_spring(const flk_element *element, const flk_machine *machine,
                        const fourlink_state *state, fourlink_load *load, flk_acting *acting)
{
    fourlink_spring_state at;
    const fourlink_state *held = acting->held ? acting->held : state;
    int status = spring_in(&machine->mechanism, state, held, element->data, &at), i;

    if (status != FOURLINK_OK)
        return status;
    for (i = 0; i < element->n_loads; i++)
        load[i] = at.load[i];
    return FOURLINK_OK;
}

static double switching(const flk_element *element, const flk_machine *machine,
                        const fourlink_state *state)
{
    return stretch_of(&machine->mechanism, state, element->data);
}

/* An angle that winds up passes the free one in one of many turns: the crank angles of this and of all
** whole turns from it repeat. */
static size_t list_spring_switches(const flk_element *element, const flk_machine *machine,
                                   flk_switch *list)
{
    const fourlink_spring *spring = element->data;

    (void)machine;
    if (!spring->only)
        return 0;
    flk_switch_of_element(element, list);
    list->period = spring->is_torsional ? 2 * M_PI : 0;
    return 1;
}

const flk_element_type flk_spring_type = {FOURLINK_LOAD_SPRING, apply_spring, list_spring_switches,
                                          switching};

void flk_element_of_spring(fourlink_spring *spring, flk_element *element)
{
    element->type = &flk_spring_type;
    element->data = spring;
    if (spring->link != FOURLINK_GROUND)
        element->link[element->n_loads++] = spring->link;
    if (spring->to != FOURLINK_GROUND)
        element->link[element->n_loads++] = spring->to;
    element->needs_motion = 1;
    element->needs_angles = spring->is_torsional;
    element->has_torque = spring->is_torsional;
}
