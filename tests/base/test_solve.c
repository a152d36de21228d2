/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_solve.c - zeros of functions whose zeros are known.
*/
#include "check.h"

#include "base/solve.h"

static int calls;

/* Dottie's number, where cos x = x: 0.739085133215160641655 (OEIS A003957) */
static double dottie(double x, void *data)
{
    (void)data;
    calls++;
    return cos(x) - x;
}

/* Almost level on one side of its zero, steep on the other. */
typedef struct steep {
    double zero, rate;
} steep;

static double rise(double x, void *data)
{
    const steep *s = data;

    calls++;
    return expm1(s->rate * (x - s->zero));
}

/* Only the sign is known. */
static double sign(double x, void *data)
{
    calls++;
    return x < *(double *)data ? -INFINITY : INFINITY;
}

static double left(double x, void *data)
{
    calls++;
    return x > *(double *)data ? NAN : x - 2;
}

TEST(test_smooth)
{
    flk_bracket b = flk_bracket_of(0, 1, dottie(0, NULL), dottie(1, NULL));

    calls = 0;
    assert_near(flk_find_zero(dottie, NULL, &b, 0), 0.739085133215160641655, 2e-16);
    assert_true(calls < 12);
    b = flk_bracket_of(0, 1, 1, cos(1) - 1);
    assert_near(flk_find_zero(dottie, NULL, &b, 1e-3), 0.739085133215160641655, 1e-3);
}

TEST(test_many)
{
    uint64_t seed = 3;
    int i, most = 0;

    for (i = 0; i < 2000; i++) {
        double low = uniform(&seed, -10, 10), high = low + pow(10, uniform(&seed, -6, 3));
        double zero = uniform(&seed, low, high), found;
        steep s = {zero, uniform(&seed, -30, 30) / (high - low)};
        flk_bracket b = flk_bracket_of(low, high, rise(low, &s), rise(high, &s));

        calls = 0;
        found = flk_find_zero(rise, &s, &b, 0);
        most = calls > most ? calls : most;
        assert_near(found, zero, 1e-14 * (fabs(low) + fabs(high) + high - low));
        b = flk_bracket_of(low, high, -INFINITY, INFINITY);
        found = flk_find_zero(sign, &zero, &b, 0);
        assert_near(found, zero, 1e-14 * (fabs(low) + fabs(high)));
        assert_true(b.low < zero && zero <= b.high); /* the bracket keeps both answers */
        b = flk_bracket_of(low, high, INFINITY, -INFINITY);
        assert_true(flk_bracket_next(&b) == 0.5 * (low + high));
    }
    assert_true(most < 60);
}

TEST(test_unknown)
{
    double end = 1.5;
    flk_bracket b = flk_bracket_of(0, 4, -2, 2);

    calls = 0;
    flk_find_zero(left, &end, &b, 0);
    assert_int_equal(calls, 1); /* NaN ends the search */
    assert_true(b.low == 0 && b.high == 4);
}

int main(void)
{
    return run_all_tests(NULL);
}
