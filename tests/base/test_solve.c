/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_solve.c - functions whose zeros, peaks and integrals are known.
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

/* A zero at an end is found there, whether the function rises or falls. */
TEST(test_zero_at_end)
{
    uint64_t seed = 8;
    int i;

    for (i = 0; i < 1000; i++) {
        double low = uniform(&seed, -10, 10), high = low + pow(10, uniform(&seed, -6, 3));
        steep s = {i % 2 ? low : high, uniform(&seed, -30, 30) / (high - low)};
        flk_bracket b = flk_bracket_of(low, high, rise(low, &s), rise(high, &s));

        assert_true(flk_find_zero(rise, &s, &b, 0) == s.zero);
    }
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

/* -infinity below a place, as where a crank stalls; then it rises from a value. */
typedef struct cliff {
    double edge, value;
} cliff;

static double from_cliff(double x, void *data)
{
    const cliff *c = data;

    calls++;
    return x < c->edge ? -INFINITY : c->value + x - c->edge;
}

TEST(test_rising)
{
    uint64_t seed = 5;
    int i, most = 0;

    for (i = 0; i < 2000; i++) {
        steep s = {uniform(&seed, -10, 10), pow(10, uniform(&seed, -2, 0))};
        cliff c = {uniform(&seed, -10, 10), -uniform(&seed, 1e-3, 2)};
        flk_rising r = {0, 0, 0.3};

        r.x = s.zero + uniform(&seed, -20, 20);
        r.slope = pow(10, uniform(&seed, -2, 2));
        calls = 0;
        assert_int_equal(flk_find_rising(rise, &s, &r, 1e-12, 0), 1);
        most = calls > most ? calls : most;
        assert_near(r.x, s.zero, 1e-11 / s.rate);
        r.x = uniform(&seed, -20, 20);
        r.slope = 1;
        assert_int_equal(flk_find_rising(from_cliff, &c, &r, 1e-12, 1e-9), 1);
        assert_near(r.x, c.edge - c.value, 1e-11);
        c.value = -c.value; /* it jumps over zero */
        assert_int_equal(flk_find_rising(from_cliff, &c, &r, 1e-12, 1e-9), 0);
    }
    assert_true(most < 100);
}

/* Nearly level, and by rounding it jumps at the zero, as the energy after a cycle of a machine that hardly settles. */
static double over_step(double x, void *data)
{
    const cliff *c = data;

    return 1e-6 * (x - c->edge) + (x < c->edge ? -c->value : c->value);
}

TEST(test_rising_over_rounding)
{
    uint64_t seed = 6;
    int i;

    for (i = 0; i < 2000; i++) {
        cliff c = {uniform(&seed, -10, 10), pow(10, uniform(&seed, -11, -9.1))};
        flk_rising r = {0, 1, 0.3};

        r.x = c.edge + uniform(&seed, -1, 1);
        assert_int_equal(flk_find_rising(over_step, &c, &r, 1e-12, 1e-9), 1);
        assert_near(r.x, c.edge, 1e-10);
        c.value = 2e-9; /* a jump that is none of rounding */
        r.x = c.edge + uniform(&seed, -1, 1);
        assert_int_equal(flk_find_rising(over_step, &c, &r, 1e-12, 1e-9), 0);
    }
}

TEST(test_rising_to_unknown)
{
    flk_rising r = {0, 1, 10};
    double end = 1.5;

    calls = 0;
    assert_int_equal(flk_find_rising(left, &end, &r, 0, 0), 0);
    assert_int_equal(calls, 2);
}

/* ---------------------------------------------------------------------------------------------- peaks */

/* A peak of the height 1 whose sides differ: 1 - u + log(u) has its largest value, 0, at u = 1. */
typedef struct hill {
    double top, width;
} hill;

static double height(double x, void *data)
{
    const hill *h = data;
    double u = 1 + (x - h->top) / h->width;

    calls++;
    return u > 0 ? 2 - u + log(u) : -INFINITY;
}

/* Two straight sides, one three times as steep. */
static double corner(double x, void *data)
{
    const hill *h = data;

    calls++;
    return x < h->top ? x - h->top : 3 * (h->top - x);
}

static double same(double x, void *data)
{
    (void)x;
    (void)data;
    calls++;
    return 7;
}

/* It rises, and is not defined beyond a place. */
static double half_known(double x, void *data)
{
    calls++;
    return x > *(double *)data ? NAN : x;
}

static double falling(double x, void *data)
{
    (void)data;
    calls++;
    return -x;
}

/* Infinite over a stretch. */
static double unbounded(double x, void *data)
{
    (void)data;
    calls++;
    return fabs(x - 0.6) < 0.3 ? INFINITY : x;
}

/* Search from a place between two others; the values there are those of the function. */
static flk_sample peak_of(flk_function *f, void *data, double low, double x, double high,
                          double close)
{
    flk_sample p[3] = {{low, f(low, data)}, {x, f(x, data)}, {high, f(high, data)}}, found;

    calls = 0;
    found = flk_find_peak(f, data, p, close);
    assert_true(low <= found.x && found.x <= high);
    assert_true(found.value >= p[1].value);
    return found;
}

TEST(test_peak)
{
    uint64_t seed = 5;
    int i, most = 0, most_close = 0, n = 0;

    for (i = 0; i < 2000; i++) {
        double low = uniform(&seed, -10, 10), length = pow(10, uniform(&seed, -6, 3));
        double x = low + uniform(&seed, 0.1, 0.9) * length, high = low + length;
        /* so narrow that one side is a cliff, up to a parabola that the samples hardly show */
        hill h = {x, length * pow(10, uniform(&seed, -2, 2))};
        flk_sample found;

        h.top += 0.05 * uniform(&seed, -1, 1) * fmin(h.width, length);
        if (height(low, &h) > height(x, &h) || height(high, &h) > height(x, &h))
            continue;
        n++;
        found = peak_of(height, &h, low, x, high, 0);
        most = calls > most ? calls : most;
        assert_near(found.x, h.top, 3e-7 * (h.width + length));
        assert_near(found.value, 1, 2e-14);
        assert_true(found.value == height(found.x, &h));
        found = peak_of(height, &h, low, x, high, 1e-9);
        most_close = calls > most_close ? calls : most_close;
        assert_near(found.value, 1, 1e-8);
    }
    assert_true(n > 1000 && most < 50 && most_close < 30);
}

/* Parabolas take no more than a few calls where the function is one. */
TEST(test_few_calls)
{
    hill h = {0.1, 1000};

    assert_near(peak_of(height, &h, -1, 0, 1, 1e-12).x, 0.1, 1e-6 * h.width);
    assert_true(calls <= 4);
}

TEST(test_corner)
{
    uint64_t seed = 7;
    int i;

    for (i = 0; i < 2000; i++) {
        hill h = {uniform(&seed, -0.9, 0.9), 0};
        double x = i % 2 ? h.top + uniform(&seed, -0.03, 0.03) : h.top / 2;

        assert_near(peak_of(corner, &h, -1, x, 1, 1e-14).x, h.top, 3e-8);
        assert_true(calls < 90);
    }
}

/* The function rises up to an end, where it is not known; or the search begins at that end. */
TEST(test_peak_at_end)
{
    flk_sample p[3] = {{2, -INFINITY}, {3, -3}, {6, -6}}, found;

    calls = 0;
    assert_near(flk_find_peak(falling, NULL, p, 0).x, 2, 1e-7);
    assert_true(calls < 150);
    found = peak_of(falling, NULL, 2, 2, 6, 0);
    assert_true(found.x == 2 && found.value == -2);
    assert_true(calls < 10);
    found = peak_of(height, &(hill){2.01, 0.1}, 2, 2, 6, 0); /* it is close to it */
    assert_near(found.x, 2.01, 1e-7);
    assert_true(calls < 50);
}

TEST(test_peak_beside_unknown)
{
    double edge = 1.5;
    flk_sample found = peak_of(half_known, &edge, 0, 1, 4, 0), unknown[3];

    assert_near(found.x, 1.5, 1e-7);
    assert_true(calls < 90);
    edge = 0.25; /* the place where it begins and all below it are known */
    found = peak_of(half_known, &edge, -4, 0.25, 4, 0);
    assert_true(found.x == 0.25 && found.value == 0.25);
    memset(unknown, 0, sizeof unknown);
    unknown[0].value = unknown[2].value = -INFINITY; /* ends that are not known */
    unknown[2].x = 2;
    unknown[1].x = 1;
    unknown[1].value = 1;
    edge = 1.5;
    assert_near(flk_find_peak(half_known, &edge, unknown, 0).x, 1.5, 1e-7);
}

TEST(test_flat)
{
    flk_sample found = peak_of(same, NULL, 0, 0.3, 1, 0);

    assert_true(found.x == 0.3 && found.value == 7);
    assert_true(calls <= 2);
}

TEST(test_infinite)
{
    flk_sample found = peak_of(unbounded, NULL, 0, 0.2, 1, 0);

    assert_true(isinf(found.value) && fabs(found.x - 0.6) < 0.3);
    assert_int_equal(calls, 1); /* an infinite value ends the search */
}

/* ------------------------------------------------------------------------------------------ integrals */

/* Powers of x whose exponents are given. */
static void powers(double x, void *data, double *y)
{
    const int *exponent = data;
    int i;

    calls++;
    for (i = 0; i < FLK_INTEGRALS; i++)
        y[i] = pow(x, exponent[i]);
}

/* exp(-x), cos(x), 1 / (1 + x^2) */
static void known(double x, void *data, double *y)
{
    (void)data;
    y[0] = exp(-x);
    y[1] = cos(x);
    y[2] = 1 / (1 + x * x);
}

static void corner_at(double x, void *data, double *y)
{
    *y = fabs(x - *(double *)data);
}

/* 1 / sqrt(x), -log(x), and a corner at 0.3 */
static void rough(double x, void *data, double *y)
{
    (void)data;
    y[0] = 1 / sqrt(x);
    y[1] = -log(x);
    y[2] = fabs(x - 0.3);
}

static void known_above(double x, void *data, double *y)
{
    *y = x < *(double *)data ? NAN : x;
}

/* A rule of 15 points that contains Gauss's of 7 is exact up to x^22 (23 by symmetry), Gauss's own up to
** x^13, and the odd one that is 0 up to x^12. */
TEST(test_degree)
{
    flk_integral of[FLK_INTEGRALS];
    int n;

    for (n = 0; n < 30; n++) {
        int exponent[FLK_INTEGRALS] = {n, n + 1, 2};
        double exact = (pow(2, n + 1) - pow(-1, n + 1)) / (n + 1);

        calls = 0;
        flk_integrate(powers, exponent, FLK_INTEGRALS, -1, 2, of);
        assert_int_equal(calls, 15);
        if (n <= 22)
            assert_near(of[0].value, exact, 4e-15 * of[0].size);
        else if (n >= 24)
            assert_true(fabs(of[0].value - exact) > 1e-14 * of[0].size);
        if (n <= 12)
            assert_near(of[0].error, 0, 4e-15 * of[0].size);
        else
            assert_true(of[0].error > 1e-8 * of[0].size);
        assert_near(of[2].value, 3, 1e-14);
    }
}

static double power(double x, void *exponent)
{
    return pow(x, *(int *)exponent);
}

static double sine(double x, void *unused)
{
    (void)unused;
    return sin(x);
}

/* Five points are exact up to the ninth power, and not beyond; of short steps of a smooth function. */
TEST(test_smooth_integrals)
{
    uint64_t seed = 23;
    int n, i;

    for (n = 0; n <= 12; n++) {
        double exact = (pow(2, n + 1) - pow(-1, n + 1)) / (n + 1);
        double error = fabs(flk_integrate_smooth(power, &n, -1, 2) - exact);

        assert_true(n <= 9 ? error < 4e-15 * (pow(2, n + 1) + 1) : error > 1e-6 * exact);
    }
    for (i = 0; i < 1000; i++) {
        double from = uniform(&seed, -9, 9), to = from + uniform(&seed, -0.5, 0.5);

        assert_near(flk_integrate_smooth(sine, NULL, from, to), cos(from) - cos(to), 1e-14);
    }
}

TEST(test_known_integrals)
{
    flk_integral of[FLK_INTEGRALS], back;
    uint64_t seed = 11;
    int i, k;

    for (i = 0; i < 500; i++) {
        double from = uniform(&seed, -2, 2), to = from + uniform(&seed, -1, 1);
        double exact[FLK_INTEGRALS] = {exp(-from) - exp(-to), sin(to) - sin(from),
                                       atan(to) - atan(from)};

        flk_integrate(known, NULL, FLK_INTEGRALS, from, to, of);
        for (k = 0; k < FLK_INTEGRALS; k++) {
            assert_near(of[k].value, exact[k], k == 2 ? 1e-12 : 1e-15 * 8);
            assert_true(of[k].error >= 0 && of[k].error < 1e-6);
            assert_true(of[k].size >= fabs(of[k].value) * (1 - 1e-15));
        }
        assert_near(of[0].size, fabs(exact[0]), 1e-14); /* of one sign */
        flk_integrate(known, NULL, 1, to, from, &back);
        assert_near(back.value, -of[0].value, 1e-15 * 8);
        assert_near(back.size, of[0].size, 1e-15 * 8);
    }
    flk_integrate(known, NULL, 2, 0, 3.14159265358979323846, of);
    assert_near(of[1].value, 0, 1e-15);
    assert_near(of[1].size, 2, 0.03); /* of both signs */
}

/* The error at a corner is known, wherever it is, but beside an end. */
TEST(test_corners)
{
    uint64_t seed = 12;
    flk_integral of;
    int i;

    for (i = 0; i < 100000; i++) {
        double at = uniform(&seed, 0.0075, 0.9925);

        flk_integrate(corner_at, &at, 1, 0, 1, &of);
        assert_true(fabs(of.value - (at * at + (1 - at) * (1 - at)) / 2) <= 4 * of.error);
    }
}

/* No point is at an end, and the rules differ by more than the error. */
TEST(test_rough_integrals)
{
    static const double exact[FLK_INTEGRALS] = {2, 1, 0.29};
    flk_integral of[FLK_INTEGRALS];
    double unknown = 0.5;
    int k;

    flk_integrate(rough, NULL, FLK_INTEGRALS, 0, 1, of);
    for (k = 0; k < FLK_INTEGRALS; k++) {
        double error = fabs(of[k].value - exact[k]);

        assert_true(error > 1e-5 && error < 0.1);
        assert_true(of[k].error > error && of[k].error < 0.4);
        assert_near(of[k].size, of[k].value, 1e-14);
    }
    flk_integrate(known_above, &unknown, 1, 0, 1, of);
    assert_true(isnan(of[0].value));
    flk_integrate(known_above, &unknown, 1, 0.5, 1, of);
    assert_near(of[0].value, 0.375, 1e-15);
}

/* One, two, three geometric sequences, falling, growing and alternating, about a limit. */
TEST(test_limit_of_sequence)
{
    double of[7], limit, part[3], ratio[3];
    uint64_t seed = 56;
    int i, k, m, n;

    for (i = 0; i < 3000; i++) {
        n = 1 + i % 3;
        limit = uniform(&seed, -1, 1);
        for (k = 0; k < n; k++) {
            part[k] = uniform(&seed, 0.5, 1);
            ratio[k] = 0.2 + 0.6 * k + uniform(&seed, -0.1, 0.1);
            if (i % 2)
                ratio[k] = -ratio[k];
        }
        for (m = 0; m <= 2 * n; m++)
            for (of[m] = limit, k = 0; k < n; k++)
                of[m] += part[k] * pow(ratio[k], m);
        assert_near(flk_limit_of_sequence(of, 2 * n + 1), limit, 1e-7);
    }
    for (m = 0; m < 7; m++)
        of[m] = 3;
    assert_near(flk_limit_of_sequence(of, 7), 3, 0);
}

int main(void)
{
    return run_all_tests(NULL);
}
