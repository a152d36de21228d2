/* SPDX-License-Identifier: GPL-3.0-or-later
**
** format.c - numbers to text, the same in every locale and as printf in the C locale, but that 0 has no sign:
** printf does what digits.c leaves.
*/
#define __USE_MINGW_ANSI_STDIO 1 /* on Windows: all digits, and exponents of two */

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/digits.h"
#include "base/number.h"
#include "format.h"

/* Take the sign off a number that prints as 0; returns its end. */
static char *take_sign_off(char *out, char *end)
{
    const char *digit = out + 1;

    if (out[0] != '-')
        return end;
    while (*digit == '0' || *digit == '.')
        digit++;
    if (*digit && *digit != 'e')
        return end;
    memmove(out, out + 1, (size_t)(end - out));
    return end - 1;
}

/* What digits.c does not write is written by printf, with a point in place of the locale's decimal mark. */
static char *print(const char *format, double value, int digits, char *out)
{
    const char *decimal;
    char *mark;

    if (value != value) /* whatever its sign */
        return strcpy(out, "nan") + 3;
    if (value - value != 0)
        return value > 0 ? strcpy(out, "inf") + 3 : strcpy(out, "-inf") + 4;
    decimal = localeconv()->decimal_point;
    sprintf(out, format, digits, value);
    if (strcmp(decimal, ".") != 0 && (mark = strstr(out, decimal)) != NULL) {
        *mark = '.';
        memmove(mark + 1, mark + strlen(decimal), strlen(mark + strlen(decimal)) + 1);
    }
    return take_sign_off(out, out + strlen(out));
}

char *format_fixed_end(double value, int decimals, char out[FORMAT_SIZE])
{
    char *end = flk_digits_fixed(value, decimals, out);

    return end ? end : print("%.*f", value, decimals, out);
}

char *format_exponent_end(double value, int decimals, char out[FORMAT_SIZE])
{
    char *end = flk_digits_exponent(value, decimals, out);

    return end ? end : print("%.*e", value, decimals, out);
}

char *format_general_end(double value, int digits, char out[FORMAT_SIZE])
{
    char *end = flk_digits_general(value, digits, out);

    return end ? end : print("%.*g", value, digits, out);
}

char *format_shortest_end(double value, char out[FORMAT_SIZE])
{
    double same;
    char *end;
    text t;
    int digits = 15;

    do {
        end = format_general_end(value, digits, out);
        t.start = out;
        t.length = (size_t)(end - out);
    } while (digits++ < 17 && !(flk_number_read(&t, &same) == NUMBER_OK && same == value));
    return end;
}

double format_settled(double value, double size)
{
    return fabs(value) <= FORMAT_ROUNDING * fabs(size) ? 0 : value;
}

char *format_fixed(double value, int decimals, char out[FORMAT_SIZE])
{
    format_fixed_end(value, decimals, out);
    return out;
}

char *format_exponent(double value, int decimals, char out[FORMAT_SIZE])
{
    format_exponent_end(value, decimals, out);
    return out;
}

char *format_general(double value, int digits, char out[FORMAT_SIZE])
{
    format_general_end(value, digits, out);
    return out;
}
