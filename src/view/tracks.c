/* SPDX-License-Identifier: GPL-3.0-or-later
**
** tracks.c - the numbers of a mechanism at an instant.
*/
#include <math.h>

#include "system/format.h"
#include "base/text.h"
#include "geometry.h"
#include "rounding.h"
#include "tracks.h"

static const fourlink_vector zero = {0, 0};

char *tracks_name(const char *before, unsigned long i, char name[TRACKS_NAME])
{
    char number[FORMAT_SIZE];

    return flk_text_join(name, TRACKS_NAME, before, format_general((double)i, 10, number),
                         (char *)NULL);
}

fourlink_vector tracks_vector(const tracks *t, int number)
{
    return t->list[number].is_there ? t->list[number].v : zero;
}

int tracks_body(const tracks *t, int number)
{
    int i = number - TRACK_OUTPUT, joint;
    fourlink_load_info load;

    load.link = FOURLINK_GROUND;
    if (i >= 0)
        return i % TRACKS_OF_OUTPUT == OUTPUT_P ? t->v->design->group[i / TRACKS_OF_OUTPUT].link
                                                : FOURLINK_END_OF(i / TRACKS_OF_OUTPUT);
    if (number >= TRACK_DRIVE)
        fourlink_deck_drive(t->v->deck, (unsigned long)(number - TRACK_DRIVE), &load);
    else if (number >= TRACK_LOAD)
        fourlink_deck_load(t->v->deck, (unsigned long)(number - TRACK_LOAD), &load);
    else if (number >= TRACK_CENTRE)
        return (number - TRACK_CENTRE) / 3;
    for (joint = 0; joint < 4 && number < TRACK_CENTRE; joint++)
        if (TRACK_OF_JOINT(&t->v->kind.joint[joint]) == number)
            return t->v->kind.joint[joint].at;
    return load.link;
}

const fourlink_link *tracks_link(const view *v, int link)
{
    int k = link - FOURLINK_FOLLOWER - 1;

    return k < 0 ? &v->design->link[link] : &v->design->group[k / 2].body[k % 2];
}

static void begin(tracks *t, const view *v)
{
    int i;

    t->v = v;
    for (i = 0; i < TRACK_COUNT; i++)
        t->list[i].is_there = 0;
}

static void put(tracks *t, int number, quantity q, fourlink_vector v)
{
    track *x = &t->list[number];

    x->is_there = 1;
    x->q = q;
    x->v = v;
}

static void put_number(tracks *t, int number, quantity q, double si)
{
    put(t, number, q, place_at(si, 0));
}

/* Put position, velocity and acceleration of a point of a link. */
static void put_point(tracks *t, int number, const fourlink_state *state, int link,
                      const fourlink_vector *at)
{
    fourlink_vector place = zero, v = zero, a = zero;

    fourlink_point(state, link, at, &place, &v, &a);
    put(t, number, QUANTITY_LENGTH, place);
    put(t, number + 1, QUANTITY_SPEED, v);
    put(t, number + 2, QUANTITY_ACCELERATION, a);
}

static void put_place(tracks *t, int number, fourlink_vector place)
{
    put(t, number, QUANTITY_LENGTH, place);
}

/* Put the ends of a lever. */
static void put_lever(tracks *t, const fourlink_state *state)
{
    const fourlink_link_state *lever = &state->link[FOURLINK_FOLLOWER];

    put_place(t, TRACK_E1, place_in(lever->origin, lever->axis, t->v->lever_low, 0));
    put_place(t, TRACK_E2, place_in(lever->origin, lever->axis, t->v->lever_high, 0));
}

/* Put the ends of springs. */
static void put_springs(tracks *t, const fourlink_state *state)
{
    fourlink_spring spring;
    int k;

    for (k = 0; k < (int)t->v->problem.n_springs; k++) {
        fourlink_deck_spring(t->v->deck, (unsigned long)k, NULL, &spring);
        if (spring.is_torsional)
            continue;
        put_place(t, TRACK_SPRING + 2 * k, geometry_of_link(state, spring.link, &spring.at));
        put_place(t, TRACK_SPRING + 2 * k + 1, geometry_of_link(state, spring.to, &spring.to_at));
    }
}

