/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build.h - the builders: from the settings of a section to its part of the problem, a file for each
** section.  reader.c calls them in this order.
*/
#ifndef FOURLINK_BUILD_H
#define FOURLINK_BUILD_H

#include "parser.h"

/* [ground] [crank] ...: the kind of the mechanism, 0 after a mistake; its lengths and masses. */
int flk_build_kind(parser *p);
void flk_build_mechanism(parser *p);

void flk_build_loads(parser *p);
void flk_build_balance(parser *p);
void flk_build_springs(parser *p);
void flk_build_gas(parser *p);
void flk_build_friction(parser *p);
void flk_build_points(parser *p);

/* The keys of the pins A, B, C, D: the coefficient of friction, the radius. */
extern const key_code flk_friction_keys[4][2];

/* `series`: the approximations of the engine method. */
void flk_build_series(parser *p);

void flk_build_motor(parser *p);
void flk_build_motion(parser *p);
void flk_build_flywheel(parser *p);
void flk_build_table(parser *p);

/* Note the curves over positions and speeds whose ends the motion exceeds. */
void flk_build_curve_ends(parser *p);

/* Note values that are allowed but probably not meant. */
void flk_build_notes(parser *p);

void flk_build_expectations(parser *p);
void flk_build_grading(parser *p);

#endif
