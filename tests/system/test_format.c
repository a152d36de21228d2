/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_format.c - numbers to text: the C library's printf is the judge of every byte but the sign of 0;
** lines of them.
*/
#include <float.h>

#include "check.h"
#include "system/format.h"
#include "locales.h"
#include "base/digits.h"
#include "base/number.h"
#include "tables/line.h"

#define MANY some_of(20000)
#define MOST_DECIMALS 20

static void compare(const char *form, int precision, double value, const char *out)
{
    char expected[FORMAT_SIZE], *comma;

    snprintf(expected, sizeof expected, form, precision, value == value ? value : fabs(value));
    if (expected[0] == '-' && !strpbrk(expected, "123456789in")) /* 0 has no sign */
        memmove(expected, expected + 1, strlen(expected));
    comma = strchr(expected, ',');
    if (comma)
        *comma = '.';
    if (strcmp(out, expected) != 0)
        fail_msg("%s with %d of %a: '%s', expected '%s'", form, precision, value, out, expected);
}

static void check_fixed(double value, int decimals)
{
    char out[FORMAT_SIZE];

    compare("%.*f", decimals, value, format_fixed(value, decimals, out));
    compare("%.*f", decimals, -value, format_fixed(-value, decimals, out));
}

static void check_exponent(double value, int decimals)
{
    char out[FORMAT_SIZE];

    compare("%.*e", decimals, value, format_exponent(value, decimals, out));
}

static void check_general(double value, int digits)
{
    char out[FORMAT_SIZE];

    compare("%.*g", digits, value, format_general(value, digits, out));
}

/* The fewest digits, 15 at least, that read back as the same number. */
static void check_shortest(double value)
{
    char out[FORMAT_SIZE], shorter[FORMAT_SIZE];
    double same;
    int digits;
    text t;

    *format_shortest_end(value, out) = '\0';
    for (digits = 15; digits < 17; digits++) {
        t = flk_text_of(format_general(value, digits, shorter));
        if (flk_number_read(&t, &same) == NUMBER_OK && same == value)
            break;
    }
    compare("%.*g", digits, value, out);
}

/* A few of the forms. */
static void check_some(double value, uint64_t *seed)
{
    static const int usual[] = {17, 12, 6};

    check_shortest(value);
    check_fixed(value, (int)uniform(seed, 0, MOST_DECIMALS + 1));
    check_exponent(-value, (int)uniform(seed, 0, MOST_DECIMALS + 1));
    check_general(value, usual[(int)uniform(seed, 0, 3)]);
    check_general(-value, (int)uniform(seed, 0, MOST_DECIMALS + 1));
}

static void check_all(double value)
{
    int i;

    for (i = 0; i <= MOST_DECIMALS; i++) {
        check_fixed(value, i);
        check_exponent(value, i);
        check_exponent(-value, i);
        check_general(value, i);
        check_general(-value, i);
    }
}

static void check_neighbours(double value, uint64_t *seed)
{
    check_some(value, seed);
    check_some(nextafter(value, HUGE_VAL), seed);
    check_some(nextafter(value, -HUGE_VAL), seed);
}

/* Sizes from 1 to 2^53, none more often than the others. */
static double integer_of_any_size(uint64_t *seed)
{
    return floor(exp2(uniform(seed, 0, 53)));
}

static void test_examples(void **unused)
{
    char out[FORMAT_SIZE];

    (void)unused;
    assert_string_equal(format_fixed(1234567.5, 2, out), "1234567.50");
    assert_string_equal(format_fixed(-0.125, 3, out), "-0.125");
    assert_string_equal(format_fixed(0.125, 2, out), "0.12");
    assert_string_equal(format_fixed(0.375, 2, out), "0.38");
    assert_string_equal(format_fixed(2.5, 0, out), "2");
    assert_string_equal(format_fixed(3.5, 0, out), "4");
    assert_string_equal(format_fixed(2, 0, out), "2");
    assert_string_equal(format_fixed(999.99996, 4, out), "1000.0000");
    assert_string_equal(format_fixed(-0.004, 2, out), "0.00");
    assert_string_equal(format_exponent(-0.0, 1, out), "0.0e+00");
    assert_string_equal(format_general(-0.0, 17, out), "0");
    assert_string_equal(format_exponent(0.00015, 1, out), "1.5e-04");
    assert_string_equal(format_exponent(-1e30, 0, out), "-1e+30");
    assert_string_equal(format_general(0.1, 17, out), "0.10000000000000001");
    assert_string_equal(format_general(1e-9, 6, out), "1e-09");
    assert_string_equal(format_general(12345678, 6, out), "1.23457e+07");
    assert_string_equal(format_general(999999.5, 6, out), "1e+06");
    assert_string_equal(format_general(0.00001, 6, out), "1e-05");
    assert_string_equal(format_general(0.000123, 6, out), "0.000123");
    assert_string_equal(format_general(66, 12, out), "66");
    assert_int_equal(strlen(format_fixed(-DBL_MAX, 17, out)), 1 + 309 + 1 + 17);
    assert_true(out[310] == '.');
}

