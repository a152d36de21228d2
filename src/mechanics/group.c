/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group.c - groups: a rod or a block on a point P of a moving link, and a slider or a rocker on the rod or
** block.
**
** A group is a dyad (an Assur group): it has no degree of freedom, and its motion follows from that of P
** and, for a rocker whose pin is on a moving link, of this pin.  To the link that carries it, it is a force
** -FP at P, or at the block in the link's slot.  So groups move after the four links, each after those on
** which it hangs, and their forces are found before those of the four links, the outermost first
** (group_forces.c).
*/
#include <math.h>
#include <string.h>

#include "group.h"
#include "group_type.h"

/* By fourlink_group_end and fourlink_group_hang. */
static const flk_group_type *const types[][3] = {
    {NULL, NULL, NULL},
    {&flk_slider_by_rod, &flk_slider_with_slot, &flk_slider_in_slot},
    {&flk_rocker_by_rod, &flk_rocker_with_slot, &flk_rocker_in_slot}};

#define TYPES ((int)(sizeof types / sizeof types[0]))
#define HANGS ((int)(sizeof types[0] / sizeof types[0][0]))

const flk_group_type *flk_group_type_of(const fourlink_group *group)
{
    return types[group->end][group->hang];
}

/* ----------------------------------------------------------------------------------------------- check */

#define UNIT 1e-9 /* by which the length of a unit vector may differ from 1 */

static int check_group(const fourlink_group *g, int first)
{
    int is_slider = g->end == FOURLINK_GROUP_SLIDES, by_rod = g->hang == FOURLINK_HANGS_BY_ROD;
    int i, status = FOURLINK_OK;

    if ((int)g->end < 1 || (int)g->end >= TYPES || (int)g->hang < 0 || (int)g->hang >= HANGS ||
        (g->side != 1 && g->side != -1) || g->link < FOURLINK_CRANK || g->link >= first ||
        g->to < 0 || g->to >= first ||
        (g->to > FOURLINK_GROUND && (is_slider || !by_rod || g->to == g->link)))
        return FOURLINK_BAD_GROUP;
    if (by_rod)
        status = flk_check_length(g->rod);
    else if (!flk_group_slot_is_good(g))
        return FOURLINK_BAD_GROUP;
    if (status == FOURLINK_OK && !is_slider && g->hang != FOURLINK_HANGS_BY_OWN_SLOT)
        status = flk_check_length(g->length);
    if (status != FOURLINK_OK)
        return status;
    if (!FLK_BOTH_WITHIN(g->at, FOURLINK_LENGTH_MAX) ||
        !FLK_BOTH_WITHIN(g->pivot, FOURLINK_LENGTH_MAX) ||
        (is_slider && !FLK_WITHIN(FLK_DOT(g->direction, g->direction) - 1, UNIT)))
        return FOURLINK_BAD_NUMBER;
    for (i = 0; i < 2 && status == FOURLINK_OK; i++)
        status = flk_check_link(&g->body[i]);
    return status;
}

int flk_group_is_block(const fourlink_design *design, int link)
{
    return link >= FOURLINK_ROD_OF(0) && (link - FOURLINK_ROD_OF(0)) % 2 == 0 &&
           design->group[(link - FOURLINK_ROD_OF(0)) / 2].hang != FOURLINK_HANGS_BY_ROD;
}

int flk_groups_check(const fourlink_design *design)
{
    int i, status = FOURLINK_OK;

    if (design->n_groups < 0 || design->n_groups > FOURLINK_MOST_GROUPS)
        return FOURLINK_BAD_GROUP;
    if (design->n_groups && !design->group)
        return FOURLINK_NULL;
    for (i = 0; i < design->n_groups && status == FOURLINK_OK; i++) {
        status = check_group(&design->group[i], FOURLINK_ROD_OF(i));
        if (status == FOURLINK_OK && (flk_group_is_block(design, design->group[i].link) ||
                                      flk_group_is_block(design, design->group[i].to)))
            status = FOURLINK_BAD_GROUP;
    }
    return status;
}

/* ---------------------------------------------------------------------------------------------- motion */

void flk_group_arm(const fourlink_group *group, const fourlink_link_state *on,
                   const fourlink_link_state *rod, fourlink_vector *r)
{
    if (group->hang == FOURLINK_HANGS_IN_SLOT) {
        r->x = rod->origin.x - on->origin.x;
        r->y = rod->origin.y - on->origin.y;
    } else
        FLK_TURN(*r, on, group->at);
}

