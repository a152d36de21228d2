/* SPDX-License-Identifier: GPL-3.0-or-later
**
** terminal.c - the terminal that results are shown on, and the progress of long work there.
*/
#include <stdlib.h>
#include <string.h>

#include "system/system.h"
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

int terminal_has_colour(FILE *out, const char *colour)
{
    const char *none = getenv("NO_COLOR"), *name = getenv("TERM");

    if (colour)
        return strcmp(colour, "always") == 0;
    return system_is_terminal(out) && !(none && *none) && name && *name &&
           strcmp(name, "dumb") != 0;
}

void terminal_set_up(sheet *s, FILE *out, int is_wide, const char *colour)
{
    s->width = is_wide ? 0 : terminal_width(out);
    s->is_coloured = s->format == &table_format && terminal_has_colour(out, colour);
}

void terminal_tell_search(unsigned long starts, clock_t begun)
{
    double seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;

    if (starts > 0 && seconds >= 1 && system_is_terminal(stderr))
        fprintf(stderr, "fourlink: %lu starts took %.1f s\n", starts, seconds);
}

void progress_begin(progress *p, FILE *out)
{
    p->is_shown = system_is_terminal(stderr) && !system_is_terminal(out);
    p->is_told = 0;
    p->start = p->last = time(NULL);
}

void progress_tell(progress *p, unsigned long done, unsigned long of)
{
    double share = (double)done / (double)of;
    time_t now = p->is_shown ? time(NULL) : p->last;

    if (now == p->last || now <= p->start + 1)
        return;
    p->last = now;
    p->is_told = 1;
    fprintf(stderr, "\rfourlink: %lu of %lu designs, %.0f %%, %.0f s to go    ", done, of,
            100 * share, difftime(now, p->start) * (1 / share - 1));
}

void progress_end(const progress *p)
{
    if (p->is_told)
        fprintf(stderr, "\r%75s\r", "");
}
