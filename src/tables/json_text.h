/* SPDX-License-Identifier: GPL-3.0-or-later
**
** json_text.h - strings and numbers of JSON, RFC 8259.
*/
#ifndef FOURLINK_JSON_TEXT_H
#define FOURLINK_JSON_TEXT_H

#include "line.h"

/* Write a string.  Bytes that are not UTF-8 become the replacement character.  Control characters and
** those of `escaped` are written as \u003c. */
void json_text_put(line *l, const char *s, const char *escaped);

/* Write a number with so many significant digits; undefined is null, unbounded is "inf" or "-inf". */
void json_text_number(line *l, double x, int digits);

#endif
