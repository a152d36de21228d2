/* SPDX-License-Identifier: GPL-3.0-or-later
**
** live_blocks.c - memory that a program has not freed at its end, for test_leaks.sh: loaded before the C library with
** LD_PRELOAD, it appends the number of such blocks to the file LEAKS.  Blocks that libraries ask for are not counted.
*/
#define _GNU_SOURCE /* RTLD_NEXT, dl_iterate_phdr */

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { MOST = 1 << 20 };
static void *live[MOST]; /* a hash table with open addressing; GONE: was live */
#define GONE ((void *)1)

static uintptr_t first_code, last_code; /* of the program */
static void *(*real_malloc)(size_t size);
static void *(*real_calloc)(size_t n, size_t size);
static void *(*real_realloc)(void *old, size_t size);
static void (*real_free)(void *old);

static int take_program(struct dl_phdr_info *object, size_t size, void *unused)
{
    int i;

    (void)size;
    (void)unused;
    first_code = UINTPTR_MAX;
    for (i = 0; i < object->dlpi_phnum; i++) {
        const ElfW(Phdr) *part = &object->dlpi_phdr[i];
        uintptr_t from = object->dlpi_addr + part->p_vaddr;

        if (part->p_type != PT_LOAD)
            continue;
        first_code = from < first_code ? from : first_code;
        last_code = from + part->p_memsz > last_code ? from + part->p_memsz : last_code;
    }
    return 1; /* the program is the first of all */
}

__attribute__((constructor)) static void begin(void)
{
    *(void **)&real_malloc = dlsym(RTLD_NEXT, "malloc");
    *(void **)&real_realloc = dlsym(RTLD_NEXT, "realloc");
    *(void **)&real_free = dlsym(RTLD_NEXT, "free");
    *(void **)&real_calloc = dlsym(RTLD_NEXT, "calloc");
    unsetenv("LD_PRELOAD");
    dl_iterate_phdr(take_program, NULL);
}

__attribute__((destructor)) static void end(void)
{
    int file = getenv("LEAKS") ? open(getenv("LEAKS"), O_WRONLY | O_CREAT | O_APPEND, 0666) : -1;
    size_t n = 0, i;

    for (i = 0; i < MOST; i++)
        n += live[i] && live[i] != GONE;
    dprintf(file, "%zu\n", n);
}

static size_t place_of(const void *block)
{
    return (size_t)(((uintptr_t)block >> 4) * 2654435761u) % MOST;
}

static void forget(void *block)
{
    size_t i;

    for (i = place_of(block); live[i]; i = (i + 1) % MOST)
        if (live[i] == block) {
            live[i] = GONE;
            return;
        }
}

static void *keep(void *block, void *caller)
{
    size_t i;

    if (!block || (uintptr_t)caller < first_code || (uintptr_t)caller >= last_code)
        return block;
    for (i = place_of(block); live[i] && live[i] != GONE; i = (i + 1) % MOST)
        ;
    live[i] = block;
    return block;
}

void *malloc(size_t size)
{
    return keep(real_malloc(size), __builtin_return_address(0));
}

void *calloc(size_t n, size_t size)
{
    static double early[512]; /* dlsym itself may ask for memory */
    static size_t used;

    if (!real_calloc) {
        used += (n * size + 15) / 16 * 2;
        return used <= 512 ? early + used - (n * size + 15) / 16 * 2 : NULL;
    }
    return keep(real_calloc(n, size), __builtin_return_address(0));
}

void *realloc(void *old, size_t size)
{
    void *new = real_realloc(old, size);

    if (new)
        forget(old);
    return keep(new, __builtin_return_address(0));
}

void free(void *old)
{
    forget(old);
    real_free(old);
}
