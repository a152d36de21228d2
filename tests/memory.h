/* SPDX-License-Identifier: GPL-3.0-or-later
**
** memory.h - allocations of the program counted, and made to fail, where COUNTS_MEMORY is defined: with glibc and without
** a sanitizer, which has its own malloc.
*/
#ifndef FOURLINK_TEST_MEMORY_H
#define FOURLINK_TEST_MEMORY_H

#include <stddef.h>

static volatile int watches_memory;
static volatile unsigned long allocations;
static volatile unsigned long fail_at; /* the number of the allocation that fails; 0: none, */
static volatile int fails_on;          /* ... 1: and all after it */

/* Count what is allocated from now on; allocation `at` fails, if that is not 0, and with `on` all after it. */
static inline void watch_memory(unsigned long at, int on)
{
    allocations = 0;
    fail_at = at;
    fails_on = on;
    watches_memory = 1;
}

/* The number of allocations since then. */
static inline unsigned long watched_memory(void)
{
    watches_memory = 0;
    return allocations;
}

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SANITIZED
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED
#endif

#if defined(__GLIBC__) && !defined(SANITIZED)
#define COUNTS_MEMORY

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *memory, size_t size);

static int memory_fails(void)
{
    if (!watches_memory)
        return 0;
    allocations++;
    return fail_at && (fails_on ? allocations >= fail_at : allocations == fail_at);
}

void *malloc(size_t size)
{
    return memory_fails() ? NULL : __libc_malloc(size);
}

void *calloc(size_t n, size_t size)
{
    return memory_fails() ? NULL : __libc_calloc(n, size);
}

void *realloc(void *memory, size_t size)
{
    return memory_fails() ? NULL : __libc_realloc(memory, size);
}
#endif

#endif
