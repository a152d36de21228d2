/* SPDX-License-Identifier: GPL-3.0-or-later
**
** output.h - an output file, replaced only when complete.
*/
#ifndef FOURLINK_OUTPUT_H
#define FOURLINK_OUTPUT_H

#include <stdio.h>

typedef struct output {
    FILE *file;
    char *path;      /* null: standard output */
    char *temporary; /* null: written directly, as to a device or a pipe */
} output;

/* Call this before anything is written: a signal that ends the program then leaves no temporary file and no
** rsvg-convert. */
void output_prepare(void);

/* Open a path, or standard output for null and "-"; prints a failure and returns the exit status.  A regular
** file is written beside the path and renamed in output_end. */
int output_begin(output *o, const char *path);

/* Keep or discard what was written; prints a failure and returns the exit status.  An old file stays as it
** was unless the new one is complete; after memory has failed none is. */
int output_end(output *o, const char *path, int keep);

#endif
