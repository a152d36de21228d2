/* SPDX-License-Identifier: GPL-3.0-or-later
**
** trig_trial.c [COUNT [SEED]] - sine, cosine, angle, arc sine, arc cosine and length of random arguments
** against MPFR's, with 200 bits: of all sizes up to 10^9, beside multiples of 90 deg and of 180 deg, of whole
** degrees, of unit vectors; sine and cosine up to 2^100 too. It prints the worst error of each in ulp, beyond 10^9 in parts
** of what is allowed there, and fails if one is beyond what trig.h says.
*/
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <gsl/gsl_math.h>
#include <mpfr.h>

#include "check.h"
#include "base/trig.h"

enum { SINE, COSINE, ANGLE, ARC_SINE, ARC_COSINE, LENGTH, LARGE_SINE, FUNCTIONS };

static const char *const names[FUNCTIONS] = {"sine",       "cosine", "angle",     "arc sine",
                                             "arc cosine", "length", "large sine"};
static const double most[FUNCTIONS] = {1, 1, 1, 3, 3, 1.5, 1};
static double worst[FUNCTIONS], at[FUNCTIONS];
static mpfr_t X, Y, exact, difference;

static void compare(int function, double argument, double value)
{
    int exponent;
    double error;

    mpfr_sub_d(difference, exact, value, MPFR_RNDN);
    frexp(mpfr_get_d(exact, MPFR_RNDN), &exponent);
    error = fabs(mpfr_get_d(difference, MPFR_RNDN));
    error = function == LARGE_SINE ? error / (1.2e-15 + 3e-32 * fabs(argument))
                                   : ldexp(error, 53 - exponent);
    if (!isnan(worst[function]) && !(error <= worst[function])) {
        worst[function] = error;
        at[function] = argument;
    }
}

static void try_sine(double x)
{
    double sine, cosine;

    flk_sine_cosine(x, &sine, &cosine);
    mpfr_set_d(X, x, MPFR_RNDN);
    mpfr_sin(exact, X, MPFR_RNDN);
    compare(fabs(x) > 1e9 ? LARGE_SINE : SINE, x, sine);
    mpfr_cos(exact, X, MPFR_RNDN);
    compare(fabs(x) > 1e9 ? LARGE_SINE : COSINE, x, cosine);
}

static void try_vector(double x, double y)
{
    mpfr_set_d(X, x, MPFR_RNDN);
    mpfr_set_d(Y, y, MPFR_RNDN);
    mpfr_atan2(exact, Y, X, MPFR_RNDN);
    compare(ANGLE, y / x, flk_angle(y, x));
    mpfr_hypot(exact, X, Y, MPFR_RNDN);
    compare(LENGTH, y / x, flk_length(x, y));
}

static void try_arc(double x)
{
    mpfr_set_d(X, x, MPFR_RNDN);
    mpfr_asin(exact, X, MPFR_RNDN);
    compare(ARC_SINE, x, flk_arc_sine(x));
    mpfr_acos(exact, X, MPFR_RNDN);
    compare(ARC_COSINE, x, flk_arc_cosine(x));
}

static double of_any_size(uint64_t *seed, double from, double to)
{
    return pow(2, uniform(seed, from, to)) * (uniform(seed, -1, 1) < 0 ? -1 : 1);
}

static void try_one(uint64_t *seed, long i)
{
    switch (i % 4) {
    case 0:
        try_sine(of_any_size(seed, -40, 29.8));
        try_vector(of_any_size(seed, -40, 40), of_any_size(seed, -40, 40));
        try_arc(uniform(seed, -1, 1));
        break;
    case 1: /* the double beside a multiple of 90 deg */
        try_sine(floor(of_any_size(seed, 0, 29)) * M_PI_2);
        try_vector(1, uniform(seed, -1.1, 1.1));
        try_arc(of_any_size(seed, -40, 0));
        break;
    case 2:
        try_sine(floor(uniform(seed, -1e5, 1e5)) * M_PI / 360);
        try_vector(cos(uniform(seed, 0, 7)), sin(uniform(seed, 0, 7)));
        try_arc(1 - fabs(of_any_size(seed, -52, -1)));
        break;
    default:
        try_sine(uniform(seed, -1e9, 1e9));
        try_sine(of_any_size(seed, 30, 100));
        try_vector(of_any_size(seed, -400, 400), of_any_size(seed, -400, 400));
        try_arc(cos(uniform(seed, 0, M_PI)));
    }
}

int main(int argc, char **argv)
{
    long n = argc > 1 ? atol(argv[1]) : 10000000, i;
    uint64_t seed = argc > 2 ? (uint64_t)atol(argv[2]) : 1;
    int k, failed = 0;

    mpfr_inits2(200, X, Y, exact, difference, (mpfr_ptr)0);
    for (i = 0; i < n; i++)
        try_one(&seed, i);
    mpfr_clears(X, Y, exact, difference, (mpfr_ptr)0);
    for (k = 0; k < FUNCTIONS; k++) {
        printf("%-10s %.3f ulp at %.17g, at most %g\n", names[k], worst[k], at[k], most[k]);
        failed += !(worst[k] <= most[k]);
    }
    printf("%ld passed, %d failed\n", FUNCTIONS * n, failed);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
