/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual_machine.h - the machine at one crank angle and speed: its inertia, and the torques that turn it.
*/
#ifndef FOURLINK_ACTUAL_MACHINE_H
#define FOURLINK_ACTUAL_MACHINE_H

#include "deck/deck.h"

typedef struct flk_machine {
    const deck *d;
    fourlink_branch branch;
    fourlink_load *loads; /* memory for all loads of the deck */
    unsigned long n_loads;
    fourlink_motor motor;
    double flywheel; /* kg m2, alone */
    double inertia;  /* kg m2, at the crank: flywheel and rotor */
    int has_angles;  /* 1: loads depend on angles of links 3 and 4 */
    int has_speeds;  /* 1: loads depend on speeds */
} flk_machine;

/* The machine at a crank angle. */
typedef struct flk_machine_place {
    fourlink_state state; /* at unit speed */
    double J;             /* kg m2, of the links */
    double half_slope;    /* kg m2, J' / 2 */
    double whole;         /* kg m2, with flywheel and rotor */
} flk_machine_place;

/* What turns it there at a speed. */
typedef struct flk_machine_push {
    double T_motor; /* N m, at the crank */
    double push;    /* N m, T_motor + Q: dE/dtheta2 */
    double alpha2;  /* rad/s2 */
} flk_machine_push;

/* The machine of a deck, with memory for its loads. */
void flk_machine_of(const deck *d, fourlink_branch branch, fourlink_load *loads,
                    unsigned long n_loads, flk_machine *m);

/* FOURLINK_OK, FOURLINK_NO_INERTIA, or why there is no position. */
int flk_machine_at(const flk_machine *m, double theta2, flk_machine_place *place);

/* FOURLINK_OK, FOURLINK_LOCKED, FOURLINK_NO_DIRECTION. */
int flk_machine_push_at(const flk_machine *m, const flk_machine_place *place, double omega2,
                        flk_machine_push *push);

#endif
