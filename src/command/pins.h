/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pins.h - the deck of --print-deck --pins: a deck by lengths as one by the places of its pins.
*/
#ifndef FOURLINK_COMMAND_PINS_H
#define FOURLINK_COMMAND_PINS_H

#include <stdio.h>

#include "input.h"

/* Write the deck, drawn at --plot-at or else at its first row; returns the exit status. */
int pins_write(FILE *out, input *in);

#endif
