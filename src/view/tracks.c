/* SPDX-License-Identifier: GPL-3.0-or-later
**
** tracks.c - the numbers of a mechanism at an instant.
*/
#include <math.h>
#include <string.h>

#include "system/format.h"
#include "base/text.h"
#include "geometry.h"
#include "rounding.h"
#include "tracks.h"

static const fourlink_vector zero = {0, 0};

char *tracks_name(const char *before, unsigned long i, const char *after, char name[TRACKS_NAME])
{
    char number[FORMAT_SIZE];

    return flk_text_join(name, TRACKS_NAME, before, format_general((double)i, 10, number), after,
                         (char *)NULL);
}

const track *tracks_get(const tracks *t, const char *name)
{
    int i;

    for (i = 0; i < t->n; i++)
        if (strcmp(t->list[i].name, name) == 0)
            return &t->list[i];
    return NULL;
}

fourlink_vector tracks_vector(const tracks *t, const char *name)
{
    const track *x = tracks_get(t, name);

    return x ? x->v : zero;
}

static track *add(tracks *t, const char *name, quantity q, fourlink_vector v)
{
    track *x = &t->list[t->n < TRACKS_MOST ? t->n++ : TRACKS_MOST - 1];

    strcpy(x->name, name);
    x->q = q;
    x->is_number = 0;
    x->v = v;
    return x;
}

static void put(tracks *t, const char *name, quantity q, fourlink_vector v)
{
    add(t, name, q, v);
}

static void put_number(tracks *t, const char *name, quantity q, double si)
{
    add(t, name, q, place_at(si, 0))->is_number = 1;
}

/* Put position, velocity and acceleration of a point of a link: P0, vP0, aP0. */
static void put_point(tracks *t, const char *name, const fourlink_state *state, int link,
                      const fourlink_vector *at)
{
    fourlink_vector place = zero, v = zero, a = zero;
    char words[TRACKS_NAME];

    fourlink_point(state, link, at, &place, &v, &a);
    put(t, name, QUANTITY_LENGTH, place);
    put(t, flk_text_join(words, sizeof words, "v", name, (char *)NULL), QUANTITY_SPEED, v);
    put(t, flk_text_join(words, sizeof words, "a", name, (char *)NULL), QUANTITY_ACCELERATION, a);
}

static void put_place(tracks *t, const char *name, fourlink_vector place)
{
    put(t, name, QUANTITY_LENGTH, place);
}

/* Put the ends of a lever. */
static void put_lever(tracks *t, const fourlink_state *state)
{
    const fourlink_link_state *lever = &state->link[FOURLINK_FOLLOWER];

    put_place(t, "E1", place_in(lever->origin, lever->axis, t->v->lever_low, 0));
    put_place(t, "E2", place_in(lever->origin, lever->axis, t->v->lever_high, 0));
}

/* Put the ends of springs. */
static void put_springs(tracks *t, const fourlink_state *state)
{
    fourlink_spring spring;
    char name[TRACKS_NAME];
    unsigned long k;

    for (k = 0; k < t->v->problem.n_springs; k++) {
        fourlink_deck_spring(t->v->deck, k, NULL, &spring);
        if (spring.is_torsional)
            continue;
        put_place(t, tracks_name("K", k, "P", name),
                  geometry_of_link(state, spring.link, &spring.at));
        put_place(t, tracks_name("K", k, "Q", name),
                  geometry_of_link(state, spring.to, &spring.to_at));
    }
}

static void put_points(tracks *t, const fourlink_state *state)
{
    char name[TRACKS_NAME];
    fourlink_vector at;
    unsigned long k;
    int joint, link;

    for (joint = 0; joint < 4; joint++)
        if (!tracks_get(t, t->v->kind.joint[joint].letter))
            put_place(t, t->v->kind.joint[joint].letter, geometry_joint(t->v, state, joint));
    if (t->v->kind.slotted)
        put_lever(t, state);
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++)
        if (t->v->design->link[link].mass > 0)
            put_point(t, tracks_name("G", (unsigned long)link, "", name), state, link,
                      &t->v->design->link[link].cg);
    for (k = 0; k < t->v->problem.n_points; k++) {
        fourlink_deck_point(t->v->deck, k, NULL, &link, &at);
        put_point(t, tracks_name("P", k, "", name), state, link, &at);
    }
    put_springs(t, state);
}

/* -------------------------------------------------------------------- velocities, accelerations, forces */

/* a^n = -omega^2 r, a^t = alpha x r, of the end of an arm r on a link */
static void put_parts(tracks *t, const char *normal, const char *tangential,
                      const fourlink_link_state *link, fourlink_vector r)
{
    put(t, normal, QUANTITY_ACCELERATION, place_in(zero, r, -link->omega * link->omega, 0));
    put(t, tangential, QUANTITY_ACCELERATION, place_in(zero, r, 0, link->alpha));
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
    put(t, "vC", QUANTITY_SPEED, v);
    put(t, "vCB", QUANTITY_SPEED, place_at(v.x - v_B->x, v.y - v_B->y));
    put_parts(t, "aCBn", "aCBt", &state->link[FOURLINK_COUPLER], arm(t, state, FOURLINK_COUPLER));
    if (t->v->kind.guided)
        put(t, "aC", QUANTITY_ACCELERATION, a);
    else
        put_parts(t, "aCn", "aCt", &state->link[FOURLINK_FOLLOWER],
                  arm(t, state, FOURLINK_FOLLOWER));
}

