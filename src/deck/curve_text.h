/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve_text.h - curves over the crank angle, or over another argument, from the text of a deck, or from a
** file that it names.
*/
#ifndef FOURLINK_DECK_CURVE_TEXT_H
#define FOURLINK_DECK_CURVE_TEXT_H

#include "parser.h"

/* Take the text up to the next comma outside parentheses off the front of `rest`; 0 if nothing is left. */
int flk_curve_text_item(text *rest, text *item);

/* 1 if a curve is `file NAME`; `name` may be null. */
int flk_curve_text_file(text value, text *name);

/* Read a value, or a force; or a curve: 0 deg 1 bar, 20 deg 32 bar, ... or file NAME. */
int flk_curve_text_read(parser *p, setting *s, quantity q);

#endif
