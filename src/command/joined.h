/* SPDX-License-Identifier: GPL-3.0-or-later
**
** joined.h - statistics of designs that were computed before, in a file of csv.
*/
#ifndef FOURLINK_JOINED_H
#define FOURLINK_JOINED_H

#include <stdio.h>

#include "input.h"

/* Write the statistics of the file of --statistics: of the outputs of a deck, with its yield, or with null of all
** columns after `branch`.  Returns the exit status. */
int joined_write(FILE *out, const options *o, const input *in);

#endif
