/* SPDX-License-Identifier: GPL-3.0-or-later
**
** number.c - numbers from the text of a deck, and into its messages.
*/
#include <math.h>
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
    if (head.length > strlen(word) && flk_text_is_word(head.start[strlen(word)]))
        return 0;
    if (head.length > strlen(word))
        head.length = strlen(word);
    return flk_text_equal(head, word);
}

/* Beyond this an exponent gives 0 or infinity, whatever the digits before it. */
#define EXPONENT_MAX 100000

/* The exponent at the front of a text, within +-EXPONENT_MAX. */
static long read_exponent(const char *s, const char *end)
{
    int negative = *s == '-';
    long exponent = 0;

    if (*s == '-' || *s == '+')
        s++;
    for (; s < end && exponent < EXPONENT_MAX; s++)
        exponent = 10 * exponent + (*s - '0');
    return negative ? -exponent : exponent;
}

/* Write a whole number; returns where it ends. */
static char *write_whole(long value, char *out)
{
    char digits[24];
    int n = 0;

    if (value < 0)
        *out++ = '-';
    value = value < 0 ? -value : value;
    do
        digits[n++] = (char)('0' + value % 10);
    while ((value /= 10) > 0);
    while (n > 0)
        *out++ = digits[--n];
    *out = '\0';
    return out;
}

/* strtod rounds correctly but looks for the decimal mark of the host's locale, so it is given a whole
** number and an exponent: 12.5e3 as 125e2. */
number_status flk_number_read(text *rest, double *value)
{
    char copy[NUMBER_SIZE], *end = copy;
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
        exponent += read_exponent(s + i + 1, s + n);
    *end++ = 'e';
    write_whole(exponent, end);
    result = strtod(copy, NULL);
    if (result - result != 0)
        return NUMBER_NOT_FINITE;
    *value = result;
    rest->start += n;
    rest->length -= n;
    return NUMBER_OK;
}

char *flk_number_write(double value, int digits, char out[NUMBER_SIZE])
{
    char figures[32], *end = out;
    int exponent, n, i, point;
    double scaled;

    if (fabs(value) < 1e-290) /* whose scale below would be infinite */
        return strcpy(out, "0");
    if (value < 0)
        *end++ = '-';
    value = fabs(value);
    exponent = (int)floor(log10(value));
    scaled = floor(value * pow(10, digits - 1 - exponent) + 0.5);
    if (scaled >= pow(10, digits)) {
        scaled /= 10;
        exponent++;
    }
    n = (int)(write_whole((long)scaled, figures) - figures);
    while (n > 1 && figures[n - 1] == '0')
        n--;
    point = -4 <= exponent && exponent < digits ? exponent + 1 : 1;
    if (point <= 0) {
        *end++ = '0';
        *end++ = '.';
    }
    for (i = point; i < 0; i++)
        *end++ = '0';
    for (i = 0; i < n || i < point; i++) {
        if (i > 0 && i == point)
            *end++ = '.';
        *end++ = i < n ? figures[i] : '0';
    }
    *end = '\0';
    if (exponent < -4 || exponent >= digits) {
        *end++ = 'e';
        write_whole(exponent, end);
    }
    return out;
}
