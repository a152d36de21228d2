/* SPDX-License-Identifier: GPL-3.0-or-later
**
** friction.h - Coulomb friction in pins and guides, solved together with the pin forces on which it depends.
*/
#ifndef FOURLINK_MECHANICS_FRICTION_H
#define FOURLINK_MECHANICS_FRICTION_H

#include "kind.h"

/* The relative speed in a joint for unit crank speed: in rad for a pin, along the slide and divided by the
** crank length for a slider.  The sense in which the crank turns or starts: 1 or -1 (friction.c). */
double flk_friction_speed(const fourlink_mechanism *mechanism, const fourlink_state *state,
                          const fourlink_joint *at);
int flk_friction_sense(double omega2, const fourlink_friction *friction);

/* As fourlink_solve_friction, but if `held` is not null, the signs of friction are those of that state. */
int flk_friction_solve(const fourlink_mechanism *mechanism, const fourlink_state *state,
                       const fourlink_state *held, const fourlink_load *loads,
                       unsigned long n_loads, const fourlink_friction *friction, int closed_form,
                       fourlink_forces *forces, fourlink_losses *losses);

/* The radius of the friction circle of pin i, or the coefficient of a guide or slot: above 0 where it has
** friction. */
double flk_friction_of(const flk_kind *kind, int i, const fourlink_friction *friction);

#endif
