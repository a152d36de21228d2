/* SPDX-License-Identifier: GPL-3.0-or-later
**
** designs.h - the designs of a deck's [sweep], one after the other.
*/
#ifndef FOURLINK_DESIGNS_H
#define FOURLINK_DESIGNS_H

#include <stdio.h>

#include "input.h"

/* Write the designs that are asked for; returns the exit status.  A signal stops it after a whole line; its
** number is `signal_number`, otherwise 0. */
int designs_write(FILE *out, const input *in, int *signal_number);

#endif
