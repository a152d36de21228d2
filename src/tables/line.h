/* SPDX-License-Identifier: GPL-3.0-or-later
**
** line.h - lines of text on their way to a stream, through a buffer.
*/
#ifndef FOURLINK_LINE_H
#define FOURLINK_LINE_H

#include <stdio.h>

#include "base/format.h"

/* Nothing else may be written to the stream between line_start and line_end. */
typedef struct line {
    FILE *out;
    size_t length;
    char bytes[8192]; /* more than this goes to the stream in parts */
} line;

void line_start(line *l, FILE *out);
void line_end(line *l);

void line_text(line *l, const char *s, size_t length);

/* Text at the right of a field; wider text keeps a blank before it. */
void line_right(line *l, const char *s, size_t length, size_t width);
void line_field(line *l, const char *s, size_t width);

/* A number at the end of a field of so many characters, of which it must leave at least one blank: its
** magnitude is for the caller to look at.  0, and nothing is written, if it is left to line_right. */
int line_fixed(line *l, double value, int decimals, size_t width);

/* Formatted text: %s a string, %-8s and %8s one in a field of so many characters; %12g a number with so many
** significant digits, -0 being 0; %lu a whole number. */
void line_put(line *l, const char *format, ...);
void line_number(line *l, double value, int digits);

#endif
