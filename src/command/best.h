/* SPDX-License-Identifier: GPL-3.0-or-later
**
** best.h - the best design of a sweep.
*/
#ifndef FOURLINK_BEST_H
#define FOURLINK_BEST_H

#include <stdio.h>

#include "input.h"

/* Find the design that --best asks for and write it as a deck; returns the exit status.  If a signal stops
** it, its number is `signal_number`, otherwise 0. */
int best_write(FILE *out, const input *in, int *signal_number);

#endif
