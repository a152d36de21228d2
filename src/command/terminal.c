/* SPDX-License-Identifier: GPL-3.0-or-later
**
** terminal.c - the terminal that results are shown on.
*/
#define _POSIX_C_SOURCE 200112L

#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

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

    if (!isatty(fileno(out)))
        return 0;
    width = width_of_environment();
#ifdef TIOCGWINSZ /* not in POSIX.1-2001, but on every system that has terminals */
    if (!width) {
        struct winsize size;

        if (ioctl(fileno(out), TIOCGWINSZ, &size) == 0)
            width = size.ws_col;
    }
#endif
    return width ? width : USUAL_WIDTH;
}
