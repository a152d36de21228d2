/* SPDX-License-Identifier: GPL-3.0-or-later
**
** output.c - a file for results, of which nothing is seen until all of it is there.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with realpath and mkstemp */

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "output.h"

static char *join(const char *x, const char *y)
{
    char *both = malloc(strlen(x) + strlen(y) + 1);

    if (both) {
        strcpy(both, x);
        strcat(both, y);
    }
    return both;
}

/* The file that a path leads to, through symbolic links; the path itself if there is none yet. */
static char *resolve(const char *path)
{
    char *real = realpath(path, NULL);

    return real ? real : join(path, "");
}

/* A regular file, or one that is not there yet: its new contents are written beside it. */
static int open_beside(output *o, int exists, mode_t mode)
{
    mode_t mask = umask(0);
    int descriptor;

    umask(mask);
    o->temporary = join(o->path, ".XXXXXX");
    if (!o->temporary)
        return 0;
    descriptor = mkstemp(o->temporary);
    if (descriptor < 0) {
        free(o->temporary);
        o->temporary = NULL;
        return 0;
    }
    fchmod(descriptor, exists ? mode & 07777 : 0666 & ~mask);
    o->file = fdopen(descriptor, "w");
    return o->file != NULL;
}

int output_open(output *o, const char *path)
{
    struct stat status;
    int exists;

    memset(o, 0, sizeof *o);
    if (!path) {
        o->file = stdout;
        return 1;
    }
    o->path = resolve(path);
    if (!o->path)
        return 0;
    exists = stat(o->path, &status) == 0;
    if (!exists && errno != ENOENT)
        return 0;
    if (exists && S_ISDIR(status.st_mode)) {
        errno = EISDIR;
        return 0;
    }
    if (exists && access(o->path, W_OK) != 0)
        return 0;
    if (!exists || S_ISREG(status.st_mode))
        return open_beside(o, exists, exists ? status.st_mode : 0);
    o->file = fopen(o->path, "w");
    return o->file != NULL;
}

static void forget(output *o)
{
    free(o->temporary);
    free(o->path);
    memset(o, 0, sizeof *o);
}

int output_close(output *o)
{
    int failed = ferror(o->file) != 0, reason;

    errno = failed ? EIO : 0;
    if (fflush(o->file) != 0)
        failed = 1;
    reason = errno;
    if (o->path && fclose(o->file) != 0 && !failed) {
        failed = 1;
        reason = errno;
    }
    if (o->temporary) {
        if (!failed && rename(o->temporary, o->path) != 0) {
            failed = 1;
            reason = errno;
        }
        if (failed)
            remove(o->temporary);
    }
    forget(o);
    errno = reason;
    return !failed;
}

void output_discard(output *o)
{
    if (o->path && o->file)
        fclose(o->file);
    if (o->temporary)
        remove(o->temporary);
    forget(o);
}
