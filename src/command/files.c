/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.c - the files of the command line: reading them, and which are the same.
*/
#define _POSIX_C_SOURCE 200112L

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"
#include "files.h"

#define LARGEST_FILE 67108864 /* bytes */

/* Read a whole stream; null with errno set if that fails. */
static char *read_stream(FILE *file, size_t *length)
{
    size_t capacity = 65536, n = 0;
    char *contents = NULL, *more;
    int reason;

    while (capacity <= LARGEST_FILE && (more = realloc(contents, capacity)) != NULL) {
        contents = more;
        n += fread(contents + n, 1, capacity - n, file);
        if (n == capacity) {
            capacity *= 2;
            continue;
        }
        if (ferror(file))
            break;
        *length = n;
        return contents;
    }
    reason = capacity > LARGEST_FILE ? EFBIG : errno;
    free(contents);
    errno = reason;
    return NULL;
}

char *files_read_path(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    char *contents;
    int reason;

    if (!file)
        return NULL;
    contents = read_stream(file, length);
    reason = errno;
    fclose(file);
    errno = reason;
    return contents;
}

char *files_read(const char *path, size_t *length)
{
    return strcmp(path, "-") == 0 ? read_stream(stdin, length) : files_read_path(path, length);
}

int files_is_folder(const char *path)
{
    struct stat s;

    return stat(path, &s) == 0 && S_ISDIR(s.st_mode);
}

char *files_beside(const char *path, const char *name)
{
    const char *slash = strrchr(path, '/');
    size_t folder = slash && name[0] != '/' ? (size_t)(slash - path) + 1 : 0;
    char *beside = malloc(folder + strlen(name) + 1);

    if (beside) {
        memcpy(beside, path, folder);
        strcpy(beside + folder, name);
    }
    return beside;
}

char *files_resolve(const char *path)
{
    char *real = files_beside("", path), *next, target[4096];
    ssize_t n;
    int links;

    for (links = 0; real && links < 40; links++) {
        n = readlink(real, target, sizeof target - 1);
        if (n < 0)
            break;
        target[n] = '\0';
        next = files_beside(real, target);
        free(real);
        real = next;
    }
    return real;
}

static int is_same(const struct stat *x, const struct stat *y)
{
    return x->st_dev == y->st_dev && x->st_ino == y->st_ino;
}

/* 1 if an output would replace an input, which is "-" for standard input. */
static int replaces(const char *output, const char *input)
{
    struct stat out, in;

    return output && stat(output, &out) == 0 && S_ISREG(out.st_mode) &&
           (strcmp(input, "-") == 0 ? fstat(STDIN_FILENO, &in) : stat(input, &in)) == 0 &&
           is_same(&in, &out);
}

int files_is_output(const options *o, const char *path)
{
    return replaces(o->output, path) || replaces(o->plot, path) || replaces(o->plot_script, path);
}

/* 1 if an output is one of the decks, or the file of answers. */
static int is_input(const char *output, const options *o)
{
    size_t i;

    for (i = 0; i < o->n_decks; i++)
        if (replaces(output, o->decks[i]))
            return 1;
    return (o->check_file && replaces(output, o->check_file)) ||
           (o->statistics_file && replaces(output, o->statistics_file));
}

/* Find the folder of a path; returns the file's name in it, or null. */
static const char *find_folder(const char *path, struct stat *folder)
{
    const char *slash = strrchr(path, '/');
    char *name = files_beside(path, ".");
    int found = name && stat(name, folder) == 0;

    free(name);
    return !found ? NULL : slash ? slash + 1 : path;
}

/* 1 if two paths, without links at their ends, name the same file of one folder. */
static int is_same_name(const char *x, const char *y)
{
    struct stat a, b;

    x = find_folder(x, &a);
    y = find_folder(y, &b);
    return x && y && is_same(&a, &b) && strcmp(x, y) == 0;
}

/* 1 if two paths lead to the same place, even if there is no file yet. */
static int is_same_place(const char *x, const char *y)
{
    struct stat a, b;
    char *target, *other;
    int is_one;

    if (!x || !y || strcmp(x, "-") == 0 || strcmp(y, "-") == 0)
        return 0;
    if (stat(x, &a) == 0 && stat(y, &b) == 0)
        return S_ISREG(a.st_mode) && is_same(&a, &b);
    target = files_resolve(x);
    other = files_resolve(y);
    is_one = target && other && is_same_name(target, other);
    free(target);
    free(other);
    return is_one;
}

int files_tell_clash(const options *o)
{
    const char *input = is_input(o->output, o)        ? o->output
                        : is_input(o->plot, o)        ? o->plot
                        : is_input(o->plot_script, o) ? o->plot_script
                                                      : NULL;
    const char *twice = is_same_place(o->output, o->plot) || is_same_place(o->plot, o->plot_script)
                            ? o->plot
                        : is_same_place(o->output, o->plot_script) ? o->plot_script
                                                                   : NULL;

    if (input)
        return command_complain("cannot write", input, "it is also read");
    return twice ? command_complain("cannot write", twice, "two outputs have this name") : 0;
}
