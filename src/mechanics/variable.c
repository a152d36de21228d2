/* SPDX-License-Identifier: GPL-3.0-or-later
**
** variable.c - the variables of a state that a load can follow.
*/
#include <string.h>

#include "variable.h"

#define STANDSTILL 1e-12 /* relative to unit crank speed: a slower variable is reversing */

double flk_variable_value(const fourlink_state *state, flk_variable variable)
{
    switch (variable) {
    case FLK_THETA2:
        return state->link[FOURLINK_CRANK].theta;
    case FLK_THETA4:
        return state->link[FOURLINK_FOLLOWER].theta;
    case FLK_X:
        return state->x;
    case FLK_SLIDE:
        return state->slide;
    case FLK_OMEGA2:
        return state->link[FOURLINK_CRANK].omega;
    case FLK_OMEGA4:
        return state->link[FOURLINK_FOLLOWER].omega;
    case FLK_V:
        return state->v;
    default:
        return state->slide_v;
    }
}

int flk_variable_falls(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       flk_variable position, int sense)
{
    int is_length = position == FLK_X || position == FLK_SLIDE;
    double r = is_length ? mechanism->design.link[FOURLINK_CRANK].length : 1;
    fourlink_state moved;

    FLK_COPY_STATE(mechanism, &moved, state);
    fourlink_velocity(mechanism, sense, &moved);
    return flk_variable_value(&moved, FLK_RATE_OF(position)) < -STANDSTILL * r;
}
