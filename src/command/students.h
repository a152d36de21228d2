/* SPDX-License-Identifier: GPL-3.0-or-later
**
** students.h - the files of a folder by the names of students.
*/
#ifndef FOURLINK_STUDENTS_H
#define FOURLINK_STUDENTS_H

#include "base/text.h"

/* A name of a file, or of a student, without its endings. */
text students_stem(const char *path);

/* 1 if two names are of the same student: letters without case and accents; blanks, "_" and "-" are the
** same. */
int students_same(text x, text y);

/* The files of a folder. */
typedef struct student_files {
    char **names; /* sorted; without the hidden ones */
    int *claimed; /* 1: some deck has it */
    size_t n;
} student_files;

/* Returns 0 with errno set if the folder cannot be read, or if out of memory. */
int students_list(student_files *f, const char *folder);
void students_free(student_files *f);

/* The file of a student, which is then claimed: that with the name itself before others, .expect, .txt and
** .csv before other endings; null if there is none. */
const char *students_find(student_files *f, text stem);

/* 1 if a file is one of answers: it ends in .expect, .txt or .csv. */
int students_is_text(const char *name);

/* Tell which files of the folder are nobody's; returns how many. */
size_t students_tell_unclaimed(const student_files *f, const char *folder,
                               const char *const *stems);

#endif
