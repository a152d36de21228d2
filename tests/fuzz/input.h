/* SPDX-License-Identifier: GPL-3.0-or-later
**
** input.h - what the fuzzers have in common: an input cut into parts, and what must not happen.
*/
#ifndef FOURLINK_FUZZ_INPUT_H
#define FOURLINK_FUZZ_INPUT_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A finding, unless `holds`. */
#define MUST(holds)                                                             \
    do {                                                                        \
        if (!(holds)) {                                                         \
            fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #holds); \
            abort();                                                            \
        }                                                                       \
    } while (0)

/* A part of an input. */
typedef struct part {
    const char *text;
    size_t length;
} part;

/* Take what stands before `stop` off the front of `rest`; all of it if there is none. */
static inline part take_part(part *rest, int stop)
{
    const char *end = rest->length ? memchr(rest->text, stop, rest->length) : NULL;
    part taken = *rest;

    if (end) {
        taken.length = (size_t)(end - rest->text);
        rest->text = end + 1;
        rest->length -= taken.length + 1;
    } else {
        rest->text += rest->length;
        rest->length = 0;
    }
    return taken;
}

/* A null-terminated copy. */
static inline char *copy_part(part p)
{
    char *copy = malloc(p.length + 1);

    MUST(copy);
    if (p.length)
        memcpy(copy, p.text, p.length);
    copy[p.length] = '\0';
    return copy;
}

#endif
