/* SPDX-License-Identifier: GPL-3.0-or-later
**
** best.h - the best design of a sweep.
*/
#ifndef FOURLINK_BEST_H
#define FOURLINK_BEST_H

#include <stdio.h>

#include "input.h"

/* Find the design that --best asks for and write it as a deck; returns the exit status. */
int best_write(FILE *out, const input *in);

#endif
