/* SPDX-License-Identifier: GPL-3.0-or-later
**
** line.c - lines of text, written to a stream through a buffer.
*/
#include <stdarg.h>
#include <string.h>

#include "base/digits.h"
#include "base/text.h"
#include "line.h"

#define FOLDED 2048 /* bytes of a line that is broken, at most */

void line_start(line *l, FILE *out)
{
    l->out = out;
    l->is_coloured = l->is_inside = 0;
    l->length = 0;
}

#define HEADING "\033[36m" /* cyan */
#define EXTREME "\033[1m"  /* bold */
#define PLAIN "\033[0m"

/* The colour of a line by its beginning: comments are headings, but for those with extremes. */
static const char *colour_of(const char *words, size_t length)
{
    size_t n = 1;

    if (words[0] != '#')
        return NULL;
    while (n < length && words[n] == ' ')
        n++;
    return n > 2 && n + 3 < length &&
                   (memcmp(words + n, "max ", 4) == 0 || memcmp(words + n, "min ", 4) == 0 ||
                    memcmp(words + n, "at ", 3) == 0)
               ? EXTREME
               : HEADING;
}

/* Write what is in the buffer line by line; a colour ends with its line, or with the buffer. */
static void write_coloured(line *l)
{
    const char *at = l->bytes, *end = l->bytes + l->length;

    while (at < end) {
        const char *next = memchr(at, '\n', (size_t)(end - at));
        const char *stop = next ? next : end;
        const char *colour = l->is_inside || at == stop ? NULL : colour_of(at, (size_t)(stop - at));

        if (colour)
            fputs(colour, l->out);
        fwrite(at, 1, (size_t)(stop - at), l->out);
        if (colour)
            fputs(PLAIN, l->out);
        if (next)
            putc('\n', l->out);
        l->is_inside = !next;
        at = next ? next + 1 : end;
    }
}

void line_end(line *l)
{
    if (l->is_coloured)
        write_coloured(l);
    else
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

char *line_blanks(line *l, size_t width)
{
    if (!room(l, width))
        return NULL;
    l->length += width;
    return memset(l->bytes + l->length - width, ' ', width);
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
    l->length += (size_t)((digits == LINE_SHORTEST ? format_shortest_end(value, begin)
                                                   : format_general_end(value, digits, begin)) -
                          begin);
}

size_t line_value(line *l, double value, int digits, size_t width)
{
    char number[FORMAT_SIZE];
    size_t length = (size_t)(format_general_end(value, digits, number) - number);

    line_right(l, number, length, width);
    return length < width ? width : length + 1;
}

size_t line_left(line *l, const char *s, size_t width)
{
    size_t n = strlen(s);

    line_words(l, s, n);
    if (n < width)
        put_blanks(l, n, width);
    return n > width ? n - width : 0;
}

void line_put(line *l, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    while (*format) {
        size_t n = strcspn(format, "%"), width = 0;

        line_text(l, format, n);
        format += n;
        if (!*format)
            break;
        for (format += format[1] == '-' ? 2 : 1; '0' <= *format && *format <= '9'; format++)
            width = 10 * width + (size_t)(*format - '0');
        if (*format == 'g')
            line_number(l, va_arg(values, double), (int)width);
        else if (*format == 's')
            line_left(l, va_arg(values, const char *), width);
        else if (*format++ == 'l')
            line_number(l, (double)va_arg(values, unsigned long), 17);
        format++;
    }
    va_end(values);
}

size_t line_here(line *l)
{
    if (l->length > sizeof l->bytes - FOLDED)
        line_end(l);
    return l->length;
}

/* 1 if a line may end before a blank: not between a number and its unit, nor beside an equals sign. */
static int may_break(text words, size_t i)
{
    int before = i > 0 ? words.start[i - 1] : ' ', after = ' ';

    if (i + 1 < words.length)
        after = words.start[i + 1];
    return before != ' ' && before != '=' && after != '=' &&
           (before < '0' || before > '9' || !(after == '%' || flk_text_is_word(after)) ||
            ('0' <= after && after <= '9'));
}

/* The words that fit this width, at least one. */
static text words_within(text words, size_t width)
{
    text fitting = words;
    size_t letters = 0, i;

    for (i = 0; i < words.length; i++) {
        if (words.start[i] == ' ' && may_break(words, i))
            fitting.length = i;
        letters += ((unsigned char)words.start[i] & 0xc0) != 0x80;
        if (letters > width && fitting.length < words.length)
            return fitting;
    }
    return words;
}

void line_finish(line *l, size_t start, size_t width, size_t indent)
{
    char copy[FOLDED];
    text rest, words;

    while (l->length > start && l->bytes[l->length - 1] == ' ')
        l->length--;
    rest.start = copy;
    rest.length = start < l->length ? l->length - start : 0;
    if (width && rest.length <= FOLDED) {
        memcpy(copy, l->bytes + start, rest.length);
        l->length -= rest.length;
        words = words_within(rest, width);
        while (words.length < rest.length) {
            line_text(l, words.start, words.length);
            line_text(l, "\n", 1);
            line_left(l, "", indent);
            rest = flk_text_trim(flk_text_from(rest, words.length));
            words = words_within(rest, width > indent ? width - indent : 1);
        }
        line_text(l, words.start, words.length);
    }
    line_text(l, "\n", 1);
}
