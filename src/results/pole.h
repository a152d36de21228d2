/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pole.h - where a column grows without bound in a piece of the motion: what the extremes and the means
** know of it.
*/
#ifndef FOURLINK_POLE_H
#define FOURLINK_POLE_H

#include "samples.h"

enum { FLK_POLE_UP = 1, FLK_POLE_DOWN = 2 };

typedef struct flk_pole {
    double s;     /* its parameter */
    int signs;    /* FLK_POLE_UP, FLK_POLE_DOWN: the infinities towards which the column grows */
    double order; /* it grows as distance^-order, with the distance in crank angle */
} flk_pole;

typedef void flk_take_pole(void *data, const flk_pole *pole);

/* Call a function for each pole of a column in the present piece. */
void flk_poles_find(const flk_samples *x, const flk_sampled *c, flk_take_pole *take, void *data);

#endif