/* Powers of ten and of two, and the numbers beside them. */
static void test_ends_of_ranges(void **unused)
{
    static const double values[] = {
        0,        1e-5, 9.9999e-5, 0.5,     1,          9.5,        99.5,
        9.9995,   1e9,  1e10,      1e17,    2147483647, 4294967295, 12345678901234568e1,
        DBL_MIN,  1e40, 1e-45,     DBL_MAX, 1e100,      1e-100,     4.9406564584124654e-324,
        INFINITY, NAN};
    int power, i;
    size_t k;

    (void)unused;
    for (k = 0; k < COUNT(values); k++)
        check_all(values[k]);
    for (power = -60; power <= 60; power++) {
        double ten = pow(10, power), two = exp2(power);

        for (i = -3; i <= 3; i++) {
            check_all(ten * (1 + i * DBL_EPSILON));
            check_all(two * (1 + i * DBL_EPSILON));
        }
    }
    for (i = -20; i <= 20; i++) {
        check_all(9007199254740992.0 + i);
        check_all(9007199254740992.0 / 2 + i * 0.5);
        check_all(9007199254740992.0 / 4 + i * 0.25);
        check_all(1e9 + i * 0.5);
        check_all(i * DBL_MIN * DBL_EPSILON);
    }
}

static void test_random_bits(void **unused)
{
    uint64_t seed = 3;
    int i;

    (void)unused;
    for (i = 0; i < MANY; i++) {
        uint64_t bits = (uint64_t)uniform(&seed, 0, 4294967296.0) << 32;
        double value;

        bits |= (uint64_t)uniform(&seed, 0, 4294967296.0);
        memcpy(&value, &bits, sizeof value);
        check_some(value, &seed);
    }
}

static void test_sizes(void **unused)
{
    uint64_t seed = 20240517;
    int i;

    (void)unused;
    for (i = 0; i < 2 * MANY; i++) {
        check_some(pow(10, uniform(&seed, -47, 42)), &seed);
        check_fixed(pow(10, uniform(&seed, -8, 10)), (int)uniform(&seed, 0, 11));
    }
}

/* Halves, exactly: an odd number over 2^(d+1) is one with d decimals.  With enough decimals before
** them they are halves in 17 digits too. */
static void test_ties(void **unused)
{
    uint64_t seed = 11;
    int i;

    (void)unused;
    for (i = 0; i < MANY; i++) {
        int decimals = i % 20;
        double odd = 2 * floor(integer_of_any_size(&seed) / 2) + 1;
        double value = ldexp(odd, -decimals - 1);

        check_fixed(value, decimals);
        check_fixed(nextafter(value, 0), decimals);
        check_fixed(nextafter(value, HUGE_VAL), decimals);
        check_general(value, 1 + decimals % 17);
        check_general(value, 17);
        check_exponent(odd * 5, 1 + decimals % 15);
    }
}

/* As near to halves as doubles are: k.5 / 10^d, and the numbers beside them. */
static void test_near_ties(void **unused)
{
    uint64_t seed = 23;
    int i;

    (void)unused;
    for (i = 0; i < MANY / 2; i++) {
        int decimals = (int)uniform(&seed, 0, 19);
        double value = (integer_of_any_size(&seed) + 0.5) / pow(10, decimals);

        check_fixed(value, decimals);
        check_fixed(nextafter(value, 0), decimals);
        check_fixed(nextafter(value, HUGE_VAL), decimals);
        check_neighbours(value, &seed);
        check_neighbours(value * 1e20, &seed);
        check_neighbours(value * 1e-20, &seed);
    }
}