static flk_hanging find(const fourlink_mechanism *mechanism, fourlink_state *state, int i)
{
    flk_hanging h;

    h.group = &mechanism->design.group[i];
    h.on = &state->link[h.group->link];
    h.to = h.group->to > FOURLINK_GROUND ? &state->link[h.group->to] : NULL;
    h.rod = &state->link[FOURLINK_ROD_OF(i)];
    h.end = h.rod + 1;
    return h;
}

static double place_group(const flk_hanging *h)
{
    fourlink_vector r, pivot = h->group->pivot;

    FLK_TURN(r, h->on, h->group->at);
    h->rod->origin.x = h->on->origin.x + r.x;
    h->rod->origin.y = h->on->origin.y + r.y;
    if (h->to) {
        FLK_TURN(r, h->to, h->group->pivot);
        pivot.x = h->to->origin.x + r.x;
        pivot.y = h->to->origin.y + r.y;
    }
    return types[h->group->end][h->group->hang]->place(h, &pivot);
}

int flk_groups_place(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double square, smallest = 1;
    int i;

    for (i = 0; i < mechanism->design.n_groups; i++) {
        flk_hanging h = find(mechanism, state, i);

        square = place_group(&h);
        if (!(square > FLK_DEAD))
            return square < -FLK_DEAD ? FOURLINK_GROUP_APART : FOURLINK_DEAD_POSITION;
        smallest = square < smallest ? square : smallest;
    }
    state->group_sine = sqrt(smallest);
    return FOURLINK_OK;
}

void flk_groups_stand(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    int i;

    for (i = 0; i < mechanism->design.n_groups; i++) {
        flk_hanging h = find(mechanism, state, i);

        place_group(&h);
    }
}

double flk_groups_margin(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double margin = 1, square[FOURLINK_LINKS];
    int i;

    for (i = 0; i < FOURLINK_ROD_OF(0); i++)
        square[i] = 1;
    for (i = 0; i < mechanism->design.n_groups; i++) {
        flk_hanging h = find(mechanism, state, i);
        int is_there = square[h.group->link] > FLK_DEAD && square[h.group->to] > FLK_DEAD;

        square[FOURLINK_ROD_OF(i)] = square[FOURLINK_END_OF(i)] = is_there ? place_group(&h) : -1;
        if (is_there && square[FOURLINK_ROD_OF(i)] < margin)
            margin = square[FOURLINK_ROD_OF(i)];
    }
    return margin;
}

static void scale_velocity(fourlink_link_state *link, double speed)
{
    link->omega = link->k * speed;
    link->velocity.x = link->k_origin.x * speed;
    link->velocity.y = link->k_origin.y * speed;
}

void flk_groups_move(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    /* of which k is for a unit: in a dead position, where the crank stands still, that of link 3 */
    double speed =
        state->link[state->link[FOURLINK_CRANK].k != 0 ? FOURLINK_CRANK : FOURLINK_COUPLER].omega;
    int i;

    for (i = 0; i < mechanism->design.n_groups; i++) {
        flk_hanging h = find(mechanism, state, i);
        fourlink_vector r, pivot = {0, 0};

        flk_group_arm(h.group, h.on, h.rod, &r);
        FLK_UNIT_VELOCITY(h.rod->k_origin, h.on, r);
        if (h.to) {
            FLK_TURN(r, h.to, h.group->pivot);
            FLK_UNIT_VELOCITY(pivot, h.to, r);
        }
        types[h.group->end][h.group->hang]->move(&h, &pivot);
        scale_velocity(h.rod, speed);
        scale_velocity(h.end, speed);
    }
}

void flk_groups_accelerate(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    int i;

    for (i = 0; i < mechanism->design.n_groups; i++) {
        flk_hanging h = find(mechanism, state, i);
        fourlink_vector r, pivot = {0, 0};

        flk_group_arm(h.group, h.on, h.rod, &r);
        FLK_ACCELERATION(h.rod->acceleration, h.on, r);
        if (h.to) {
            FLK_TURN(r, h.to, h.group->pivot);
            FLK_ACCELERATION(pivot, h.to, r);
        }
        types[h.group->end][h.group->hang]->accelerate(&h, &pivot);
    }
}

void flk_groups_angles(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    int i;

    for (i = FOURLINK_ROD_OF(0); i <= FLK_LAST_LINK(mechanism); i++)
        state->link[i].theta = flk_angle_of_axis(&state->link[i].axis);
}

int flk_groups_follow(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    int status = flk_groups_place(mechanism, state);

    if (status != FOURLINK_OK)
        return status;
    flk_groups_move(mechanism, state);
    flk_groups_accelerate(mechanism, state);
    return FOURLINK_OK;
}
