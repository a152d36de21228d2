/* SPDX-License-Identifier: GPL-3.0-or-later
**
** line.c - lines of text, written to a stream through a buffer.
*/
#include <stdarg.h>
#include <string.h>

#include "base/digits.h"
#include "base/text.h"
#include "line.h"

void line_start(line *l, FILE *out)
{
    l->out = out;
    l->length = 0;
}

void line_end(line *l)
{
    fwrite(l->bytes, 1, l->length, l->out);
    l->length = 0;
}

/* Make room for so many bytes; 0 if they exceed the buffer. */
static int room(line *l, size_t length)
{
    if (length > sizeof l->bytes - l->length)
        line_end(l);
    return length <= sizeof l->bytes;
}

void line_text(line *l, const char *s, size_t length)
{
    if (room(l, length)) {
        memcpy(l->bytes + l->length, s, length);
        l->length += length;
    } else {
        fwrite(s, 1, length, l->out);
    }
}

void line_byte(line *l, char c)
{
    room(l, 1);
    l->bytes[l->length++] = c;
}

void line_words(line *l, const char *s, size_t length)
{
    text rest;

    rest.start = s;
    rest.length = length;
    while (rest.length) {
        size_t n = flk_text_printable(rest);

        line_text(l, n ? rest.start : "?", n ? n : 1);
        rest = flk_text_from(rest, n ? n : 1);
    }
}

/* The blanks before a text of this length. */
static void put_blanks(line *l, size_t length, size_t width)
{
    size_t blanks = length < width ? width - length : 1;

    if (room(l, blanks)) {
        memset(l->bytes + l->length, ' ', blanks);
        l->length += blanks;
    } else {
        for (; blanks > 0; blanks--)
            putc(' ', l->out);
    }
}

void line_right(line *l, const char *s, size_t length, size_t width)
{
    put_blanks(l, length, width);
    line_text(l, s, length);
}

/* Blanks are copied in one piece, even if fewer are needed. */
#define BLANKS 16

int line_fixed(line *l, double value, int decimals, size_t width)
{
    char *begin;

    if (!room(l, width + BLANKS))
        return 0;
    begin = l->bytes + l->length;
    memset(begin, ' ', BLANKS);
    if (width > BLANKS)
        memset(begin + BLANKS, ' ', width - BLANKS);
    if (!flk_digits_fixed_before(value, decimals, begin + width))
        return 0;
    l->length += width;
    return 1;
}

void line_field(line *l, const char *s, size_t width)
{
    put_blanks(l, strlen(s), width);
    line_words(l, s, strlen(s));
}

void line_number(line *l, double value, int digits)
{
    char *begin;

    room(l, FORMAT_SIZE);
    begin = l->bytes + l->length;
    l->length += (size_t)(format_general_end(value, digits, begin) - begin);
}

void line_general(line *l, double value, int digits, size_t width)
{
    char number[FORMAT_SIZE];

    line_right(l, number, (size_t)(format_general_end(value, digits, number) - number), width);
}

/* Write a string padded with blanks. */
static void put_padded(line *l, const char *s, int is_left, size_t width)
{
    size_t n = strlen(s), i;

    if (is_left)
        line_words(l, s, n);
    for (i = n; i < width; i++)
        line_text(l, " ", 1);
    if (!is_left)
        line_words(l, s, n);
}

void line_put(line *l, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    while (*format) {
        size_t n = strcspn(format, "%"), width = 0;
        int is_left;

        line_text(l, format, n);
        format += n;
        if (!*format)
            break;
        is_left = *++format == '-';
        for (format += is_left; '0' <= *format && *format <= '9'; format++)
            width = 10 * width + (size_t)(*format - '0');
        if (*format == 'g')
            line_number(l, va_arg(values, double), (int)width);
        else if (*format == 's')
            put_padded(l, va_arg(values, const char *), is_left, width);
        else if (*format++ == 'l')
            line_number(l, (double)va_arg(values, unsigned long), 17);
        format++;
    }
    va_end(values);
}
