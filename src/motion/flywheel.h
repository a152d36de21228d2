/* SPDX-License-Identifier: GPL-3.0-or-later
**
** flywheel.h - the flywheel that gives the steady motion a required fluctuation of speed.
*/
#ifndef FOURLINK_FLYWHEEL_H
#define FOURLINK_FLYWHEEL_H

#include "path.h"

/* Find this flywheel, and the steady motion with it, as flk_steady_find does.  The machine has no flywheel
** before the call and this one after it; 0 if the motion fluctuates less without a flywheel. */
int flk_flywheel_find(flk_path *p, double cycle, double mean_speed, double fluctuation);

#endif
