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
#include "svg.h"

#define PART 8192 /* bytes; an SVG has its title and description in the first of them */

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

static const char *draw(FILE *script, FILE *out, FILE *complaints)
{
    static const char *const gnuplot[] = {"gnuplot", "--default-settings", "-", NULL};
    system_outcome outcome;

    return system_run(gnuplot, script, out, complaints, &outcome) ? reason_of(&outcome, complaints)
                                                                  : strerror(errno);
}

/* Copy an SVG, with this caption; null, or the reason why not. */
static const char *copy_svg(FILE *svg, FILE *out, const plot_caption *caption)
{
    char part[PART];
    size_t n;

    if (fflush(svg) != 0)
        return strerror(errno);
    rewind(svg);
    n = fread(part, 1, sizeof part, svg);
    svg_put_head(out, part, n, caption);
    while ((n = fread(part, 1, sizeof part, svg)) > 0)
        fwrite(part, 1, n, out);
    return ferror(svg) || ferror(out) ? strerror(errno) : NULL;
}

static const char *draw_svg(FILE *script, FILE *out, const plot_caption *caption, FILE *complaints)
{
    FILE *svg = system_scratch();
    const char *why = svg ? draw(script, svg, complaints) : strerror(errno);

    if (!why)
        why = copy_svg(svg, out, caption);
    if (svg)
        fclose(svg);
    return why;
}

const char *gnuplot_run(FILE *script, FILE *out, const plot_caption *caption)
{
    FILE *complaints = system_scratch();
    const char *why = !complaints ? strerror(errno)
                      : caption   ? draw_svg(script, out, caption, complaints)
                                  : draw(script, out, complaints);

    if (complaints)
        fclose(complaints);
    return why;
}
