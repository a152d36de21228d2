/* SPDX-License-Identifier: GPL-3.0-or-later
**
** locales.h - tests under the C locale, and under one with a decimal comma, which the system may not have.
*/
#ifndef FOURLINK_LOCALES_H
#define FOURLINK_LOCALES_H

#include <locale.h>
#include <stdio.h>

#include "check.h"

/* 0 if the system has no locale with a decimal comma. */
static inline int set_comma_locale(void)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8",
                                        "de_DE",       "fr_FR",      "nl_NL.UTF-8", "it_IT.UTF-8"};
    size_t i;

    for (i = 0; i < COUNT(names); i++)
        if (setlocale(LC_ALL, names[i]) && strcmp(localeconv()->decimal_point, ",") == 0)
            return 1;
    setlocale(LC_ALL, "C");
    return 0;
}

static inline int in_c_locale(void **unused)
{
    (void)unused;
    return setlocale(LC_ALL, "C") ? 0 : -1;
}

static inline int in_comma_locale(void **unused)
{
    (void)unused;
    return set_comma_locale() ? 0 : -1;
}

#define C_LOCALE(f) cmocka_unit_test_setup(f, in_c_locale)
#define COMMA_LOCALE(f) cmocka_unit_test_setup_teardown(f, in_comma_locale, in_c_locale)

/* Whether the program is to run its tests with a decimal comma, PROGRAM comma. */
static inline int asks_for_comma(int argc, char **argv)
{
    return argc > 1 && strcmp(argv[1], "comma") == 0;
}

/* The status of a test that is skipped, with its reason. */
static inline int no_comma_locale(void)
{
    puts("skipped: there is no locale with a decimal comma (Debian: locales, then localedef -i "
         "de_DE -f UTF-8 de_DE.UTF-8)");
    return 77;
}

#endif
