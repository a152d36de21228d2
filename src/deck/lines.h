/* SPDX-License-Identifier: GPL-3.0-or-later
**
** lines.h - first pass over a deck: its lines.
*/
#ifndef FOURLINK_DECK_LINES_H
#define FOURLINK_DECK_LINES_H

#include "parser.h"

/* A line up to its comment, which starts with # or ; at the start of the line or after a blank, outside
** quotes. */
text flk_line_without_comment(text line);

/* Take the next line off a text and cut off its comment.  0 at the end of the text; 0 and a mistake if the
** line is not text, or the text is too large, and reading stops. */
int flk_line_take(parser *p, text *rest, int line_end, text_place place, text cut(text line),
                  text *line);

/* First pass: the lines of the text. */
void flk_lines_read(parser *p);

#endif
