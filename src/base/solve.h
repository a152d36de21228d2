/* SPDX-License-Identifier: GPL-3.0-or-later
**
** solve.h - zeros, peaks and integrals of a function of one variable.
*/
#ifndef FOURLINK_SOLVE_H
#define FOURLINK_SOLVE_H

#include "arithmetic.h"

typedef double flk_function(double x, void *data);

/* Two places, low < high, with values of opposite signs; one of them may be 0.  An infinite value has a sign,
** but no size. */
typedef struct flk_bracket {
    double low, high, f_low, f_high;
    int side; /* which end the last value replaced: -1 low, 1 high, 0 none, or an infinite value */
} flk_bracket;

/* A bracket.  For an end whose value is unknown, f_low is infinity, or f_high is minus infinity. */
flk_bracket flk_bracket_of(double low, double high, double f_low, double f_high);

/* The next place to evaluate: by false position, or the middle if a value is infinite. */
double flk_bracket_next(const flk_bracket *b);

/* Replace the end whose value has the same sign.  `is_rising`: the value at `low` is the negative one. */
void flk_bracket_take(flk_bracket *b, double x, double f, int is_rising);

/* A zero in a bracket, down to rounding, or a place where |f| <= close: the last place evaluated.  The
** bracket shrinks around it, unless f is 0 at one of its ends.  NaN ends the search. */
double flk_find_zero(flk_function *f, void *data, flk_bracket *b, double close);

/* A search for the zero of an increasing function. */
typedef struct flk_rising {
    double x;       /* a guess; then the place evaluated last, */
    double slope;   /* ... and the slope of the function there, > 0 */
    double longest; /* of the first step */
} flk_rising;

/* Search by the secant method; where it fails, by longer and longer steps, then in the bracket.  The
** search ends where |f| and the step are at most `close`, or where neither is above `rounded` and steps do
** not become shorter, or in a bracket as narrow as `close`, over which |f| jumps by rounding, to no more than
** `rounded`.  The function may be infinite.  0 if there is no zero: it is infinite on one side.  NaN ends the
** search, with 0. */
int flk_find_rising(flk_function *f, void *data, flk_rising *r, double close, double rounded);

/* A place and the value there. */
typedef struct flk_sample {
    double x, value;
} flk_sample;

/* The largest value between p[0] and p[2], searched for from p[1], the best of the three.  The search ends
** where values of a smooth function differ by no more than about `close`, and at an infinite value.  NaN
** counts as less than any number. */
flk_sample flk_find_peak(flk_function *f, void *data, const flk_sample p[3], double close);

/* Integrate a function that is as smooth as a polynomial of degree 9, such as within a step of an integration
** of order 8. */
double flk_integrate_smooth(flk_function *f, void *data, double from, double to);

/* The values of several functions at one place. */
#define FLK_INTEGRALS 3
typedef void flk_functions(double x, void *data, double y[FLK_INTEGRALS]);

/* An integral; what coarser rules with the same points differ by, which for a smooth function is far
** more than the error, and at a corner that is not beside an end at least a quarter of it; and the
** integral of the magnitude. */
typedef struct flk_integral {
    double value, error, size;
} flk_integral;

/* Integrate n functions by one rule of 15 points, none of them at an end. */
void flk_integrate(flk_functions *f, void *data, int n, double from, double to, flk_integral *of);

/* The limit of a sequence of n numbers, n odd, whose distances from it are a sum of geometric sequences,
** exactly of (n - 1) / 2 of these; the numbers are overwritten. */
double flk_limit_of_sequence(double *of, int n);

#endif
