/* SPDX-License-Identifier: GPL-3.0-or-later
**
** system.h - what the command needs from the operating system: files, terminals, signals, programs.  Only
** system_posix.c and system_windows.c depend on the system; one of them is empty.  The library uses none of
** this.
**
** Paths are as the user typed them; on Windows they are UTF-8, and \ and the colon after a drive also
** separate names.  Functions that fail set errno.
*/
#ifndef FOURLINK_SYSTEM_H
#define FOURLINK_SYSTEM_H

#include <stdio.h>

/* Call this first: it may replace the arguments, and makes the standard streams binary.  From then on, a
** signal that ends the program also removes its temporary file and ends the program it has started. */
void system_begin(int *argc, char ***argv);

/* ---- names */

/* 1 if a character separates the names of a path. */
int system_is_separator(char c);

/* 1 if a path does not depend on the working folder. */
int system_is_absolute(const char *path);

/* The target of a symbolic link, cut to `size`; 0 if the path is not one. */
int system_read_link(const char *path, char *target, size_t size);

/* ---- files */

typedef enum system_kind {
    SYSTEM_NOTHING, /* no such file */
    SYSTEM_FILE,
    SYSTEM_FOLDER,
    SYSTEM_OTHER, /* a device or a pipe */
    SYSTEM_ERROR  /* it cannot be determined */
} system_kind;

system_kind system_kind_of(const char *path);

/* 1 if both paths lead to the same existing file or folder; 1 if a path leads to the file that a stream has
** open. */
int system_is_same(const char *x, const char *y);
int system_is_open_as(const char *path, FILE *stream);

/* Give each name in a folder to a function, in any order, as long as it returns 1.  Returns 1; 0 with errno
** set. */
int system_list(const char *folder, int (*take)(void *host, const char *name), void *host);

int system_may_write(const char *path);

/* Make a folder, in one that is there; 1 also if it is there.  0 with errno set. */
int system_make_folder(const char *path);

FILE *system_open(const char *path, const char *mode);

/* The same for reading, without waiting for another program; null with errno 0 if it is not a regular
** file. */
FILE *system_open_regular(const char *path);

/* 1 if a file, after symbolic links, is in a folder or below it, or does not exist.  Otherwise 0; errno is
** then ENOMEM if out of memory, else 0. */
int system_is_within(const char *folder, const char *path);

/* A temporary file without a name, for reading and writing. */
FILE *system_scratch(void);

/* Create a file with a unique name: the last six characters of `name`, XXXXXX, are replaced.  It gets the
** permissions of the file `like`, or those of a new file.  A signal removes it until one of the functions
** below has been called. */
FILE *system_create(char *name, const char *like);
int system_rename(const char *name, const char *path); /* 1; 0 with errno set */
void system_remove(const char *name);

/* Let a signal remove this file too, until it is renamed or removed; `name` stays where it is until then. */
void system_watch(char *name);

/* ---- terminals */

int system_is_terminal(FILE *stream);
unsigned long system_width(FILE *stream); /* of a terminal; 0: unknown */

/* ---- signals */

/* Catch the signals that end a program, or restore the old actions. */
void system_catch(int begin);

/* The signal caught since then; 0: none. */
int system_caught(void);

/* ---- programs */

typedef struct system_outcome {
    int is_found; /* 0: there is no such program */
    int status;   /* exit status; -1: ended by a signal */
    long copied;  /* bytes of its output */
} system_outcome;

/* Take a variable out of the environment, also that of programs. */
void system_forget(const char *variable);

/* Run a program from PATH without a shell; `arguments` begin with its name and end with null.  It reads
** `input` from its beginning; its standard output is copied to `output`.  Returns 1, or 0 with errno set. */
int system_run(const char *const *arguments, FILE *input, FILE *output, FILE *complaints,
               system_outcome *outcome);

#endif
