/* SPDX-License-Identifier: GPL-3.0-or-later
**
** number.c - numbers from the text of a deck.
*/
#include <stdlib.h>
#include <string.h>

#include "number.h"

static int is_digit(int c)
{
    return '0' <= c && c <= '9';
}

/* The length of a decimal number at the front of t, 0 if there is none. */
static size_t scan(text t, size_t *point)
{
    const char *s = t.start;
    size_t i = 0, digits = 0, mark, n = t.length;

    *point = n;
    if (i < n && (s[i] == '+' || s[i] == '-'))
        i++;
    for (; i < n && is_digit(s[i]); i++)
        digits++;
    if (i < n && s[i] == '.') {
        *point = i;
        for (i++; i < n && is_digit(s[i]); i++)
            digits++;
    }
    if (!digits)
        return 0;
    mark = i;
    if (i < n && (s[i] == 'e' || s[i] == 'E')) {
        i++;
        if (i < n && (s[i] == '+' || s[i] == '-'))
            i++;
        if (i < n && is_digit(s[i])) {
            while (i < n && is_digit(s[i]))
                i++;
            mark = i;
        }
    }
    return mark;
}

/* 1 if the text starts with exactly this word, with or without a sign. */
static int starts_with(text t, const char *word)
{
    size_t n = strlen(word);

    if (t.length && (t.start[0] == '+' || t.start[0] == '-'))
        t = flk_text_from(t, 1);
    if (t.length > n && flk_text_is_word(t.start[n]))
        return 0;
    t.length = t.length < n ? t.length : n;
    return flk_text_equal(t, word);
}

/* A larger exponent gives 0 or infinity whatever the digits. */
#define EXPONENT_MAX 100000

/* The exponent at the front of a text, within +-EXPONENT_MAX. */
static long read_number_exponent(const char *s, const char *end)
{
    int negative = *s == '-';
    long exponent = 0;

    if (*s == '-' || *s == '+')
        s++;
    for (; s < end && exponent < EXPONENT_MAX; s++)
        exponent = 10 * exponent + (*s - '0');
    return negative ? -exponent : exponent;
}

/* A whole number of at most 15 digits and a power of ten up to 10^22 are doubles, so that their product
** or quotient, which is rounded once, is the number that is written (Clinger, "How to read floating
** point numbers accurately", 1990).  With registers of 80 bits it would be rounded twice. */
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ == 0
#define EXACT_DIGITS 15
#else
#define EXACT_DIGITS 0
#endif
#define EXACT_POWER 22

static const double power_of_ten[EXACT_POWER + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* The number with these digits, which may have a sign, times 10^exponent; 0 if it is not known exactly. */
static int read_exactly(const char *s, const char *end, long exponent, double *value)
{
    int negative = s < end && *s == '-';
    double whole = 0;

    if (s < end && (*s == '-' || *s == '+'))
        s++;
    while (s < end && *s == '0')
        s++;
    if (end - s > EXACT_DIGITS || exponent < -EXACT_POWER || exponent > EXACT_POWER)
        return 0;
    for (; s < end; s++)
        whole = 10 * whole + (*s - '0');
    whole = exponent < 0 ? whole / power_of_ten[-exponent] : whole * power_of_ten[exponent];
    *value = negative ? -whole : whole;
    return 1;
}

/* Otherwise strtod: it rounds correctly but expects the decimal mark of the host's locale, so it is
** given a whole number and an exponent: 12.5e3 as 125e2. */
number_status flk_number_read(text *rest, double *value)
{
    char copy[400], *end = copy;
    const char *s = rest->start;
    size_t n, point, i;
    long exponent = 0;
    double result;

    n = scan(*rest, &point);
    if (!n) {
        if (starts_with(*rest, "inf") || starts_with(*rest, "infinity") ||
            starts_with(*rest, "nan"))
            return NUMBER_NOT_FINITE;
        return NUMBER_NONE;
    }
    if (n < rest->length && (s[n] == 'x' || s[n] == 'X') && s[n - 1] == '0')
        return NUMBER_HEX;
    if (n + 1 < rest->length && s[n] == ',' && is_digit(s[n + 1]))
        return NUMBER_COMMA;
    if (n + 24 >= sizeof copy)
        return NUMBER_TOO_LONG;
    for (i = 0; i < n && s[i] != 'e' && s[i] != 'E'; i++)
        if (i != point) {
            *end++ = s[i];
            exponent -= i > point;
        }
    if (i < n)
        exponent += read_number_exponent(s + i + 1, s + n);
    if (!read_exactly(copy, end, exponent, &result)) {
        *end++ = 'e';
        flk_digits_short((double)exponent, 9, end);
        result = strtod(copy, NULL);
    }
    if (result - result != 0)
        return NUMBER_NOT_FINITE;
    *value = result;
    *rest = flk_text_from(*rest, n);
    return NUMBER_OK;
}

char *flk_number_shortest(double value, char out[DIGITS_SIZE])
{
    double same;
    int digits;

    for (digits = 15; digits <= 17; digits++) {
        text t = flk_text_of(flk_digits_short(value, digits, out));

        if (flk_number_read(&t, &same) == NUMBER_OK && same == value)
            break;
    }
    return out;
}