static void put_points(tracks *t, const fourlink_state *state)
{
    fourlink_vector at;
    unsigned long k;
    int joint, link;

    for (joint = 0; joint < 4; joint++)
        put_place(t, TRACK_OF_JOINT(&t->v->kind.joint[joint]), geometry_joint(t->v, state, joint));
    if (t->v->kind.slotted)
        put_lever(t, state);
    for (link = FOURLINK_CRANK; link <= state->last; link++)
        if (tracks_link(t->v, link)->mass > 0)
            put_point(t, TRACK_OF_CENTRE(link), state, link, &tracks_link(t->v, link)->cg);
    for (k = 0; k < t->v->problem.n_points; k++) {
        fourlink_deck_point(t->v->deck, k, NULL, &link, &at);
        put_point(t, TRACK_OF_POINT(k), state, link, &at);
    }
    put_springs(t, state);
}

/* -------------------------------------------------------------------- velocities, accelerations, forces */

/* a^n = -omega^2 r, a^t = alpha x r, of the end of an arm r on a link, behind each other */
static void put_parts(tracks *t, int normal, const fourlink_link_state *link, fourlink_vector r)
{
    put(t, normal, QUANTITY_ACCELERATION, place_in(zero, r, -link->omega * link->omega, 0));
    put(t, normal + 1, QUANTITY_ACCELERATION, place_in(zero, r, 0, link->alpha));
}

/* The arm of a link: its length along its axis. */
static fourlink_vector arm(const tracks *t, const fourlink_state *state, int link)
{
    return place_in(zero, state->link[link].axis, t->v->design->link[link].length, 0);
}

/* v_C = v_B + v_CB; a_C = a_B + a_CB^n + a_CB^t */
static void put_rod(tracks *t, const fourlink_state *state)
{
    fourlink_vector C = place_at(t->v->design->link[FOURLINK_COUPLER].length, 0), v = zero,
                    a = zero;
    const fourlink_vector *v_B = &state->link[FOURLINK_COUPLER].velocity;

    fourlink_point(state, FOURLINK_COUPLER, &C, NULL, &v, &a);
    put(t, TRACK_VC, QUANTITY_SPEED, v);
    put(t, TRACK_VCB, QUANTITY_SPEED, place_at(v.x - v_B->x, v.y - v_B->y));
    put_parts(t, TRACK_ACBN, &state->link[FOURLINK_COUPLER], arm(t, state, FOURLINK_COUPLER));
    if (t->v->kind.guided)
        put(t, TRACK_AC, QUANTITY_ACCELERATION, a);
    else
        put_parts(t, TRACK_ACN, &state->link[FOURLINK_FOLLOWER], arm(t, state, FOURLINK_FOLLOWER));
}

/* v_B = v_B4 + slide_v u; a_B = a_B4^n + a_B4^t + 2 omega4 x slide_v u + slide_a u, B4 the point of the lever
** at B; a yoke does not turn, and a_B = a_B4 + slide_a u */
static void put_sliding(tracks *t, const fourlink_state *state)
{
    const fourlink_link_state *lever = &state->link[FOURLINK_FOLLOWER];
    const fourlink_vector *B = &state->link[FOURLINK_COUPLER].origin,
                          *u = &state->link[FOURLINK_COUPLER].axis;
    fourlink_vector r = place_at(B->x - lever->origin.x, B->y - lever->origin.y);

    put(t, TRACK_VB4, QUANTITY_SPEED, place_in(lever->velocity, r, 0, lever->omega));
    put(t, TRACK_VS, QUANTITY_SPEED, place_in(zero, *u, state->slide_v, 0));
    if (t->v->kind.guided) {
        put(t, TRACK_AB4, QUANTITY_ACCELERATION, lever->acceleration);
    } else {
        put_parts(t, TRACK_AB4N, lever, r);
        put(t, TRACK_AK, QUANTITY_ACCELERATION, place_in(zero, *u, 0, state->coriolis));
    }
    put(t, TRACK_AS, QUANTITY_ACCELERATION, place_in(zero, *u, state->slide_a, 0));
}

static void put_loads(tracks *t, const fourlink_state *state, const fourlink_load *loads)
{
    int k;

    for (k = 0; k < (int)t->v->problem.n_loads; k++) {
        const fourlink_load *load = &loads[k];

        put_place(t, TRACK_LOAD + k, geometry_of_link(state, load->link, &load->at));
        put(t, TRACK_LOAD_FORCE + k, QUANTITY_FORCE, geometry_force(load, state));
        put_number(t, TRACK_LOAD_TORQUE + k, QUANTITY_TORQUE, load->torque);
    }
}

