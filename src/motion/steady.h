/* SPDX-License-Identifier: GPL-3.0-or-later
**
** steady.h - the motion that repeats after a cycle, and facts of a motion.
*/
#ifndef FOURLINK_STEADY_H
#define FOURLINK_STEADY_H

#include "path.h"

/* Find the speed at the first row of the steady motion of a path's machine and, for a motor that balances,
** its torque.  The path is then the cycle.  If there is none, p->status says why and, if the crank stalls,
** the path ends where it does.
**
** Given:
**    cycle       rad
**    mean_speed  rad/s, in the sense of the motion, of a motor that balances
**    fluctuation 1, of the speed: then the flywheel is sought, too, in place of the machine's; 0: it is given
** Returned (function value):
**    1 found, 0 not
*/
int flk_steady_find(flk_path *p, double cycle, double mean_speed, double fluctuation);

/* Set all facts to unknown. */
void flk_facts_forget(flk_actual_facts *f);

/* The facts of the last cycle of a path, which must have one: mean speeds, period, fluctuation; if the path
** is the steady cycle, also its rate. */
void flk_facts_of_cycle(const flk_path *p, double cycle, flk_actual_facts *f);

/* The time of a run-up to the mean speed, which must be known. */
void flk_facts_of_run_up(const flk_path *p, flk_actual_facts *f);

#endif
