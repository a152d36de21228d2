/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group_type.h - what differs between types of groups: a slider or a rocker, by a rod or by a slot.
*/
#ifndef FOURLINK_MECHANICS_GROUP_TYPE_H
#define FOURLINK_MECHANICS_GROUP_TYPE_H

#include "kind.h"

/* A group in a state, with the links between which it hangs. */
typedef struct flk_hanging {
    const fourlink_group *group;
    const fourlink_link_state *on, *to; /* the carrying link; that with the pin, null: the ground */
    fourlink_link_state *rod, *end;     /* rod or block; slider or rocker */
} flk_hanging;

/* A type: its motion from that of the carrying link, its forces from those on its bodies.  The rod's origin
** is P with its motion before each step; a block's is where it is in the slot.
**
** place        axes and origins of both links; returns the square of the sine of its position, negative
**              where it cannot be assembled; in a dead position they are those in line, unless pins meet
** move         k of both, from the derivatives of the rod's origin and of `pivot`
** accelerate   alpha of both, and the acceleration of a slider's origin
** solve        FQ in closed form, from the free bodies and their moments about their origins
*/
typedef struct flk_group_type {
    double (*place)(const flk_hanging *h, const fourlink_vector *pivot);
    void (*move)(const flk_hanging *h, const fourlink_vector *pivot);
    void (*accelerate)(const flk_hanging *h, const fourlink_vector *pivot);
    fourlink_vector (*solve)(const fourlink_group *group, const fourlink_link_state *rod,
                             const fourlink_link_state *end, const flk_body body[2]);
} flk_group_type;

extern const flk_group_type flk_slider_by_rod, flk_rocker_by_rod; /* group_rod.c */
extern const flk_group_type flk_slider_with_slot, flk_rocker_with_slot, flk_slider_in_slot,
    flk_rocker_in_slot; /* group_slot.c */

/* The sine of a position from its square. */
#define FLK_ROOT_OR_0(square) ((square) > 0 ? sqrt(square) : 0)

/* The arm of the carrying link to P, or to the block in its slot, which must have its place. */
void flk_group_arm(const fourlink_group *group, const fourlink_link_state *on,
                   const fourlink_link_state *rod, fourlink_vector *r);

/* 1 if the data of a slot are right: its direction, no mass of the block (group_slot.c). */
int flk_group_slot_is_good(const fourlink_group *group);

/* The type of a group that has been checked (group.c). */
const flk_group_type *flk_group_type_of(const fourlink_group *group);

#endif