static void put_drive(tracks *t, const fourlink_instant *now)
{
    fourlink_load load[2];
    int n, k;

    fourlink_drive_loads(t->v->mechanism, &now->state, now->forces.drive, load, &n);
    for (k = 0; k < n; k++) {
        put_place(t, TRACK_DRIVE + k, geometry_of_link(&now->state, load[k].link, &load[k].at));
        put(t, TRACK_DRIVE_FORCE + k, QUANTITY_FORCE, geometry_force(&load[k], &now->state));
        put_number(t, TRACK_DRIVE_TORQUE + k, QUANTITY_TORQUE, load[k].torque);
    }
}

/* Put weight, -m a_G and -I alpha of each link. */
static void put_inertia(tracks *t, const fourlink_state *state)
{
    fourlink_body body[FOURLINK_LINKS];
    int link;

    fourlink_bodies(t->v->mechanism, state, NULL, 0, body);
    for (link = FOURLINK_CRANK; link <= state->last; link++) {
        const fourlink_link *data = tracks_link(t->v, link);

        if (data->mass > 0) {
            put(t, TRACK_WEIGHT + link, QUANTITY_FORCE, body[link].weight);
            put(t, TRACK_INERTIA_FORCE + link, QUANTITY_FORCE,
                place_in(zero, body[link].acceleration, -data->mass, 0));
        }
        if (data->inertia > 0)
            put_number(t, TRACK_INERTIA_TORQUE + link, QUANTITY_TORQUE,
                       -data->inertia * state->link[link].alpha);
    }
}

/* ------------------------------------------------------------------------------------------ outputs */

static fourlink_vector difference(fourlink_vector u, fourlink_vector v)
{
    return place_at(u.x - v.x, u.y - v.y);
}

/* The part of a vector along a direction. */
static fourlink_vector along(fourlink_vector v, const fourlink_vector *e)
{
    return place_in(zero, *e, v.x * e->x + v.y * e->y, 0);
}

/* The pins of an output, with their motion; each is a point of a link. */
static void put_pins(tracks *t, const fourlink_state *state, int i)
{
    const fourlink_group *g = &t->v->design->group[i];
    int first = TRACK_OF_OUTPUT(i), rod = FOURLINK_ROD_OF(i);
    fourlink_vector end = zero;

    put_point(t, first + OUTPUT_P, state, g->link, &g->at);
    if (g->hang != FOURLINK_HANGS_IN_SLOT) {
        put(t, first + OUTPUT_VP, QUANTITY_SPEED, t->list[first + OUTPUT_P + 1].v);
        put(t, first + OUTPUT_AP, QUANTITY_ACCELERATION, t->list[first + OUTPUT_P + 2].v);
    }
    if (g->end == FOURLINK_GROUP_TURNS && g->hang != FOURLINK_HANGS_BY_OWN_SLOT)
        end.x = g->length;
    put_point(t, first + OUTPUT_Q, state, rod + 1, &end);
    if (g->end == FOURLINK_GROUP_TURNS && g->to > FOURLINK_GROUND)
        put_point(t, first + OUTPUT_D, state, g->to, &g->pivot);
    else
        put_place(t, first + OUTPUT_D, state->link[rod + 1].origin);
}

/* v_Q = v_P + v_QP, and of a rocker that floats v_Q = v_D + v_QD; so accelerations, each of two parts. */
static void put_by_rod(tracks *t, const fourlink_state *state, int i)
{
    const fourlink_group *g = &t->v->design->group[i];
    int first = TRACK_OF_OUTPUT(i);
    const track *P = &t->list[first + OUTPUT_P], *Q = &t->list[first + OUTPUT_Q];
    const fourlink_link_state *rod = &state->link[FOURLINK_ROD_OF(i)], *end = rod + 1;

    put(t, first + OUTPUT_VQP, QUANTITY_SPEED, difference(Q[1].v, P[1].v));
    put_parts(t, first + OUTPUT_AQPN, rod, difference(Q->v, P->v));
    if (g->end == FOURLINK_GROUP_TURNS && g->to > FOURLINK_GROUND) {
        const track *D = &t->list[first + OUTPUT_D];

        put(t, first + OUTPUT_VQD, QUANTITY_SPEED, difference(Q[1].v, D[1].v));
        put_parts(t, first + OUTPUT_AQDN, end, difference(Q->v, D->v));
    }
}

