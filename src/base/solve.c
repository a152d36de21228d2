/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solve.c - zeros of a function of one variable, by false position that halves the value of an end which stays (the
** Illinois method; M. Dowell, P. Jarratt, A modified regula falsi method, BIT 11, 1971, p. 168), and by bisection where
** only the sign of the function is known.
*/
#include <float.h>
#include <math.h>

#include <gsl/gsl_math.h>

#include "solve.h"

#define ITERATIONS 200

flk_bracket flk_bracket_of(double low, double high, double f_low, double f_high)
{
    flk_bracket b;

    b.low = low;
    b.high = high;
    b.f_low = f_low;
    b.f_high = f_high;
    b.side = 0;
    return b;
}

/* x = a - f(a) (b - a) / (f(b) - f(a)) */
double flk_bracket_next(const flk_bracket *b)
{
    return gsl_finite(b->f_low) && gsl_finite(b->f_high)
               ? b->low - b->f_low * (b->high - b->low) / (b->f_high - b->f_low)
               : 0.5 * (b->low + b->high);
}

void flk_bracket_take(flk_bracket *b, double x, double f, int is_rising)
{
    if ((f < 0) == is_rising) {
        b->low = x;
        b->f_low = f;
        b->f_high *= b->side == -1 ? 0.5 : 1;
        b->side = gsl_finite(f) ? -1 : 0;
    } else {
        b->high = x;
        b->f_high = f;
        b->f_low *= b->side == 1 ? 0.5 : 1;
        b->side = gsl_finite(f) ? 1 : 0;
    }
}

/* Beside an end, where false position does not leave it: the zero is there to rounding, or the function is steep. */
static double beside_end(const flk_bracket *b, double next)
{
    double little = DBL_EPSILON * GSL_MAX_DBL(fabs(b->low), fabs(b->high));

    return next > b->low ? b->high - little : b->low + little;
}

double flk_find_zero(double (*f)(double x, void *data), void *data, flk_bracket *b, double close)
{
    double x = fabs(b->f_low) < fabs(b->f_high) ? b->low : b->high, value;
    int is_rising = b->f_low < 0, is_beside = 0, k;

    for (k = 0; k < ITERATIONS && b->high - b->low > DBL_EPSILON * fabs(b->high); k++) {
        double next = is_beside ? 0.5 * (b->low + b->high) : flk_bracket_next(b);

        is_beside = !(next > b->low && next < b->high);
        if (is_beside)
            next = beside_end(b, next);
        if (!(next > b->low && next < b->high))
            break;
        x = next;
        value = f(x, data);
        if (gsl_isnan(value) || fabs(value) <= close)
            break;
        flk_bracket_take(b, x, value, is_rising);
    }
    return x;
}
