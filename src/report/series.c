/* SPDX-License-Identifier: GPL-3.0-or-later
**
** series.c - numbers of all steps in few letters: how each differs from where the two before lead to.
*/
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_math.h>

#include "series.h"

#define DIGITS 6

void series_put_rounded(line *l, double x, double parts)
{
    line_number(l, floor(parts * x + 0.5) / parts, DIGITS);
}

static const char signs[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                            "!#$%'*+,-./:;=?@[]^_`{|}~ ";

#define SIGNS \
    88 /* of which the first 62 stand alone, the next 18 before one, and the others before two */

/* One sign from -30 to 31, two from -792 to 791, three from -30976 to 30975; others as (-40000). */
static void put_small(line *l, long n)
{
    if (n >= -30 && n < 32) {
        line_byte(l, signs[n + 30]);
    } else if (n >= -9 * SIGNS && n < 9 * SIGNS) {
        line_byte(l, signs[62 + (n + 9 * SIGNS) / SIGNS]);
        line_byte(l, signs[(n + 9 * SIGNS) % SIGNS]);
    } else if (n >= -4 * SIGNS * SIGNS && n < 4 * SIGNS * SIGNS) {
        n += 4 * SIGNS * SIGNS;
        line_byte(l, signs[80 + n / SIGNS / SIGNS]);
        line_byte(l, signs[n / SIGNS % SIGNS]);
        line_byte(l, signs[n % SIGNS]);
    } else {
        line_put(l, n < 0 ? "(-" : "(");
        line_put(l, "%lu)", (unsigned long)labs(n));
    }
}

void series_put(line *l, const double *x, size_t n, double parts)
{
    long here, last = 0, before = 0;
    size_t i, first = 0;

    while (first + 1 < n && gsl_isnan(x[first]))
        first++;
    line_byte(l, '"');
    for (i = 0; i < n; i++) {
        double now = i ? x[i] : x[first];

        here = gsl_isnan(now) ? last : (long)floor(parts * now + 0.5);
        put_small(l, here - (2 * last - before));
        before = i ? last : here;
        last = here;
    }
    line_byte(l, '"');
}

void series_put_or_one(line *l, const double *x, size_t n, double parts, double near)
{
    double first = GSL_NAN;
    size_t i;
    int varies = 0;

    for (i = 0; i < n; i++) {
        first = gsl_isnan(first) ? x[i] : first;
        varies |= fabs(x[i] - first) > near;
    }
    if (varies)
        series_put(l, x, n, parts);
    else
        series_put_rounded(l, first, 1e6);
}
