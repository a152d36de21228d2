/* SPDX-License-Identifier: GPL-3.0-or-later
**
** corners.h - the crank angles at which columns are not smooth.
*/
#ifndef FOURLINK_CORNERS_H
#define FOURLINK_CORNERS_H

#include "jumps.h"

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
    double sense;  /* 1 or -1: of the range */
    int has_loads; /* 1: the corners of loads too */
} flk_corners;

/* Two angles passed that differ by less are one. */
#define FLK_CORNERS_CLOSE(passed) (1e-9 + 1e-14 * (passed))

/* The next corner behind `after`, rad passed since the first row, and what is there; n more may be given. */
double flk_corners_next(const flk_corners *c, double after, const double *more, size_t n,
                        flk_piece_end *end);

/* What is at the first row. */
flk_piece_end flk_corners_first(const flk_corners *c);

#endif
