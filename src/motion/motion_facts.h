/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motion_facts.h - facts of the actual motion: mean speed, fluctuation, rate, time of a run-up.
*/
#ifndef FOURLINK_MOTION_FACTS_H
#define FOURLINK_MOTION_FACTS_H

#include "path.h"

/* Set all facts to unknown. */
void flk_facts_forget(flk_actual_facts *f);

/* The facts of the last cycle of a path, which must have one: mean speeds, period, fluctuation; if the path
** is the steady cycle, also its rate. */
void flk_facts_of_cycle(const flk_path *p, double cycle, flk_actual_facts *f);

/* The time of a run-up to the mean speed, which must be known. */
void flk_facts_of_run_up(const flk_path *p, flk_actual_facts *f);

#endif
