/* SPDX-License-Identifier: GPL-3.0-or-later
**
** text.h - pieces of text within a larger one.
*/
#ifndef FOURLINK_TEXT_H
#define FOURLINK_TEXT_H

#include <stddef.h>

#include "arithmetic.h"

/* A piece of a text, not null-terminated. */
typedef struct text {
    const char *start;
    size_t length;
} text;

text flk_text_of(const char *string);
text flk_text_trim(text t);

/* The length of the blank at the start of a text, or at its end; 0 if there is none.  Typographic blanks,
** such as the no-break space, count too. */
size_t flk_text_blank(text t);
size_t flk_text_blank_before(text t);

/* A text without its first n characters. */
text flk_text_from(text t, size_t n);

/* A text without the byte order mark of UTF-8 at its start. */
text flk_text_without_mark(text t);

/* A text without the double quotes around it. */
text flk_text_unquoted(text t);

/* The number of times a character occurs. */
size_t flk_text_count(text t, int c);

/* Join strings, up to a null pointer; cut off at `size`. */
char *flk_text_join(char *out, size_t size, ...);

/* 1 for a character of a word (letter, digit, _ or a byte of UTF-8). */
int flk_text_is_word(int c);

/* Equal except for the case of ASCII letters. */
int flk_text_equal(text t, const char *word);

/* Equal, case included. */
int flk_text_same(text t, const char *word);

/* 1 if a text ends in this, whatever the case of its letters, and is longer. */
int flk_text_ends_in(text t, const char *ending);

/* Take the characters up to `stop` (or all) off the front of `rest`; 0 if nothing is left. */
int flk_text_split(text *rest, int stop, text *piece);

/* What separates the fields of a spreadsheet's lines: ;, a tab or a comma, the first of these that it has.
** Take a field off the front of a line, trimmed and without the quotes around it, within which a separator is
** a letter; 0 if nothing is left. */
int flk_text_separator(text t);
int flk_text_field(text *rest, int separator, text *field);

/* The length of the UTF-8 character at the front; 0 if there is none.  The same if it is printable: allowed
** in XML, and not a control character, which could control a terminal. */
size_t flk_text_letter(text t);
size_t flk_text_printable(text t);

/* The character that ends the lines of a text: LF, or CR if it has no LF. */
int flk_text_line_end(text t);

/* Cut a text at a separator: at the first one, or at the last; the pieces are trimmed.  0 if there is none.
** A tab counts as a blank of the separator. */
int flk_text_cut(text t, const char *separator, text *before, text *after);
int flk_text_cut_last(text t, const char *separator, text *before, text *after);

/* Cut a range, LOW to HIGH or LOW .. HIGH, in two; 0 if it is none. */
int flk_text_range(text t, text *low, text *high);

/* A null-terminated copy in `size` bytes; unprintable bytes are replaced, and "..." marks what did not
** fit. */
char *flk_text_copy(text t, char *out, size_t size);

/* The same for a message: a tab becomes a blank. */
char *flk_text_quote(text t, char *out, size_t size);

/* The word nearest to `t`, one or two typing mistakes away, in a list that ends with a null pointer.  Null if
** there is none. */
const char *flk_text_nearest(text t, const char *const *words);

/* Join the words of a list, with a null pointer at its end: a BETWEEN b BETWEEN c LAST d; cut off at
** `size`. */
char *flk_text_list(const char *const *words, const char *between, const char *last, char *out,
                    size_t size);

/* "a" or "an", whichever stands before these words. */
const char *flk_text_article(const char *words);

#endif
