/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.h - the files of the command line: reading them, and whether two are one.
*/
#ifndef FOURLINK_FILES_H
#define FOURLINK_FILES_H

#include "options.h"

/* All of a file, of files_read also standard input for "-": memory to be freed, or null with errno set;
** EFBIG if it is of more than 64 MB. */
char *files_read(const char *path, size_t *length);
char *files_read_path(const char *path, size_t *length);

/* A name as seen from the folder that a path is in: memory to be freed, or null. */
char *files_beside(const char *path, const char *name);

/* 1 if a file is one of those that are to be written. */
int files_is_output(const options *o, const char *path);

/* Tell the first output file that is an input, or that is another output too; the exit status. */
int files_tell_clash(const options *o);

#endif
