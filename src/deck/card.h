/* SPDX-License-Identifier: GPL-3.0-or-later
**
** card.h - curves from two-column files, crank angle and value, as instruments write them.
*/
#ifndef FOURLINK_DECK_CARD_H
#define FOURLINK_DECK_CARD_H

#include "parser.h"

/* Read a curve from a file: NAME, or NAME with the units of its columns; see card.c. */
int flk_card_read(parser *p, setting *s, quantity q, text name);

#endif