/* A point, with its velocity and acceleration, in a slot: those of the place r of the link that has it,
** there at present, and along the slot, with Coriolis' acceleration 2 omega x v between. */
typedef struct in_slot {
    fourlink_vector r, v, a, slide, slide_a, coriolis;
} in_slot;

static in_slot find_in_slot(const track point[3], const fourlink_link_state *on,
                            const fourlink_vector *axis)
{
    in_slot x;

    x.r = difference(point[0].v, on->origin);
    x.v = place_in(on->velocity, x.r, 0, on->omega);
    x.a = place_in(place_in(on->acceleration, x.r, 0, on->alpha), x.r, -on->omega * on->omega, 0);
    x.slide = along(difference(point[1].v, x.v), axis);
    x.coriolis = place_in(zero, x.slide, 0, 2 * on->omega);
    x.slide_a = along(difference(difference(point[2].v, x.a), x.coriolis), axis);
    return x;
}

/* v_P = v_P6 + v_PP6 along the slot, a_P = a_P6 + 2 omega6 x v_PP6 + a_PP6 */
static void put_by_own_slot(tracks *t, const fourlink_state *state, int i)
{
    int first = TRACK_OF_OUTPUT(i);
    const fourlink_link_state *end = &state->link[FOURLINK_END_OF(i)];
    in_slot x =
        find_in_slot(&t->list[first + OUTPUT_P], end, &state->link[FOURLINK_ROD_OF(i)].axis);

    put(t, first + OUTPUT_VP6, QUANTITY_SPEED, x.v);
    put(t, first + OUTPUT_VPP6, QUANTITY_SPEED, x.slide);
    if (t->v->design->group[i].end == FOURLINK_GROUP_SLIDES)
        put(t, first + OUTPUT_AP6, QUANTITY_ACCELERATION, x.a);
    else
        put_parts(t, first + OUTPUT_AP6N, end, x.r);
    put(t, first + OUTPUT_AK, QUANTITY_ACCELERATION, x.coriolis);
    put(t, first + OUTPUT_AS, QUANTITY_ACCELERATION, x.slide_a);
}

/* v_Q = v_Qk + v_QQk along the slot, a_Q = a_Qk + 2 omega_k x v_QQk + a_QQk */
static void put_in_slot(tracks *t, const fourlink_state *state, int i)
{
    int first = TRACK_OF_OUTPUT(i);
    in_slot x = find_in_slot(&t->list[first + OUTPUT_Q], &state->link[t->v->design->group[i].link],
                             &state->link[FOURLINK_ROD_OF(i)].axis);

    put(t, first + OUTPUT_VQK, QUANTITY_SPEED, x.v);
    put(t, first + OUTPUT_VQQK, QUANTITY_SPEED, x.slide);
    put(t, first + OUTPUT_AQK, QUANTITY_ACCELERATION, x.a);
    put(t, first + OUTPUT_AKK, QUANTITY_ACCELERATION, x.coriolis);
    put(t, first + OUTPUT_ASK, QUANTITY_ACCELERATION, x.slide_a);
}

/* Q from the pole: a slider's, or in two parts a rocker's about a fixed pin. */
static void put_Q(tracks *t, const fourlink_state *state, int i)
{
    const fourlink_group *g = &t->v->design->group[i];
    int first = TRACK_OF_OUTPUT(i);
    const track *Q = &t->list[first + OUTPUT_Q];
    const fourlink_link_state *end = &state->link[FOURLINK_END_OF(i)];

    if (g->hang == FOURLINK_HANGS_BY_OWN_SLOT ||
        (g->end == FOURLINK_GROUP_TURNS && g->to > FOURLINK_GROUND))
        return;
    put(t, first + OUTPUT_VQ, QUANTITY_SPEED, Q[1].v);
    if (g->end == FOURLINK_GROUP_SLIDES)
        put(t, first + OUTPUT_AQ, QUANTITY_ACCELERATION, Q[2].v);
    else
        put_parts(t, first + OUTPUT_AQN, end, difference(Q->v, end->origin));
}

static void put_output(tracks *t, const fourlink_state *state, int i)
{
    put_pins(t, state, i);
    switch (t->v->design->group[i].hang) {
    case FOURLINK_HANGS_BY_ROD:
        put_by_rod(t, state, i);
        break;
    case FOURLINK_HANGS_BY_OWN_SLOT:
        put_by_own_slot(t, state, i);
        break;
    case FOURLINK_HANGS_IN_SLOT:
        put_in_slot(t, state, i);
    }
    put_Q(t, state, i);
}

