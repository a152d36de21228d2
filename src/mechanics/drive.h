/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drive.h - what drives a machine, if not a torque on the crank.
**
** A drive is its loads for an effort of 1: from them follow its column of the nine equations, and K, their
** power at unit crank speed, by which the effort Q replaces the torque Ts that the crank would need:
**
**    Q K = Ts
*/
#ifndef FOURLINK_DRIVE_H
#define FOURLINK_DRIVE_H

#include "kind.h"

enum {
    FLK_DRIVE_TORQUE, /* on link 4, from the ground */
    FLK_DRIVE_ALONG,  /* a force on piston or yoke, at C, along x of link 1, from the ground */
    FLK_DRIVE_SLIDE,  /* a force that pushes the slider along the slide from the lever */
    FLK_DRIVE_ENDS,   /* an actuator that pushes its ends apart */
    FLK_DRIVE_OUTPUT, /* the last link of a group: a slider along its line, from the ground; a rocker, from the
                         link with its pin */
    FLK_DRIVE_LOAD /* a load, whose size is unknown */
};

#define FLK_ACTUATOR_COLUMNS 6

/* An actuator, between points of two links; the ground is link 1, with its origin at A. */
typedef struct flk_actuator {
    const char *name;
    int link, to;
    fourlink_vector at, to_at;                      /* m */
    double bore, rod_diameter;                      /* m; 0: not given */
    const char *column_names[FLK_ACTUATOR_COLUMNS]; /* NAME.length ... */
} flk_actuator;

typedef struct flk_actuator_state {
    double length, speed, acceleration; /* m, m/s, m/s2 */
    fourlink_vector w;                  /* 1, direction from its end on `to` to that on `link` */
} flk_actuator_state;

/* FOURLINK_OK, or FOURLINK_NO_DIRECTION where its ends meet. */
int flk_actuator_at(const flk_actuator *actuator, const fourlink_state *state,
                    flk_actuator_state *at);

/* FLK_DRIVE_ENDS: `actuator`; FLK_DRIVE_OUTPUT: `link`, and `to`, that with its pin; FLK_DRIVE_LOAD:
** `load`, of size 1. */
struct flk_drive {
    int sort, link, to;
    int is_torque;    /* FLK_DRIVE_OUTPUT: on a rocker */
    const char *name; /* of it in a deck */
    const flk_actuator *actuator;
    fourlink_load load;
};

/* The loads of a drive with the effort 1, at most two: none on the ground. */
typedef struct flk_unit_drive {
    fourlink_load load[2];
    int n_loads;
    double K; /* m, or 1: power at unit crank speed */
} flk_unit_drive;

/* FOURLINK_OK, FOURLINK_NO_DIRECTION, or FOURLINK_INPUT_DEAD_CENTRE where K is 0. */
int flk_drive_unit(const flk_drive *drive, const fourlink_mechanism *mechanism,
                   const fourlink_state *state, flk_unit_drive *unit);

/* The link on which load i acts, from 0; 0 if there is none. */
int flk_drive_link(const flk_drive *drive, unsigned long i);

/* 1 if the effort is a torque. */
int flk_drive_is_torque(const flk_drive *drive);

#endif
