/* SPDX-License-Identifier: GPL-3.0-or-later
**
** roster.h - the list of a class: names, ids, days late.
*/
#ifndef FOURLINK_ROSTER_H
#define FOURLINK_ROSTER_H

#include "base/text.h"

typedef struct roster_entry {
    text name, id;
    double late; /* days */
} roster_entry;

typedef struct roster {
    char *contents;
    roster_entry *list;
    size_t n;
} roster;

/* Read a file of a spreadsheet with the columns name, id and late, separated by ; or a tab or a comma, in
** any order; the first line names them, and others are not read.  Prints a mistake and returns the exit
** status. */
int roster_read(roster *r, const char *path);
void roster_free(roster *r);

/* The entry of a student; null if there is none. */
const roster_entry *roster_find(const roster *r, text name);

#endif
