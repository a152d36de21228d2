/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_curve.h - builds curves, of loads, gas and motors, from points.
*/
#ifndef FOURLINK_DECK_BUILD_CURVE_H
#define FOURLINK_DECK_BUILD_CURVE_H

#include "parser.h"

/* Build one curve for each component of a setting: angles theta2 and theta4, and the two components of a
** vector, are in these axes. */
void flk_build_curves(parser *p, const setting *s, int n_components, int over,
                      const deck_axes *axes, curve *results);

/* The axes of link 1. */
extern const deck_axes flk_ground_axes;

/* 1 if the arguments of a curve rise, by this step at least; otherwise 0 and this mistake. */
int flk_build_is_rising(parser *p, const setting *s, double least, const char *message);

#endif
