/* SPDX-License-Identifier: GPL-3.0-or-later
**
** coordinate.h - the coordinates that can be prescribed in place of the crank angle: rocker or lever, piston or
** yoke, slide.
**
** A coordinate q that is prescribed gives the crank:
**
**    dq/dt = K omega2,   d2q/dt2 = K alpha2 + L omega2^2,   K = dq/dtheta2, L = d2q/dtheta2^2
**
** It rises where K > 0, falls where K < 0, and is at its dead centre where K = 0.
*/
#ifndef FOURLINK_COORDINATE_H
#define FOURLINK_COORDINATE_H

#include "drive.h"
#include "fourlink.h"

/* What kinds ask of a coordinate: kind.h, theta2_of. */
enum { FLK_OF_FOLLOWER, FLK_OF_DISPLACEMENT, FLK_OF_PIN, FLK_OF_SLIDE, FLK_OF_ACTUATOR };

typedef struct flk_coordinate {
    const char *name, *symbol; /* in a deck; in UTF-8 */
    const char *words;         /* in a sentence */
    int is_angle;              /* 1: rad; 0: m */
    int kinds;                 /* that have it */
    int what;                  /* FLK_OF_FOLLOWER ... */
    const flk_actuator *
        actuator; /* FLK_OF_ACTUATOR: its length; it joins the ground to the crank, or to a link 4 that
                                     turns */
} flk_coordinate;

/* By the word of [motion] input, from 1; 0 is the crank angle, and the word after these the length of an actuator. */
#define FLK_COORDINATES 4
#define FLK_ACTUATOR_INPUT (FLK_COORDINATES + 1)
extern const flk_coordinate flk_coordinates[FLK_COORDINATES];

/* A value, its rate and its second rate, rad or m. */
typedef struct flk_prescribed {
    double value, rate, second;
} flk_prescribed;

/* A coordinate in a state. */
void flk_coordinate_of(const flk_coordinate *q, const fourlink_state *state, flk_prescribed *at);

/* Set a coordinate of a state, an angle less whole turns.  Nothing else of the state changes. */
void flk_coordinate_set(const flk_coordinate *q, const flk_prescribed *at, fourlink_state *state);

/* A stretch between two neighbouring dead centres of the coordinate, or dead positions of the mechanism, or a
** whole turn without any. */
typedef struct flk_stretch {
    double theta2_from, theta2_to; /* rad, increasing */
    double from, to; /* of the coordinate; continuous, so that an angle may pass 180 deg */
    int side;
} flk_stretch;

/* The crank where a coordinate is as prescribed, on a branch and in a stretch.  FOURLINK_OK; FOURLINK_NO_SUCH_ANGLE;
** FOURLINK_INPUT_DEAD_CENTRE, with theta2 set; or the status of the position. */
int flk_coordinate_crank(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                         fourlink_branch branch, const flk_stretch *stretch,
                         const flk_prescribed *at, fourlink_crank *crank);

/* The same, with the position there in a state that moves at unit speed. */
int flk_coordinate_crank_in(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, const flk_stretch *stretch,
                            const flk_prescribed *at, fourlink_crank *crank, fourlink_state *state);

/* The same at rest, without acceleration, where the coordinate goes as c (t - t0)^4, as from flk_program_from_rest.  At its
** dead centre, where q - q0 = L (theta2 - theta2_0)^2 / 2,
**
**    omega2 = 0,   alpha2 = +- 2 sqrt(2 c / L)
**
** and FOURLINK_INPUT_DEAD_CENTRE if c is NaN: alpha2 is unbounded. */
int flk_coordinate_crank_from_rest(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                                   fourlink_branch branch, const flk_stretch *stretch, double value,
                                   double c, fourlink_crank *crank);

/* The same where theta2 of the crank is given, on any side; the value of `at` is set. */
int flk_coordinate_crank_at(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, flk_prescribed *at, fourlink_crank *crank);

/* The value where a crank angle is, also at a dead position, a change point, or where an output cannot be assembled; an angle
** is that of the principal turn. */
double flk_coordinate_value(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, double theta2);

/* A value moved by whole turns to what it is at a crank angle of a stretch of more than one turn, over which crank and link 4
** turn alike; else the value. */
double flk_coordinate_in_turn(const flk_coordinate *q, const flk_stretch *stretch, double theta2,
                              double value);

/* The crank angle of a value in a stretch, at those places too: by bisection. */
double flk_coordinate_between(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                              fourlink_branch branch, const flk_stretch *stretch, double value);

/* The same by the closed form, where there is one, and at the ends of the stretch themselves. */
double flk_coordinate_theta2(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                             fourlink_branch branch, const flk_stretch *stretch, double value);

#define FLK_STRETCHES 16 /* at most */

/* List the stretches of a branch, and return their number. */
int flk_coordinate_stretches(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                             fourlink_branch branch, flk_stretch list[FLK_STRETCHES]);

#endif
