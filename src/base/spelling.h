/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spelling.h - what people type for a value, in the plain characters of a deck.
*/
#ifndef FOURLINK_SPELLING_H
#define FOURLINK_SPELLING_H

#include "text.h"

/* 1 if a value is sure to be as flk_spelling_plain writes it. */
int flk_spelling_is_plain(text t);

/* The room that flk_spelling_plain needs. */
#define SPELLING_SIZE(length) (4 * (length) + 1)

/* Write a value in plain characters: a minus sign, the blanks of typography, a degree sign, superscripts,
** multiplication signs, powers of ten.  What it does not know it leaves.
**
**    −1.5 × 10³ N·m   -1.5e3 N*m
**    20°              20 deg
**
** Returned (function value):
**    the text, in `out`, of SPELLING_SIZE(t.length) bytes */
text flk_spelling_plain(text t, char *out);

/* The blanks alone. */
text flk_spelling_blanks(text t, char *out);

#endif
