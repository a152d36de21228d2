/* SPDX-License-Identifier: GPL-3.0-or-later
**
** best.h - the best design of a sweep: of its grid, refined between its neighbours there.
*/
#ifndef FOURLINK_COMMAND_BEST_H
#define FOURLINK_COMMAND_BEST_H

#include <stdio.h>

#include "input.h"

/* Write the design that --best asks for, as a deck. */
int best_write(FILE *out, const input *in);

#endif
