/* SPDX-License-Identifier: GPL-3.0-or-later
**
** gnuplot.c - runs gnuplot without a shell.  The script is its standard input and the picture its standard
** output, so that it never reads a file name.  gnuplot does not check whether it can write, so the picture is
** copied here.
*/
#include <errno.h>
#include <string.h>

#include "base/system.h"
#include "gnuplot.h"

static void show(FILE *complaints)
{
    int c;

    rewind(complaints);
    while ((c = getc(complaints)) != EOF)
        putc(c, stderr);
}

/* Null, or the reason why there is no picture. */
static const char *reason_of(const system_outcome *o, FILE *complaints)
{
    if (!o->is_found)
        return "gnuplot is not installed; its package is gnuplot-nox (Debian, Ubuntu) or gnuplot; "
               "--plot-script writes its script";
    if (o->status != 0)
        show(complaints);
    else if (o->copied > 0)
        return NULL;
    return "gnuplot failed";
}

static const char *draw(FILE *script, FILE *picture, FILE *complaints)
{
    static const char *const gnuplot[] = {"gnuplot", "--default-settings", "-", NULL};
    system_outcome outcome;

    return system_run(gnuplot, script, picture, complaints, &outcome)
               ? reason_of(&outcome, complaints)
               : strerror(errno);
}

const char *gnuplot_run(FILE *script, FILE *picture)
{
    FILE *complaints = system_scratch();
    const char *why = complaints ? draw(script, picture, complaints) : strerror(errno);

    if (complaints)
        fclose(complaints);
    return why;
}
