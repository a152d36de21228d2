/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.h - paths, and whole files.
*/
#ifndef FOURLINK_FILES_H
#define FOURLINK_FILES_H

#include <stddef.h>

/* All of a file, of files_read also standard input for "-": memory to be freed, or null with errno set;
** EFBIG if it is of more than 64 MB. */
char *files_read(const char *path, size_t *length);
char *files_read_path(const char *path, size_t *length);

/* A name as seen from the folder that a path is in: memory to be freed, or null. */
char *files_beside(const char *path, const char *name);

#endif
