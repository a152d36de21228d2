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

/* Some text, all of it or so many bytes. */
void line_words(line *l, const char *s);
void line_text(line *l, const char *s, size_t length);

/* Text in a field, to the right of blanks, or to their left for a width below 0; wider text keeps a blank
** before it. */
void line_right(line *l, const char *s, size_t length, size_t width);
void line_field(line *l, const char *s, int width);

/* A number at the end of a field of so many characters, of which it must leave at least one blank: its
** magnitude is for the caller to look at.  0, and nothing is written, if it is left to line_right. */
int line_fixed(line *l, double value, int decimals, size_t width);

/* A number with so many significant digits; -0 is 0. */
void line_number(line *l, double value, int digits);

#endif
