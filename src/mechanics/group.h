/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group.h - groups: a rod or a block on a point of a moving link, and a slider or a rocker on it.
*/
#ifndef FOURLINK_MECHANICS_GROUP_H
#define FOURLINK_MECHANICS_GROUP_H

#include "kind.h"

/* FOURLINK_OK, or what is wrong with the groups of a design. */
int flk_groups_check(const fourlink_design *design);

/* 1 if a link is the block of a group with a slot: without mass, it takes no loads and carries no group. */
int flk_group_is_block(const fourlink_design *design, int link);

/* The place of the block of group i along its slot, m, and its rate: from P in a slot of the carrying
** link, from the pin Q of a slider's own slot, from the foot of the pin in a rocker's (group_slot.c). */
void flk_group_slide(const fourlink_mechanism *mechanism, const fourlink_state *state, int i,
                     double *slide, double *rate);

/* The motion of links 5, 6 ... in a state whose other links have theirs: position, the derivatives by
** theta2 and the velocities, accelerations, angles.  The first returns a status; the last does all but
** the angles. */
int flk_groups_place(const fourlink_mechanism *mechanism, fourlink_state *state);
void flk_groups_move(const fourlink_mechanism *mechanism, fourlink_state *state);
void flk_groups_accelerate(const fourlink_mechanism *mechanism, fourlink_state *state);
void flk_groups_angles(const fourlink_mechanism *mechanism, fourlink_state *state);
int flk_groups_follow(const fourlink_mechanism *mechanism, fourlink_state *state);

/* The places of links 5, 6 ... also in a dead position: those in line. */
void flk_groups_stand(const fourlink_mechanism *mechanism, fourlink_state *state);

/* How far the groups are from where they cannot be assembled, smooth in theta2 and negative beyond: the
** smallest square of a sine.  A group on one that cannot be assembled does not count.  Links 5, 6 ... of the
** state are written. */
double flk_groups_margin(const fourlink_mechanism *mechanism, fourlink_state *state);

/* The crank angles, increasing from 0 to `period`, at which the groups begin or cease to be assembled on a
** branch: a list of `most`, and their number (group_ends.c). */
size_t flk_groups_ends(const fourlink_mechanism *mechanism, fourlink_branch branch, double period,
                       double *list, size_t most);

/* 1 if the crank turns fully with all groups, they come back after a turn, and none goes beyond all
** bounds. */
int flk_groups_come_back(const fourlink_mechanism *mechanism, fourlink_branch branch);

/* The first group without a position at a crank angle at which the four links have one; -1: none. */
int flk_groups_apart(const fourlink_mechanism *mechanism, fourlink_branch branch, double theta2);

/* 1 if one of these angles is where a slider goes beyond all bounds and comes back from the other side:
** the slot of the carrying link is along its line. */
int flk_groups_are_beyond(const fourlink_mechanism *mechanism, fourlink_branch branch,
                          double theta2);

#define FLK_GROUPS_ENDS 64 /* at most, in a turn or two */

/* The ranges of crank angles, rad, in which the mechanism can be assembled on a branch with its groups:
** a list of `most`, and their number.  A range is 0 to 2 pi, or ends at dead positions. */
typedef struct flk_range {
    double from, to;
} flk_range;

size_t flk_groups_ranges(const fourlink_mechanism *mechanism, fourlink_branch branch,
                         flk_range *list, size_t most);

/* 1 if the forces of groups cannot be found in a state from a caller. */
int flk_groups_are_singular(const fourlink_mechanism *mechanism, const fourlink_state *state);

/* The forces in a group. */
typedef struct flk_group_forces {
    fourlink_vector FP; /* N, at P, of the carrying link on the rod; with a slot, on the block */
    fourlink_vector FQ; /* N, at Q, of the rod on slider or rocker; with a slot, of the block */
    fourlink_vector
        FD;   /* N, of the guide on the slider; of the ground, or the link with its pin, on
                           the rocker */
    double M; /* N m, of the guide on the slider; 0 */
} flk_group_forces;

/* With valid loads, and the effort of a drive that is not the crank, of a state that is not singular: in
** closed form, or by the six equations of each group. */
void flk_groups_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       const fourlink_load *loads, unsigned long n_loads, double effort,
                       int closed_form, flk_group_forces *list);

#endif
