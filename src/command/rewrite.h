/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rewrite.h - the text of a deck with other values.
*/
#ifndef FOURLINK_REWRITE_H
#define FOURLINK_REWRITE_H

#include <stdio.h>

#include "base/text.h"

#define REWRITE_VALUE 400

/* A value that replaces the deck's own, or is added. */
typedef struct rewrite {
    text section, name, key; /* [SECTION NAME] key; the name may be empty */
    char value[REWRITE_VALUE];
    int is_there; /* 1: the deck has this key */
} rewrite;

/* Equal but for the case of letters. */
int rewrite_same(text x, text y);

/* Split SECTION.KEY, SECTION NAME.KEY or KEY. */
void rewrite_split(text whole, rewrite *r);

/* Write a deck without its [sweep], with these values. */
void rewrite_deck(FILE *out, text deck, rewrite *list, size_t n);

/* The same to memory: a deck without its [sweep], as it is.  Memory to free, or null. */
char *rewrite_without_sweep(text deck, size_t *length);

#endif
