/* SPDX-License-Identifier: GPL-3.0-or-later
**
** gnuplot.c - runs gnuplot without a shell.  The script is its standard input and the picture its standard
** output, so that it never reads a file name.  gnuplot does not check whether it can write, so the picture is
** copied here; an SVG gets a title and a description, which gnuplot cannot set.
*/
#include <errno.h>
#include <string.h>

#include "system/system.h"
#include "base/text.h"
#include "system/xml.h"
#include "plot.h"

#define PART 8192 /* bytes; an SVG has its title and description in the first of them */

/* The first line of gnuplot's messages that names a line of the script, or else their first line. */
static void find_complaint(FILE *complaints, char words[GNUPLOT_REASON])
{
    char one[GNUPLOT_REASON / 2];
    text t;

    words[0] = '\0';
    rewind(complaints);
    while (fgets(one, sizeof one, complaints)) {
        one[strcspn(one, "\n")] = '\0';
        t = flk_text_trim(flk_text_of(one));
        if (t.length && (!words[0] || strstr(one, "line ")))
            flk_text_copy(t, words, GNUPLOT_REASON);
        if (strstr(one, "line "))
            return;
    }
}

/* Null, or the reason why there is no picture. */
static const char *reason_of(const system_outcome *o, FILE *complaints, char why[GNUPLOT_REASON])
{
    char words[GNUPLOT_REASON];

    if (!o->is_found)
        return "gnuplot is not installed; its package is gnuplot-nox (Debian, Ubuntu) or gnuplot; "
               "--plot-script writes its script";
    if (o->status == 0 && o->copied > 0)
        return NULL;
    find_complaint(complaints, words);
    return flk_text_join(why, GNUPLOT_REASON, "gnuplot failed", words[0] ? ": " : "", words,
                         (char *)NULL);
}

static const char *draw(FILE *script, FILE *out, FILE *complaints, char why[GNUPLOT_REASON])
{
    static const char *const gnuplot[] = {"gnuplot", "--default-settings", "-", NULL};
    system_outcome outcome;

    system_forget("GNUTERM"); /* the script sets the terminal */
    return system_run(gnuplot, script, out, complaints, &outcome)
               ? reason_of(&outcome, complaints, why)
               : strerror(errno);
}

void gnuplot_put_head(FILE *out, const char *head, const plot_caption *caption)
{
    static const char end[] = "</desc>";
    const char *from = strstr(head, "<title>"), *to = strstr(head, end);

    if (from && to && from < to) {
        fwrite(head, 1, (size_t)(from - head), out);
        fputs("<title>", out);
        xml_put(out, caption->title, strlen(caption->title));
        fputs("</title>\n<desc>", out);
        xml_put(out, caption->words, strlen(caption->words));
        head = to;
    }
    fputs(head, out);
}

/* Copy an SVG, with this caption; null, or the reason why not. */
static const char *copy_svg(FILE *svg, FILE *out, const plot_caption *caption)
{
    char part[PART + 1];
    size_t n;

    if (fflush(svg) != 0)
        return strerror(errno);
    rewind(svg);
    part[fread(part, 1, PART, svg)] = '\0';
    gnuplot_put_head(out, part, caption);
    while ((n = fread(part, 1, PART, svg)) > 0)
        fwrite(part, 1, n, out);
    return ferror(svg) || ferror(out) ? strerror(errno) : NULL;
}

static const char *draw_svg(FILE *script, FILE *out, const plot_caption *caption, FILE *complaints,
                            char reason[GNUPLOT_REASON])
{
    FILE *svg = system_scratch();
    const char *why = svg ? draw(script, svg, complaints, reason) : strerror(errno);

    if (!why)
        why = copy_svg(svg, out, caption);
    if (svg)
        fclose(svg);
    return why;
}

const char *gnuplot_run(FILE *script, FILE *out, const plot_caption *caption,
                        char reason[GNUPLOT_REASON])
{
    FILE *complaints = system_scratch();
    const char *why = !complaints ? strerror(errno)
                      : caption   ? draw_svg(script, out, caption, complaints, reason)
                                  : draw(script, out, complaints, reason);

    if (complaints)
        fclose(complaints);
    return why;
}
