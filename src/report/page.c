/* SPDX-License-Identifier: GPL-3.0-or-later
**
** page.c - a page of HTML, which is XML too.
*/
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/format.h"
#include "base/text.h"
#include "system/xml.h"
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

/* A number with the digits of a deck. */
static const char *number_text(double value, int digits, char out[FORMAT_SIZE])
{
    if (gsl_isnan(value))
        return "\342\200\223"; /* a dash */
    if (gsl_isinf(value))
        return value > 0 ? "\342\210\236" : "\342\210\222\342\210\236";
    return format_general(value, digits > 12 ? 15 : digits > 6 ? 9 : 6, out);
}

int page_behind(double value, int digits)
{
    char number[FORMAT_SIZE];
    const char *point = strchr(number_text(value, digits, number), '.');

    return point ? (int)strlen(point) : 0;
}

void page_number_cell(page *p, double value, int digits, int most)
{
    char number[FORMAT_SIZE];

    page_print(p, "<td class=\"number\" style=\"--behind: %d\">%s</td>",
               most - page_behind(value, digits), number_text(value, digits, number));
}

/* The same as printf's; in a row, | begins the next cell. */
static void print(page *p, const char *format, va_list arguments, int is_row)
{
    const char *words;
    char number[FORMAT_SIZE], *end;
    double value;
    int digits, cells = 0;

    for (; *format; format++) {
        if (is_row && *format == '|') {
            fputs(cells++ ? "</td><td>" : "</th><td>", p->out);
        } else if (*format != '%' || *++format == '%') {
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
        } else if (*format == 'v') {
            value = va_arg(arguments, double);
            fputs(number_text(value, va_arg(arguments, int), number), p->out);
        } else { /* .6g, .4f */
            digits = (int)strtol(format + 1, &end, 10);
            format = end;
            fputs((*format == 'f' ? format_fixed : format_general)(va_arg(arguments, double),
                                                                   digits, number),
                  p->out);
        }
    }
}

void page_print(page *p, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    print(p, format, arguments, 0);
    va_end(arguments);
}

void page_row(page *p, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    page_print(p, "<tr><th scope=\"row\">");
    print(p, format, arguments, 1);
    page_print(p, "</td></tr>\n");
    va_end(arguments);
}

void page_table_of(page *p, const char *name_of_class, const char *caption, const char *columns)
{
    text rest = flk_text_of(columns), name;

    page_print(p, "<div class=\"wide\"><table class=\"%s\">\n", name_of_class);
    if (caption)
        page_print(p, "<caption>Table %d. %s</caption>\n", ++p->n_tables, caption);
    page_print(p, "<thead><tr>");
    while (flk_text_split(&rest, '|', &name)) {
        page_print(p, "<th scope=\"col\">");
        xml_put(p->out, name.start, name.length);
        page_print(p, "</th>");
    }
    page_print(p, "</tr></thead>\n<tbody>\n");
}

void page_table(page *p, const char *caption, const char *columns)
{
    page_table_of(p, "facts", caption, columns);
}

void page_table_end(page *p)
{
    page_print(p, "</tbody>\n</table></div>\n");
}

void page_fold(page *p, int is_long, const char *title, unsigned long n_rows)
{
    page_print(p, "<details class=\"table%s\">\n<summary>Table %d. %s (%lu)</summary>\n",
               is_long ? " long" : "", ++p->n_tables, title, n_rows);
}

void page_fold_end(page *p)
{
    page_print(p, "</details>\n");
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
    page_print(p, "<section id=\"%s\">\n<h2>%d %s</h2>\n<div class=\"body\">\n", id,
               ++p->n_sections, heading);
}

void page_section_end(page *p)
{
    page_print(p, "</div>\n</section>\n");
}
