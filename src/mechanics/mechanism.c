/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mechanism.c - the common part of all mechanisms: the check of a design, the crank, points of links, the
** steps of an analysis.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "kind.h"
#include "closed_form.h"
#include "group.h"
#include "mechanism.h"

int flk_check_link(const fourlink_link *link)
{
    if (!FLK_WITHIN(link->mass, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(link->inertia, FOURLINK_NUMBER_MAX) ||
        !FLK_BOTH_WITHIN(link->cg, FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    if (link->mass < 0 || link->inertia < 0)
        return FOURLINK_BAD_MASS;
    return FOURLINK_OK;
}

int flk_check_length(double length)
{
    if (!FLK_WITHIN(length, FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    if (length <= 0)
        return FOURLINK_BAD_LENGTH;
    return length < FOURLINK_LENGTH_MIN ? FOURLINK_BAD_NUMBER : FOURLINK_OK;
}

/* A uniform slender bar between the ends of the link:
**
**    x_G = L / 2,  I_G = m L^2 / 12
*/
int fourlink_uniform_bar(double length, double mass, fourlink_link *link)
{
    if (!link)
        return FOURLINK_NULL;
    if (!FLK_WITHIN(mass, FOURLINK_NUMBER_MAX) || !FLK_WITHIN(length, FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    if (length <= 0)
        return FOURLINK_BAD_LENGTH;
    if (mass < 0)
        return FOURLINK_BAD_MASS;
    link->length = length;
    link->mass = mass;
    link->inertia = mass * length * length / 12;
    link->cg.x = length / 2;
    link->cg.y = 0;
    return FOURLINK_OK;
}

int fourlink_prepare(const fourlink_design *design, fourlink_mechanism *mechanism)
{
    const flk_kind *kind;
    fourlink_mechanism prepared;
    int i, status;

    if (!design || !mechanism)
        return FOURLINK_NULL;
    kind = flk_kind_of(design->kind);
    if (!kind)
        return FOURLINK_BAD_KIND;
    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        double length = design->link[i].length;
        int has_length = kind->has_length[i] == FLK_LENGTH ||
                         (kind->has_length[i] == FLK_LENGTH_OR_NONE && length != 0);

        if (has_length && (status = flk_check_length(length)) != FOURLINK_OK)
            return status;
        if (i != FOURLINK_GROUND && (status = flk_check_link(&design->link[i])) != FOURLINK_OK)
            return status;
    }
    if (!FLK_WITHIN(design->offset, FOURLINK_LENGTH_MAX) ||
        !FLK_WITHIN(design->angle, FOURLINK_NUMBER_MAX) ||
        !FLK_BOTH_WITHIN(design->gravity, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    status = flk_groups_check(design);
    if (status != FOURLINK_OK)
        return status;

    memset(&prepared, 0, sizeof prepared);
    prepared.design = *design;
    status = kind->prepare(&prepared);
    if (status == FOURLINK_OK)
        *mechanism = prepared;
    return status;
}

/* Sine and cosine of half the crank angle, and the sine of the position on this branch, or why there is
** none. */
typedef struct half_angle {
    double half_sine, half_cosine, sine;
} half_angle;

static int find_reach(const flk_kind *kind, const fourlink_mechanism *mechanism,
                      fourlink_branch branch, double theta2, half_angle *at)
{
    int status;

    if (!FLK_WITHIN(theta2, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    if (!flk_kind_has_branch(kind, branch))
        return FOURLINK_BAD_BRANCH;
    flk_sine_cosine(0.5 * theta2, &at->half_sine, &at->half_cosine);
    status = kind->reach(mechanism, at->half_sine, at->half_cosine, &at->sine);
    if (status == FOURLINK_OK && branch == FOURLINK_CROSSED)
        at->sine = -at->sine;
    return status;
}

/* The crank turns about the fixed pin A; its other pin B is the origin of link 3. */
static void place(const flk_kind *kind, const fourlink_mechanism *mechanism, fourlink_branch branch,
                  double theta2, const half_angle *at, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    fourlink_link_state *crank = &state->link[FOURLINK_CRANK];
    fourlink_link_state *coupler = &state->link[FOURLINK_COUPLER];
    double a = mechanism->design.link[FOURLINK_CRANK].length;

    crank->theta = theta2;
    crank->k = 1;
    crank->axis.x = (at->half_cosine - at->half_sine) * (at->half_cosine + at->half_sine);
    crank->axis.y = 2 * at->half_sine * at->half_cosine;
    crank->origin = zero;
    crank->k_origin = zero;
    crank->velocity = zero;
    crank->acceleration = zero;
    coupler->origin.x = a * crank->axis.x;
    coupler->origin.y = a * crank->axis.y;
    state->branch = branch;
    state->last = FLK_LAST_LINK(mechanism);
    state->sine = at->sine;
    state->group_sine = 1;
    state->phi = state->x = state->slide = state->s = 0;
    kind->position(mechanism, state);
}

double flk_angle_of_axis(const fourlink_vector *axis)
{
    if (fabs(axis->y) < 4e-16)
        return axis->x < 0 ? M_PI : 0;
    return flk_angle(axis->y, axis->x);
}

static void measure_angles(const flk_kind *kind, const fourlink_mechanism *mechanism,
                           fourlink_state *state)
{
    state->link[3].theta = flk_angle_of_axis(&state->link[3].axis);
    state->link[4].theta = flk_angle_of_axis(&state->link[4].axis);
    kind->angles(mechanism, state);
    if (mechanism->design.n_groups)
        flk_groups_angles(mechanism, state);
}

/* omega x r for the pin B of the crank */
static void move(const flk_kind *kind, const fourlink_mechanism *mechanism, double omega2,
                 fourlink_state *state)
{
    fourlink_link_state *crank = &state->link[FOURLINK_CRANK];
    fourlink_link_state *coupler = &state->link[FOURLINK_COUPLER];
    double a = mechanism->design.link[FOURLINK_CRANK].length;

    crank->omega = omega2;
    coupler->k_origin.x = -a * crank->axis.y;
    coupler->k_origin.y = a * crank->axis.x;
    coupler->velocity.x = coupler->k_origin.x * omega2;
    coupler->velocity.y = coupler->k_origin.y * omega2;
    state->v = state->slide_v = state->coriolis = 0;
    kind->velocity(mechanism, state);
}

/* alpha x r - omega^2 r for the pin B of the crank */
static void accelerate_pin_B(const flk_kind *kind, const fourlink_mechanism *mechanism,
                             double alpha2, fourlink_state *state)
{
    fourlink_link_state *crank = &state->link[FOURLINK_CRANK];
    fourlink_link_state *coupler = &state->link[FOURLINK_COUPLER];
    double t = mechanism->design.link[FOURLINK_CRANK].length * alpha2;
    double n = mechanism->design.link[FOURLINK_CRANK].length * crank->omega * crank->omega;

    crank->alpha = alpha2;
    coupler->acceleration.x = -t * crank->axis.y - n * crank->axis.x;
    coupler->acceleration.y = t * crank->axis.x - n * crank->axis.y;
    state->a = state->slide_a = 0;
    kind->acceleration(mechanism, state);
}

/* The position of every link where there are groups, which may not be assembled; other members are kept. */
static int place_all(const flk_kind *kind, const fourlink_mechanism *mechanism,
                     fourlink_branch branch, double theta2, const half_angle *at,
                     fourlink_state *state)
{
    fourlink_state found;
    int status;

    FLK_COPY_STATE(mechanism, &found, state);
    place(kind, mechanism, branch, theta2, at, &found);
    status = flk_groups_place(mechanism, &found);
    if (status == FOURLINK_OK)
        FLK_COPY_STATE(mechanism, state, &found);
    return status;
}

int fourlink_position(const fourlink_mechanism *mechanism, fourlink_branch branch, double theta2,
                      fourlink_state *state)
{
    const flk_kind *kind;
    half_angle at;
    int status = flk_kind_find(mechanism, state, &kind);

    if (status == FOURLINK_OK)
        status = find_reach(kind, mechanism, branch, theta2, &at);
    if (status == FOURLINK_OK && mechanism->design.n_groups)
        status = place_all(kind, mechanism, branch, theta2, &at, state);
    if (status != FOURLINK_OK)
        return status;
    if (!mechanism->design.n_groups)
        place(kind, mechanism, branch, theta2, &at, state);
    measure_angles(kind, mechanism, state);
    return FOURLINK_OK;
}

int fourlink_velocity(const fourlink_mechanism *mechanism, double omega2, fourlink_state *state)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, state, &kind);

    if (status != FOURLINK_OK)
        return status;
    if (!FLK_WITHIN(omega2, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    move(kind, mechanism, omega2, state);
    if (mechanism->design.n_groups)
        flk_groups_move(mechanism, state);
    return FOURLINK_OK;
}

int fourlink_acceleration(const fourlink_mechanism *mechanism, double alpha2, fourlink_state *state)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, state, &kind);

    if (status != FOURLINK_OK)
        return status;
    if (!FLK_WITHIN(alpha2, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    accelerate_pin_B(kind, mechanism, alpha2, state);
    if (mechanism->design.n_groups)
        flk_groups_accelerate(mechanism, state);
    return FOURLINK_OK;
}

/* For a point P of a rigid body with origin O and arm r = P - O:
**
**    v_P = v_O + omega x r,   a_P = a_O + alpha x r - omega^2 r
*/
int fourlink_point(const fourlink_state *state, int link, const fourlink_vector *at,
                   fourlink_vector *position, fourlink_vector *velocity,
                   fourlink_vector *acceleration)
{
    const fourlink_link_state *body;
    fourlink_vector r;

    if (!state || !at)
        return FOURLINK_NULL;
    if (link < FOURLINK_CRANK || link > state->last)
        return FOURLINK_BAD_LINK;
    if (!FLK_BOTH_WITHIN(*at, FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    body = &state->link[link];
    FLK_TURN(r, body, *at);
    if (position) {
        position->x = body->origin.x + r.x;
        position->y = body->origin.y + r.y;
    }
    if (velocity) {
        velocity->x = body->velocity.x - body->omega * r.y;
        velocity->y = body->velocity.y + body->omega * r.x;
    }
    if (acceleration)
        FLK_ACCELERATION(*acceleration, body, r);
    return FOURLINK_OK;
}

/* The motion of every link where there are groups, which may not be assembled. */
static int move_all(const flk_kind *kind, const fourlink_mechanism *mechanism,
                    fourlink_branch branch, const fourlink_crank *crank, const half_angle *at,
                    fourlink_state *state)
{
    fourlink_state found;
    int status;

    place(kind, mechanism, branch, crank->theta2, at, &found);
    move(kind, mechanism, crank->omega2, &found);
    accelerate_pin_B(kind, mechanism, crank->alpha2, &found);
    status = flk_groups_follow(mechanism, &found);
    if (status == FOURLINK_OK)
        FLK_COPY_STATE(mechanism, state, &found);
    return status;
}

static int check_speed(const fourlink_crank *crank)
{
    return FLK_WITHIN(crank->omega2, FOURLINK_NUMBER_MAX) &&
                   FLK_WITHIN(crank->alpha2, FOURLINK_NUMBER_MAX)
               ? FOURLINK_OK
               : FOURLINK_BAD_NUMBER;
}

int flk_mechanism_stand(const fourlink_mechanism *mechanism, fourlink_branch branch,
                        const fourlink_crank *crank, fourlink_state *state)
{
    const flk_kind *kind;
    half_angle at;
    int status = flk_kind_find(mechanism, state, &kind);

    if (status == FOURLINK_OK)
        status = find_reach(kind, mechanism, branch, crank->theta2, &at);
    if (status == FOURLINK_OK)
        status = check_speed(crank);
    if (status != FOURLINK_OK)
        return status;
    place(kind, mechanism, branch, crank->theta2, &at, state);
    measure_angles(kind, mechanism, state);
    return FOURLINK_OK;
}

/* Find the motion of every link, except the angles.  The state is written only if everything is valid,
** including the loads. */
static int analyse_motion(const flk_kind *kind, const fourlink_mechanism *mechanism,
                          fourlink_branch branch, const fourlink_crank *crank,
                          const fourlink_load *loads, unsigned long n_loads, fourlink_state *state)
{
    half_angle at;
    int status;

    if (!crank)
        return FOURLINK_NULL;
    status = find_reach(kind, mechanism, branch, crank->theta2, &at);
    if (status == FOURLINK_OK)
        status = check_speed(crank);
    if (status == FOURLINK_OK)
        status = flk_check_loads(mechanism, loads, n_loads);
    if (status != FOURLINK_OK)
        return status;
    if (mechanism->design.n_groups)
        return move_all(kind, mechanism, branch, crank, &at, state);
    place(kind, mechanism, branch, crank->theta2, &at, state);
    move(kind, mechanism, crank->omega2, state);
    accelerate_pin_B(kind, mechanism, crank->alpha2, state);
    return FOURLINK_OK;
}

int flk_mechanism_move(const fourlink_mechanism *mechanism, fourlink_branch branch,
                       const fourlink_crank *crank, int angles, fourlink_state *state)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, state, &kind);

    if (status == FOURLINK_OK)
        status = analyse_motion(kind, mechanism, branch, crank, NULL, 0, state);
    if (status == FOURLINK_OK && angles)
        measure_angles(kind, mechanism, state);
    return status;
}

int flk_mechanism_move_from(const fourlink_mechanism *mechanism, const fourlink_crank *crank,
                            int angles, fourlink_state *state)
{
    const flk_kind *kind = flk_kind_of(mechanism->design.kind);
    int status = check_speed(crank);

    if (status != FOURLINK_OK)
        return status;
    move(kind, mechanism, crank->omega2, state);
    accelerate_pin_B(kind, mechanism, crank->alpha2, state);
    if (angles)
        measure_angles(kind, mechanism, state);
    return FOURLINK_OK;
}

void flk_mechanism_place(const fourlink_mechanism *mechanism, fourlink_branch branch, double theta2,
                         fourlink_state *state)
{
    const flk_kind *kind = flk_kind_of(mechanism->design.kind);
    half_angle at;

    flk_sine_cosine(0.5 * theta2, &at.half_sine, &at.half_cosine);
    at.sine = 0;
    if (kind->reach(mechanism, at.half_sine, at.half_cosine, &at.sine) != FOURLINK_OK)
        at.sine = 0;
    if (branch == FOURLINK_CROSSED)
        at.sine = -at.sine;
    place(kind, mechanism, branch, theta2, &at, state);
}

int flk_mechanism_swing(const fourlink_mechanism *mechanism, fourlink_branch branch, double theta2,
                        double omega3, double alpha3, int angles, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    const flk_kind *kind = flk_kind_of(mechanism->design.kind);
    fourlink_link_state *crank = &state->link[FOURLINK_CRANK];
    fourlink_link_state *coupler = &state->link[FOURLINK_COUPLER];
    double t;
    int status = FOURLINK_OK;

    flk_mechanism_place(mechanism, branch, theta2, state);
    state->sine = 0;
    state->v = state->a = state->slide_v = state->slide_a = state->coriolis = 0;
    crank->k = crank->omega = 0;
    coupler->k = 1;
    coupler->omega = omega3;
    coupler->alpha = alpha3;
    coupler->k_origin = coupler->velocity = zero;
    kind->swing(mechanism, state);
    t = mechanism->design.link[FOURLINK_CRANK].length * crank->alpha;
    coupler->acceleration.x = -t * crank->axis.y;
    coupler->acceleration.y = t * crank->axis.x;
    if (mechanism->design.n_groups)
        status = flk_groups_follow(mechanism, state);
    if (status == FOURLINK_OK && angles)
        measure_angles(kind, mechanism, state);
    return status;
}

/* The matrix may be singular, so the state is written only after the solution. */
int fourlink_analyse(const fourlink_mechanism *mechanism, fourlink_branch branch,
                     const fourlink_crank *crank, const fourlink_load *loads, unsigned long n_loads,
                     fourlink_state *state, fourlink_forces *forces)
{
    const flk_kind *kind;
    fourlink_state result;
    int status;

    if (!forces)
        return fourlink_analyse_dyad(mechanism, branch, crank, NULL, 0, state, NULL);
    status = flk_kind_find(mechanism, state, &kind);
    if (status == FOURLINK_OK)
        status = analyse_motion(kind, mechanism, branch, crank, loads, n_loads, &result);
    if (status == FOURLINK_OK)
        status = fourlink_solve(mechanism, &result, loads, n_loads, forces);
    if (status != FOURLINK_OK)
        return status;
    measure_angles(kind, mechanism, &result);
    FLK_COPY_STATE(mechanism, state, &result);
    return FOURLINK_OK;
}

/* Once the position is found, its sine is not 0: only a drive can fail. */
int fourlink_analyse_dyad(const fourlink_mechanism *mechanism, fourlink_branch branch,
                          const fourlink_crank *crank, const fourlink_load *loads,
                          unsigned long n_loads, fourlink_state *state, fourlink_forces *forces)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, state, &kind);

    if (status == FOURLINK_OK)
        status = analyse_motion(kind, mechanism, branch, crank, loads, forces ? n_loads : 0, state);
    if (status != FOURLINK_OK)
        return status;
    if (forces)
        status = flk_dyad(kind, mechanism, state, loads, n_loads, forces);
    measure_angles(kind, mechanism, state);
    return status;
}

int fourlink_analyse_design(const fourlink_design *design, fourlink_branch branch,
                            const fourlink_crank *crank, const fourlink_load *loads,
                            unsigned long n_loads, fourlink_state *state, fourlink_forces *forces)
{
    fourlink_mechanism mechanism;
    int status = fourlink_prepare(design, &mechanism);

    if (status == FOURLINK_OK)
        status = fourlink_analyse(&mechanism, branch, crank, loads, n_loads, state, forces);
    return status;
}
