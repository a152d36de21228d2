/* SPDX-License-Identifier: GPL-3.0-or-later
**
** page.c - a page of HTML, which is XML too.
*/
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/format.h"
#include "base/xml.h"
#include "page.h"
#include "view/notation.h"

/* A name with its index, as markup. */
static void put_name(page *p, const char *name)
{
    char below[NOTATION_SIZE];
    notation n;

    page_print(p, notation_split(name, &n) || strlen(name) == 1 ? "<i>%s</i>" : "%s", n.symbol);
    if (*notation_below(&n, below))
        page_print(p, "<sub>%s</sub>", below);
}

/* A unit, nothing for "1"; with the gap to the number before it, unless it is the sign of degrees. */
static void put_unit(page *p, const char *unit, int has_gap)
{
    char typeset[NOTATION_SIZE];

    if (strcmp(unit, "1") == 0)
        return;
    page_print(p, has_gap && strcmp(unit, "deg") != 0 ? "\302\240%s" : "%s",
               notation_unit(unit, typeset));
}

void page_print(page *p, const char *format, ...)
{
    va_list arguments;
    const char *words;
    char number[FORMAT_SIZE], *end;
    int digits;

    va_start(arguments, format);
    for (; *format; format++) {
        if (*format != '%' || *++format == '%') {
            putc(*format, p->out);
        } else if (*format == 's') {
            words = va_arg(arguments, const char *);
            xml_put(p->out, words, strlen(words));
        } else if (*format == 'n') {
            put_name(p, va_arg(arguments, const char *));
        } else if (*format == 'u' || *format == 'U') {
            put_unit(p, va_arg(arguments, const char *), *format == 'U');
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
            fputs((*format == 'f' ? format_fixed : format_general)(va_arg(arguments, double),
                                                                   digits, number),
                  p->out);
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
