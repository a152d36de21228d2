/* SPDX-License-Identifier: GPL-3.0-or-later
**
** output.h - a file for results, of which nothing is seen until all of it is there.
*/
#ifndef FOURLINK_OUTPUT_H
#define FOURLINK_OUTPUT_H

#include <stdio.h>

typedef struct output {
    FILE *file;
    char *path;      /* null: standard output */
    char *temporary; /* null: written directly, as to a device or a pipe */
} output;

/* To be called before anything is written to standard output. */
void output_prepare(void);

/* Open a path, or standard output for null and "-"; the exit status, which has been told.  A regular file is
** written beside the path and takes its place in output_end. */
int output_begin(output *o, const char *path);

/* Finish, or give up what was written; the exit status, which has been told.  A file that was there before
** is as it was, unless all of the new one was written. */
int output_end(output *o, const char *path, int keep);

#endif
