/* SPDX-License-Identifier: GPL-3.0-or-later
**
** corners.h - the crank angles at which columns are not smooth.
*/
#ifndef FOURLINK_CORNERS_H
#define FOURLINK_CORNERS_H

#include "deck/deck.h"
#include "mechanics/group.h"
#include "mechanics/switch.h"

/* How columns behave at the end of a piece. */
typedef enum flk_piece_end {
    FLK_END_PLAIN, /* the motion begins or ends, a load has a corner, links come near to one line */
    FLK_END_ROOT,  /* the crank is at rest: as the root of the distance */
    FLK_END_DEAD,  /* dead position: as the root, with poles; no row there */
    FLK_END_POLE, /* a slider goes beyond all bounds, its slot along its line: poles; no row there */
    FLK_END_LOCK,   /* friction begins or ceases to lock: as the root, with a pole; no row beyond */
    FLK_END_CHANGE, /* change point: smooth, or a pole; no row there */
    FLK_END_CHANGE_REST, /* the same with the crank at rest: as the root of the distance */
    FLK_END_NOWHERE      /* after the last piece */
} flk_piece_end;

#define FLK_DRIVE_DEAD 32 /* dead centres of a drive in a period, at most */

/* The switches of a deck's machine, and the crank angles at which each branch crosses their levels.  They are
** found when first needed, so that columns of the motion alone never pay for them. */
typedef struct flk_corners {
    const deck *d;
    flk_switch *switches; /* the first n_over_theta2 are over the crank angle; */
    size_t n_switches, n_over_theta2;
    size_t n_of_speed; /* ... so many behind the others depend on the crank's speed */
    double period;     /* rad: positions repeat after this */
    double *theta2[2]; /* rad, increasing, of the open and the crossed branch */
    size_t n[2], most;
    int is_known[2];
    double *work;                   /* values of the switches */
    double dead[2][FLK_DRIVE_DEAD]; /* rad, within a period: where the drive stands still */
    size_t n_dead[2];
    int knows_dead[2];
    double ends[2][FLK_GROUPS_ENDS]; /* rad, of outputs: where they cease to be assembled */
    size_t n_ends[2];
    int are_ends_known[2];
} flk_corners;

/* A motion that passes corners. */
typedef struct flk_direction {
    flk_corners *corners;
    fourlink_branch branch;
    double from;   /* rad, theta2 at the first row */
    double sense;  /* 1 or -1 */
    int has_loads; /* 1: include the corners of loads */
} flk_direction;

/* Set up the corners of a deck; null if out of memory. */
flk_corners *flk_corners_open(const deck *d);
void flk_corners_close(flk_corners *corners);

/* Two passed angles that differ by less count as one. */
#define FLK_CORNERS_CLOSE(passed) (1e-9 + 1e-14 * (passed))

/* The next corner after `after`, in rad passed since the first row, and its kind; n more ends may be
** given. */
double flk_corners_next(const flk_direction *direction, double after, const double *more, size_t n,
                        flk_piece_end *what);

/* A motion of a branch: `at` sets the crank after an angle passed, or returns 0. */
typedef struct flk_moving {
    fourlink_branch branch;
    int (*at)(const void *data, double passed, fourlink_crank *crank);
    const void *data;
} flk_moving;

/* The first corner between two angles passed at which a speed crosses one of its levels, if that depends
** on the crank's speed; infinite if there is none. */
double flk_corners_of_speed(const flk_corners *corners, const flk_moving *moving, double from,
                            double to);

/* The kind of corner at the first row. */
flk_piece_end flk_corners_first(const flk_direction *direction);

/* The largest possible number of load corners in an angle. */
size_t flk_corners_most(const flk_corners *corners, double angle);

#endif
