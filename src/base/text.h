/* SPDX-License-Identifier: GPL-3.0-or-later
**
** text.h - pieces of text within a larger one.
*/
#ifndef FOURLINK_TEXT_H
#define FOURLINK_TEXT_H

#include <stddef.h>

/* A piece of a text: not terminated by a null character. */
typedef struct text {
    const char *start;
    size_t length;
} text;

text flk_text_of(const char *string);
text flk_text_trim(text t);

/* Without its first n characters. */
text flk_text_from(text t, size_t n);

/* Without the byte order mark of UTF-8 at its start. */
text flk_text_without_mark(text t);

/* Pieces of text, up to a null pointer, one behind the other, cut off where `size` ends. */
char *flk_text_join(char *out, size_t size, ...);

/* 1 for a character of a word (letter, digit, _ or a byte of UTF-8). */
int flk_text_is_word(int c);

/* Equal but for the case of ASCII letters. */
int flk_text_equal(text t, const char *word);

/* Equal, case included. */
int flk_text_same(text t, const char *word);

/* Take the characters up to `stop` (or all) off the front of `rest`; 0 when nothing is left. */
int flk_text_split(text *rest, int stop, text *piece);

/* Cut a text at a separator: at the first one, or at the last; the pieces are trimmed.  0 if there is none.
** A tab is as good as a blank of the separator. */
int flk_text_cut(text t, const char *separator, text *before, text *after);
int flk_text_cut_last(text t, const char *separator, text *before, text *after);

/* A copy that fits into `size` bytes, null-terminated, what cannot be printed replaced, what does
** not fit replaced by "..." */
char *flk_text_copy(text t, char *out, size_t size);

/* The word of a list, ended by a null pointer, that is most like `t`: a typing mistake or two away.
** Null if none is. */
const char *flk_text_nearest(text t, const char *const *words);

/* "a" or "an", whichever stands before these words. */
const char *flk_text_article(const char *words);

#endif
