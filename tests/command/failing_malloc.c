/* SPDX-License-Identifier: GPL-3.0-or-later
**
** failing_malloc.c - memory that runs out, for failed_allocations.sh.
**
** FAIL_AT=N      allocation number N of the program fails; with FAIL_ON=1 all after it too
** TRIALS=FOLDER  each EVERY-th allocation fails in a copy of the process, which goes on to its end and is judged; the
**                process itself goes on as usual.  So a trial costs no more than what is left of the run.  With WHOLE=1
**                each copy runs from the start: for a program that waits for another.
**
** FOLDER/run is where the program works, with its standard output and error in the files out and err; FOLDER/old was the
** same before it, FOLDER/usual after a run in which nothing failed with the exit status USUAL.  A copy works in
** FOLDER/N.  It is right if all became as usual.  It is right, too, if it was refused: exit status 3, a message, each
** file old, complete or still missing, no other file; and what was printed are
** lines that are usually printed.  FOLDER/report has what became of them.
**
** Loaded before the C library with LD_PRELOAD, or, as a sanitizer has its own malloc, linked into the program
** with -DWRAPPED and --wrap.
*/
#define _GNU_SOURCE /* RTLD_NEXT, O_TMPFILE */

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

void *__real_malloc(size_t size);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *old, size_t size);

#ifdef WRAPPED
#define NAME(function) __wrap_##function
#define REAL(function) __real_##function

static void find_real(void)
{
}
#else
#define NAME(function) function
#define REAL(function) real_##function

static void *(*real_malloc)(size_t size);
static void *(*real_calloc)(size_t n, size_t size);
static void *(*real_realloc)(void *old, size_t size);

static void find_real(void)
{
    *(void **)&real_malloc = dlsym(RTLD_NEXT, "malloc");
    *(void **)&real_calloc = dlsym(RTLD_NEXT, "calloc");
    *(void **)&real_realloc = dlsym(RTLD_NEXT, "realloc");
}
#endif

void *NAME(malloc)(size_t size);
void *NAME(calloc)(size_t n, size_t size);
void *NAME(realloc)(void *old, size_t size);

#define MOST_FILES 64
#define MOST_AT_ONCE 64
#define MOST_TOLD 20
#define SECONDS 60 /* of a trial */
#define REFUSED 3  /* its exit status */

typedef struct contents {
    char name[NAME_MAX + 1];
    char *bytes;
    size_t length;
} contents;

typedef struct folder {
    contents files[MOST_FILES];
    int n;
} folder;

/* A copy of the process. */
typedef struct trial {
    pid_t process; /* 0: this place is free */
    unsigned long at;
} trial;

static unsigned long count, fail_at, every, at_once;
static int is_on, fails_on, usual_status;
static pid_t owner;
static const char *trials;
static folder old, usual;
static trial running[MOST_AT_ONCE];
static int *reached; /* shared: the copy came to its allocation */
static unsigned long n_tried, n_refused, n_wrong;
static int report = -1;

static unsigned long number_of(const char *name)
{
    const char *value = getenv(name);

    return value ? strtoul(value, NULL, 10) : 0;
}

/* -------------------------------------------------------------------------------------------------- files */

__attribute__((noreturn)) static void give_up(const char *what, const char *name)
{
    dprintf(STDERR_FILENO, "failing_malloc: %s %s: %s\n", what, name, strerror(errno));
    dprintf(report, "FAILED: failing_malloc: %s %s: %s\n", what, name, strerror(errno));
    _exit(99);
}

static const char *path_of(const char *place, const char *name)
{
    static char path[2][PATH_MAX];
    static int i;

    i = !i;
    snprintf(path[i], sizeof path[i], "%s/%s%s%s", trials, place, name ? "/" : "",
             name ? name : "");
    return path[i];
}

/* All that is in a file, with a zero behind. */
static char *read_all(const char *path, size_t *length)
{
    int file = open(path, O_RDONLY | O_CLOEXEC);
    struct stat s;
    char *bytes;
    ssize_t n;

    if (file < 0 || fstat(file, &s) != 0)
        give_up("cannot read", path);
    bytes = REAL(malloc)((size_t)s.st_size + 1);
    for (*length = 0; (n = read(file, bytes + *length, (size_t)s.st_size - *length)) > 0;
         *length += (size_t)n)
        ;
    bytes[*length] = '\0';
    close(file);
    return bytes;
}