/* v_B = v_B4 + slide_v u; a_B = a_B4^n + a_B4^t + 2 omega4 x slide_v u + slide_a u, B4 the point of the lever
** at B; a yoke does not turn, and a_B = a_B4 + slide_a u */
static void put_sliding(tracks *t, const fourlink_state *state)
{
    const fourlink_link_state *lever = &state->link[FOURLINK_FOLLOWER];
    const fourlink_vector *B = &state->link[FOURLINK_COUPLER].origin,
                          *u = &state->link[FOURLINK_COUPLER].axis;
    fourlink_vector r = place_at(B->x - lever->origin.x, B->y - lever->origin.y);

    put(t, "vB4", QUANTITY_SPEED, place_in(lever->velocity, r, 0, lever->omega));
    put(t, "vS", QUANTITY_SPEED, place_in(zero, *u, state->slide_v, 0));
    if (t->v->kind.guided) {
        put(t, "aB4", QUANTITY_ACCELERATION, lever->acceleration);
    } else {
        put_parts(t, "aB4n", "aB4t", lever, r);
        put(t, "aK", QUANTITY_ACCELERATION, place_in(zero, *u, 0, state->coriolis));
    }
    put(t, "aS", QUANTITY_ACCELERATION, place_in(zero, *u, state->slide_a, 0));
}

static void put_loads(tracks *t, const fourlink_state *state, const fourlink_load *loads)
{
    char name[TRACKS_NAME];
    unsigned long k;

    for (k = 0; k < t->v->problem.n_loads; k++) {
        const fourlink_load *load = &loads[k];

        put_place(t, tracks_name("L", k, "", name), geometry_of_link(state, load->link, &load->at));
        put(t, tracks_name("L", k, "F", name), QUANTITY_FORCE, geometry_force(load, state));
        put_number(t, tracks_name("L", k, "T", name), QUANTITY_TORQUE, load->torque);
    }
}

/* Put weight, -m a_G and -I alpha of each link. */
static void put_inertia(tracks *t, const fourlink_state *state)
{
    fourlink_body body[5];
    char name[TRACKS_NAME];
    unsigned long link;

    fourlink_bodies(t->v->mechanism, state, NULL, 0, body);
    for (link = FOURLINK_CRANK; link <= FOURLINK_FOLLOWER; link++) {
        const fourlink_link *data = &t->v->design->link[link];

        if (data->mass > 0) {
            put(t, tracks_name("W", link, "", name), QUANTITY_FORCE, body[link].weight);
            put(t, tracks_name("I", link, "F", name), QUANTITY_FORCE,
                place_in(zero, body[link].acceleration, -data->mass, 0));
        }
        if (data->inertia > 0)
            put_number(t, tracks_name("I", link, "T", name), QUANTITY_TORQUE,
                       -data->inertia * state->link[link].alpha);
    }
}

static void put_forces(tracks *t, const fourlink_instant *now, const fourlink_load *loads)
{
    const fourlink_forces *f = &now->forces;

    put(t, "F12", QUANTITY_FORCE, place_at(f->F12x, f->F12y));
    put(t, "F23", QUANTITY_FORCE, place_at(f->F23x, f->F23y));
    put(t, "F34", QUANTITY_FORCE, place_at(f->F34x, f->F34y));
    put(t, "F14", QUANTITY_FORCE,
        place_at(t->v->kind.guided ? 0 : f->F14x, f->F14y)); /* N without friction */
    put_number(t, "Ts", QUANTITY_TORQUE, view_driving_torque(t->v, f));
    if (t->v->kind.slotted)
        put_number(t, "M34", QUANTITY_TORQUE, f->M34);
    if (t->v->kind.guided)
        put_number(t, "M14", QUANTITY_TORQUE, f->M14);
    put_inertia(t, &now->state);
    put_loads(t, &now->state, loads);
}

void tracks_find_places(tracks *t, const view *v, const fourlink_state *state)
{
    t->v = v;
    t->n = 0;
    put_points(t, state);
}

int tracks_is_outline(const track *x)
{
    return x->q == QUANTITY_LENGTH && strchr("ABCDEPK", x->name[0]) != NULL;
}

void tracks_find(tracks *t, const view *v, const fourlink_instant *now, const fourlink_load *loads)
{
    double r = v->design->link[FOURLINK_CRANK].length, theta = now->row.crank.theta2;
    const fourlink_state *state = &now->state;

    if (now->status != FOURLINK_OK) {
        t->n = 0;
        put_place(t, "A", zero);
        put_place(t, "B", place_at(r * cos(theta), r * sin(theta)));
        return;
    }
    tracks_find_places(t, v, state);
    put(t, "vB", QUANTITY_SPEED, state->link[FOURLINK_COUPLER].velocity);
    if (v->kind.slotted)
        put_sliding(t, state);
    else
        put_rod(t, state);
    put_parts(t, "aBn", "aBt", &state->link[FOURLINK_CRANK], arm(t, state, FOURLINK_CRANK));
    if (v->problem.has_forces)
        put_forces(t, now, loads);
}
