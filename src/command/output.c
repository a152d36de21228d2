/* SPDX-License-Identifier: GPL-3.0-or-later
**
** output.c - an output file, replaced only when complete.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with mkstemp */

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"
#include "files.h"
#include "output.h"
#include "pictures/gnuplot.h"

/* Bytes.  With millions of rows, a system call for each 4 kB costs time. */
#define BUFFER 65536

/* The temporary file that a signal must remove; null if there is none. */
static char *volatile at_work;

static void on_signal(int number)
{
    if (at_work)
        unlink(at_work);
    gnuplot_stop();
    signal(number, SIG_DFL);
    raise(number);
}

/* Leave nothing behind if a signal ends the program.  After a crash the memory that names the file may be wrong. */
static void watch_signals(void)
{
    static const int numbers[] = {SIGINT,  SIGTERM, SIGHUP,  SIGQUIT,   SIGPIPE, SIGALRM,
                                  SIGXFSZ, SIGXCPU, SIGUSR1, SIGVTALRM, SIGPROF, SIGUSR2};
    struct sigaction action, old;
    size_t i;

    memset(&action, 0, sizeof action);
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    for (i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        if (sigaction(numbers[i], NULL, &old) == 0 && old.sa_handler == SIG_DFL)
            sigaction(numbers[i], &action, NULL);
}

/* As mkstemp; no signal comes between the file and its name in `at_work`. */
static int make_temporary(char *name)
{
    sigset_t all, old;
    int descriptor;

    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &old);
    descriptor = mkstemp(name);
    if (descriptor >= 0)
        at_work = name;
    sigprocmask(SIG_SETMASK, &old, NULL);
    return descriptor;
}

/* Open a temporary file beside a regular file, or beside one that does not exist yet. */
static FILE *open_beside(output *o, int exists, mode_t mode)
{
    mode_t mask = umask(0);
    int descriptor;

    umask(mask);
    o->temporary = files_beside(o->path, ".fourlinkXXXXXX"); /* whatever the length of the name */
    descriptor = o->temporary ? make_temporary(o->temporary) : -1;
    if (descriptor < 0) {
        free(o->temporary);
        o->temporary = NULL;
        return NULL;
    }
    fchmod(descriptor, exists ? mode & 07777 : 0666 & ~mask);
    return fdopen(descriptor, "w");
}

void output_prepare(void)
{
    watch_signals();
    if (!isatty(STDOUT_FILENO))
        setvbuf(stdout, NULL, _IOFBF, BUFFER);
}

/* 1; 0 with errno set. */
static int open_output(output *o, const char *path)
{
    struct stat status, standard;
    int exists, is_regular;

    memset(o, 0, sizeof *o);
    if (!path) {
        o->file = stdout;
        return 1;
    }
    exists = stat(path, &status) == 0;
    if (!exists && errno != ENOENT)
        return 0;
    if (exists && fstat(STDOUT_FILENO, &standard) == 0 && standard.st_dev == status.st_dev &&
        standard.st_ino == status.st_ino) {
        o->file = stdout; /* as for /dev/stdout: other programs may write to it too */
        return 1;
    }
    if (exists && S_ISDIR(status.st_mode)) {
        errno = EISDIR;
        return 0;
    }
    if (exists && access(path, W_OK) != 0)
        return 0;
    is_regular = !exists || S_ISREG(status.st_mode);
    o->path = is_regular ? files_resolve(path) : files_beside("", path);
    if (!o->path)
        return 0;
    o->file = is_regular ? open_beside(o, exists, status.st_mode) : fopen(path, "w");
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

    if (keep && (fflush(o->file) != 0 || ferror(o->file)))
        reason = reason_of(o->file);
    if (o->path && o->file && fclose(o->file) != 0 && keep && !reason)
        reason = errno;
    if (o->temporary && keep && !reason && rename(o->temporary, o->path) != 0)
        reason = errno;
    if (o->temporary && (!keep || reason))
        remove(o->temporary);
    at_work = NULL;
    free(o->temporary);
    free(o->path);
    memset(o, 0, sizeof *o);
    return reason
               ? command_complain("cannot write", path ? path : "standard output", strerror(reason))
               : 0;
}
