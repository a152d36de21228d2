/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turns.h - link angles that are continuous in the crank angle and count full turns.
*/
#ifndef FOURLINK_MECHANICS_TURNS_H
#define FOURLINK_MECHANICS_TURNS_H

#include "kind.h"

/* The angle of a link, 1 to 4, continuous in theta2: it counts full turns, with an arbitrary origin
** (turns.c). */
double flk_turns_angle(const fourlink_mechanism *mechanism, const fourlink_state *state, int link);

/* The angle of the line from D to B, of the signed length r, as smooth in theta2. */
double flk_turns_of_B(const fourlink_mechanism *mechanism, const fourlink_state *state, double *r);

#endif
