/* SPDX-License-Identifier: GPL-3.0-or-later
**
** variants.h - the designs of a [sweep] as files, with numbers or with names from a list.
*/
#ifndef FOURLINK_VARIANTS_H
#define FOURLINK_VARIANTS_H

#include "input.h"
#include "roster.h"

/* The names of the files. */
typedef struct variants {
    roster *names;   /* empty: the files have numbers */
    unsigned long n; /* how many files are written */
} variants;

/* Take the list of --names, if it is given, for a deck with a [sweep], and give each student without a
** design the next that is free, in the order of the list.  One without a column for designs has those of
** the list that was written into the folder before.  Returns the exit status. */
int variants_open(variants *v, const input *deck, roster *names, const char *folder);

/* The design of file i, from 1. */
unsigned long variants_design(const variants *v, unsigned long i);

/* Write the list with a column for the designs into the folder, FOLDER/class.csv; returns the exit status. */
int variants_write_list(const variants *v, const char *folder);

/* FOLDER/NAME.ending or FOLDER/DECK-N.ending, N from 1 with as many digits as the largest has: memory
** to free, or null. */
char *variants_path(const variants *v, const char *folder, const input *deck, unsigned long i,
                    const char *ending);

#endif
