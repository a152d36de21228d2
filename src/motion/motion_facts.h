/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motion_facts.h - facts of the actual motion: mean speed, fluctuation, rate, time of a run-up.
*/
#ifndef FOURLINK_MOTION_FACTS_H
#define FOURLINK_MOTION_FACTS_H

#include "path.h"

/* None is known. */
void flk_facts_forget(flk_actual_facts *f);

/* Those of the last cycle of a path, which has one: mean speeds, period, fluctuation; of a path that is the steady
** cycle its rate too. */
void flk_facts_of_cycle(const flk_path *p, double cycle, flk_actual_facts *f);

/* The time of a run-up to the mean speed, which is known. */
void flk_facts_of_run_up(const flk_path *p, flk_actual_facts *f);

#endif
