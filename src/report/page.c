/* SPDX-License-Identifier: GPL-3.0-or-later
**
** page.c - a page of HTML, which is XML too.
*/
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/format.h"
#include "base/text.h"
#include "page.h"

#define REPLACEMENT "\357\277\275" /* U+FFFD in UTF-8 */

/* The length of the character at the start of a text, 1 for a byte that is none; and whether it can stand in a
** page. */
static size_t next_letter(const char *s, size_t length, int *is_allowed)
{
    text rest;
    size_t n;

    rest.start = s;
    rest.length = length;
    n = flk_text_letter(rest);
    *is_allowed = s[0] == '\t' || s[0] == '\n' || flk_text_printable(rest) > 0;
    return n ? n : 1;
}

void page_text(page *p, const char *words, size_t length)
{
    static const char special[] = "&<>\"'";
    static const char *const names[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
    const char *s = words, *found;
    int is_allowed;
    size_t n;

    for (; length > 0; s += n, length -= n) {
        n = next_letter(s, length, &is_allowed);
        found = n == 1 && s[0] ? strchr(special, s[0]) : NULL;
        if (found)
            fputs(names[found - special], p->out);
        else if (is_allowed)
            fwrite(s, 1, n, p->out);
        else if (s[0] != '\r')
            fputs(REPLACEMENT, p->out);
        else if (length < 2 || s[1] != '\n')
            putc('\n', p->out);
    }
}

static void put_number(page *p, double value, int digits, int is_fixed)
{
    char number[FORMAT_SIZE], *digit;

    if (is_fixed)
        format_fixed(value, digits, number);
    else
        format_general(value, digits, number);
    for (digit = number + 1; *digit == '0' || *digit == '.'; digit++)
        ;
    fputs(number + (number[0] == '-' && !*digit), p->out);
}

void page_print(page *p, const char *format, ...)
{
    va_list arguments;
    const char *words;
    char *end;
    int digits;

    va_start(arguments, format);
    for (; *format; format++) {
        if (*format != '%' || *++format == '%') {
            putc(*format, p->out);
        } else if (*format == 's') {
            words = va_arg(arguments, const char *);
            page_text(p, words, strlen(words));
        } else if (*format == 'm') {
            fputs(va_arg(arguments, const char *), p->out);
        } else if (*format == 'd') {
            fprintf(p->out, "%d", va_arg(arguments, int));
        } else if (*format == 'l') {
            format++;
            fprintf(p->out, "%lu", va_arg(arguments, unsigned long));
        } else { /* .6g, .4f */
            digits = (int)strtol(format + 1, &end, 10);
            format = end;
            put_number(p, va_arg(arguments, double), digits, *format == 'f');
        }
    }
    va_end(arguments);
}

/* RFC 4648, section 4 */
void page_base64(page *p, FILE *bytes)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    unsigned char in[3];
    size_t n;

    while ((n = fread(in, 1, 3, bytes)) > 0) {
        memset(in + n, 0, 3 - n);
        putc(digits[in[0] >> 2], p->out);
        putc(digits[(in[0] & 3) << 4 | in[1] >> 4], p->out);
        putc(n > 1 ? digits[(in[1] & 15) << 2 | in[2] >> 6] : '=', p->out);
        putc(n > 2 ? digits[in[2] & 63] : '=', p->out);
    }
}

void page_section(page *p, const char *id, const char *heading)
{
    page_print(p, "<section id=\"%s\">\n<h2>%d %s</h2>\n", id, ++p->n_sections, heading);
}
