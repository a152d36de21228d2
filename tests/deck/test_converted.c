/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_converted.c - numbers of a deck in other units: decimals stay the decimals that they are by hand.
*/
#include <float.h>

#include "check.h"
#include "base/number.h"
#include "deck/numbers.h"

#define MANY some_of(200000)

/* Units whose sizes are whole multiples of a small one: 1 in is 254 of 0.1 mm. */
static const struct {
    const char *name;
    quantity q;
    long size;
    int power; /* of ten, of this size in SI units */
} units[] = {{"m", QUANTITY_LENGTH, 1, 0},     {"mm", QUANTITY_LENGTH, 1, -3},
             {"cm", QUANTITY_LENGTH, 1, -2},   {"km", QUANTITY_LENGTH, 1, 3},
             {"in", QUANTITY_LENGTH, 254, -4}, {"ft", QUANTITY_LENGTH, 3048, -4},
             {"kg", QUANTITY_MASS, 1, 0},      {"g", QUANTITY_MASS, 1, -3},
             {"t", QUANTITY_MASS, 1, 3},       {"N", QUANTITY_FORCE, 1, 0},
             {"kN", QUANTITY_FORCE, 1, 3},     {"bar", QUANTITY_PRESSURE, 1, 5},
             {"MPa", QUANTITY_PRESSURE, 1, 6}, {"kPa", QUANTITY_PRESSURE, 1, 3},
             {"s", QUANTITY_TIME, 1, 0},       {"ms", QUANTITY_TIME, 1, -3},
             {"min", QUANTITY_TIME, 60, 0},    {"%", QUANTITY_NUMBER, 1, -2},
             {"1", QUANTITY_NUMBER, 1, 0}};

#define N_UNITS ((int)(sizeof units / sizeof units[0]))

static unit unit_of(int i)
{
    text bad;
    unit u;

    assert_true(flk_unit_read(flk_text_of(units[i].name), &u, &bad));
    return u;
}

/* The number of this text. */
static double number_of(long digits, int power)
{
    char words[100];
    text t;
    double value;

    snprintf(words, sizeof words, "%lde%d", digits, power);
    t = flk_text_of(words);
    assert_int_equal(flk_number_read(&t, &value), NUMBER_OK);
    return value;
}

/* Fractions whose value in the other unit is a whole number: 1/3 rev/s is 20 rpm, if this is the same value. */
TEST(test_fractions)
{
    static const struct {
        const char *from, *to;
        long size;
    } pairs[] = {{"rev/s", "rpm", 60}, {"rev", "deg", 360}, {"ft", "in", 12},    {"min", "s", 60},
                 {"in", "mm", 0},      {"m", "mm", 1000},   {"kip", "lbf", 1000}};
    long n, d, cases = 0;
    size_t i;
    text bad;

    for (i = 0; i < sizeof pairs / sizeof *pairs; i++)
        for (d = 1; d <= 300; d++)
            for (n = 1; n <= 300; n++) {
                unit from, to;
                double whole, value, number = (double)n / (double)d;

                if (pairs[i].size == 0 ? n * 254 % (10 * d) : n * pairs[i].size % d)
                    continue;
                assert_true(flk_unit_read(flk_text_of(pairs[i].from), &from, &bad));
                assert_true(flk_unit_read(flk_text_of(pairs[i].to), &to, &bad));
                value = flk_number_converted(number, from, to);
                whole = (double)(pairs[i].size == 0 ? n * 254 / (10 * d) : n * pairs[i].size / d);
                if (flk_unit_in(whole, to, from) != number)
                    continue;
                cases++;
                if (value != whole)
                    fail_msg("%ld/%ld %s: %.17g %s", n, d, pairs[i].from, value, pairs[i].to);
            }
    print_message("%ld fractions\n", cases);
}

/* Decimals of up to 9 digits in each pair of units in which they have an end. */
TEST(test_decimals)
{
    uint64_t seed = 1;
    long k;

    for (k = 0; k < MANY; k++) {
        int i = (int)uniform(&seed, 0, N_UNITS), j = (int)uniform(&seed, 0, N_UNITS),
            power = (int)uniform(&seed, -8, 3);
        long digits = (long)uniform(&seed, 1, pow(10, uniform(&seed, 1, 9)));
        double number = number_of(digits, power), expected, value;

        if (units[i].q != units[j].q || digits * units[i].size % units[j].size != 0)
            continue;
        if (uniform(&seed, 0, 1) < 0.3) {
            digits = -digits;
            number = -number;
        }
        expected = number_of(digits * units[i].size / units[j].size,
                             power + units[i].power - units[j].power);
        value = flk_number_converted(number, unit_of(i), unit_of(j));
        if (value != expected)
            fail_msg("%.17g %s: %.17g %s, expected %.17g", number, units[i].name, value,
                     units[j].name, expected);
        value = flk_number_written(flk_unit_to_si(number, unit_of(i)), unit_of(i), unit_of(j));
        if (value != expected)
            fail_msg("%.17g %s, read: %.17g %s, expected %.17g", number, units[i].name, value,
                     units[j].name, expected);
    }
}

/* Numbers of up to 15 digits are what was written; any are within the rounding of what they are converted from, and in
** their own unit the same. */
TEST(test_any_numbers)
{
    uint64_t seed = 2;
    long k;

    for (k = 0; k < MANY; k++) {
        int i = (int)uniform(&seed, 0, N_UNITS), j = (int)uniform(&seed, 0, N_UNITS),
            digits = (int)uniform(&seed, 1, 16);
        double any = uniform(&seed, -1, 1) * pow(10, uniform(&seed, -9, 9)), number, plain;
        char words[100];
        text t;

        if (units[i].q != units[j].q)
            continue;
        snprintf(words, sizeof words, "%.*g", digits, any);
        t = flk_text_of(words);
        flk_number_read(&t, &number);
        if (flk_number_written(flk_unit_to_si(number, unit_of(i)), unit_of(i), unit_of(i)) !=
            number)
            fail_msg("%s %s is not what was written", words, units[i].name);
        assert_true(flk_number_converted(any, unit_of(i), unit_of(i)) == any);
        plain = flk_unit_in(any, unit_of(i), unit_of(j));
        assert_close(flk_number_converted(any, unit_of(i), unit_of(j)), plain, 2 * DBL_EPSILON);
    }
    assert_true(flk_number_converted(0, unit_of(0), unit_of(1)) == 0);
}

int main(void)
{
    return run_all_tests(NULL);
}
