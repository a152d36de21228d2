/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "fourlink.h"

static void placeholder(void **s)
{
    (void)s;
}
int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(placeholder)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
