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
#include "svg.h"

#define NOT_FOUND 127
#define NOT_STARTED 126
#define PART 8192 /* bytes; an SVG has its title and description in the first of them */

static volatile pid_t running; /* not above 0: none */

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
static void become_gnuplot(FILE *script, int output, FILE *complaints)
{
    if (dup2(fileno(script), STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
        dup2(fileno(complaints), STDERR_FILENO) >= 0)
        run(complaints);
    _exit(errno == ENOENT ? NOT_FOUND : NOT_STARTED);
}

/* Start gnuplot; returns the pipe that the picture comes from, or -1. */
static int start(FILE *script, FILE *complaints, pid_t *child)
{
    int ends[2];
    sigset_t all, old;

    if (fflush(script) != 0 || lseek(fileno(script), 0, SEEK_SET) != 0 || fflush(stdout) != 0 ||
        pipe(ends) != 0)
        return -1;
    signal(SIGCHLD, SIG_DFL); /* otherwise there is no status to wait for */
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &old); /* none comes before `running` is known */
    running = *child = fork();
    sigprocmask(SIG_SETMASK, &old, NULL);
    if (*child == 0) {
        close(ends[0]);
        become_gnuplot(script, ends[1], complaints);
    }
    close(ends[1]);
    if (*child < 0) {
        close(ends[0]);
        return -1;
    }
    return ends[0];
}

/* Read until `part` is full or the stream ends; returns the number of bytes. */
static size_t fill(int from, char part[PART])
{
    size_t n = 0;
    ssize_t more;

    while (n < PART &&
           ((more = read(from, part + n, PART - n)) > 0 || (more < 0 && errno == EINTR)))
        n += more > 0 ? (size_t)more : 0;
    return n;
}

/* Copy a picture, an SVG with this caption; returns the number of bytes, or -1 with errno set if they cannot be
** written. */
static long copy(int from, FILE *to, const plot_caption *caption)
{
    long copied = 0;
    char part[PART];
    size_t n;

    while ((n = fill(from, part)) > 0) {
        if (caption && !copied)
            svg_put_head(to, part, n, caption);
        else
            fwrite(part, 1, n, to);
        if (ferror(to))
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

static const char *draw(FILE *script, FILE *out, const plot_caption *caption, FILE *complaints)
{
    pid_t child, ended;
    int status = 0, pipe_end = start(script, complaints, &child), reason;
    long copied;

    if (pipe_end < 0)
        return strerror(errno);
    copied = copy(pipe_end, out, caption);
    reason = errno;
    close(pipe_end);
    while ((ended = waitpid(child, &status, 0)) < 0 && errno == EINTR)
        ;
    running = 0;
    if (ended < 0 || copied < 0)
        return strerror(copied < 0 ? reason : errno);
    return outcome(status, copied, complaints);
}

const char *gnuplot_run(FILE *script, FILE *out, const plot_caption *caption)
{
    FILE *complaints = tmpfile();
    const char *why = complaints ? draw(script, out, caption, complaints) : strerror(errno);

    if (complaints)
        fclose(complaints);
    return why;
}

void gnuplot_stop(void)
{
    if (running > 0)
        kill(running, SIGKILL);
}
