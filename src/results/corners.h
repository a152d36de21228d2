/* SPDX-License-Identifier: GPL-3.0-or-later
**
** corners.h - the crank angles at which a column may have a corner: those of loads, of friction, of positions.
*/
#ifndef FOURLINK_CORNERS_H
#define FOURLINK_CORNERS_H

#include "jumps.h"

/* Ends that are closer, in rad, are one. */
#define FLK_CLOSEST 1e-9

/* How columns behave at the end of a piece. */
typedef enum flk_piece_end {
    FLK_END_PLAIN, /* the motion begins or ends, a load has a corner, links come near to one line */
    FLK_END_ROOT,  /* the crank is at rest: as the root of the distance */
    FLK_END_DEAD,  /* dead position: as the root, with poles; no row there */
    FLK_END_CHANGE,      /* change point: smooth, or a pole; no row there */
    FLK_END_CHANGE_REST, /* the same with the crank at rest: as the root of the distance */
    FLK_END_NOWHERE      /* behind the last piece */
} flk_piece_end;

typedef struct flk_corners {
    const deck *d;
    const flk_jumps *jumps;
    double sense; /* 1, or -1: clockwise */
} flk_corners;

/* The next corner behind `after`, both in rad that the crank has passed since the first row of a motion of this
** length, and what it is; the end of a period is one too.  Returns the length if there is none before. */
double flk_corners_next(const flk_corners *c, double length, double period, double after,
                        flk_piece_end *end);

/* The same at the first row itself. */
flk_piece_end flk_corners_first(const flk_corners *c);

#endif
