/* SPDX-License-Identifier: GPL-3.0-or-later
**
** memory.c - the memory of the command, and whether there was enough.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

static int has_failed;

static void *noted(void *memory)
{
    has_failed |= !memory;
    return memory;
}

void *memory_get(size_t n, size_t size)
{
    return noted(calloc(n ? n : 1, size));
}

void *memory_grow(void *list, size_t n, size_t size)
{
    return noted(n > (size_t)-1 / size ? NULL : realloc(list, n * size));
}

char *memory_copy(const char *string)
{
    char *copy = memory_get(strlen(string) + 1, 1);

    return copy ? strcpy(copy, string) : NULL;
}

void memory_note_failure(void)
{
    has_failed = 1;
}

void memory_note_reason(int reason)
{
    has_failed |= reason == ENOMEM;
}

int memory_has_failed(void)
{
    return has_failed;
}

void memory_forget_failure(void)
{
    has_failed = 0;
}
