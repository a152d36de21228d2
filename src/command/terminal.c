/* SPDX-License-Identifier: GPL-3.0-or-later
**
** terminal.c - the terminal that results are shown on.
*/
#include <stdlib.h>

#include "base/system.h"
#include "terminal.h"

#define USUAL_WIDTH 80
#define LARGEST_WIDTH 100000

static unsigned long width_of_environment(void)
{
    const char *columns = getenv("COLUMNS");
    char *end;
    long width = columns ? strtol(columns, &end, 10) : 0;

    return width > 0 && width <= LARGEST_WIDTH && !*end ? (unsigned long)width : 0;
}

unsigned long terminal_width(FILE *out)
{
    unsigned long width = 0;

    if (!system_is_terminal(out))
        return 0;
    width = width_of_environment();
    if (!width)
        width = system_width(out);
    return width ? width : USUAL_WIDTH;
}
