/* SPDX-License-Identifier: GPL-3.0-or-later
**
** designs.h - the designs of a deck's [sweep], one after the other.
*/
#ifndef FOURLINK_DESIGNS_H
#define FOURLINK_DESIGNS_H

#include <stdio.h>

#include "input.h"

/* Write the designs that are asked for; the exit status.  An interruption ends it behind a whole line, and is
** told by `signal_number`, which is 0 otherwise. */
int designs_write(FILE *out, const input *in, int *signal_number);

#endif