/* Decimals of few digits, as they stand in decks: many zeros to leave out. */
static void test_short_numbers(void **unused)
{
    uint64_t seed = 5;
    int i;

    (void)unused;
    for (i = 0; i < MANY; i++) {
        double value = floor(pow(10, uniform(&seed, 0, 6))), power = pow(10, i % 21);

        check_some(value * power, &seed);
        check_some(value / power, &seed);
    }
}

/* Any number in few digits: within half a unit of the last digit, but what is below the normal range is 0. */
static void test_any_numbers(void **unused)
{
    uint64_t seed = 9;
    char out[FORMAT_SIZE];
    double value, again;
    int i, n;

    (void)unused;
    for (i = 0; i < MANY; i++) {
        text rest;

        n = 1 + (int)uniform(&seed, 0, 9);
        value = uniform(&seed, -10, 10) * pow(10, uniform(&seed, -320, 307));
        rest = flk_text_of(flk_digits_short(value, n, out));
        if (fabs(value) < DBL_MIN) {
            assert_string_equal(out, "0");
            continue;
        }
        assert_int_equal(flk_number_read(&rest, &again), NUMBER_OK);
        assert_true(fabs(again - value) <= 0.5000001 * pow(10, 1 - n) * fabs(value) + DBL_MIN);
    }
    assert_string_equal(flk_digits_short(0x1p-1074, 6, out), "0");
    assert_string_equal(flk_digits_short(-DBL_MIN / 2, 6, out), "0");
    assert_string_equal(flk_digits_short(DBL_MIN, 6, out), "2.22507e-308");
    assert_string_equal(flk_digits_short(0, 6, out), "0");
    assert_string_equal(flk_digits_short(HUGE_VAL, 6, out), "inf");
}

/* 17 digits bring a number back. */
static void test_back(void **unused)
{
    uint64_t seed = 7;
    int i;

    (void)unused;
    for (i = 0; i < MANY; i++) {
        double value = uniform(&seed, -1, 1) * pow(10, uniform(&seed, -300, 300)), again = 0;
        char out[FORMAT_SIZE];
        text rest = flk_text_of(format_general(value, 17, out));

        assert_int_equal(flk_number_read(&rest, &again), NUMBER_OK);
        assert_int_equal(rest.length, 0);
        assert_true(again == value);
    }
}

/* Lines of the buffer have the bytes that the C library writes, also where they are longer than the
** buffer. */
static void test_lines(void **unused)
{
    static char longest[10000];
    static const char *const texts[] = {"", "-0.125", "a, \"b\"", "a field of some length",
                                        longest};
    FILE *expected = tmpfile(), *out = tmpfile();
    uint64_t seed = 13;
    int i, k, c;

    (void)unused;
    assert_non_null(expected);
    assert_non_null(out);
    memset(longest, 'x', sizeof longest - 1);
    for (i = 0; i < (tries_all() ? 200 : 40); i++) {
        int fields = (int)uniform(&seed, 0, i % 20 == 0 ? 1000 : 10);
        digits_cell cell;
        line l;

        line_start(&l, out);
        for (k = 0; k < fields; k++) {
            const char *s = texts[(int)uniform(&seed, 0, i % 10 == 0 ? 5 : 4)];
            int length = (int)strlen(s), width = (int)uniform(&seed, 0, k % 50 == 49 ? 9000 : 30);
            double value = pow(10, uniform(&seed, -3, 6));
            char number[FORMAT_SIZE];
            unsigned long n = (unsigned long)uniform(&seed, 0, 1e9);

            fprintf(expected, "%*s", length < width ? width : length + 1, s);
            if (k % 2)
                line_right(&l, s, (size_t)length, (size_t)width);
            else
                line_field(&l, s, (size_t)width);
            fprintf(expected, "%s|%-9s|%.12g|%.17g|%lu%%\n", s, s, value, -value, n);
            line_put(&l, "%s|%-9s|%12g|%17g|%lu", s, s, value, -value, n);
            line_text(&l, "%\n", 2);
            fprintf(expected, "%-*s|%20.12g|", width, s, value);
            assert_int_equal(line_left(&l, s, (size_t)width), length > width ? length - width : 0);
            line_put(&l, "|");
            assert_int_equal(line_value(&l, value, 12, 20), 20);
            line_put(&l, "|");
            fprintf(expected, "%25.3f|%.6g", value, -value);
            flk_digits_cell(&cell, 0, 3, 1e9, 25);
            if (flk_digits_put(&cell, 1, &value, line_blanks(&l, 25))) {
                assert_true(value > 99999 || (FLT_EVAL_METHOD | 1) != 1);
                l.length -= 25;
                line_right(&l, number, strlen(format_fixed(value, 3, number)), 25);
            }
            line_text(&l, "|", 1);
            line_number(&l, -value, 6);
            line_number(&l, -0.0, 17);
            putc('0', expected);
        }
        line_end(&l);
    }
    assert_true(ftell(out) > 500000);
    rewind(expected);
    rewind(out);
    do {
        c = getc(expected);
        assert_int_equal(getc(out), c);
    } while (c != EOF);
    fclose(expected);
    fclose(out);
}

