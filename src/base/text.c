/* SPDX-License-Identifier: GPL-3.0-or-later
**
** text.c - pieces of text within a larger one.
*/
#include <stdarg.h>
#include <string.h>

#include "text.h"

text flk_text_of(const char *string)
{
    text t;

    t.start = string;
    t.length = strlen(string);
    return t;
}

/* In UTF-8: the no-break space U+00A0; U+2000 to U+200A, thin spaces among them; U+202F; U+205F; U+3000. */
size_t flk_text_blank(text t)
{
    const unsigned char *s = (const unsigned char *)t.start;

    if (t.length >= 1 && (s[0] == ' ' || s[0] == '\t' || s[0] == '\r'))
        return 1;
    if (t.length >= 2 && s[0] == 0xc2 && s[1] == 0xa0)
        return 2;
    if (t.length < 3)
        return 0;
    if (s[0] == 0xe2 && s[1] == 0x80 && ((0x80 <= s[2] && s[2] <= 0x8a) || s[2] == 0xaf))
        return 3;
    return (s[0] == 0xe2 && s[1] == 0x81 && s[2] == 0x9f) ||
                   (s[0] == 0xe3 && s[1] == 0x80 && s[2] == 0x80)
               ? 3
               : 0;
}

size_t flk_text_blank_before(text t)
{
    size_t n;

    for (n = 1; n <= 3 && n <= t.length; n++)
        if (flk_text_blank(flk_text_from(t, t.length - n)) == n)
            return n;
    return 0;
}

text flk_text_from(text t, size_t n)
{
    t.start += n;
    t.length -= n;
    return t;
}

text flk_text_trim(text t)
{
    size_t n;

    while ((n = flk_text_blank(t)) > 0)
        t = flk_text_from(t, n);
    while ((n = flk_text_blank_before(t)) > 0)
        t.length -= n;
    return t;
}

text flk_text_without_mark(text t)
{
    return t.length >= 3 && memcmp(t.start, "\357\273\277", 3) == 0 ? flk_text_from(t, 3) : t;
}

/* ASCII only: a deck is read the same way in every locale. */
static int lower(int c)
{
    return 'A' <= c && c <= 'Z' ? c - 'A' + 'a' : c;
}

int flk_text_is_word(int c)
{
    return ('a' <= lower(c) && lower(c) <= 'z') || ('0' <= c && c <= '9') || c == '_' || (c & 0x80);
}

int flk_text_equal(text t, const char *word)
{
    size_t i;

    for (i = 0; i < t.length; i++)
        if (word[i] == '\0' || lower(t.start[i]) != lower(word[i]))
            return 0;
    return word[i] == '\0';
}

int flk_text_ends_in(text t, const char *ending)
{
    size_t length = strlen(ending);

    return t.length > length && flk_text_equal(flk_text_from(t, t.length - length), ending);
}

int flk_text_same(text t, const char *word)
{
    size_t i;

    for (i = 0; i < t.length; i++)
        if (word[i] == '\0' || t.start[i] != word[i])
            return 0;
    return word[i] == '\0';
}

int flk_text_split(text *rest, int stop, text *piece)
{
    const char *end;

    if (!rest->start)
        return 0;
    end = memchr(rest->start, stop, rest->length);
    *piece = *rest;
    if (end)
        piece->length = (size_t)(end - rest->start);
    *rest = flk_text_from(*rest, piece->length + (end != NULL));
    if (!end)
        rest->start = NULL;
    return 1;
}

int flk_text_separator(text t)
{
    return memchr(t.start, ';', t.length) ? ';' : memchr(t.start, '\t', t.length) ? '\t' : ',';
}

/* The length up to the quote that ends a field in double quotes; 0 if the field has none, or if none ends
** it. */
static size_t length_of_quoted(text t, int separator)
{
    const char *end = NULL;
    text inside = t;

    while (flk_text_blank(inside) && inside.start[0] != separator)
        inside = flk_text_from(inside, flk_text_blank(inside));
    if (inside.length && inside.start[0] == '"')
        end = memchr(inside.start + 1, '"', inside.length - 1);
    return end ? (size_t)(end + 1 - t.start) : 0;
}

int flk_text_field(text *rest, int separator, text *field)
{
    size_t quoted = rest->start ? length_of_quoted(*rest, separator) : 0;
    text start = *rest;

    if (!rest->start)
        return 0;
    *rest = flk_text_from(*rest, quoted);
    flk_text_split(rest, separator, field);
    start.length = quoted + field->length;
    *field = flk_text_unquoted(flk_text_trim(start));
    return 1;
}

size_t flk_text_letter(text t)
{
    const unsigned char *c = (const unsigned char *)t.start;
    size_t n = !t.length     ? 0
               : c[0] < 0x80 ? 1
               : c[0] < 0xc2 ? 0
               : c[0] < 0xe0 ? 2
               : c[0] < 0xf0 ? 3
               : c[0] < 0xf5 ? 4
                             : 0,
           i;

    if (n > t.length)
        return 0;
    for (i = 1; i < n; i++)
        if ((c[i] & 0xc0) != 0x80)
            return 0;
    /* overlong forms, surrogates, numbers above U+10FFFF */
    if (n > 1 && ((c[0] == 0xe0 && c[1] < 0xa0) || (c[0] == 0xed && c[1] > 0x9f) ||
                  (c[0] == 0xf0 && c[1] < 0x90) || (c[0] == 0xf4 && c[1] > 0x8f)))
        return 0;
    return n;
}

