/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pins.h - [pins]: a mechanism by the places of its pins on a page, in one drawn position.
*/
#ifndef FOURLINK_DECK_PINS_H
#define FOURLINK_DECK_PINS_H

#include "parser.h"

/* Find what follows from the places of the pins, before the mechanism is built.  Does nothing without
** [pins]. */
void flk_pins_read(parser *p);

/* Find the drawn branch of the mechanism that has been built. */
void flk_pins_find_branch(parser *p);

/* Find where the links of outputs are in the drawing, of those that have been built. */
void flk_pins_draw_outputs(parser *p);

/* The point of a link, or of the ground, that is at a place of the drawing; 0 and a mistake without
** [pins], or where an output cannot be assembled in the drawn position. */
int flk_pins_place(parser *p, const setting *s, int link, fourlink_vector *at);

/* 1 if a key of a deck follows from its pins, so that it cannot be set. */
int flk_pins_give(const deck *d, key_code key);

#endif
