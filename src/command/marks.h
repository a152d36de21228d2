/* SPDX-License-Identifier: GPL-3.0-or-later
**
** marks.h - what is asked of many answers, and what each is worth.
*/
#ifndef FOURLINK_MARKS_H
#define FOURLINK_MARKS_H

#include "input.h"
#include "roster.h"

/* The values that are asked for. */
typedef struct marks {
    struct question *list; /* null: each file is asked for the values that it has */
    unsigned long n;
    sheet_question *questions; /* the same, for sheets; marks_give sets what each got */
    unsigned long n_of_deck;   /* those of the deck's own [expect] */
    int set_tolerances;        /* 1: some answers set their own */
    int are_guessed;           /* 1: found in the answers, because the deck does not list them */
    unsigned long readable, number; /* answers that could be read, of so many */
    const options *o;
    const input *deck;
    size_t n_compared; /* with the decks of others */
    roster names;      /* of --names; empty: none */
} marks;

/* Find what is asked of many answers, those to one deck or of a folder: the values of the deck's own
** [expect]; if it has none, the values that enough answers have, which a note tells.  Begin, which
** returns the exit status; add each input; then end. */
int marks_begin(marks *m, const options *o, const input *deck);
void marks_add(marks *m, const input *in);
void marks_end(marks *m);

/* What an input is worth. */
void marks_give(marks *m, const input *in, sheet_mark *mark);

/* The question that a value answers; -1: it is not asked. */
long marks_question(const marks *m, const fourlink_check *c);

void marks_free(marks *m);

#endif
