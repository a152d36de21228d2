/* SPDX-License-Identifier: GPL-3.0-or-later
**
** json_text.c - strings and numbers of JSON, RFC 8259.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "json_text.h"

void json_text_put(line *l, const char *s, const char *escaped)
{
    static const char hex[] = "0123456789abcdef";
    text rest = flk_text_of(s);

    line_text(l, "\"", 1);
    while (rest.length) {
        unsigned char c = (unsigned char)*rest.start;
        size_t n = flk_text_letter(rest);

        if (n == 2 && c == 0xc2 && !flk_text_printable(rest))
            c = (unsigned char)rest.start[1]; /* U+0080 to U+009F */
        if (c < ' ' || (0x7f <= c && c < 0xa0 && n) || strchr(escaped, c)) {
            line_put(l, "\\u00");
            line_text(l, &hex[c / 16], 1);
            line_text(l, &hex[c % 16], 1);
        } else if (n) {
            line_text(l, "\\", c == '"' || c == '\\');
            line_text(l, rest.start, n);
        } else {
            line_put(l, "\\ufffd");
        }
        rest = flk_text_from(rest, n ? n : 1);
    }
    line_text(l, "\"", 1);
}

void json_text_number(line *l, double x, int digits)
{
    if (gsl_isnan(x))
        line_put(l, "null");
    else if (gsl_isinf(x))
        line_put(l, x > 0 ? "\"inf\"" : "\"-inf\"");
    else
        line_number(l, x, digits);
}
