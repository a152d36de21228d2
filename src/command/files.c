/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.c - paths, and whole files.
*/
#define _POSIX_C_SOURCE 200112L

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"

#define LARGEST_FILE 67108864 /* bytes */

/* All of a stream; null with errno set if it cannot be read. */
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
