/* SPDX-License-Identifier: GPL-3.0-or-later
**
** variable.h - the variables of a state that a load can follow.
*/
#ifndef FOURLINK_VARIABLE_H
#define FOURLINK_VARIABLE_H

#include "mechanics.h"

/* In the order of the words for `over` in a deck: positions, then the rate of each. */
typedef enum flk_variable {
    FLK_THETA2,
    FLK_THETA4,
    FLK_X,
    FLK_SLIDE,
    FLK_OMEGA2,
    FLK_OMEGA4,
    FLK_V,
    FLK_SLIDE_V
} flk_variable;

#define FLK_IS_SPEED(variable) ((variable) >= FLK_OMEGA2)

#define FLK_RATE_OF(position) ((flk_variable)((int)(position) + (FLK_OMEGA2 - FLK_THETA2)))

/* The value of a variable, in rad or m, rad/s or m/s. */
double flk_variable_value(const fourlink_state *state, flk_variable variable);

/* 1 if a position decreases as the crank turns in a sense, 1 or -1.  Where it reverses, it does not
** decrease. */
int flk_variable_falls(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       flk_variable position, int sense);

#endif
