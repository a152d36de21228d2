/* SPDX-License-Identifier: GPL-3.0-or-later
**
** convert.c - runs rsvg-convert, which makes png and pdf of an SVG, without a shell.
*/
#include <errno.h>
#include <string.h>

#include "base/text.h"
#include "system/system.h"
#include "convert.h"

/* Why rsvg-convert has made no picture; null if it has. */
static const char *reason_of(const system_outcome *o, FILE *complaints, char reason[CONVERT_REASON])
{
    char words[CONVERT_REASON / 2] = "";

    if (!o->is_found)
        return "rsvg-convert, which makes png and pdf, is not installed; its package is "
               "librsvg2-bin (Debian, Ubuntu); .svg needs no other program";
    if (o->status == 0 && o->copied > 0)
        return NULL;
    rewind(complaints);
    if (fgets(words, sizeof words, complaints))
        words[strcspn(words, "\n")] = '\0';
    return flk_text_join(reason, CONVERT_REASON, "rsvg-convert failed", words[0] ? ": " : "", words,
                         (char *)NULL);
}

const char *convert_svg(FILE *svg, plot_file file, FILE *out, char reason[CONVERT_REASON])
{
    static const char *const png[] = {"rsvg-convert", "--format=png", "--zoom=2", NULL},
                             *const pdf[] = {"rsvg-convert", "--format=pdf", NULL};
    FILE *complaints = system_scratch();
    system_outcome outcome;
    const char *why;

    if (!complaints)
        return strerror(errno);
    why = system_run(file == PLOT_PNG ? png : pdf, svg, out, complaints, &outcome)
              ? reason_of(&outcome, complaints, reason)
              : strerror(errno);
    fclose(complaints);
    return why;
}
