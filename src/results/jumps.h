/* SPDX-License-Identifier: GPL-3.0-or-later
**
** jumps.h - the crank angles at which a joint with friction stands still, so that its friction changes its sense.
*/
#ifndef FOURLINK_JUMPS_H
#define FOURLINK_JUMPS_H

#include "deck/deck.h"

typedef struct flk_jumps {
    double *theta2; /* rad, in one period; to be freed */
    size_t n;
    double period; /* rad */
} flk_jumps;

/* Find them once for a deck; 0 when out of memory. */
int flk_jumps_find(const deck *d, flk_jumps *jumps);

#endif
