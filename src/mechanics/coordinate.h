/* SPDX-License-Identifier: GPL-3.0-or-later
**
** coordinate.h - the crank by a coordinate that is prescribed: rocker or lever, piston or yoke, slide;
** slider or rocker of a group; the length of an actuator.
**
** A coordinate q that is prescribed gives the crank:
**
**    dq/dt = K omega2,   d2q/dt2 = K alpha2 + L omega2^2,   K = dq/dtheta2, L = d2q/dtheta2^2
**
** It rises where K > 0, falls where K < 0, and is at its dead centre where K = 0.
*/
#ifndef FOURLINK_COORDINATE_H
#define FOURLINK_COORDINATE_H

#include "coordinate_search.h"

/* The crank where a coordinate is as prescribed, on a branch and in a stretch.  FOURLINK_OK;
** FOURLINK_NO_SUCH_ANGLE; FOURLINK_INPUT_DEAD_CENTRE, with theta2 set; or the status of the position. */
int flk_coordinate_crank(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                         fourlink_branch branch, const flk_stretch *stretch,
                         const flk_prescribed *at, fourlink_crank *crank);

/* The same, with the position there in a state that moves at unit speed. */
int flk_coordinate_crank_in(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, const flk_stretch *stretch,
                            const flk_prescribed *at, fourlink_crank *crank, fourlink_state *state);

/* The same at rest, without acceleration, where the coordinate goes as c (t - t0)^4, as from
** flk_program_from_rest.  At its dead centre, where q - q0 = L (theta2 - theta2_0)^2 / 2,
**
**    omega2 = 0,   alpha2 = +- 2 sqrt(2 c / L)
**
** and FOURLINK_INPUT_DEAD_CENTRE if c is NaN: alpha2 is unbounded. */
int flk_coordinate_crank_from_rest(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                                   fourlink_branch branch, const flk_stretch *stretch, double value,
                                   double c, fourlink_crank *crank);

/* The motion in a dead position of the crank, of which a coordinate that link 3 or 4 has can carry it: a
** state with sine 0 and omega2 = 0, and alpha2 the limit (mechanism.h).  FOURLINK_DEAD_POSITION if it
** cannot. */
int flk_coordinate_swing(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                         fourlink_branch branch, const flk_prescribed *at, double theta2,
                         int angles, fourlink_state *state);

/* The same where theta2 of the crank is given, on any side; the value of `at` is set. */
int flk_coordinate_crank_at(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                            fourlink_branch branch, flk_prescribed *at, fourlink_crank *crank);

/* 1 if a coordinate is an angle that goes on turning as the crank does. */
int flk_coordinate_turns(const flk_coordinate *q, const flk_stretch *stretch);

/* A value moved by whole turns to what it is at a crank angle of a stretch: of one of more than one
** turn, over which crank and link 4 turn alike; of any where it is searched; else the value. */
double flk_coordinate_in_turn(const flk_coordinate *q, const flk_stretch *stretch, double theta2,
                              double value);

/* The crank angle of a value in a stretch, at those places too: by bisection. */
double flk_coordinate_between(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                              fourlink_branch branch, const flk_stretch *stretch, double value);

/* The same by the closed form or the search, where there is one, and at the ends of the stretch
** themselves. */
double flk_coordinate_theta2(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                             fourlink_branch branch, const flk_stretch *stretch, double value);

#define FLK_STRETCHES 16 /* at most */

/* List the stretches of a branch, and return their number. */
int flk_coordinate_stretches(const flk_coordinate *q, const fourlink_mechanism *mechanism,
                             fourlink_branch branch, flk_stretch list[FLK_STRETCHES]);

#endif
