/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pieces.h - the motion of a deck in pieces within which all columns are smooth.
*/
#ifndef FOURLINK_PIECES_H
#define FOURLINK_PIECES_H

#include "crank_motion.h"

/* A piece, in rad passed by the crank since the first row. */
typedef struct flk_piece {
    double from, to;
    flk_piece_end begin, end;
} flk_piece;

/* The motion of a branch, for a loop over its pieces. */
typedef struct flk_pieces {
    const flk_crank_motion *crank_motion;
    fourlink_branch branch;
    int has_loads; /* 1: columns of loads must be smooth too */
    double length; /* rad; a length other than that of the motion omits whole periods, */
    double period; /* rad, and a piece ends after the first of them */
} flk_pieces;

/* Advance to the next piece; 0 at the end.  Begin with a piece from 0 to 0. */
int flk_pieces_next(const flk_pieces *pieces, flk_piece *piece);

#endif
