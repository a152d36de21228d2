/* SPDX-License-Identifier: GPL-3.0-or-later
**
** check.h - what the tests share: cmocka, a list of tests that fills itself, comparison of doubles,
** random numbers.
*/
#ifndef FOURLINK_CHECK_H
#define FOURLINK_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_errno.h>

#include <cmocka.h>

/* TEST(name) and a body: a test, which is in the list of its file without being named again. */
#define TEST(name)                                            \
    static void name(void **);                                \
    __attribute__((constructor)) static void add_##name(void) \
    {                                                         \
        add_test(#name, name);                                \
    }                                                         \
    static void name(void **unused __attribute__((unused)))

static struct {
    struct CMUnitTest list[64];
    size_t n;
} tests;

static inline void add_test(const char *name, CMUnitTestFunction f)
{
    if (tests.n == sizeof tests.list / sizeof tests.list[0])
        abort();
    tests.list[tests.n].name = name;
    tests.list[tests.n++].test_func = f;
}

/* Run the tests of the file; the status of its main().  `setup` is called once before them, unless it is
** null. */
static inline int run_all_tests(CMFixtureFunction setup)
{
    return _cmocka_run_group_tests("tests", tests.list, tests.n, setup, NULL);
}

/* 1 if a test tries all of its cases: with ALL_CASES in the environment, as in the long trials. */
static inline int tries_all(void)
{
    return getenv("ALL_CASES") != NULL;
}

/* How many random cases a test tries: all, or a tenth. */
static inline int some_of(int all)
{
    return tries_all() ? all : (all + 9) / 10;
}

/* GSL's error handler is the host's: no result reaches it. */
static inline void fail_in_gsl(const char *reason, const char *file, int line, int code)
{
    fail_msg("GSL's error handler reached: %s (%s:%d, %d)", reason, file, line, code);
}

static inline int watch_gsl(void **unused)
{
    (void)unused;
    gsl_set_error_handler(fail_in_gsl);
    return 0;
}

#define PI 3.14159265358979323846
#define DEG (PI / 180)
#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

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