size_t flk_text_printable(text t)
{
    const unsigned char *c = (const unsigned char *)t.start;
    size_t n = flk_text_letter(t);
    int is_control =
        (n == 1 && (c[0] < ' ' || c[0] == 0x7f)) || (n == 2 && c[0] == 0xc2 && c[1] < 0xa0);
    int is_none = n == 3 && c[0] == 0xef && c[1] == 0xbf && c[2] >= 0xbe; /* U+FFFE, U+FFFF */

    return is_control || is_none ? 0 : n;
}

int flk_text_line_end(text t)
{
    return t.length && !memchr(t.start, '\n', t.length) && memchr(t.start, '\r', t.length) ? '\r'
                                                                                           : '\n';
}

size_t flk_text_count(text t, int c)
{
    size_t i, n = 0;

    for (i = 0; i < t.length; i++)
        n += t.start[i] == c;
    return n;
}

text flk_text_unquoted(text t)
{
    if (t.length >= 2 && t.start[0] == '"' && t.start[t.length - 1] == '"') {
        t = flk_text_from(t, 1);
        t.length--;
    }
    return t;
}

/* A tab counts as a blank. */
static int is_at(text t, size_t i, const char *separator)
{
    for (; *separator; separator++, i++)
        if (t.start[i] != *separator && !(t.start[i] == '\t' && *separator == ' '))
            return 0;
    return 1;
}

static int cut(text t, const char *separator, int at_last, text *before, text *after)
{
    size_t n = strlen(separator), i;

    for (i = 0; i + n <= t.length; i++) {
        size_t at = at_last ? t.length - n - i : i;

        if (is_at(t, at, separator)) {
            *after = flk_text_trim(flk_text_from(t, at + n));
            t.length = at;
            *before = flk_text_trim(t);
            return 1;
        }
    }
    return 0;
}

int flk_text_cut(text t, const char *separator, text *before, text *after)
{
    return cut(t, separator, 0, before, after);
}

int flk_text_cut_last(text t, const char *separator, text *before, text *after)
{
    return cut(t, separator, 1, before, after);
}

int flk_text_range(text t, text *low, text *high)
{
    return flk_text_cut(t, " to ", low, high) || flk_text_cut(t, "..", low, high);
}

char *flk_text_copy(text t, char *out, size_t size)
{
    size_t i, n = t.length < size ? t.length : size - 1;

    for (i = 0; i < n; i++) {
        unsigned char c = (unsigned char)t.start[i];

        out[i] = (char)(c < ' ' || c == 0x7f ? '?' : c);
    }
    out[n] = '\0';
    if (n < t.length && size > 4) {
        while (n > size - 4 || (n > 0 && (out[n] & 0xc0) == 0x80))
            n--; /* do not cut a UTF-8 character */
        strcpy(out + n, "...");
    }
    return out;
}

char *flk_text_quote(text t, char *out, size_t size)
{
    size_t i;

    flk_text_copy(t, out, size);
    for (i = 0; out[i]; i++)
        if (out[i] == '?' && t.start[i] == '\t')
            out[i] = ' ';
    return out;
}

#define WORD_MAX 32

/* The number of edits between two words: letters inserted, left out or replaced, neighbours swapped (the
** restricted Damerau-Levenshtein distance). */
static size_t distance(text t, const char *word)
{
    size_t row[3][WORD_MAX + 1], n = strlen(word), i, j;

    if (t.length > WORD_MAX || n > WORD_MAX)
        return WORD_MAX;
    for (j = 0; j <= n; j++)
        row[0][j] = j;
    for (i = 1; i <= t.length; i++) {
        size_t *now = row[i % 3], *last = row[(i + 2) % 3], *before = row[(i + 1) % 3];

        now[0] = i;
        for (j = 1; j <= n; j++) {
            size_t best = last[j - 1] + (lower(t.start[i - 1]) != lower(word[j - 1]));

            if (last[j] + 1 < best)
                best = last[j] + 1;
            if (now[j - 1] + 1 < best)
                best = now[j - 1] + 1;
            if (i > 1 && j > 1 && lower(t.start[i - 1]) == lower(word[j - 2]) &&
                lower(t.start[i - 2]) == lower(word[j - 1]) && before[j - 2] + 1 < best)
                best = before[j - 2] + 1;
            now[j] = best;
        }
    }
    return row[t.length % 3][n];
}

const char *flk_text_nearest(text t, const char *const *words)
{
    const char *nearest = NULL;
    size_t best = t.length <= 3 ? 2 : t.length / 3 + 2;

    for (; *words; words++) {
        size_t n = strlen(*words), d;

        /* at least this many letters are inserted or left out */
        if ((n > t.length ? n - t.length : t.length - n) >= best)
            continue;
        d = distance(t, *words);
        if (d < best && d < n) {
            best = d;
            nearest = *words;
        }
    }
    return nearest;
}

char *flk_text_join(char *out, size_t size, ...)
{
    const char *piece;
    size_t used = 0;
    va_list pieces;

    out[0] = '\0';
    va_start(pieces, size);
    while ((piece = va_arg(pieces, const char *)) != NULL) {
        flk_text_copy(flk_text_of(piece), out + used, size - used);
        used += strlen(out + used);
    }
    va_end(pieces);
    return out;
}

char *flk_text_list(const char *const *words, const char *between, const char *last, char *out,
                    size_t size)
{
    size_t length;

    for (out[0] = '\0'; *words; words++) {
        length = strlen(out);
        flk_text_join(out + length, size - length,
                      !length    ? ""
                      : words[1] ? between
                                 : last,
                      *words, (char *)NULL);
    }
    return out;
}

const char *flk_text_article(const char *words)
{
    return strchr("aeiou", words[0]) ? "an" : "a";
}
