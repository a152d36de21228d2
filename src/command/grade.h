/* SPDX-License-Identifier: GPL-3.0-or-later
**
** grade.h - the answers that decks are checked against.
*/
#ifndef FOURLINK_GRADE_H
#define FOURLINK_GRADE_H

#include "options.h"
#include "students.h"

/* The answers of --check: a file, one of a folder for each deck, or all of a folder for one deck; and
** the class of --names. */
typedef struct grade_answers {
    const char *folder; /* null: it is a file */
    int is_class;       /* 1: all files of the folder are answers to one deck */
    roster names;       /* of --names; empty: none */
    students students;  /* those of the class, or of the decks */
    char *path;         /* of the file that was read */
    char *text;         /* null: there is none */
    size_t length;
} grade_answers;

/* Open what --check and --names name, if they name something.  Prints a failure and returns the exit
** status. */
int grade_open(grade_answers *a, const options *o);

/* Give each student of a folder the file that he or she has handed in, and tell which are not marked.
** Returns the exit status. */
int grade_match(grade_answers *a, const options *o);

/* Read the file of answers of a student.  Returns the exit status, and why there are no answers in
** `why`, which stays as it is if memory failed. */
int grade_read(grade_answers *a, const grade_answers *all, const options *o, const student *x,
               char why[400]);

/* The same for a deck, which tells the student; for null, it is no student's. */
int grade_read_for(grade_answers *a, const grade_answers *all, const options *o, const char *deck,
                   const student **x, char why[400]);

void grade_close(grade_answers *a);

#endif
