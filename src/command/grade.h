/* SPDX-License-Identifier: GPL-3.0-or-later
**
** grade.h - the answers that decks are checked against.
*/
#ifndef FOURLINK_GRADE_H
#define FOURLINK_GRADE_H

#include "options.h"
#include "students.h"

/* The answers of --check: a file, one of a folder for each deck, or all of a folder for one deck. */
typedef struct grade_answers {
    const char *folder; /* null: it is a file */
    char **files;       /* null: not many answers to one deck; their paths, in the order of names */
    size_t n_files;
    student_files handed; /* those of a folder with one for each deck */
    char *path;           /* of the file that was read */
    char *text;           /* null: there is none */
    size_t length;
} grade_answers;

/* Open what --check names, if it names something.  Prints a failure and returns the exit status. */
int grade_open(grade_answers *a, const options *o);

/* Read a file of answers, or for null that of the folder which has the name of the deck.  Returns the exit
** status, and why there are no answers in `why`, which stays as it is if memory failed. */
int grade_read(grade_answers *a, const grade_answers *all, const options *o, const char *deck,
               const char *file, char why[400]);

/* Tell which files of the folder no deck has read; returns the exit status. */
int grade_tell_unclaimed(const grade_answers *a, const options *o);

void grade_close(grade_answers *a);

#endif
