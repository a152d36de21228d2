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

/* Open a path, or standard output for null.  1 if it went well; else 0, errno says why.  A regular
** file is written beside the path and takes its place in output_close. */
int output_open(output *o, const char *path);

/* Finish: 1 if everything was written.  Else 0, errno says why, and a file that was there before is
** as it was. */
int output_close(output *o);

/* Give up what was written to a regular file. */
void output_discard(output *o);

#endif
