/* SPDX-License-Identifier: GPL-3.0-or-later
**
** svg.c - title and description of an SVG file, which gnuplot cannot set: it writes <title>Gnuplot</title> and a
** line <desc> that names itself.
*/
#include <string.h>

#include "svg.h"

void svg_put_text(FILE *out, const char *words)
{
    text rest = flk_text_of(words);

    while (rest.length) {
        size_t n = flk_text_printable(rest);

        if (n == 0)
            putc('?', out);
        else if (*rest.start == '&')
            fputs("&amp;", out);
        else if (*rest.start == '<')
            fputs("&lt;", out);
        else if (*rest.start == '>')
            fputs("&gt;", out);
        else if (*rest.start == '"')
            fputs("&quot;", out);
        else
            fwrite(rest.start, 1, n, out);
        rest = flk_text_from(rest, n ? n : 1);
    }
}

/* Where a string begins in a text; its end if it does not. */
static size_t find(const char *words, size_t length, const char *string)
{
    size_t n = strlen(string), i;

    for (i = 0; i + n <= length; i++)
        if (memcmp(words + i, string, n) == 0)
            return i;
    return length;
}

void svg_put_head(FILE *out, const char *head, size_t length, const plot_caption *caption)
{
    static const char desc_end[] = "</desc>";
    size_t from = find(head, length, "<title>"), to = find(head, length, desc_end);

    if (from < to && to < length) {
        fwrite(head, 1, from, out);
        fputs("<title>", out);
        svg_put_text(out, caption->title);
        fputs("</title>\n<desc>", out);
        svg_put_text(out, caption->words);
        from = to;
    } else {
        from = 0;
    }
    fwrite(head + from, 1, length - from, out);
}
