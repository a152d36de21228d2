/* SPDX-License-Identifier: GPL-3.0-or-later
**
** system_posix.c - the operating system, for POSIX.1-2001.
*/
#ifndef _WIN32
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with mkstemp, realpath and SA_RESTART */
#endif

#include "system.h"

#ifndef _WIN32

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#ifndef PATH_MAX
#define PATH_MAX 4096
#endif
#define NOT_FOUND 127
#define NOT_STARTED 126

/* The temporary file that a signal must remove; null if there is none. */
static char *volatile at_work;
static volatile pid_t running; /* the program that was started; not above 0: none */
static volatile sig_atomic_t caught;
static struct sigaction old_actions[3];

/* ------------------------------------------------------------------------------------------------ begin */

static void on_end(int number)
{
    if (at_work)
        unlink(at_work);
    if (running > 0)
        kill(running, SIGKILL);
    signal(number, SIG_DFL);
    raise(number);
}

/* After a crash the memory that names the file may be wrong, so such signals are not caught. */
void system_begin(int *argc, char ***argv)
{
    static const int numbers[] = {SIGINT,  SIGTERM, SIGHUP,  SIGQUIT,   SIGPIPE, SIGALRM,
                                  SIGXFSZ, SIGXCPU, SIGUSR1, SIGVTALRM, SIGPROF, SIGUSR2};
    struct sigaction action, old;
    size_t i;

    (void)argc;
    (void)argv;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_end;
    sigemptyset(&action.sa_mask);
    for (i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        if (sigaction(numbers[i], NULL, &old) == 0 && old.sa_handler == SIG_DFL)
            sigaction(numbers[i], &action, NULL);
}

/* ------------------------------------------------------------------------------------------------ names */

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
    ssize_t n = readlink(path, target, size - 1);

    target[n < 0 ? 0 : n] = '\0';
    return n >= 0;
}

/* ------------------------------------------------------------------------------------------------ files */

system_kind system_kind_of(const char *path)
{
    struct stat s;

    if (stat(path, &s) != 0)
        return errno == ENOENT ? SYSTEM_NOTHING : SYSTEM_ERROR;
    return S_ISREG(s.st_mode) ? SYSTEM_FILE : S_ISDIR(s.st_mode) ? SYSTEM_FOLDER : SYSTEM_OTHER;
}

static int is_same(const struct stat *x, const struct stat *y)
{
    return x->st_dev == y->st_dev && x->st_ino == y->st_ino;
}

int system_is_same(const char *x, const char *y)
{
    struct stat a, b;

    return stat(x, &a) == 0 && stat(y, &b) == 0 && is_same(&a, &b);
}

int system_is_open_as(const char *path, FILE *stream)
{
    struct stat a, b;

    return stat(path, &a) == 0 && fstat(fileno(stream), &b) == 0 && is_same(&a, &b);
}

int system_list(const char *folder, int (*take)(void *host, const char *name), void *host)
{
    DIR *names = opendir(folder);
    struct dirent *entry;
    int is_wanted = 1, reason;

    if (!names)
        return 0;
    errno = 0;
    while (is_wanted && (entry = readdir(names)) != NULL) {
        is_wanted = take(host, entry->d_name);
        errno = is_wanted ? 0 : errno;
    }
    reason = errno;
    closedir(names);
    errno = reason;
    return is_wanted && reason == 0;
}

int system_may_write(const char *path)
{
    return access(path, W_OK) == 0;
}

int system_make_folder(const char *path)
{
    if (mkdir(path, 0777) == 0 || system_kind_of(path) == SYSTEM_FOLDER)
        return 1;
    errno = errno == EEXIST ? ENOTDIR : errno;
    return 0;
}

FILE *system_open(const char *path, const char *mode)
{
    return fopen(path, mode);
}

FILE *system_open_regular(const char *path)
{
    int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY);
    struct stat s;
    FILE *file;

    if (descriptor < 0)
        return NULL;
    errno = 0;
    file = fstat(descriptor, &s) == 0 && S_ISREG(s.st_mode) ? fdopen(descriptor, "rb") : NULL;
    if (!file)
        close(descriptor);
    return file;
}

int system_is_within(const char *folder, const char *path)
{
    char place[PATH_MAX + 1], file[PATH_MAX];
    int is_within = 0;

    errno = 0;
    if (realpath(folder, place)) {
        if (strcmp(place, "/") != 0)
            strcat(place, "/");
        if (realpath(path, file))
            is_within = strncmp(file, place, strlen(place)) == 0;
        else
            is_within = errno == ENOENT || errno == ENOTDIR;
    }
    if (errno != ENOMEM)
        errno = 0;
    return is_within;
}

FILE *system_scratch(void)
{
    return tmpfile();
}

