/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.h - the files of the command line: reading them, and which are the same.
*/
#ifndef FOURLINK_FILES_H
#define FOURLINK_FILES_H

#include "options.h"

/* Read a whole file; files_read reads standard input for "-".  Returns memory to free, or null with errno
** set, to EFBIG if the file is larger than 64 MB. */
char *files_read(const char *path, size_t *length);
char *files_read_path(const char *path, size_t *length);

/* Read a file that is no device or FIFO, which could wait for ever; null with errno 0 if it is one. */
char *files_read_regular(const char *path, size_t *length);

/* 1 if a name, relative to the folder of `path`, does not lead out of this folder; symbolic links are
** followed.  0 with errno ENOMEM if out of memory, otherwise with 0. */
int files_is_beside(const char *path, const char *name);

/* 1 if this errno means that there is no such file. */
int files_is_missing(int reason);

/* 1 if a path is that of a folder. */
int files_is_folder(const char *path);

/* Make the folder of a path, which ends in its separator, and those above it that are missing.  Prints a
** failure, also of one that may not be written, and returns the exit status. */
int files_make_folder(const char *path);

/* The name of a file in a path, after its folders. */
const char *files_name(const char *path);

/* The same without the ending of a deck. */
text files_stem(const char *path);

/* The path of a file in a folder, its name and an ending: memory to free, or null. */
char *files_within(const char *folder, text name, const char *ending);

/* The path of a name in the folder of another path: memory to free, or null. */
char *files_beside(const char *path, const char *name);

/* The file that a path leads to through symbolic links, even if it does not exist yet: memory to free, or
** null. */
char *files_resolve(const char *path);

/* 1 if a file is one that will be written. */
int files_is_output(const options *o, const char *path);

/* Refuse an output file that is also an input or another output; returns the exit status. */
int files_tell_clash(const options *o);

#endif
