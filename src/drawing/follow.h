/* SPDX-License-Identifier: GPL-3.0-or-later
**
** follow.h - the places of a motion in few numbers: most of them follow others.
**
** A file that had each place at each step would be ten times as large.
*/
#ifndef FOURLINK_FOLLOW_H
#define FOURLINK_FOLLOW_H

#include "motion.h"

typedef enum follow_sort {
    FOLLOW_FIXED,  /* by[0], by[1]: where it is at all steps */
    FOLLOW_OWN,    /* it follows none: `track` has it */
    FOLLOW_BESIDE, /* by[0], by[1] from another place */
    FOLLOW_ALONG /* from P: by[0] of the way to Q and by[1] further, by[2] to the left of that way on paper */
} follow_sort;

typedef struct follow_place {
    follow_sort sort;
    size_t of[2]; /* places before it in the list */
    double by[3];
    size_t track; /* of the motion */
} follow_place;

typedef struct follow {
    const motion *m;
    follow_place *list; /* room for as many as the motion has tracks */
    size_t n;
    size_t *number; /* of the place, by the motion's track */
} follow;

/* Find the places of a motion.  Close it whatever came of it. */
void follow_open(follow *f, const motion *m);
void follow_close(follow *f);

/* Where a place is at a step, from those that it follows; NaN where its track is not there. */
fourlink_vector follow_at(const follow *f, size_t place, size_t step);

#endif
