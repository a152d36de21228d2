/* SPDX-License-Identifier: GPL-3.0-or-later
**
** files.c - reading whole files.
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
    char *contents = malloc(capacity), *more;

    while (contents) {
        n += fread(contents + n, 1, capacity - n, file);
        if (n < capacity)
            break;
        if (capacity >= LARGEST_FILE) {
            free(contents);
            errno = EFBIG;
            return NULL;
        }
        more = realloc(contents, 2 * capacity);
        if (!more)
            free(contents);
        contents = more;
        capacity *= 2;
    }
    if (contents && ferror(file)) {
        int reason = errno;

        free(contents);
        contents = NULL;
        errno = reason;
    }
    *length = n;
    return contents;
}

char *files_read_path(const char *path, size_t *length)
{
    FILE *file;
    char *contents;
    int reason;

    file = fopen(path, "rb");
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
