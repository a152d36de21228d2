/* SPDX-License-Identifier: GPL-3.0-or-later
**
** crank_motion.h - the motion of a deck's crank, given or integrated: as a whole, and in pieces within which
** all columns are smooth.
*/
#ifndef FOURLINK_CRANK_MOTION_H
#define FOURLINK_CRANK_MOTION_H

#include "actual.h"

typedef struct flk_crank_motion {
    const deck *d;
    fourlink_range range; /* of the rows */
    double end;           /* the crank angle of the last row, in the deck's unit; unused by time */
    double
        period; /* rad, period of a motion that repeats: the cycle, at least one turn; two turns if
                   the mechanism has one change point, since the links return on the other side
                   after one turn */
    int winds;  /* 1: a spring winds up, so that cycles differ */
    flk_corners *corners;
    flk_actual *actual; /* null: the motion is given */
    int is_shared;      /* 1: it belongs to another deck */
} flk_crank_motion;

/* Set up the motion of a deck, which must remain valid as long, and memory for the loads of a row; 0 if out
** of memory.  `actual` is null, or that of the same deck, found before, which must remain valid too. */
int flk_crank_motion_open(flk_crank_motion *crank_motion, const deck *d, flk_acting *acting,
                          flk_actual *actual);
void flk_crank_motion_close(flk_crank_motion *crank_motion);

/* 1 if the actual motion of a branch took too many steps: its facts depend on where the budget ended. */
int flk_crank_motion_stops(const flk_crank_motion *crank_motion, fourlink_branch branch);

/* 1 if speed and acceleration are the same in every period. */
int flk_crank_motion_repeats(const flk_crank_motion *crank_motion);

/* 1 if the motion is one revolution that ends at its initial position and speed. */
int flk_crank_motion_is_periodic(const flk_crank_motion *crank_motion);

/* Find the angle of the motion, in the deck's unit, that differs from an angle by whole periods (a turn, or a
** cycle of several turns); 0 if the motion does not reach it. */
int flk_crank_motion_find_angle(const flk_crank_motion *crank_motion, double angle, double *at);

/* The length of the motion on a branch, rad, and the crank angle at its end, in the deck's unit; for rows by
** time, the time, s. */
double flk_crank_motion_length(const flk_crank_motion *crank_motion, fourlink_branch branch);
double flk_crank_motion_end(const flk_crank_motion *crank_motion, fourlink_branch branch);

/* ---------------------------------------------------------------------------------------------- pieces */

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
