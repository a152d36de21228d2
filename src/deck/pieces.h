/* SPDX-License-Identifier: GPL-3.0-or-later
**
** pieces.h - pieces of a value: a number, its unit, its size; a quantity.
*/
#ifndef FOURLINK_DECK_PIECES_H
#define FOURLINK_DECK_PIECES_H

#include "parser.h"

/* Read a quantity; 0 and a mistake if it is not one.  `whole` is the text that contains it. */
int flk_piece_quantity(parser *p, text_place place, text t, text whole, quantity q,
                       quantity_value *value);

/* Pieces of a setting's value: take the number off the front of `rest`; read the unit `t` (the deck's if
** empty); check the size; read a quantity. */
int flk_piece_number(parser *p, const setting *s, text *rest, quantity q, double *number);
int flk_piece_unit(parser *p, const setting *s, text t, quantity q, unit *u);
int flk_piece_size(parser *p, const setting *s, quantity q, double si);
int flk_piece_read(parser *p, setting *s, text t, quantity q, double *si);

/* Take the text up to the next comma outside parentheses off the front of `rest`; 0 if nothing is left. */
int flk_piece_item(text *rest, text *item);

#endif
