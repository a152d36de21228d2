/* SPDX-License-Identifier: GPL-3.0-or-later
**
** group_limits.h - the stroke or swing of a group, over a turn of the crank.
*/
#ifndef FOURLINK_MECHANICS_GROUP_LIMITS_H
#define FOURLINK_MECHANICS_GROUP_LIMITS_H

#include "kind.h"

/* Of a slider its place along the line, m; of a rocker its angle, rad, from -pi to pi at `least`. */
typedef struct flk_group_limits {
    double least, most, least_at, most_at; /* the last two: rad, crank angles from 0 to 2 pi */
    double time_ratio; /* 1, of its two ways; 0 if it turns back more than twice */
} flk_group_limits;

/* Of a mechanism whose groups come back after a turn (flk_groups_come_back); 0 if a rocker turns fully. */
int flk_group_limits_find(const fourlink_mechanism *mechanism, fourlink_branch branch, int group,
                          flk_group_limits *limits);

#endif