/* With the unknowns of a group: S n of a slot in place of the components of FP or FQ. */
static void put_forces_of_output(tracks *t, const fourlink_instant *now, const fourlink_load *loads,
                                 int i)
{
    const fourlink_state *state = &now->state;
    const fourlink_group *g = &t->v->design->group[i];
    const fourlink_vector *e = &state->link[FOURLINK_ROD_OF(i)].axis;
    int first = TRACK_OF_OUTPUT(i);
    double A[6][6], b[6], x[6];

    if (view_group_system(t->v, now, loads, i, A, b, x) != FOURLINK_OK)
        return;
    put(t, first + OUTPUT_FP, QUANTITY_FORCE,
        g->hang == FOURLINK_HANGS_IN_SLOT ? place_in(zero, *e, 0, x[0]) : place_at(x[0], x[1]));
    if (g->hang == FOURLINK_HANGS_BY_ROD)
        put(t, first + OUTPUT_FQ, QUANTITY_FORCE, place_at(x[2], x[3]));
    if (g->end == FOURLINK_GROUP_SLIDES) {
        put(t, first + OUTPUT_FD, QUANTITY_FORCE, place_in(zero, g->direction, 0, x[4]));
        put_number(t, first + OUTPUT_M, QUANTITY_TORQUE, x[5]);
    } else {
        put(t, first + OUTPUT_FD, QUANTITY_FORCE, place_at(x[4], x[5]));
    }
}

static void put_forces(tracks *t, const fourlink_instant *now, const fourlink_load *loads)
{
    const fourlink_forces *f = &now->forces;
    int i;

    put(t, TRACK_FORCE, QUANTITY_FORCE, place_at(f->F12x, f->F12y));
    put(t, TRACK_FORCE + 1, QUANTITY_FORCE, place_at(f->F23x, f->F23y));
    put(t, TRACK_FORCE + 2, QUANTITY_FORCE, place_at(f->F34x, f->F34y));
    put(t, TRACK_FORCE + 3, QUANTITY_FORCE,
        place_at(t->v->kind.guided ? 0 : f->F14x, f->F14y)); /* N without friction */
    put_number(t, TRACK_TS, QUANTITY_TORQUE, view_driving_torque(t->v, f));
    if (t->v->kind.slotted)
        put_number(t, TRACK_COUPLE + 2, QUANTITY_TORQUE, f->M34);
    if (t->v->kind.guided)
        put_number(t, TRACK_COUPLE + 3, QUANTITY_TORQUE, f->M14);
    put_inertia(t, &now->state);
    put_loads(t, &now->state, loads);
    put_drive(t, now);
    for (i = 0; i < t->v->design->n_groups; i++)
        put_forces_of_output(t, now, loads, i);
}

void tracks_find_places(tracks *t, const view *v, const fourlink_state *state)
{
    begin(t, v);
    put_points(t, state);
}

int tracks_is_outline(const tracks *t, int number)
{
    int is_centre = number >= TRACK_CENTRE && number < TRACK_WEIGHT;
    int is_load = (number >= TRACK_LOAD && number < TRACK_LOAD_FORCE) || number >= TRACK_DRIVE;

    return t->list[number].is_there && t->list[number].q == QUANTITY_LENGTH && !is_centre &&
           !is_load;
}

void tracks_find(tracks *t, const view *v, const fourlink_instant *now, const fourlink_load *loads)
{
    double r = v->design->link[FOURLINK_CRANK].length, theta = now->row.crank.theta2;
    const fourlink_state *state = &now->state;
    int i;

    if (now->status != FOURLINK_OK) {
        begin(t, v);
        put_place(t, TRACK_A, zero);
        put_place(t, TRACK_B, place_at(r * cos(theta), r * sin(theta)));
        return;
    }
    tracks_find_places(t, v, state);
    put(t, TRACK_VB, QUANTITY_SPEED, state->link[FOURLINK_COUPLER].velocity);
    if (v->kind.slotted)
        put_sliding(t, state);
    else
        put_rod(t, state);
    put_parts(t, TRACK_ABN, &state->link[FOURLINK_CRANK], arm(t, state, FOURLINK_CRANK));
    for (i = 0; i < v->design->n_groups; i++)
        put_output(t, state, i);
    if (v->problem.has_forces)
        put_forces(t, now, loads);
}
