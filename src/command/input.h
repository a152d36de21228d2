/* SPDX-License-Identifier: GPL-3.0-or-later
**
** input.h - a deck of the command line, opened for results.
*/
#ifndef FOURLINK_INPUT_H
#define FOURLINK_INPUT_H

#include "base/message.h"
#include "grade.h"
#include "options.h"

/* Set it to zero before input_read, and give it to input_close. */
typedef struct input {
    const options *o;
    const char *name;
    char *text;
    fourlink_source source;
    struct named_file *files;  /* the files that the deck names */
    int names_output;          /* 1: one of them would be written */
    const char *no_file;       /* why one of them is not read; null: the system says why */
    fourlink_results *results; /* null: the deck is not usable */
    int is_design; /* 1: a design of a [sweep], or a linkage found, is in place of the deck */
    fourlink_solution *found; /* by synthesis, for a report; or null */
    int has_sweep,
        has_task,   /* 1: the deck has a [sweep]; its linkage was found for a [synthesis], */
        has_starts; /* ... from many starts */
    unsigned long n_designs; /* of that [sweep] */
    int has_defects;         /* 1: the linkage found by synthesis has some */
    int has_mistakes;        /* 1: because its text has mistakes */
    fourlink_problem problem;
    grade_answers answers;  /* its own, of a folder */
    const student *student; /* who has written them; null: nobody of a class */
    const struct input
        *deck; /* the same deck without answers, whose notes have been told; null: there is none */
    fourlink_results *like;     /* of the same deck with other answers, opened before; or null */
    int has_slips;              /* 1: some lines of its answers are not read */
    char remarks[MESSAGE_SIZE]; /* what is told of its answers: such lines, decimal commas */
    /* why it is not usable: the first mistake, or a missing file; empty: reading or memory failed, so
    ** that nothing is known about it */
    char refusal[MESSAGE_SIZE];
} input;

/* The text of a deck that can be read only once, such as standard input; null: it has not been read. */
typedef struct input_text {
    char *start;
    size_t length;
} input_text;

/* Read a deck; the answers replace its expected values.  Returns the exit status.  Of a [sweep] this
** reads the first design without mistakes.  `once` keeps the text of a deck that is read again and can
** be read only once; null: it is not read again. */
int input_read(input *in, const char *path, const options *o, const grade_answers *answers,
               input_text *once);

/* The same with the answers of a student to a deck that has been read. */
int input_read_answers(input *in, const input *deck, const options *o, const grade_answers *answers,
                       const student *x);

/* Read a deck without answers, as for a summary, of a [sweep] one design: that of the options, or the
** first.  `own` are the options then, which must live as long as the input.  `with` is null, or the deck
** with answers, which must live longer.  Returns the exit status. */
int input_read_without(input *in, const options *o, options *own, const char *path,
                       const input *with);

void input_close(input *in);

/* 1 if the columns are values of the deck, printed as one line for each branch, and of several decks for each
** design of a [sweep]. */
int input_has_values(const input *in);

/* Convert a value of a number of the deck from the unit of results, with this `to_si`, to the unit of its
** line, in which it is set. */
double input_in_line_unit(fourlink_results *results, const char *name, double to_si, double value);

/* The text of a deck with the values that are computed: memory to free, null if there is not enough. */
char *input_deck_text(const fourlink_results *results, unsigned long *length);

/* Write that text; 0 if memory fails. */
int input_write_deck(const input *in, FILE *out);

#endif
