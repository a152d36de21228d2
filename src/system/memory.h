/* SPDX-License-Identifier: GPL-3.0-or-later
**
** memory.h - the memory of the command, and whether there was enough.
**
** That memory failed must never look like "there is nothing here".  So it is noted where it happens, here,
** and does not depend on what the caller makes of a null pointer or a status: no output file is replaced
** after it (command/output.c), and the exit status is that of a failure (command_end).  The command has all
** its memory from here, and calls the functions of fourlink.h that need some by way of view/results.h
** (tests/includes.sh).
*/
#ifndef FOURLINK_MEMORY_H
#define FOURLINK_MEMORY_H

#include <stddef.h>

/* Memory for n things of a size, set to 0; with memory_grow a list of them, whose new end is not set.
** Null if there is not enough; the list then stays as it was. */
void *memory_get(size_t n, size_t size);
void *memory_grow(void *list, size_t n, size_t size);

/* A copy of a string; null if there is not enough. */
char *memory_copy(const char *string);

/* Note that memory has failed elsewhere: in the C library, in another library. */
void memory_note_failure(void);

/* The same if this errno says so. */
void memory_note_reason(int reason);

/* 1: memory has failed since the start. */
int memory_has_failed(void);

/* For a program that goes on with something else. */
void memory_forget_failure(void);

#endif
