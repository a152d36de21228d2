/* SPDX-License-Identifier: GPL-3.0-or-later
**
** coordinate_value.h - a coordinate that can be prescribed in place of the crank angle, in a state: its
** value and its rates.
*/
#ifndef FOURLINK_COORDINATE_VALUE_H
#define FOURLINK_COORDINATE_VALUE_H

#include "drive.h"
#include "fourlink.h"

/* What kinds ask of a coordinate: kind.h, theta2_of. */
enum {
    FLK_OF_FOLLOWER,
    FLK_OF_DISPLACEMENT,
    FLK_OF_PIN,
    FLK_OF_SLIDE,
    FLK_OF_ACTUATOR,
    FLK_OF_GROUP
};

typedef struct flk_coordinate {
    const char *name, *symbol;    /* in a deck; in UTF-8 */
    const char *words;            /* in a sentence */
    int is_angle;                 /* 1: rad; 0: m */
    int kinds;                    /* that have it */
    int what;                     /* FLK_OF_FOLLOWER ... */
    const flk_actuator *actuator; /* FLK_OF_ACTUATOR: its length */
    const fourlink_group *group;  /* FLK_OF_GROUP: its rocker's angle, or its slider's place, */
    int link;                     /* ... which is this link */
    int n_groups;                 /* the first groups of the mechanism, of which some move it */
    int is_searched;              /* 1: no closed form for the crank angle (coordinate_search.c) */
} flk_coordinate;

/* By the word of [motion] input, from 1; 0 is the crank angle, and the word after these a name:
** NAME.length of an actuator, NAME.x or NAME.theta of a group. */
#define FLK_COORDINATES 4
#define FLK_NAMED_INPUT (FLK_COORDINATES + 1)
extern const flk_coordinate flk_coordinates[FLK_COORDINATES];

/* A value, its rate and its second rate, rad or m. */
typedef struct flk_prescribed {
    double value, rate, second;
} flk_prescribed;

/* A coordinate in a state. */
void flk_coordinate_of(const flk_coordinate *q, const fourlink_state *state, flk_prescribed *at);

/* The state at unit crank speed, and with it the value, K and L of a coordinate; a status. */
int flk_coordinate_unit_state(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                              fourlink_branch branch, double theta2, flk_prescribed *unit,
                              fourlink_state *state);

/* Set a coordinate of a state, an angle less whole turns.  Nothing else of the state changes. */
void flk_coordinate_set(const flk_coordinate *q, const flk_prescribed *at, fourlink_state *state);

/* The value where a crank angle is, also at a dead position, a change point, or where an output cannot
** be assembled; an angle is that of the principal turn. */
double flk_coordinate_value(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, double theta2);

#endif