/* Like mkstemp; signals are blocked until the file's name is in `at_work`. */
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

FILE *system_create(char *name, const char *like)
{
    struct stat s;
    mode_t mask = umask(0), mode = stat(like, &s) == 0 ? s.st_mode & 07777 : 0666 & ~mask;
    int descriptor, reason;
    FILE *file;

    umask(mask);
    descriptor = make_temporary(name);
    if (descriptor < 0)
        return NULL;
    fchmod(descriptor, mode);
    file = fdopen(descriptor, "w");
    if (!file) {
        reason = errno;
        close(descriptor);
        system_remove(name);
        errno = reason;
    }
    return file;
}

int system_rename(const char *name, const char *path)
{
    if (rename(name, path) != 0)
        return 0;
    at_work = NULL;
    return 1;
}

void system_remove(const char *name)
{
    remove(name);
    at_work = NULL;
}

void system_watch(char *name)
{
    at_work = name;
}

/* -------------------------------------------------------------------------------------------- terminals */

int system_is_terminal(FILE *stream)
{
    return isatty(fileno(stream));
}

unsigned long system_width(FILE *stream)
{
#ifdef TIOCGWINSZ /* not in POSIX.1-2001, but on every system that has terminals */
    struct winsize size;

    if (ioctl(fileno(stream), TIOCGWINSZ, &size) == 0)
        return size.ws_col;
#else
    (void)stream;
#endif
    return 0;
}

/* ---------------------------------------------------------------------------------------------- signals */

static void on_signal(int number)
{
    caught = number;
}

void system_catch(int begin)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action;
    int i;

    memset(&action, 0, sizeof action);
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART; /* finish the line that is being written */
    sigemptyset(&action.sa_mask);
    if (begin)
        caught = 0;
    for (i = 0; i < 3; i++)
        if (!begin)
            sigaction(signals[i], &old_actions[i], NULL);
        else if (sigaction(signals[i], NULL, &old_actions[i]) == 0 &&
                 old_actions[i].sa_handler != SIG_IGN)
            sigaction(signals[i], &action, NULL);
}

int system_caught(void)
{
    return (int)caught;
}

/* --------------------------------------------------------------------------------------------- programs */

void system_forget(const char *variable)
{
    unsetenv(variable);
}

/* Replace this process by the program, with only the three standard files open. */
static void become(const char *const *arguments, FILE *complaints)
{
    int file, reason;

    for (file = STDERR_FILENO + 1; file < 64; file++)
        if (file != fileno(complaints))
            close(file);
    fcntl(fileno(complaints), F_SETFD, FD_CLOEXEC);
    execvp(arguments[0], (char *const *)arguments);
    reason = errno;
    if (reason != ENOENT) {
        fprintf(complaints, "%s: %s\n", arguments[0], strerror(reason));
        fflush(complaints);
    }
    errno = reason;
}

/* Start the program.  Returns the pipe from its standard output, or -1. */
static int start_program(const char *const *arguments, FILE *input, FILE *complaints)
{
    int ends[2];
    sigset_t all, old;

    if (fflush(input) != 0 || lseek(fileno(input), 0, SEEK_SET) != 0 || fflush(stdout) != 0 ||
        pipe(ends) != 0)
        return -1;
    signal(SIGCHLD, SIG_DFL); /* if it is ignored, there is no status to wait for */
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &old); /* until `running` is known */
    running = fork();
    sigprocmask(SIG_SETMASK, &old, NULL);
    if (running == 0) {
        close(ends[0]);
        if (dup2(fileno(input), STDIN_FILENO) >= 0 && dup2(ends[1], STDOUT_FILENO) >= 0 &&
            dup2(fileno(complaints), STDERR_FILENO) >= 0)
            become(arguments, complaints);
        _exit(errno == ENOENT ? NOT_FOUND : NOT_STARTED);
    }
    close(ends[1]);
    if (running < 0) {
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

int system_run(const char *const *arguments, FILE *input, FILE *output, FILE *complaints,
               system_outcome *outcome)
{
    int status = 0, pipe_end = start_program(arguments, input, complaints), reason;
    pid_t ended;

    memset(outcome, 0, sizeof *outcome);
    if (pipe_end < 0)
        return 0;
    outcome->copied = copy(pipe_end, output);
    reason = errno;
    close(pipe_end);
    while ((ended = waitpid(running, &status, 0)) < 0 && errno == EINTR)
        ;
    running = 0;
    if (ended < 0)
        return 0;
    outcome->status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    /* a program that lacks a library, or a script that lacks a program, has this status too, and says so */
    outcome->is_found = outcome->status != NOT_FOUND || lseek(fileno(complaints), 0, SEEK_END) > 0;
    errno = reason;
    return outcome->copied >= 0;
}

#endif
