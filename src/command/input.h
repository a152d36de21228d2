/* SPDX-License-Identifier: GPL-3.0-or-later
**
** input.h - a deck of the command line, opened for results.
*/
#ifndef FOURLINK_INPUT_H
#define FOURLINK_INPUT_H

#include "options.h"

/* Zero it before input_read, and give it to input_close. */
typedef struct input {
    const options *o;
    const char *name;
    char *text;
    fourlink_source source;
    struct named_file *files;  /* those that the deck names */
    int names_output;          /* 1: one of them is to be written */
    fourlink_results *results; /* null: the deck is not usable */
    fourlink_problem problem;
} input;

/* Read a deck, and the answers that take the place of its expected values, if they are not null; the exit
** status.  Of a [sweep] it is the first design that is in order. */
int input_read(input *in, const char *path, const options *o, const char *answers,
               size_t answers_length);

void input_close(input *in);

#endif
