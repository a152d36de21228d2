/* SPDX-License-Identifier: GPL-3.0-or-later
**
** coordinate_value.c - a coordinate that can be prescribed, in a state: its value and its rates.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/trig.h"
#include "coordinate_value.h"
#include "group.h"
#include "mechanism.h"

const flk_coordinate flk_coordinates[FLK_COORDINATES] = {
    {"theta4", "\316\270\342\202\204", "theta4", 1,
     FOURLINK_FOUR_BAR | FOURLINK_INVERTED_SLIDER_CRANK, FLK_OF_FOLLOWER, NULL, NULL, 0, 0, 0},
    {"x", "x", "x", 0, FOURLINK_SLIDER_CRANK | FOURLINK_SCOTCH_YOKE, FLK_OF_DISPLACEMENT, NULL,
     NULL, 0, 0, 0},
    {"C.x", "C.x", "C.x", 0, FOURLINK_SLIDER_CRANK | FOURLINK_SCOTCH_YOKE, FLK_OF_PIN, NULL, NULL,
     0, 0, 0},
    {"slide", "slide", "the slide", 0, FOURLINK_INVERTED_SLIDER_CRANK, FLK_OF_SLIDE, NULL, NULL, 0,
     0, 0}};

/* The angle of a rocker; the place of a slider along its line. */
static void find_end_of_group(const flk_coordinate *q, const fourlink_link_state *end,
                              flk_prescribed *at)
{
    const fourlink_vector *u = &q->group->direction;
    fourlink_vector r;

    if (q->is_angle) {
        at->value = flk_angle(end->axis.y, end->axis.x);
        at->rate = end->omega;
        at->second = end->alpha;
        return;
    }
    r.x = end->origin.x - q->group->pivot.x;
    r.y = end->origin.y - q->group->pivot.y;
    at->value = FLK_DOT(*u, r);
    at->rate = FLK_DOT(*u, end->velocity);
    at->second = FLK_DOT(*u, end->acceleration);
}

static void set_end_of_group(const flk_coordinate *q, const flk_prescribed *at,
                             fourlink_link_state *end)
{
    const fourlink_group *g = q->group;

    if (q->is_angle) {
        end->theta = -flk_cycle_place(-at->value, -M_PI, 2 * M_PI);
        end->omega = at->rate;
        end->alpha = at->second;
        return;
    }
    end->origin.x = g->pivot.x + at->value * g->direction.x;
    end->origin.y = g->pivot.y + at->value * g->direction.y;
    end->velocity.x = at->rate * g->direction.x;
    end->velocity.y = at->rate * g->direction.y;
    end->acceleration.x = at->second * g->direction.x;
    end->acceleration.y = at->second * g->direction.y;
}

void flk_coordinate_of(const flk_coordinate *q, const fourlink_state *state, flk_prescribed *at)
{
    const fourlink_link_state *follower = &state->link[FOURLINK_FOLLOWER];
    flk_actuator_state length = {0, 0, 0, {0, 0}};

    switch (q->what) {
    case FLK_OF_FOLLOWER:
        at->value = flk_angle(follower->axis.y, follower->axis.x);
        at->rate = follower->omega;
        at->second = follower->alpha;
        break;
    case FLK_OF_PIN:
        at->value = follower->origin.x;
        at->rate = follower->velocity.x;
        at->second = follower->acceleration.x;
        break;
    case FLK_OF_DISPLACEMENT:
        at->value = state->x;
        at->rate = state->v;
        at->second = state->a;
        break;
    case FLK_OF_SLIDE:
        at->value = state->slide;
        at->rate = state->slide_v;
        at->second = state->slide_a;
        break;
    case FLK_OF_GROUP:
        find_end_of_group(q, &state->link[q->link], at);
        break;
    default:
        flk_actuator_at(q->actuator, state, &length);
        at->value = length.length;
        at->rate = length.speed;
        at->second = length.acceleration;
        break;
    }
}

void flk_coordinate_set(const flk_coordinate *q, const flk_prescribed *at, fourlink_state *state)
{
    fourlink_link_state *follower = &state->link[FOURLINK_FOLLOWER];
    double sense =
        -(double)state->branch; /* x rises where the pin goes back, but on a crossed branch */

    switch (q->what) {
    case FLK_OF_FOLLOWER:
        follower->theta = -flk_cycle_place(-at->value, -M_PI, 2 * M_PI); /* -pi < theta <= pi */
        follower->omega = at->rate;
        follower->alpha = at->second;
        break;
    case FLK_OF_PIN:
        follower->origin.x = at->value;
        follower->velocity.x = at->rate;
        follower->acceleration.x = at->second;
        state->v = sense * at->rate;
        state->a = sense * at->second;
        break;
    case FLK_OF_DISPLACEMENT:
        state->x = at->value;
        state->v = at->rate;
        state->a = at->second;
        follower->velocity.x = sense * at->rate;
        follower->acceleration.x = sense * at->second;
        break;
    case FLK_OF_SLIDE:
        state->slide = at->value;
        state->slide_v = at->rate;
        state->slide_a = at->second;
        break;
    case FLK_OF_GROUP:
        set_end_of_group(q, at, &state->link[q->link]);
        break;
    default: /* an actuator's length is no part of a state */
        break;
    }
}

int flk_coordinate_unit_state(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                              fourlink_branch branch, double theta2, flk_prescribed *unit,
                              fourlink_state *state)
{
    fourlink_crank crank = {0, 1, 0};
    int status;

    crank.theta2 = theta2;
    status = flk_mechanism_move(mechanism, branch, &crank, 0, state);
    if (status == FOURLINK_OK)
        flk_coordinate_of(q, state, unit);
    return status;
}

double flk_coordinate_value(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, double theta2)
{
    fourlink_state state;
    flk_prescribed at;

    memset(&state, 0, sizeof state);
    flk_mechanism_place(mechanism, branch, theta2, &state);
    flk_groups_stand(mechanism, &state);
    flk_coordinate_of(q, &state, &at);
    return at.value;
}
