/* SPDX-License-Identifier: GPL-3.0-or-later
**
** system.c - the operating system of the page: the deck is a file, those that the command writes are kept for
** the page; no folders, terminals, signals or programs.  See src/system/system.h.
*/
#define _POSIX_C_SOURCE 200809L /* fmemopen, open_memstream */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "system.h"
#include "system/system.h"

#define MOST_FILES 8
#define SCRATCH 33554432 /* bytes of the file without a name */

static web_file deck, written[MOST_FILES];
static int n_written;

void web_system_put(const char *name, char *text, size_t length)
{
    deck.name = name;
    deck.text = text;
    deck.length = length;
}

const web_file *web_system_written(int k)
{
    return k < n_written ? &written[k] : NULL;
}

/* Nothing can be done, for want of a system. */
static int refuse(void)
{
    errno = ENOTSUP;
    return 0;
}

void system_begin(int *argc, char ***argv)
{
    (void)argc;
    (void)argv;
}

/* ------------------------------------------------------------------------------------------------- names */

int system_is_separator(char c)
{
    return c == '/';
}

int system_is_absolute(const char *path)
{
    return path[0] == '/';
}

int system_read_link(const char *path, char *target, size_t size)
{
    (void)path;
    (void)size;
    *target = '\0';
    return 0;
}

/* ------------------------------------------------------------------------------------------------- files */

/* The file of this name, or null. */
static web_file *find(const char *name)
{
    int k;

    if (deck.name && strcmp(name, deck.name) == 0)
        return &deck;
    for (k = 0; k < n_written && strcmp(written[k].name, name) != 0; k++)
        ;
    return k < n_written ? &written[k] : NULL;
}

system_kind system_kind_of(const char *path)
{
    return find(path) ? SYSTEM_FILE : SYSTEM_NOTHING;
}

int system_is_same(const char *x, const char *y)
{
    return find(x) && strcmp(x, y) == 0;
}

int system_is_open_as(const char *path, FILE *stream)
{
    (void)path;
    (void)stream;
    return 0;
}

int system_list(const char *folder, int (*take)(void *host, const char *name), void *host)
{
    (void)folder;
    (void)take;
    (void)host;
    return refuse();
}

/* Any file can be written; there are no folders to be made. */
int system_make_folder(const char *path)
{
    (void)path;
    return 1;
}

int system_may_write(const char *path)
{
    (void)path;
    return 1;
}

FILE *system_open(const char *path, const char *mode)
{
    web_file *file = find(path);

    if (file && mode[0] == 'r')
        return fmemopen(file->text, file->length, "r");
    errno = file ? ENOTSUP : ENOENT;
    return NULL;
}

FILE *system_open_regular(const char *path)
{
    return system_open(path, "r");
}

int system_is_within(const char *folder, const char *path)
{
    (void)folder;
    (void)path;
    return 1;
}

FILE *system_scratch(void)
{
    return fmemopen(NULL, SCRATCH, "w+");
}

static char *copy_of(const char *name)
{
    char *copy = malloc(strlen(name) + 1);

    return copy ? strcpy(copy, name) : NULL;
}

FILE *system_create(char *name, const char *like)
{
    web_file *file = &written[n_written];

    (void)like;
    if (n_written == MOST_FILES) {
        errno = ENFILE;
        return NULL;
    }
    name[strlen(name) - 1] = (char)('0' + n_written);
    file->name = copy_of(name);
    if (!file->name)
        return NULL;
    n_written++;
    return open_memstream(&file->text, &file->length);
}

int system_rename(const char *name, const char *path)
{
    web_file *file = find(name);
    char *copy = file ? copy_of(path) : NULL;

    if (!copy)
        return refuse();
    free((char *)file->name);
    file->name = copy;
    return 1;
}

void system_remove(const char *name)
{
    web_file *file = find(name);

    if (file)
        file->length = 0;
}

void system_watch(char *name)
{
    (void)name;
}

/* ------------------------------------------------------------------------ terminals, signals, programs */

int system_is_terminal(FILE *stream)
{
    (void)stream;
    return 0;
}

unsigned long system_width(FILE *stream)
{
    (void)stream;
    return 0;
}

void system_catch(int begin)
{
    (void)begin;
}

int system_caught(void)
{
    return 0;
}

void system_forget(const char *variable)
{
    (void)variable;
}

int system_run(const char *const *arguments, FILE *input, FILE *output, FILE *complaints,
               system_outcome *outcome)
{
    (void)arguments;
    (void)input;
    (void)output;
    (void)complaints;
    memset(outcome, 0, sizeof *outcome);
    return 1;
}
