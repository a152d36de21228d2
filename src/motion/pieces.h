/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pieces.h - the motion of a deck in pieces within which all columns are smooth.
*/
#ifndef FOURLINK_PIECES_H
#define FOURLINK_PIECES_H

#include "crank_motion.h"

/* A piece, by the crank angle that the motion has passed since its first row, rad. */
typedef struct flk_piece {
    double from, to;
    flk_piece_end begin, end;
} flk_piece;

/* The motion of a branch, to be gone through piece by piece. */
typedef struct flk_pieces {
    const flk_crank_motion *crank_motion;
    fourlink_branch branch;
    int has_loads; /* 1: columns of loads are to be smooth too */
    double length; /* rad; another than that of the motion leaves whole periods out, */
    double period; /* rad, and a piece ends after the first of them */
} flk_pieces;

/* Go on to the piece behind this one; 0 at the end.  Begin with a piece of 0 to 0. */
int flk_pieces_next(const flk_pieces *pieces, flk_piece *piece);

#endif
