/* SPDX-License-Identifier: GPL-3.0-or-later
**
** marks.h - what is asked of many answers, and what each is worth.
*/
#ifndef FOURLINK_MARKS_H
#define FOURLINK_MARKS_H

#include "input.h"

/* The values that are asked for.  Set it to zero first. */
typedef struct marks {
    struct question *list; /* null: each file is asked for the values that it has */
    unsigned long n;
    int set_tolerances; /* 1: some answers set their own */
    int is_class;       /* 1: all answers are to one deck */
    int are_guessed;    /* 1: found in the answers, because the deck does not list them */
} marks;

/* Find what is asked of the answers in a folder: the values of the deck's own [expect]; without a deck, or if it has
** none, the values that enough answers have.  Returns 0 if out of memory. */
int marks_find(marks *m, const input *deck, const input *inputs, size_t n);

/* Print a note on the values that were found in the answers, if some answers do not have them all. */
void marks_tell(const marks *m, const char *name);

/* What an input is worth. */
void marks_give(marks *m, const input *in, sheet_mark *mark);

void marks_free(marks *m);

#endif
