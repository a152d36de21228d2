/* SPDX-License-Identifier: GPL-3.0-or-later
**
** wrong.h - what is wrong with a report: printed, and counted.
*/
#ifndef TESTS_WRONG_H
#define TESTS_WRONG_H

#include <stdarg.h>
#include <stdio.h>

static const char *report; /* the name of its file */
static int n_wrong;

static inline void wrong(const char *format, ...) __attribute__((format(printf, 1, 2)));

static inline void wrong(const char *format, ...)
{
    va_list rest;

    va_start(rest, format);
    printf("%s: ", report);
    vprintf(format, rest);
    printf("\n");
    va_end(rest);
    n_wrong++;
}

#endif
