/* SPDX-License-Identifier: GPL-3.0-or-later
**
** output.c - an output file, replaced only when complete.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "files.h"
#include "output.h"

/* Bytes.  With millions of rows, a system call for each 4 kB costs time. */
#define BUFFER 65536

/* Open a temporary file beside a regular file, or beside one that does not exist yet. */
static FILE *open_beside(output *o)
{
    FILE *file;

    o->temporary = files_beside(o->path, ".fourlinkXXXXXX"); /* whatever the length of the name */
    file = o->temporary ? system_create(o->temporary, o->path) : NULL;
    if (!file) {
        free(o->temporary);
        o->temporary = NULL;
    }
    return file;
}

void output_prepare(void)
{
    if (!system_is_terminal(stdout))
        setvbuf(stdout, NULL, _IOFBF, BUFFER);
}

/* 1; 0 with errno set. */
static int open_output(output *o, const char *path)
{
    system_kind kind;
    int is_regular;

    memset(o, 0, sizeof *o);
    if (!path) {
        o->file = stdout;
        return 1;
    }
    kind = system_kind_of(path);
    if (kind == SYSTEM_ERROR)
        return 0;
    if (system_is_open_as(path, stdout)) {
        o->file = stdout; /* as for /dev/stdout: other programs may write to it too */
        return 1;
    }
    if (kind == SYSTEM_FOLDER) {
        errno = EISDIR;
        return 0;
    }
    if (kind != SYSTEM_NOTHING && !system_may_write(path))
        return 0;
    is_regular = kind == SYSTEM_NOTHING || kind == SYSTEM_FILE;
    o->path = is_regular ? files_resolve(path) : files_beside("", path);
    if (!o->path)
        return 0;
    o->file = is_regular ? open_beside(o) : system_open(path, "wb");
    if (o->file)
        setvbuf(o->file, NULL, _IOFBF, BUFFER);
    return o->file != NULL;
}

/* The errno of a failed stream, found by writing one more byte. */
static int reason_of(FILE *file)
{
    errno = EIO;
    clearerr(file);
    putc('\n', file);
    fflush(file);
    return errno;
}

int output_begin(output *o, const char *path)
{
    int status = 0;

    if (!open_output(o, path && strcmp(path, "-") == 0 ? NULL : path)) {
        status = command_complain("cannot write", path ? path : "standard output", strerror(errno));
        output_end(o, path, 0);
    }
    return status;
}

int output_end(output *o, const char *path, int keep)
{
    int reason = 0;

    keep = keep && !memory_has_failed();
    if (keep && (fflush(o->file) != 0 || ferror(o->file)))
        reason = reason_of(o->file);
    if (o->path && o->file && fclose(o->file) != 0 && keep && !reason)
        reason = errno;
    if (o->temporary && keep && !reason && !system_rename(o->temporary, o->path))
        reason = errno;
    if (o->temporary && (!keep || reason))
        system_remove(o->temporary);
    free(o->temporary);
    free(o->path);
    memset(o, 0, sizeof *o);
    return reason
               ? command_complain("cannot write", path ? path : "standard output", strerror(reason))
               : 0;
}
