/* SPDX-License-Identifier: GPL-3.0-or-later
**
** xml.c - texts in XML and HTML.
*/
#include <string.h>

#include "base/text.h"
#include "xml.h"

#define REPLACEMENT "\357\277\275" /* U+FFFD in UTF-8 */

void xml_put(FILE *out, const char *words, size_t length)
{
    static const char special[] = "&<>\"'";
    static const char *const names[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
    text rest;

    rest.start = words;
    rest.length = length;
    while (rest.length) {
        char c = *rest.start;
        const char *found = c ? strchr(special, c) : NULL;
        size_t n = flk_text_letter(rest);

        if (found)
            fputs(names[found - special], out);
        else if (c == '\t' || c == '\n' || flk_text_printable(rest))
            fwrite(rest.start, 1, n, out);
        else if (c != '\r')
            fputs(REPLACEMENT, out);
        else if (rest.length < 2 || rest.start[1] != '\n')
            putc('\n', out);
        rest = flk_text_from(rest, n ? n : 1);
    }
}
