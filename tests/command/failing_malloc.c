/* SPDX-License-Identifier: GPL-3.0-or-later
**
** failing_malloc.c - memory that runs out, for failed_allocations.sh: allocation number FAIL_AT of the
** program fails, and if FAIL_ON is 1 all after it too.  COUNT_FILE gets the number of allocations.
**
** Loaded before the C library with LD_PRELOAD, or, as a sanitizer has its own malloc, linked into the program
** with -DWRAPPED and --wrap.
*/
#define _GNU_SOURCE /* RTLD_NEXT */

#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
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

static unsigned long count, fail_at;
static int is_on, fails_on;
static pid_t owner;

static unsigned long number_of(const char *name)
{
    const char *value = getenv(name);

    return value ? strtoul(value, NULL, 10) : 0;
}

__attribute__((constructor)) static void begin(void)
{
    find_real();
    fail_at = number_of("FAIL_AT");
    fails_on = number_of("FAIL_ON") != 0;
    unsetenv("LD_PRELOAD"); /* gnuplot has its memory */
    owner = getpid();
    is_on = 1;
}

__attribute__((destructor)) static void end(void)
{
    const char *name = getenv("COUNT_FILE");
    FILE *file;

    is_on = 0;
    if (!name || getpid() != owner || (file = fopen(name, "w")) == NULL)
        return;
    fprintf(file, "%lu\n", count);
    fclose(file);
}

/* 1 if this allocation fails. */
static int fails(void)
{
    if (!is_on)
        return 0;
    count++;
    if (!fail_at || (fails_on ? count < fail_at : count != fail_at))
        return 0;
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

void *NAME(realloc)(void *old, size_t size)
{
    return fails() ? NULL : REAL(realloc)(old, size);
}
