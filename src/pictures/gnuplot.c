/* SPDX-License-Identifier: GPL-3.0-or-later
**
** gnuplot.c - runs gnuplot without a shell.  The script is its standard input and the picture its standard
** output, so that it never reads a file name.  gnuplot does not check whether it can write, so the picture is
** copied here.
*/
#define _POSIX_C_SOURCE 200112L

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include "gnuplot.h"

#define NOT_FOUND 127
#define NOT_STARTED 126

static volatile pid_t running; /* 0: none */

/* Run gnuplot with only the three standard files open. */
static void run(FILE *complaints)
{
    int file, reason;

    for (file = STDERR_FILENO + 1; file < 64; file++)
        if (file != fileno(complaints))
            close(file);
    fcntl(fileno(complaints), F_SETFD, FD_CLOEXEC);
    execlp("gnuplot", "gnuplot", "--default-settings", "-", (char *)NULL);
    reason = errno;
    fprintf(complaints, "fourlink: gnuplot: %s\n", strerror(reason));
    fflush(complaints);
    errno = reason;
}

/* Become gnuplot, in the child; never returns. */
static void become_gnuplot(FILE *script, int picture, FILE *complaints)
{
    if (dup2(fileno(script), STDIN_FILENO) >= 0 && dup2(picture, STDOUT_FILENO) >= 0 &&
        dup2(fileno(complaints), STDERR_FILENO) >= 0)
        run(complaints);
    _exit(errno == ENOENT ? NOT_FOUND : NOT_STARTED);
}

/* Start gnuplot; returns the pipe that the picture comes from, or -1. */
static int start(FILE *script, FILE *complaints, pid_t *child)
{
    int ends[2];

    if (fflush(script) != 0 || lseek(fileno(script), 0, SEEK_SET) != 0 || fflush(stdout) != 0 ||
        pipe(ends) != 0)
        return -1;
    signal(SIGCHLD, SIG_DFL); /* otherwise there is no status to wait for */
    *child = fork();
    if (*child == 0) {
        close(ends[0]);
        become_gnuplot(script, ends[1], complaints);
    }
    running = *child;
    close(ends[1]);
    if (*child < 0) {
        close(ends[0]);
        return -1;
    }
    return ends[0];
}

/* Copy a stream; returns the number of bytes, or -1 with errno set if they cannot be written. */
static long copy(int from, FILE *to)
{
    long copied = 0;
    char part[8192];
    ssize_t n;

    while ((n = read(from, part, sizeof part)) > 0 || (n < 0 && errno == EINTR))
        if (n > 0) {
            if (fwrite(part, 1, (size_t)n, to) != (size_t)n)
                return -1;
            copied += (long)n;
        }
    return copied;
}

static void show(FILE *complaints)
{
    int c;

    rewind(complaints);
    while ((c = getc(complaints)) != EOF)
        putc(c, stderr);
}

/* Null, or the reason why there is no picture. */
static const char *outcome(int status, long copied, FILE *complaints)
{
    if (WIFEXITED(status) && WEXITSTATUS(status) == NOT_FOUND)
        return "gnuplot is not installed; its package is gnuplot-nox (Debian, Ubuntu) or gnuplot; "
               "--plot-script writes its script";
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        show(complaints);
    else if (copied > 0)
        return NULL;
    return "gnuplot failed";
}

static const char *draw(FILE *script, FILE *picture, FILE *complaints)
{
    pid_t child, ended;
    int status = 0, pipe_end = start(script, complaints, &child), reason;
    long copied;

    if (pipe_end < 0)
        return strerror(errno);
    copied = copy(pipe_end, picture);
    reason = errno;
    close(pipe_end);
    while ((ended = waitpid(child, &status, 0)) < 0 && errno == EINTR)
        ;
    running = 0;
    if (ended < 0 || copied < 0)
        return strerror(copied < 0 ? reason : errno);
    return outcome(status, copied, complaints);
}

const char *gnuplot_run(FILE *script, FILE *picture)
{
    FILE *complaints = tmpfile();
    const char *why = complaints ? draw(script, picture, complaints) : strerror(errno);

    if (complaints)
        fclose(complaints);
    return why;
}

void gnuplot_stop(void)
{
    if (running > 0)
        kill(running, SIGKILL);
}