static int is_name(const char *name)
{
    return strcmp(name, ".") != 0 && strcmp(name, "..") != 0;
}

/* Read a folder; none if there is none. */
static void read_folder(folder *f, const char *place)
{
    DIR *names = opendir(path_of(place, NULL));
    struct dirent *entry;

    f->n = 0;
    while (names && (entry = readdir(names)) != NULL)
        if (is_name(entry->d_name) &&
            access(path_of(place, entry->d_name), F_OK) == 0) { /* no link to nothing */
            if (f->n == MOST_FILES)
                give_up("too many files in", place);
            strcpy(f->files[f->n].name, entry->d_name);
            f->files[f->n].bytes = read_all(path_of(place, entry->d_name), &f->files[f->n].length);
            f->n++;
        }
    if (names)
        closedir(names);
}

static void free_folder(folder *f)
{
    while (f->n)
        free(f->files[--f->n].bytes);
}

static const contents *find(const folder *f, const char *name)
{
    int i;

    for (i = 0; i < f->n; i++)
        if (strcmp(f->files[i].name, name) == 0)
            return &f->files[i];
    return NULL;
}

static void copy_to(int from, int to, const char *name)
{
    char part[65536];
    ssize_t n;
    off_t at = 0;

    while ((n = pread(from, part, sizeof part, at)) > 0) {
        if (write(to, part, (size_t)n) != n)
            give_up("cannot write", name);
        at += n;
    }
    if (n < 0)
        give_up("cannot read", name);
}

/* Make FOLDER/PLACE a copy of FOLDER/run. */
static void copy_run(const char *place)
{
    char target[PATH_MAX];
    DIR *names;
    struct dirent *entry;

    mkdir(path_of(place, NULL), 0777);
    names = opendir(path_of(place, NULL));
    while (names && (entry = readdir(names)) != NULL)
        if (is_name(entry->d_name))
            unlink(path_of(place, entry->d_name));
    if (!names)
        give_up("cannot read", place);
    closedir(names);
    names = opendir(path_of("run", NULL));
    while (names && (entry = readdir(names)) != NULL)
        if (is_name(entry->d_name)) {
            int from, to;
            ssize_t n = readlink(path_of("run", entry->d_name), target, sizeof target - 1);

            if (n > 0) {
                target[n] = '\0';
                if (symlink(target, path_of(place, entry->d_name)) != 0)
                    give_up("cannot link", entry->d_name);
                continue;
            }
            from = open(path_of("run", entry->d_name), O_RDONLY | O_CLOEXEC);
            to = open(path_of(place, entry->d_name), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);

            if (from < 0 || to < 0)
                give_up("cannot copy", entry->d_name);
            copy_to(from, to, entry->d_name);
            close(from);
            close(to);
        }
    if (!names)
        give_up("cannot read", "run");
    closedir(names);
}

/* Open each file of this process again, at the same place: in FOLDER/PLACE where it is in FOLDER/run, a copy where it
** has no name any more.  So the copies of a process do not move each other's places. */
static void open_again(const char *place)
{
    char link[40], path[PATH_MAX], run[PATH_MAX];
    int file, again, flags;
    struct stat s;
    size_t length;
    ssize_t n;
    off_t at;

    if (!realpath(path_of("run", NULL), run))
        give_up("no folder", "run");
    length = strlen(run);
    for (file = 0; file < 64; file++) {
        if (fstat(file, &s) != 0 || !(S_ISREG(s.st_mode) || S_ISDIR(s.st_mode)))
            continue;
        snprintf(link, sizeof link, "/proc/self/fd/%d", file);
        n = readlink(link, path, sizeof path - 1);
        flags = fcntl(file, F_GETFL);
        at = lseek(file, 0, SEEK_CUR);
        if (n < 0 || flags < 0 || at < 0)
            give_up("cannot find", link);
        path[n] = '\0';
        if (s.st_nlink == 0) {
            again = open(trials, O_RDWR | O_TMPFILE, 0600);
            copy_to(file, again, path);
        } else if (strncmp(path, run, length) == 0 && path[length] == '/')
            again = open(path_of(place, path + length + 1), flags & ~(O_CREAT | O_EXCL | O_TRUNC));
        else
            again = open(path, flags & ~(O_CREAT | O_EXCL | O_TRUNC));
        if (again < 0 || lseek(again, at, SEEK_SET) != at || dup2(again, file) < 0)
            give_up("cannot open again", path);
        close(again);
    }
}

