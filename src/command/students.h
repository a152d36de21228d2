/* SPDX-License-Identifier: GPL-3.0-or-later
**
** students.h - the students of a class, and which file of a folder each has handed in.
*/
#ifndef FOURLINK_STUDENTS_H
#define FOURLINK_STUDENTS_H

#include "options.h"
#include "roster.h"

/* A student. */
typedef struct student {
    text name;
    const roster_entry *entry; /* of --names; null: not in it, or there is no list */
    struct person_words *words;
    const char *file;   /* in the folder, such as NAME.txt or NAME/hw4.txt; null: none is marked */
    const char *second; /* another one, where it is not clear which counts; null: it is clear */
} student;

/* A file that was handed in. */
typedef struct student_file {
    char *name;  /* in the folder */
    char *owner; /* the name that says whose it is: of the file, or of its own folder */
} student_file;

typedef struct students {
    student *list;
    size_t n;
    student_file *files; /* of the folder, sorted, without hidden ones */
    size_t n_files;
} students;

/* 1 if a file is one of answers: it ends in .expect, .txt or .csv. */
int students_is_text(const char *name);

/* List the files of a folder; a folder in it is that of a student, with what he or she has handed in,
** unless the options name it for output.  Returns 0 with errno set if it cannot be read, or if out of
** memory. */
int students_list(students *s, const char *folder, const options *o);

/* Add a student, with the entry of a list or null; a name that is there is not added again.  `name` must
** live as long.  0 if out of memory. */
int students_add(students *s, text name, const roster_entry *entry);

/* Add those whose names the files of answers have; 0 if out of memory. */
int students_add_owners(students *s);

/* Give each student the file that he or she has handed in, and tell which files are not marked, and why,
** with the nearest name; of nobody's files with `is_class` only.  Returns 0 if out of memory. */
int students_match(students *s, const char *folder, int is_class);

/* The student of a name; null if there is none. */
const student *students_find(const students *s, text name);

void students_free(students *s);

#endif
