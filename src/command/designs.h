/* SPDX-License-Identifier: GPL-3.0-or-later
**
** designs.h - the designs of a deck's [sweep], one after the other.
*/
#ifndef FOURLINK_COMMAND_DESIGNS_H
#define FOURLINK_COMMAND_DESIGNS_H

#include <stdio.h>

#include "input.h"

/* Write the designs of a [sweep] that are asked for. */
int designs_write(FILE *out, const input *in);

#endif
