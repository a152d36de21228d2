/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.h - reading whole files, and whether what is to be written is something else already.
*/
#ifndef FOURLINK_FILES_H
#define FOURLINK_FILES_H

#include "options.h"

/* All of a file, of files_read also standard input for "-": memory to be freed, or null with errno set;
** EFBIG if it is of more than 64 MB. */
char *files_read(const char *path, size_t *length);
char *files_read_path(const char *path, size_t *length);

/* 1 if a file is one of those that are to be written. */
int files_is_output(const options *o, const char *path);

/* The first output file that is an input, or that is another output too; or null. */
const char *files_input_among_outputs(const options *o);
const char *files_output_given_twice(const options *o);

#endif
