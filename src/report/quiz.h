/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quiz.h - the exercise of a deck as a quiz in Moodle XML: a question of the type cloze for each design.
*/
#ifndef FOURLINK_QUIZ_H
#define FOURLINK_QUIZ_H

#include <stdio.h>

#include "fourlink.h"

/* Begin the file of a quiz, with the category of its questions; end it. */
void quiz_begin(FILE *out, const char *title);
void quiz_end(FILE *out);

/* Write a question: the words of the exercise, what is given, the figure without answers, a field for each
** value of [expect] with its tolerance and marks, and the sample calculation as feedback.
**
** Given:
**    title       of the deck, or what stands for it
**    source      of the deck, or of this design of its [sweep], in the units of the deck
**    results     opened from it
**    design      the number of the design, from 1; 0: the deck has no [sweep]
** Returned:
**    why         if it returns 0, why there is no question
** Returned (function value):
**    1; 0; -1 if out of memory or a temporary file failed
*/
int quiz_put_question(FILE *out, const char *title, const fourlink_source *source,
                      fourlink_results *results, unsigned long design, fourlink_mistake *why);

#endif
