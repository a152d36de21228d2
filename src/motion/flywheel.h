/* SPDX-License-Identifier: GPL-3.0-or-later
**
** flywheel.h - the flywheel with which the steady motion has a wanted fluctuation of speed.
*/
#ifndef FOURLINK_FLYWHEEL_H
#define FOURLINK_FLYWHEEL_H

#include "path.h"

/* Find this flywheel, and with it the steady motion, as flk_steady_find does.  The machine has no flywheel before, and
** then this one; its flywheel is 0 if the motion fluctuates less without one. */
int flk_flywheel_find(flk_path *p, double cycle, double mean_speed, double fluctuation);

#endif
