/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve_text.h - curves over the crank angle, or over another argument, from the text of a deck, or from a
** file that it names.
*/
#ifndef FOURLINK_DECK_CURVE_TEXT_H
#define FOURLINK_DECK_CURVE_TEXT_H

#include "parser.h"

/* 1 if a curve is `file NAME`; `name` may be null. */
int flk_curve_text_file(text value, text *name);

/* Read a value, or a force; or a curve: 0 deg 1 bar, 20 deg 32 bar, ... or file NAME. */
int flk_curve_text_read(parser *p, setting *s, quantity q);

#endif
