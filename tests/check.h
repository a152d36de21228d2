/* SPDX-License-Identifier: GPL-3.0-or-later
**
** check.h - what the tests share: cmocka, comparison of doubles, random numbers.
*/
#ifndef FOURLINK_CHECK_H
#define FOURLINK_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#define DEG (3.14159265358979323846 / 180)

/* |actual - expected| <= tolerance, absolutely; a NaN fails. */
#define assert_near(actual, expected, tolerance) \
    check_near((actual), (expected), (tolerance), #actual, __FILE__, __LINE__)

/* The same relative to |expected|. */
#define assert_close(actual, expected, relative) \
    check_near((actual), (expected), (relative)*fabs(expected), #actual, __FILE__, __LINE__)

static inline void check_near(double actual, double expected, double tolerance, const char *what,
                              const char *file, int line)
{
    if (!(fabs(actual - expected) <= tolerance)) {
        print_error("%s = %.17g, expected %.17g +- %.3g\n", what, actual, expected, tolerance);
        _fail(file, line);
    }
}

/* A fixed sequence of numbers, uniform in [low, high): the same on every machine. */
static inline double uniform(uint64_t *state, double low, double high)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*state >> 11) / 9007199254740992.0;
}

#endif