/* Numbers side by side in lines of random cells, with some too large for a cell, ties, zeros, infinities,
** NaN: the function writes those of which it is certain, and leaves every byte between them as it was. */
static void test_cells(void **unused)
{
    uint64_t seed = 17;
    long tried = 0, left = 0;
    int i, j;

    (void)unused;
    for (i = 0; i < MANY; i++) {
        char found[400], expected[400], number[400];
        double values[10];
        digits_cell cells[10];
        size_t n = (size_t)uniform(&seed, 1, 11), end = 0, k;

        memset(found, ' ', sizeof found);
        memset(expected, ' ', sizeof expected);
        for (k = 0; k < n; k++) {
            int decimals = (int)uniform(&seed, -1, 11);
            double size = pow(10, uniform(&seed, -9, 9 - decimals)),
                   special[] = {0, INFINITY, NAN, 0.5, 2.5, -0.0};
            int width = 13 + (int)uniform(&seed, 0, 8);

            values[k] = uniform(&seed, -size, size);
            j = (int)uniform(&seed, 0, 60);
            values[k] = j < 6 ? special[j] : values[k];
            end += (size_t)width;
            flk_digits_cell(&cells[k], k, decimals, uniform(&seed, 0, 1) < 0.1 ? 1 : 1e9, end);
        }
        tried += (long)n;
        for (k = n; (k = flk_digits_put(cells, k, values, found)) > 0;) {
            left++;
            k--;
            memset(found + cells[k].end - 13, '*', 13);
            memset(expected + cells[k].end - 13, '*', 13);
        }
        for (k = 0; k < n; k++)
            if (expected[cells[k].end - 1] != '*') {
                size_t length =
                    (size_t)snprintf(number, sizeof number, "%.*f", cells[k].decimals, values[k]);
                const char *digits = number;

                if (number[0] == '-' && !strpbrk(number, "123456789")) {
                    digits++;
                    length--;
                }
                memcpy(expected + cells[k].end - length, digits, length);
            }
        found[399] = expected[399] = '\0';
        assert_string_equal(found, expected);
    }
    printf("%ld numbers in lines, %ld of them left to the caller\n", tried, left);
    assert_true(left < tried / 2);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest with_point[] = {
        C_LOCALE(test_examples),      C_LOCALE(test_ends_of_ranges), C_LOCALE(test_random_bits),
        C_LOCALE(test_sizes),         C_LOCALE(test_ties),           C_LOCALE(test_near_ties),
        C_LOCALE(test_short_numbers), C_LOCALE(test_back),           C_LOCALE(test_lines),
        C_LOCALE(test_cells),         C_LOCALE(test_any_numbers),
    };
    const struct CMUnitTest with_comma[] = {
        COMMA_LOCALE(test_examples),  COMMA_LOCALE(test_sizes),
        COMMA_LOCALE(test_back),      COMMA_LOCALE(test_ties),
        COMMA_LOCALE(test_near_ties), COMMA_LOCALE(test_ends_of_ranges),
    };

    if (!asks_for_comma(argc, argv))
        return cmocka_run_group_tests(with_point, NULL, NULL);
    return set_comma_locale() ? cmocka_run_group_tests(with_comma, NULL, NULL) : no_comma_locale();
}
