/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spelling.c - values as people type them, rewritten in the plain characters of a deck.
*/
#include <string.h>

#include "spelling.h"

/* In UTF-8: minus, hyphens, and the dash that word processors put for a hyphen; the degree sign, and the
** ordinal beside it on keyboards; dots, cross.  Some instruments write the degree sign in Latin-1. */
static const struct {
    const char *typed, *plain;
} signs[] = {{"\342\210\222", "-"}, {"\342\200\220", "-"}, {"\342\200\221", "-"},
             {"\342\200\223", "-"}, {"\302\260", "deg"},   {"\302\272", "deg"},
             {"\260", "deg"},       {"\302\267", "*"},     {"\342\213\205", "*"},
             {"\303\227", "*"},     {"\317\200", "pi"}};

static const struct {
    const char *typed;
    char plain;
} superscripts[] = {{"\302\271", '1'},     {"\302\262", '2'},     {"\302\263", '3'},
                    {"\342\201\260", '0'}, {"\342\201\264", '4'}, {"\342\201\265", '5'},
                    {"\342\201\266", '6'}, {"\342\201\267", '7'}, {"\342\201\270", '8'},
                    {"\342\201\271", '9'}, {"\342\201\273", '-'}};

static int is_decimal_digit(char c)
{
    return '0' <= c && c <= '9';
}

static int begins_with(text t, const char *word)
{
    size_t n = strlen(word);

    return t.length >= n && memcmp(t.start, word, n) == 0;
}

/* Take a superscript off the front of `t`; 0 if there is none. */
static char take_superscript(text *t)
{
    size_t i;

    for (i = 0; i < sizeof superscripts / sizeof superscripts[0]; i++)
        if (begins_with(*t, superscripts[i].typed)) {
            *t = flk_text_from(*t, strlen(superscripts[i].typed));
            return superscripts[i].plain;
        }
    return 0;
}

/* Take a sign off the front of `t` and write it.  Returns the end of what was written. */
static char *write_sign(text *t, const char *start, char *end)
{
    size_t i;

    for (i = 0; i < sizeof signs / sizeof signs[0]; i++)
        if (begins_with(*t, signs[i].typed)) {
            if (end > start && is_decimal_digit(end[-1]) && signs[i].plain[0] == 'd')
                *end++ = ' '; /* 20 deg */
            strcpy(end, signs[i].plain);
            *t = flk_text_from(*t, strlen(signs[i].typed));
            return end + strlen(end);
        }
    return end;
}

/* Take the next character off `t` and write it.  Returns the end of what was written. */
static char *write_next(text *t, const char *start, char *end)
{
    size_t blank = flk_text_blank(*t);
    char c = blank ? 0 : take_superscript(t), *after;

    if (blank) {
        *end++ = blank > 1 ? ' ' : *t->start;
        *t = flk_text_from(*t, blank);
        return end;
    }
    if (c) {
        for (*end++ = '^'; c; c = take_superscript(t))
            *end++ = c;
        return end;
    }
    after = write_sign(t, start, end);
    if (after == end)
        do { /* a whole character of UTF-8 */
            *after++ = *t->start;
            *t = flk_text_from(*t, 1);
        } while ((after[-1] & 0x80) && t->length && (*t->start & 0xc0) == 0x80);
    return after;
}

/* The exponent of the power of ten at the front of a text, such as * 10^3; null if there is none. */
static const char *exponent_after(const char *s)
{
    s += strspn(s, " ");
    if (*s++ != '*')
        return NULL;
    s += strspn(s, " ");
    if (strncmp(s, "10^", 3) != 0)
        return NULL;
    s += 3;
    return is_decimal_digit(*s) || ((*s == '-' || *s == '+') && is_decimal_digit(s[1])) ? s : NULL;
}

/* Rewrite powers of ten after digits as e3.  Returns the new length. */
static size_t write_powers(char *out)
{
    const char *from = out, *exponent;
    char *to = out;

    while (*from) {
        exponent =
            to > out && (is_decimal_digit(to[-1]) || to[-1] == '.') ? exponent_after(from) : NULL;
        if (exponent) {
            *to++ = 'e';
            from = exponent;
            *to++ = *from++; /* its sign, or first digit */
        } else {
            *to++ = *from++;
        }
    }
    *to = '\0';
    return (size_t)(to - out);
}

int flk_spelling_is_plain(text t)
{
    size_t i;

    for (i = 0; i < t.length; i++)
        if (t.start[i] & 0x80 || t.start[i] == '^')
            return 0;
    return 1;
}

text flk_spelling_plain(text t, char *out)
{
    char *end = out;

    while (t.length)
        end = write_next(&t, out, end);
    *end = '\0';
    t.start = out;
    t.length = write_powers(out);
    return t;
}