/* ------------------------------------------------------------------------------------------------ judging */

static int is_same(const contents *x, const contents *y)
{
    return x && y && x->length == y->length && memcmp(x->bytes, y->bytes, x->length) == 0;
}

static int is_printed(const char *name)
{
    return strcmp(name, "out") == 0 || strcmp(name, "err") == 0;
}

/* 1 if there is a message that memory failed: in our words or in those of the system. */
static int has_message(const contents *c)
{
    const char *line = c ? c->bytes : NULL, *end;

    for (; line && (end = strchr(line, '\n')) != NULL; line = end + 1)
        if (strncmp(line, "fourlink: ", 10) == 0 &&
            (memmem(line, (size_t)(end - line), ": not enough memory", 19) ||
             memmem(line, (size_t)(end - line), strerror(ENOMEM), strlen(strerror(ENOMEM)))))
            return 1;
    return 0;
}

/* The first whole line that is not, in this order, among those usually printed; null if there is none. */
static const char *new_line(const contents *c, const contents *as)
{
    const char *line = c->bytes, *from = as->bytes, *end, *other;

    for (; (end = strchr(line, '\n')) != NULL; line = end + 1) {
        size_t n = (size_t)(end - line) + 1;

        for (other = from; *other && strncmp(line, other, n) != 0; other = strchr(other, '\n') + 1)
            if (!strchr(other, '\n'))
                return line;
        if (!*other)
            return line;
        from = other + n;
    }
    return NULL;
}

/* Why a copy that was not as usual is wrong; null if it was refused as it should be. */
static const char *why_wrong(const folder *now, int status)
{
    static char why[400];
    const char *line;
    int i;

    if (!WIFEXITED(status) || WEXITSTATUS(status) != REFUSED)
        return "not as usual, and not refused";
    if (!has_message(find(now, "err")))
        return "refused without a message";
    for (i = 0; i < old.n; i++)
        if (!find(now, old.files[i].name))
            return "a file is lost";
    for (i = 0; i < now->n; i++) {
        const contents *c = &now->files[i], *before = find(&old, c->name);

        if (!is_printed(c->name) && !is_same(c, before) && !is_same(c, find(&usual, c->name))) {
            snprintf(why, sizeof why, "the file %s is neither old nor complete: %.200s", c->name,
                     c->bytes);
            return why;
        }
    }
    line = new_line(find(now, "out"), find(&usual, "out"));
    if (line) {
        snprintf(why, sizeof why, "prints what it usually does not: %.200s", line);
        return why;
    }
    return NULL;
}

/* What became of a copy. */
static void judge(const char *place, unsigned long at, int status)
{
    const contents *err;
    folder now;
    const char *why = NULL;
    int i, is_usual = WIFEXITED(status) && WEXITSTATUS(status) == usual_status;

    read_folder(&now, place);
    is_usual = is_usual && now.n == usual.n;
    for (i = 0; i < now.n; i++)
        is_usual = is_usual && is_same(&now.files[i], find(&usual, now.files[i].name));
    n_tried++;
    if (!is_usual) {
        why = why_wrong(&now, status);
        n_refused += !why;
        n_wrong += why != NULL;
    }
    if (why && n_wrong <= MOST_TOLD) {
        err = find(&now, "err");
        dprintf(report,
                "FAILED: allocation %lu, FAIL_ON=%d: %s %d, usually %d: %s; messages: %.200s\n", at,
                fails_on, WIFEXITED(status) ? "exit status" : "signal",
                WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status), usual_status, why,
                err ? err->bytes : "");
    }
    free_folder(&now);
}

/* ------------------------------------------------------------------------------------------------- trials */

/* Wait for a copy to end. */
static void wait_for_one(void)
{
    int status;
    pid_t ended;
    char place[20];
    unsigned long i;

    while ((ended = waitpid(-1, &status, 0)) > 0)
        for (i = 0; i < at_once; i++)
            if (running[i].process == ended) {
                running[i].process = 0;
                snprintf(place, sizeof place, "%lu", i);
                judge(place, running[i].at, status);
                return;
            }
    give_up("cannot wait for", "a trial");
}

