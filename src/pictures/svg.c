/* SPDX-License-Identifier: GPL-3.0-or-later
**
** svg.c - title and description of an SVG file, which gnuplot cannot set: it writes <title>Gnuplot</title> and a
** line <desc> that names itself.
*/
#include <string.h>

#include "base/xml.h"
#include "svg.h"

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
        xml_put(out, caption->title, strlen(caption->title));
        fputs("</title>\n<desc>", out);
        xml_put(out, caption->words, strlen(caption->words));
        from = to;
    } else {
        from = 0;
    }
    fwrite(head + from, 1, length - from, out);
}
