/* SPDX-License-Identifier: GPL-3.0-or-later
**
** jumps.h - the crank angles at which a joint with friction stands still, so that its friction changes its sense.
*/
#ifndef FOURLINK_JUMPS_H
#define FOURLINK_JUMPS_H

#include "analysis.h"

/* Find them once for a deck; 0 when out of memory. */
int flk_jumps_find(flk_analysis *a);

#endif
