/* SPDX-License-Identifier: GPL-3.0-or-later
**
** line.h - lines of text, written to a stream through a buffer.
*/
#ifndef FOURLINK_LINE_H
#define FOURLINK_LINE_H

#include <stdio.h>

#include "system/format.h"

/* Nothing else may be written to the stream between line_start and line_end. */
typedef struct line {
    FILE *out;
    int is_coloured; /* 1: to a terminal, with headings and extremes in colour */
    int is_inside;   /* 1: what was written ends within a line */
    size_t length;
    char bytes[8192]; /* longer text goes to the stream in parts */
} line;

void line_start(line *l, FILE *out);
void line_end(line *l);

void line_text(line *l, const char *s, size_t length);
void line_byte(line *l, char c);

/* The same for text that is not this program's own: bytes that are not printable become question marks. */
void line_words(line *l, const char *s, size_t length);

/* Right-aligned text; if it is wider than the field, a blank is still put before it. */
void line_right(line *l, const char *s, size_t length, size_t width);
void line_field(line *l, const char *s, size_t width);

/* The same for a number with so many significant digits; returns the columns used. */
size_t line_value(line *l, double value, int digits, size_t width);

/* Left-aligned text; returns how much longer it is than the field. */
size_t line_left(line *l, const char *s, size_t width);

/* So many blanks, in which the caller may write; null, and nothing written, if they exceed the buffer. */
char *line_blanks(line *l, size_t width);

/* End a line that began at `start`, which line_here gave, without blanks at its end: on a terminal of this
** width in letters it is broken at blanks, and goes on below the column `indent`.  Width 0: it stays
** whole. */
size_t line_here(line *l);
void line_finish(line *l, size_t start, size_t width, size_t indent);

/* Formatted text: %s a string, %-8s one in a field; %12g a number with so many significant digits, -0
** as 0; %lu a whole number. */
void line_put(line *l, const char *format, ...);
void line_number(line *l, double value, int digits);

/* In place of digits: the fewest that read back as the same number. */
#define LINE_SHORTEST 0

#endif
