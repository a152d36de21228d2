/* SPDX-License-Identifier: GPL-3.0-or-later
**
** exercise.h - the deck of an exercise: its [expect] says what is asked, its [grading] how it is marked.
*/
#ifndef FOURLINK_EXERCISE_H
#define FOURLINK_EXERCISE_H

#include "input.h"

typedef struct exercise {
    input deck; /* its results are null if it has not been read */
    options of_deck;
    options of_answers; /* those of the command line, with its [grading] */
    fourlink_change *changes;
    char *text;
} exercise;

/* Read the deck of an exercise, of a [sweep] its first design.  Returns the exit status. */
int exercise_read(exercise *x, const options *o, const char *path);
void exercise_close(exercise *x);

#endif
