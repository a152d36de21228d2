/* SPDX-License-Identifier: GPL-3.0-or-later
**
** geometry.h - where the parts of a mechanism are at a position, in m, in the frame of link 1.
*/
#ifndef FOURLINK_GEOMETRY_H
#define FOURLINK_GEOMETRY_H

#include "place.h"
#include "view.h"

/* The place of a point of a link or of the ground, given in the link's own axes. */
fourlink_vector geometry_of_link(const fourlink_state *state, int link, const fourlink_vector *at);

/* The place of a joint, by its number in the kind. */
fourlink_vector geometry_joint(const view *v, const fourlink_state *state, int joint);

/* The pins of output i: P, Q, and that of a rocker, or Q again.  Q of a rocker with a slot is P. */
typedef struct geometry_output {
    fourlink_vector P, Q, D;
} geometry_output;

geometry_output geometry_find_output(const view *v, const fourlink_state *state, int i);

/* The slot of an output that hangs by one: where its block is, the unit vector along it, and where it
** begins and ends, beside the block, which is beyond its end where the slider is far away.  `link` has
** it. */
typedef struct geometry_slot {
    fourlink_vector block, axis;
    double from, to;
    int link;
} geometry_slot;

int geometry_has_slot(const view *v, int i);
geometry_slot geometry_find_slot(const view *v, const fourlink_state *state, int i);

/* 1 if a slider is far away, as the slot of the carrying link is nearly along its line. */
int geometry_is_far(const view *v, const fourlink_state *state, int i);

/* A link's second pin. */
fourlink_vector geometry_end(const view *v, const fourlink_state *state, int link);

/* The way of a piston or yoke on a branch, x, from its end near the crankshaft to the other. */
void geometry_find_guide(const view *v, fourlink_branch branch, double *near, double *far);

/* The way of a slider on a branch, along its slide from the foot of the perpendicular from D, or from C in a
** yoke. */
void geometry_find_way(const view *v, fourlink_branch branch, double *near, double *far);

/* A point of the slide: so far along it from the foot of the perpendicular from D. */
fourlink_vector geometry_on_slide(const fourlink_state *state, double along);

/* How far along it the lever meets its slide: C, or the foot itself. */
double geometry_root(const view *v);

/* The force of a load in the frame of link 1, N. */
fourlink_vector geometry_force(const fourlink_load *load, const fourlink_state *state);

/* The angle by which the x axis rises, rad: drawings are turned by it. */
double geometry_turn(const view *v);

/* 1 if a link has weight. */
int geometry_has_weight(const view *v);

#endif
