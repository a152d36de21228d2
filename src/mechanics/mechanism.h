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

/* The crank of a stroke that is possible, by the rod and the offset of the line of stroke. */
double flk_mechanism_crank_of_stroke(double stroke, double rod, double offset);

#endif