static unsigned long free_place(void)
{
    unsigned long i;

    for (i = 0; i < at_once; i++)
        if (!running[i].process)
            return i;
    wait_for_one();
    return free_place();
}

/* Fork a copy in which allocation `at` fails; 1 in the copy. */
static int try_at(unsigned long at)
{
    unsigned long i = free_place();
    char place[20], none;
    int ready[2];

    snprintf(place, sizeof place, "%lu", i);
    copy_run(place);
    running[i].at = at;
    if (pipe(ready) != 0 || (running[i].process = fork()) < 0)
        give_up("cannot fork", place);
    if (running[i].process > 0) {
        close(ready[1]);
        if (read(ready[0], &none, 1) != 0) /* the files are open */
            give_up("cannot read", "a pipe");
        close(ready[0]);
        return 0;
    }
    open_again(place);
    close(ready[0]);
    close(ready[1]);
    if (chdir(path_of(place, NULL)) != 0)
        give_up("no folder", place);
    close(report);
    owner = getpid();
    trials = NULL;
    fail_at = at;
    alarm(SECONDS);
    return 1;
}

static void finish_trials(void)
{
    unsigned long i;

    for (i = 0; i < at_once; i++)
        while (running[i].process)
            wait_for_one();
    dprintf(report, "%lu %lu %lu %lu\n", n_tried, n_refused, n_tried - n_refused - n_wrong,
            n_wrong);
    close(report);
}

/* All trials before the program starts; 1 in a copy. */
static int try_whole(void)
{
    unsigned long at;

    for (at = 1;; at += every) {
        *reached = 0;
        if (try_at(at))
            return 1;
        while (running[0].process)
            wait_for_one();
        if (!*reached) { /* the program has no such allocation */
            n_tried--;
            return 0;
        }
    }
}

static int begin_trials(void)
{
    every = number_of("EVERY");
    at_once = number_of("AT_ONCE");
    every = every ? every : 1;
    at_once = at_once < 1 || number_of("WHOLE") ? 1
              : at_once > MOST_AT_ONCE          ? MOST_AT_ONCE
                                                : at_once;
    usual_status = (int)number_of("USUAL");
    report = open(path_of("report", NULL), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    report = fcntl(report, F_DUPFD_CLOEXEC, 100); /* not among the files of the program */
    reached =
        mmap(NULL, sizeof *reached, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (report < 0 || reached == MAP_FAILED)
        give_up("cannot write", "report");
    read_folder(&old, "old");
    read_folder(&usual, "usual");
    return number_of("WHOLE") && try_whole();
}

__attribute__((constructor)) static void begin(void)
{
    find_real();
    fail_at = number_of("FAIL_AT");
    fails_on = number_of("FAIL_ON") != 0;
    unsetenv("LD_PRELOAD"); /* other programs have their memory */
    owner = getpid();
    trials = getenv("TRIALS");
    if (trials && !begin_trials() && number_of("WHOLE"))
        every = 0;
    is_on = 1;
}

__attribute__((destructor)) static void end(void)
{
    if (trials && getpid() == owner) {
        is_on = 0;
        finish_trials();
    }
}

/* 1 if this allocation fails. */
static int fails(void)
{
    int reason = errno;

    if (!is_on || getpid() != owner)
        return 0;
    count++;
    if (trials && every && (count - 1) % every == 0) {
        is_on = 0;
        try_at(count);
        is_on = 1;
        errno = reason;
    }
    if (!fail_at || (fails_on ? count < fail_at : count != fail_at))
        return 0;
    if (reached)
        *reached = 1;
    errno = ENOMEM;
    return 1;
}

void *NAME(malloc)(size_t size)
{
    return fails() ? NULL : REAL(malloc)(size);
}

void *NAME(calloc)(size_t n, size_t size)
{
#ifndef WRAPPED
    static double early[512]; /* dlsym itself may ask for memory */
    static size_t used;

    if (!real_calloc) {
        used += (n * size + 15) / 16 * 2;
        return used <= 512 ? early + used - (n * size + 15) / 16 * 2 : NULL;
    }
#endif
    return fails() ? NULL : REAL(calloc)(n, size);
}

void *NAME(realloc)(void *old_memory, size_t size)
{
    return fails() ? NULL : REAL(realloc)(old_memory, size);
}
