/* SPDX-License-Identifier: GPL-3.0-or-later
**
** message.c - messages, and the mistakes of a deck.
*/
#include <stdlib.h>
#include <string.h>

#include "digits.h"
#include "message.h"

#define WORD_SIZE 64

/* A message being written. */
typedef struct writer {
    char *end;
    size_t room;
} writer;

static void put_piece(writer *w, text piece)
{
    size_t length = strlen(flk_text_copy(piece, w->end, w->room));

    w->end += length;
    w->room -= length;
}

static void put_string(writer *w, const char *string)
{
    put_piece(w, flk_text_of(string));
}

static void put_hint(writer *w, const char *nearest)
{
    if (nearest) {
        put_string(w, "; did you mean '");
        put_string(w, nearest);
        put_string(w, "'?");
    }
}

char *flk_message_list(char *out, size_t size, const char *format, va_list values)
{
    char copy[WORD_SIZE];
    writer w;

    w.end = out;
    w.room = size;
    *out = '\0';
    while (*format) {
        size_t plain = strcspn(format, "%");
        int digits = 9;
        text piece;

        piece.start = format;
        piece.length = plain;
        put_piece(&w, piece);
        format += plain;
        if (!*format++)
            return out;
        if (*format == '.') {
            digits = format[1] - '0';
            format += 2;
        }
        switch (*format++) {
        case 's':
            put_string(&w, va_arg(values, const char *));
            break;
        case 't':
            put_string(&w, flk_text_quote(va_arg(values, text), copy, sizeof copy));
            break;
        case 'l': /* %ld */
            put_string(&w, flk_digits_short((double)va_arg(values, long), digits, copy));
            format++;
            break;
        case 'g':
            put_string(&w, flk_digits_short(va_arg(values, double), digits, copy));
            break;
        case 'h':
            put_hint(&w, va_arg(values, const char *));
            break;
        default:
            put_string(&w, "%");
        }
    }
    return out;
}

char *flk_message(char *out, size_t size, const char *format, ...)
{
    va_list values;

    va_start(values, format);
    flk_message_list(out, size, format, values);
    va_end(values);
    return out;
}

int flk_mistake(mistakes *m, text_place place, const char *format, ...)
{
    struct mistake *new;
    va_list values;

    if (!m->list)
        m->list = malloc(MOST_MISTAKES * sizeof *m->list);
    if (!m->list || m->count == MOST_MISTAKES) {
        m->out_of_memory |= !m->list;
        m->left_out++;
        return 0;
    }
    new = &m->list[m->count++];
    new->place = place;
    va_start(values, format);
    flk_message_list(new->message, sizeof new->message, format, values);
    va_end(values);
    return 0;
}

size_t flk_mistakes_count(const mistakes *m)
{
    return m->count + m->left_out;
}

int flk_mistakes_are_full(const mistakes *m)
{
    return m->count == MOST_MISTAKES;
}

/* An insertion sort: the list is short, and mistakes on the same line keep their order. */
void flk_mistakes_sort(mistakes *m)
{
    size_t i, j;

    for (i = 1; i < m->count; i++)
        for (j = i; j > 0 && m->list[j].place.line < m->list[j - 1].place.line; j--) {
            struct mistake swap = m->list[j];

            m->list[j] = m->list[j - 1];
            m->list[j - 1] = swap;
        }
}

void flk_mistakes_free(mistakes *m)
{
    free(m->list);
    memset(m, 0, sizeof *m);
}
