/* SPDX-License-Identifier: GPL-3.0-or-later
**
** results.c - a deck in, named numbers out, in strict C90.
*/
#include <stdio.h>
#include <fourlink.h>

int main(void)
{
    static const char *const names[] = {"theta4", "Ts", "min(Ts)", "mu_min"};
    static char text[10000];
    static fourlink_source source; /* what stays zero is absent */
    fourlink_mistake mistakes[10];
    fourlink_results *results;
    fourlink_value v;
    unsigned long n, i;

    source.text = text;
    source.length = (unsigned long)fread(text, 1, sizeof text, stdin);
    if (fourlink_results_open(&source, 10, &results, mistakes, &n) != FOURLINK_OK) {
        for (i = 0; i < n && i < 10; i++)
            printf("deck:%ld: error: %s\n", mistakes[i].line, mistakes[i].message);
        return 1;
    }
    for (i = 0; i < 4; i++)
        if (fourlink_results_value(results, names[i], FOURLINK_OPEN, 40, &v) == FOURLINK_OK)
            printf("%s = %.9f %s\n", v.name, v.value, v.unit);
    fourlink_results_free(results);
    return 0;
}
