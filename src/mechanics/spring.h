/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spring.h - springs and dampers between two links, or between a link and the ground.
*/
#ifndef FOURLINK_MECHANICS_SPRING_H
#define FOURLINK_MECHANICS_SPRING_H

#include "kind.h"

/* 1 if a torsional spring winds up: its angle is different after this crank angle, a period of the linkage
** (spring.c). */
int flk_spring_winds(const fourlink_mechanism *mechanism, const fourlink_spring *spring,
                     double period);

#endif
