/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spelling.h - values as people type them, rewritten in the plain characters of a deck.
*/
#ifndef FOURLINK_SPELLING_H
#define FOURLINK_SPELLING_H

#include "text.h"

/* 1 if flk_spelling_plain would certainly leave a value as it is. */
int flk_spelling_is_plain(text t);

/* The size of the buffer that flk_spelling_plain needs. */
#define SPELLING_SIZE(length) (4 * (length) + 1)

/* Write a value in plain characters: converts minus signs, typographic blanks, degree signs, superscripts,
** multiplication signs and powers of ten.  Other characters are copied.
**
**    −1.5 × 10³ N·m   -1.5e3 N*m
**    20°              20 deg
**
** Returned (function value):
**    the text, in `out`, of SPELLING_SIZE(t.length) bytes */
text flk_spelling_plain(text t, char *out);

#endif
