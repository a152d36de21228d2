/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build.h - the builders: from the settings of a section to its part of the problem, a file for each
** section.  reader.c calls them in this order.
*/
#ifndef FOURLINK_BUILD_H
#define FOURLINK_BUILD_H

#include "parser.h"

/* The kind of the mechanism, 0 after a mistake. */
int flk_build_kind(parser *p);

/* The builders of machine and motion, in this order: outputs before what acts on their links; motor and
** motion before the friction, which starts in the motion's sense; elements in the order of their loads. */
#define BUILD_LIST(X) \
    X(mechanism)      \
    X(outputs)        \
    X(motor)          \
    X(motion)         \
    X(loads)          \
    X(balance)        \
    X(springs)        \
    X(gas)            \
    X(friction)

#define BUILD_DECLARATION(name) void flk_build_##name(parser *p);
BUILD_LIST(BUILD_DECLARATION)

#define MOST_ROWS 10000000 /* of a given motion */

/* [actuator] and `drive`. */
void flk_build_drive(parser *p);

void flk_build_points(parser *p);

/* The keys of the pins A, B, C, D: the coefficient of friction, the radius. */
extern const key_code flk_friction_keys[4][2];

/* `series`: the approximations of the engine method. */
void flk_build_series(parser *p);

void flk_build_flywheel(parser *p);
void flk_build_table(parser *p);

/* `input`: what is prescribed in place of the crank angle, on the branches of the table. */
void flk_build_prescribed(parser *p);

/* Note the curves over positions and speeds whose ends the motion exceeds. */
void flk_build_curve_ends(parser *p);

/* Note values that are allowed but probably not meant. */
void flk_build_notes(parser *p);

void flk_build_expectations(parser *p);

/* Refuse a branch that the mechanism does not have. */
void flk_build_check_branch(parser *p, const setting *branch);
void flk_build_grading(parser *p);

#endif
