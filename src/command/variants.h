/* SPDX-License-Identifier: GPL-3.0-or-later
**
** variants.h - the designs of a [sweep] as files, with numbers or with names from a list.
*/
#ifndef FOURLINK_VARIANTS_H
#define FOURLINK_VARIANTS_H

#include "input.h"
#include "roster.h"

/* The names of the files.  Set it to zero first. */
typedef struct variants {
    const roster *names; /* empty: the files have numbers */
    unsigned long n;     /* how many files are written */
} variants;

/* Take the list of --names, if it is given, for a deck with a [sweep].  Returns the exit status. */
int variants_open(variants *v, const input *deck, const roster *names);

/* FOLDER/NAME.ending or FOLDER/DECK-N.ending, N from 1 with as many digits as the largest has: memory
** to free, or null. */
char *variants_path(const variants *v, const char *folder, const input *deck, unsigned long i,
                    const char *ending);

#endif
