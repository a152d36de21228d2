/* SPDX-License-Identifier: GPL-3.0-or-later
**
** json_text.c - strings and numbers of JSON, RFC 8259.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "json_text.h"

/* The length of the UTF-8 sequence at the beginning of a text; 0 if there is none. */
static size_t sequence(const unsigned char *c)
{
    size_t n = c[0] < 0x80                   ? 1
               : c[0] >= 0xc2 && c[0] < 0xe0 ? 2
               : c[0] >= 0xe0 && c[0] < 0xf0 ? 3
               : c[0] >= 0xf0 && c[0] < 0xf5 ? 4
                                             : 0;
    size_t i;

    for (i = 1; i < n; i++)
        if ((c[i] & 0xc0) != 0x80)
            return 0;
    /* overlong forms, surrogates, numbers above U+10FFFF */
    if ((c[0] == 0xe0 && c[1] < 0xa0) || (c[0] == 0xed && c[1] > 0x9f) ||
        (c[0] == 0xf0 && c[1] < 0x90) || (c[0] == 0xf4 && c[1] > 0x8f))
        return 0;
    return n;
}

void json_text_put(line *l, const char *s, const char *escaped)
{
    static const char hex[] = "0123456789abcdef";

    line_text(l, "\"", 1);
    while (*s) {
        unsigned char c = (unsigned char)*s;
        size_t n = sequence((const unsigned char *)s);

        if (c < ' ' || c == 0x7f || strchr(escaped, *s)) {
            line_put(l, "\\u00");
            line_text(l, &hex[c / 16], 1);
            line_text(l, &hex[c % 16], 1);
        } else if (n) {
            line_text(l, "\\", c == '"' || c == '\\');
            line_text(l, s, n);
        } else {
            line_put(l, "\\ufffd");
        }
        s += n ? n : 1;
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
