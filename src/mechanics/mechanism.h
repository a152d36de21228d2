/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mechanism.h - the common part of all mechanisms: the check of a design, the crank, points of links, the
** steps of an analysis.
*/
#ifndef FOURLINK_MECHANICS_MECHANISM_H
#define FOURLINK_MECHANICS_MECHANISM_H

#include "kind.h"

/* Find the motion of every link.  Without `angles`, which take a third of the time, theta of links 3 and 4,
** mu and phi are not set (mechanism.c). */
int flk_mechanism_move(const fourlink_mechanism *mechanism, fourlink_branch branch,
                       const fourlink_crank *crank, int angles, fourlink_state *state);

/* The same where the state has the position of the crank already, of a mechanism without groups. */
int flk_mechanism_move_from(const fourlink_mechanism *mechanism, const fourlink_crank *crank,
                            int angles, fourlink_state *state);

/* The same without velocities and accelerations, which are not set, of a mechanism without groups; with
** the angles (mechanism.c). */
int flk_mechanism_stand(const fourlink_mechanism *mechanism, fourlink_branch branch,
                        const fourlink_crank *crank, fourlink_state *state);

/* The places of links 3 and 4 also in a dead position, and beyond it those in line (mechanism.c). */
void flk_mechanism_place(const fourlink_mechanism *mechanism, fourlink_branch branch, double theta2,
                         fourlink_state *state);

/* The motion in a dead position, where the crank stands still while link 3 turns about B: omega2 = 0,
** alpha2 is set.  All k are for a unit of omega3, so that of the crank is 0; the sine is 0.
** FOURLINK_OK, or the status of an output. */
int flk_mechanism_swing(const fourlink_mechanism *mechanism, fourlink_branch branch, double theta2,
                        double omega3, double alpha3, int angles, fourlink_state *state);

#endif
