/* SPDX-License-Identifier: GPL-3.0-or-later
**
** roster.h - the list of a class: names, ids, days late.
*/
#ifndef FOURLINK_ROSTER_H
#define FOURLINK_ROSTER_H

#include <stdio.h>

#include "base/text.h"

typedef struct roster_entry {
    text name; /* null-terminated */
    text id, user, email;
    double late;          /* days */
    unsigned long design; /* of a [sweep], from 1; 0: none is given */
    long line;
} roster_entry;

typedef struct roster {
    char *contents, *names;
    roster_entry *list;
    size_t n;
    int has_header; /* 0: a list of names, one a line */
    int separator;  /* of the columns */
    int n_columns;
    int design_column; /* from 0; -1: there is none */
    text lines;        /* of the file */
} roster;

/* Read a list of names, one a line, or a file of a spreadsheet, separated by ; or a tab or a comma,
** whose first line has headings: name, or first name and surname; id, user name, email; late; design.
** Other columns are not read.  Prints a mistake and returns the exit status. */
int roster_read(roster *r, const char *path);
void roster_free(roster *r);

/* Write the same table with a column for the design of each, a list of names with headings. */
void roster_write(const roster *r, FILE *out);

/* The entry of a student; null if there is none. */
const roster_entry *roster_find(const roster *r, text name);

#endif
