/* SPDX-License-Identifier: GPL-3.0-or-later
**
** course.h - the course of a deck: what its rows go over, and the motion of the crank along it, given or
** integrated, as a whole and in pieces within which all columns are smooth.
**
** A place of the course is a value of its abscissa: a crank angle in the deck's unit, or a time in s.  Its
** length is in rad; over the crank angle it is the angle passed since the first row.
*/
#ifndef FOURLINK_COURSE_H
#define FOURLINK_COURSE_H

#include "actual.h"

typedef struct flk_course {
    const struct flk_course_type *type; /* given; integrated by angle, by time */
    const deck *d;
    fourlink_abscissa over;
    fourlink_range range; /* of the rows */
    double end;           /* the last crank angle of the deck's motion, in its unit */
    double
        period; /* rad, period of a motion that repeats: the cycle, at least one turn; two turns if
                   the mechanism has one change point, since the links return on the other side
                   after one turn */
    int winds;  /* 1: a spring winds up, so that cycles differ */
    flk_corners *corners;
    flk_actual *actual; /* null: the motion is given */
    int is_shared;      /* 1: it belongs to another deck */
} flk_course;

/* Set up the course of a deck, which must remain valid as long, and memory for the loads of a row; 0 if out
** of memory.  `actual` is null, or that of the same deck, found before, which must remain valid too. */
int flk_course_open(flk_course *course, const deck *d, flk_acting *acting, flk_actual *actual);
void flk_course_close(flk_course *course);

/* 1 if the actual motion of a branch took too many steps: its facts depend on where the budget ended. */
int flk_course_stops(const flk_course *course, fourlink_branch branch);

/* 1 if speed and acceleration are the same in every period. */
int flk_course_repeats(const flk_course *course);

/* 1 if the motion is one revolution that ends at its initial position and speed. */
int flk_course_is_periodic(const flk_course *course);

/* The crank where it first passes a crank angle, in the deck's unit, as from `at`; 0 if the motion has no
** such angle.  Which angles rows by time reach depends on the branch. */
int flk_course_pass(const flk_course *course, fourlink_branch branch, double angle, int *status,
                    fourlink_row *row, flk_actual_row *actual);

/* The side of row i: FOURLINK_RISING or FOURLINK_FALLING of an input, else 0; that of the first rows. */
int flk_course_side(const flk_course *course, unsigned long i);
int flk_course_first_side(const flk_course *course);

/* 1 if some rows are on a side of an input. */
int flk_course_has_side(const flk_course *course, int side);

/* The crank by an input over whose values the rows go, and unless they are one crank angle the position
** there: in a state that moves at unit speed. */
int flk_course_at_input(const flk_course *course, fourlink_branch branch, int side, double place,
                        fourlink_row *row, fourlink_state *state);

/* What is prescribed at a place of its rows, and the row's place and time; at a crank angle it is as the
** deck gives it, and the place is the value. */
void flk_course_prescribed_at(const deck_prescribed *prescribed, double place, flk_prescribed *at,
                              fourlink_row *row);

/* Set a prescribed coordinate, its rate and its second rate in the state of a row to what they are,
** which rounding error of the crank hides: an acceleration that is 0. */
void flk_course_set_prescribed(const flk_course *course, double place, fourlink_state *state);

/* 1 if a place is a dead position of the crank that has a row: over the input all is smooth there. */
int flk_course_leaves_dead(const flk_course *course, fourlink_branch branch, int side,
                           double place);

/* The motion by an input in a dead position of the crank, at a place of its rows. */
int flk_course_swing(const flk_course *course, fourlink_branch branch, double place, double theta2,
                     int angles, fourlink_state *state);

/* ---------------------------------------------------------------------------------------------- pieces */

/* A piece, in rad of the length. */
typedef struct flk_piece {
    double from, to;
    flk_piece_end begin, end;
} flk_piece;

/* The motion of a branch, for a loop over its pieces. */
typedef struct flk_pieces {
    const flk_course *course;
    fourlink_branch branch;
    int has_loads;     /* 1: columns of loads must be smooth too */
    double first, end; /* places; */
    double rate;       /* ... for 1 rad of the length */
    double length;     /* rad; a length other than that of the motion omits whole periods, */
    double one_side;   /* rad, of both sides of an input the length of the first; else 0 */
    double period;     /* rad, and a piece ends after the first of them */
} flk_pieces;

/* Advance to the next piece; 0 at the end.  Begin with a piece from 0 to 0. */
int flk_pieces_next(const flk_pieces *pieces, flk_piece *piece);

/* ------------------------------------------------------------------------------------------------ types */

/* What differs from course to course: everything else asks these. */
struct flk_course_type {
    /* the place of row i */
    double (*place)(const flk_course *c, unsigned long i);
    /* The crank at a place, of an input on a side; `actual` is filled unless the motion is given.
    ** FOURLINK_OK, or why the machine does not get there: only the place and the crank angle are set,
    ** the rest is NaN. */
    int (*at)(const flk_course *c, fourlink_branch branch, int side, double place,
              fourlink_row *row, flk_actual_row *actual);
    /* The place that is meant by a place: of crank angles that of the motion that differs by whole periods (a
    ** turn, or a cycle of several turns).  0 if there is none. */
    int (*find)(const flk_course *c, double place, double *at);
    /* set places, rate and length of the motion of a branch */
    void (*begin)(const flk_course *c, flk_pieces *x);
    /* set `to` and `end` of a piece, and `begin` of the first */
    void (*next)(const flk_pieces *x, flk_piece *piece);
};

/* By a program over time, of the crank angle; of what is prescribed in place of it (by_program.c). */
extern const struct flk_course_type flk_course_by_program, flk_course_by_program_of_input;

/* The first time at which a program passes a crank angle, rad; 0 if there is none. */
int flk_course_pass_program(const flk_course *c, fourlink_branch branch, double theta2,
                            double *time);

/* Of all courses over time: the place of row i; the place that is meant by a time. */
double flk_course_place_of_time(const flk_course *c, unsigned long i);
int flk_course_find_time(const flk_course *c, double time, double *at);

#endif
