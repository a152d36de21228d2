/* SPDX-License-Identifier: GPL-3.0-or-later
**
** inertia.h - the machine as one mass that turns with the crank.
*/
#ifndef FOURLINK_INERTIA_H
#define FOURLINK_INERTIA_H

#include "mechanics.h"

/* J, kg m2, and the torque, N m, that the inertia of the links requires at the state's speeds and
** accelerations: J alpha2 + J' omega2^2 / 2. */
void flk_inertia_of_motion(const fourlink_mechanism *mechanism, const fourlink_state *state,
                           double *J, double *turning);

/* Q, N m, of weights and valid loads. */
double flk_inertia_force(const fourlink_mechanism *mechanism, const fourlink_state *state,
                         const fourlink_load *loads, unsigned long n_loads);

/* The torque of a valid motor on the crank, on the smooth piece of its curve that contains the speed
** `within`; the two crank speeds between which that piece holds, infinite if there is no limit (motor.c). */
double flk_motor_torque(const fourlink_motor *motor, double omega2, double within);
void flk_motor_piece(const fourlink_motor *motor, double within, double *low, double *high);

#endif
