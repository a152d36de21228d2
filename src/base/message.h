/* SPDX-License-Identifier: GPL-3.0-or-later
**
** message.h - messages, and the mistakes of a deck.
*/
#ifndef FOURLINK_MESSAGE_H
#define FOURLINK_MESSAGE_H

#include <stdarg.h>

#include "text.h"

#define MESSAGE_SIZE 400

/* Write a message.  Its format may contain
**
**    %s    a string
**    %t    a text, shortened if it is longer than a word
**    %ld   a whole number, a long
**    %g    a number with at most 9 significant digits; with at most 4: %.4g
**    %h    the nearest known word, a string: "; did you mean 'WORD'?"; nothing for null
**    %%    a per cent sign
**
** A message that does not fit is cut off. */
char *flk_message(char *out, size_t size, const char *format, ...);
char *flk_message_list(char *out, size_t size, const char *format, va_list values);

/* The place of something: "FILE:LINE", or an option of the command line (line 0). */
typedef struct text_place {
    const char *source;
    long line;
} text_place;

/* Mistakes beyond this number are only counted, not listed. */
#define MOST_MISTAKES 100

/* The mistakes found in a deck, in the order of its lines. */
typedef struct mistakes {
    struct mistake *list;
    size_t count, left_out;
    int out_of_memory; /* 1: a mistake could not be recorded */
} mistakes;

struct mistake {
    text_place place;
    char message[MESSAGE_SIZE];
};

/* Record a mistake, with a format as above.  Returns 0, so that a failing function can return it. */
int flk_mistake(mistakes *m, text_place place, const char *format, ...);

/* The number of mistakes, including those that are only counted. */
size_t flk_mistakes_count(const mistakes *m);

/* 1 if further mistakes are only counted, so that no details are needed. */
int flk_mistakes_are_full(const mistakes *m);

/* Sort by line, for printing. */
void flk_mistakes_sort(mistakes *m);
void flk_mistakes_free(mistakes *m);

#endif
