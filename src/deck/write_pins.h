/* SPDX-License-Identifier: GPL-3.0-or-later
**
** write_pins.h - the [pins] of a deck by lengths, for write.c.
*/
#ifndef FOURLINK_DECK_WRITE_PINS_H
#define FOURLINK_DECK_WRITE_PINS_H

#include "parser.h"

#define PINS_SIZE 1000

/* Write [pins] as drawn on the open branch at a crank angle, in lines that end in LF; a status, as from
** fourlink_position. */
int flk_write_pins(parser *p, const deck *d, double theta2, char lines[PINS_SIZE]);

/* 1 if a key of a deck by lengths follows from its pins then. */
int flk_write_drops(const deck *d, key_code key);

/* The word that a key must have then if the deck does not give it; null: it need not. */
const char *flk_write_word(parser *p, const deck *d, key_code key);

#endif
