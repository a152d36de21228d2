/* SPDX-License-Identifier: GPL-3.0-or-later
**
** number.c - numbers to text and back, the same under every locale.
**
** The C library rounds correctly both ways but writes and expects the decimal mark of the host's
** locale, which is exchanged here for a point.
*/
#include <locale.h>
#include <stdio.h>
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

static int starts_with(text t, const char *word)
{
    text head = t;

    if (head.length && (head.start[0] == '+' || head.start[0] == '-')) {
        head.start++;
        head.length--;
    }
    if (head.length > strlen(word) && text_is_word(head.start[strlen(word)]))
        return 0;
    if (head.length > strlen(word))
        head.length = strlen(word);
    return text_equal(head, word);
}

number_status number_read(text *rest, double *value)
{
    char copy[NUMBER_SIZE];
    size_t point, n, mark;
    const char *decimal;
    double result;

    n = scan(*rest, &point);
    if (!n) {
        if (starts_with(*rest, "inf") || starts_with(*rest, "infinity") ||
            starts_with(*rest, "nan"))
            return NUMBER_NOT_FINITE;
        return NUMBER_NONE;
    }
    if (n < rest->length && (rest->start[n] == 'x' || rest->start[n] == 'X') &&
        rest->start[n - 1] == '0')
        return NUMBER_HEX;
    if (n + 1 < rest->length && rest->start[n] == ',' && is_digit(rest->start[n + 1]))
        return NUMBER_COMMA;
    decimal = localeconv()->decimal_point;
    mark = strlen(decimal);
    if (n + mark >= sizeof copy)
        return NUMBER_TOO_LONG;
    if (point < n) {
        memcpy(copy, rest->start, point);
        memcpy(copy + point, decimal, mark);
        memcpy(copy + point + mark, rest->start + point + 1, n - point - 1);
        copy[n + mark - 1] = '\0';
    } else {
        memcpy(copy, rest->start, n);
        copy[n] = '\0';
    }
    result = strtod(copy, NULL);
    if (result - result != 0)
        return NUMBER_NOT_FINITE;
    *value = result;
    rest->start += n;
    rest->length -= n;
    return NUMBER_OK;
}

/* Exchange the locale's decimal mark for a point. */
static char *with_point(char *out)
{
    const char *decimal = localeconv()->decimal_point;
    char *mark;

    if (strcmp(decimal, ".") != 0 && (mark = strstr(out, decimal)) != NULL) {
        *mark = '.';
        memmove(mark + 1, mark + strlen(decimal), strlen(mark + strlen(decimal)) + 1);
    }
    return out;
}

char *number_fixed(double value, int decimals, char out[NUMBER_SIZE])
{
    sprintf(out, "%.*f", decimals, value);
    return with_point(out);
}

char *number_exponent(double value, int decimals, char out[NUMBER_SIZE])
{
    sprintf(out, "%.*e", decimals, value);
    return with_point(out);
}

char *number_general(double value, int digits, char out[NUMBER_SIZE])
{
    sprintf(out, "%.*g", digits, value);
    return with_point(out);
}
