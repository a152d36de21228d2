/* SPDX-License-Identifier: GPL-3.0-or-later
**
** person.h - names of people, compared by their words: letters without case and accents.
*/
#ifndef FOURLINK_PERSON_H
#define FOURLINK_PERSON_H

#include "base/text.h"

#define PERSON_NAME 256
#define PERSON_WORDS 40

/* The words of a name in plain letters, one behind the other. */
typedef struct person_words {
    char letters[PERSON_NAME];
    int start[PERSON_WORDS + 1];
    int n;
} person_words;

/* Take the words of a text, or add them.  Marks that stand behind their letter, U+0300 to U+036F, and
** apostrophes are left out. */
void person_take(person_words *w, text t);
void person_add(person_words *w, text t);

/* The number of bytes of all words. */
int person_length(const person_words *w);

/* 1 if two names have the same words. */
int person_are_same(const person_words *x, const person_words *y);
int person_same(text x, text y);

/* 1 if whole words of w, one behind the other, are the letters of `part`, from its word k on and then
** those before it; the same from any word on. */
int person_has_turned(const person_words *w, const person_words *part, int k);
int person_has_name(const person_words *w, const person_words *name);

/* 1 if word i of w is one of `of`, or begins one if it is a single letter; *is_whole is set if it is all
** of it. */
int person_is_word(const person_words *w, int i, const person_words *of, int *is_whole);

#endif
