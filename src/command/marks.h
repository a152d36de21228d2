/* SPDX-License-Identifier: GPL-3.0-or-later
**
** marks.h - what is asked of many answers, and what each is worth.
*/
#ifndef FOURLINK_MARKS_H
#define FOURLINK_MARKS_H

#include "exercise.h"
#include "roster.h"

/* The values that are asked for. */
typedef struct marks {
    struct question *list; /* null: each file is asked for the values that it has */
    unsigned long n;
    sheet_question *questions; /* the same, for sheets; marks_give sets what each got */
    int set_tolerances;        /* 1: answers may set their own */
    char unit_of_angle[16];
    double turn; /* in this unit, where rows a turn apart are the same; else 0 */
    const options *o;
    const input *deck;   /* to which all are answers; null: each has its own deck */
    exercise exercise;   /* of --exercise */
    size_t n_compared;   /* with the decks of others */
    const roster *names; /* of --names; empty: none */
} marks;

/* Take what is asked of many answers from the [expect] of --exercise or else of the deck to which all
** are answers.  Refuses scores of a folder for which neither says it.  Returns the exit status. */
int marks_begin(marks *m, const options *o, const input *deck, const roster *names);

/* What an input is worth. */
void marks_give(marks *m, const input *in, sheet_mark *mark);

/* The question that a value answers; -1: it is not asked. */
long marks_question(const marks *m, const fourlink_check *c);

/* What question i asks: its name and place. */
const fourlink_check *marks_asked(const marks *m, unsigned long i);

void marks_free(marks *m);

#endif
