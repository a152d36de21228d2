/* SPDX-License-Identifier: GPL-3.0-or-later
**
** coordinate_search.h - the stretches on which a coordinate only rises or only falls; the crank angle of a
** value where there is no closed form.
*/
#ifndef FOURLINK_COORDINATE_SEARCH_H
#define FOURLINK_COORDINATE_SEARCH_H

#include "coordinate_value.h"

#define FLK_STRETCH_PARTS 32

/* The value at a crank angle. */
typedef struct flk_stretch_node {
    double theta2, value;
} flk_stretch_node;

/* A stretch between two neighbouring dead centres of the coordinate, or dead positions of the mechanism, or a
** whole turn without any. */
typedef struct flk_stretch {
    double theta2_from, theta2_to; /* rad, increasing */
    double from, to; /* of the coordinate; continuous, so that an angle may pass 180 deg */
    int side;
    int is_whole; /* 1: a whole turn, or two where positions repeat after two, without any */
    flk_stretch_node node[FLK_STRETCH_PARTS + 1]; /* of a coordinate that is searched, end to end */
} flk_stretch;

/* 1 if the crank angle does not follow from the length of an actuator in closed form: unless it joins
** the ground to the crank, or to a link 4 that turns. */
int flk_search_has_to(const flk_actuator *actuator, fourlink_kind kind);

/* The number of the first groups on which links up to `link` depend. */
int flk_search_groups(int link);

/* The mechanism without the groups that do not move a coordinate. */
void flk_search_reduce(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                       fourlink_mechanism *reduced);

/* Set the values at the ends of a stretch and its nodes, and end it where a slider is far on its way
** beyond all bounds. */
void flk_search_prepare(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                        fourlink_branch branch, flk_stretch *stretch);

/* An angle moved by whole turns to what it is at a crank angle of a stretch, over which it is continuous. */
double flk_search_in_turn(const flk_stretch *stretch, double theta2, double value);

/* The crank angle of a value in a stretch, but at its ends; with the state at unit speed there. */
int flk_search_crank(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                     fourlink_branch branch, const flk_stretch *stretch, double value,
                     double *theta2, flk_prescribed *unit, fourlink_state *state);

#endif
