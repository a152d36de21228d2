/* SPDX-License-Identifier: GPL-3.0-or-later
**
** machine.h - the mechanism with everything that determines forces and accelerations: elements that exert
** loads, friction in the joints, motor and flywheel on the shaft.
*/
#ifndef FOURLINK_MACHINE_H
#define FOURLINK_MACHINE_H

#include <stddef.h>

#include "element.h"

/* A machine.  Its loads are those of the elements in their order (given loads, springs, gas), then, with
** friction, FOURLINK_FRICTION_LOADS of friction. */
typedef struct flk_machine {
    fourlink_mechanism mechanism; /* with counterweights applied */
    flk_element *element;
    size_t n_elements;
    int has_friction;
    fourlink_friction friction;
    fourlink_motor motor; /* FOURLINK_NO_MOTOR: none */
    double flywheel;      /* kg m2, on the shaft outside the crank */
    double cycle;         /* rad, the period of curves over theta2 and of ranges of crank angles */
    /* from flk_machine_finish: */
    unsigned long n_loads;
    unsigned long first_friction; /* index of a load; n_loads: none */
    int needs_motion;             /* 1: loads depend on more than the crank angle */
    int needs_angles;             /* 1: ... on the angles of links 3 and 4 */
} flk_machine;

/* Number the loads; call this after the last element has been added. */
void flk_machine_finish(flk_machine *machine);

/* The number of elements of a type; the i-th of them, or null. */
size_t flk_machine_count(const flk_machine *machine, const flk_element_type *type);
const flk_element *flk_machine_find(const flk_machine *machine, const flk_element_type *type,
                                    size_t i);

/* 1 if there are forces in a dead position of the crank that the machine leaves: the crank cannot drive
** there, and which way friction acts follows from the crank's motion. */
int flk_machine_leaves_dead(const flk_machine *machine);

/* The loads at a crank angle; only the sense of the speed matters.  Loads of friction and of elements that
** need the motion are 0. */
void flk_machine_loads_at(const flk_machine *machine, fourlink_branch branch, double theta2,
                          double omega2, flk_acting *acting);

/* The loads in a state, including friction, and the resulting forces.  Losses are those of friction; without
** friction Ts0 is Ts, the efficiency is 1 and the rest is 0. */
int flk_machine_forces(const flk_machine *machine, const fourlink_state *state, int closed_form,
                       flk_acting *acting, fourlink_forces *forces, fourlink_losses *losses);

/* ------------------------------------------------------------------------------------------ its motion */

/* The machine at a crank angle. */
typedef struct flk_machine_place {
    fourlink_state state; /* at unit speed */
    double J;             /* kg m2, of the links */
    double half_slope;    /* kg m2, J' / 2 */
    double total;         /* kg m2, with flywheel and rotor */
} flk_machine_place;

/* The torques there at a speed. */
typedef struct flk_machine_torque {
    double T_motor; /* N m, at the crank */
    double net;     /* N m, T_motor + Q: dE/dtheta2 */
    double alpha2;  /* rad/s2 */
} flk_machine_torque;

/* The inertia of flywheel and rotor at the crank, kg m2. */
double flk_machine_shaft(const flk_machine *machine);

/* FOURLINK_OK, FOURLINK_NO_INERTIA, or why there is no position. */
int flk_machine_at(const flk_machine *machine, fourlink_branch branch, double theta2,
                   flk_machine_place *place);

/* FOURLINK_OK, FOURLINK_LOCKED, FOURLINK_NO_DIRECTION. */
int flk_machine_torque_at(const flk_machine *machine, const flk_machine_place *place, double omega2,
                          flk_acting *acting, flk_machine_torque *torque);

#endif
