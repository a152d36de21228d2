/* SPDX-License-Identifier: GPL-3.0-or-later
**
** format.c - numbers to text, the same under every locale, and the same as printf's in the C locale:
** what digits.c leaves is for printf to do.
*/
#include <locale.h>
#include <stdio.h>
#include <string.h>

#include "digits.h"
#include "format.h"

/* Exchange the locale's decimal mark for a point; the end of the text. */
static char *with_point(char *out)
{
    const char *decimal = localeconv()->decimal_point;
    char *mark;

    if (strcmp(decimal, ".") != 0 && (mark = strstr(out, decimal)) != NULL) {
        *mark = '.';
        memmove(mark + 1, mark + strlen(decimal), strlen(mark + strlen(decimal)) + 1);
    }
    return out + strlen(out);
}

char *format_fixed_end(double value, int decimals, char out[FORMAT_SIZE])
{
    char *end = flk_digits_fixed(value, decimals, out);

    if (!end) {
        sprintf(out, "%.*f", decimals, value);
        end = with_point(out);
    }
    return end;
}

char *format_exponent_end(double value, int decimals, char out[FORMAT_SIZE])
{
    char *end = flk_digits_exponent(value, decimals, out);

    if (!end) {
        sprintf(out, "%.*e", decimals, value);
        end = with_point(out);
    }
    return end;
}

char *format_general_end(double value, int n, char out[FORMAT_SIZE])
{
    char *end = flk_digits_general(value, n, out);

    if (!end) {
        sprintf(out, "%.*g", n, value);
        end = with_point(out);
    }
    return end;
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
