/* SPDX-License-Identifier: GPL-3.0-or-later
**
** best.h - the best design of a sweep: of its grid, refined between its neighbours there.
*/
#ifndef FOURLINK_COMMAND_BEST_H
#define FOURLINK_COMMAND_BEST_H

#include <stdio.h>

#include "input.h"
#include "tables/sheet.h"

/* Write the design that --best asks for, as a deck. */
int best_write(FILE *out, const input *in);

/* The same as a line of a sheet of values, with columns that best_columns gives: memory to free, null if
** there is not enough.  A deck without one has a line that says why. */
fourlink_value *best_columns(const input *in, unsigned long *n);
int best_put(sheet *s, const input *in);

#endif
