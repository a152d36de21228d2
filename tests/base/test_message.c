/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_message.c - messages and the lists of them; quantities read from text, and why they are none.
*/
#include <float.h>
#include <stdlib.h>

#include "base/number.h"
#include "base/quantity.h"
#include "check.h"

/* -------------------------------------------------------------------------------------- messages */

static char *number(double value, int digits)
{
    static char out[MESSAGE_SIZE];

    return digits == 4 ? flk_message(out, sizeof out, "%.4g", value)
                       : flk_message(out, sizeof out, "%g", value);
}

TEST(test_conversions)
{
    char out[MESSAGE_SIZE], small[12];

    flk_message(out, sizeof out, "a %s of %t, 5 %%, line %ld%h", "rod", flk_text_of("80 mm"), 12L,
                "rocker");
    assert_string_equal(out, "a rod of 80 mm, 5 %, line 12; did you mean 'rocker'?");
    assert_string_equal(flk_message(out, sizeof out, "%t%h.", flk_text_of("a\tb"), (char *)NULL),
                        "a b.");
    flk_message(out, sizeof out, "%t",
                flk_text_of("0123456789012345678901234567890123456789"
                            "01234567890123456789012345678901234567"));
    assert_int_equal(strlen(out), 63);
    assert_string_equal(out + 60, "...");
    assert_string_equal(flk_message(small, sizeof small, "%s", "0123456789abc"), "01234567...");
    assert_string_equal(flk_message(out, sizeof out, ""), "");
}

TEST(test_numbers_in_messages)
{
    static const struct {
        double value;
        int digits;
        const char *text;
    } cases[] = {
        {0, 9, "0"},
        {20, 9, "20"},
        {-0.1, 9, "-0.1"},
        {1e9, 9, "1e9"},
        {1e-5, 9, "1e-5"},
        {0.0001, 9, "0.0001"},
        {1.0 / 3, 4, "0.3333"},
        {2.0 / 3, 4, "0.6667"},
        {123456, 4, "1.235e5"},
        {1e100, 9, "1e100"},
        {-1e-100, 9, "-1e-100"},
        {2.5e300, 4, "2.5e300"},
        {9.9999e-5, 4, "0.0001"},
    };
    size_t i;

    for (i = 0; i < COUNT(cases); i++)
        assert_string_equal(number(cases[i].value, cases[i].digits), cases[i].text);
    number(DBL_MAX, 9);
    number(DBL_MIN / 8, 9);
    assert_string_equal(number(INFINITY, 9), "inf");
}

TEST(test_shortest)
{
    uint64_t seed = 7;
    char out[DIGITS_SIZE];
    int i;

    assert_string_equal(flk_number_shortest(0.1, out), "0.1");
    assert_string_equal(flk_number_shortest(20.3, out), "20.3");
    assert_string_equal(flk_number_shortest(1e-7, out), "1e-7");
    for (i = 0; i < 200000; i++) {
        double value = uniform(&seed, -10, 10) * pow(10, floor(uniform(&seed, -26, 30))), same;
        text t = flk_text_of(flk_number_shortest(value, out));

        if (fabs(value) < 1e-28)
            continue;
        assert_int_equal(flk_number_read(&t, &same), NUMBER_OK);
        if (same != value || t.length)
            fail_msg("%.17g became '%s'", value, out);
    }
}

TEST(test_mistakes)
{
    static const long lines[] = {7, 3, 7, 0, 5, 3};
    static const char *const expected[] = {"3", "1", "5", "4", "0", "2"};
    mistakes m;
    text_place place = {"deck", 0};
    char number[3] = "0", piece[101];
    size_t i;

    memset(&m, 0, sizeof m);
    for (i = 0; i < 6; i++) {
        place.line = lines[i];
        number[0] = (char)('0' + i);
        flk_mistake(&m, place, "%s", number);
    }
    flk_mistakes_sort(&m);
    assert_int_equal(m.count, 6);
    for (i = 0; i < 6; i++)
        assert_string_equal(m.list[i].message, expected[i]); /* those of a line in their order */
    flk_mistakes_free(&m);
    assert_int_equal(m.count, 0);

    memset(piece, 'x', 100);
    piece[100] = '\0';
    for (i = 0; i < 1000; i++)
        flk_mistake(&m, place, "%s%s%s%s%send", piece, piece, piece, piece, piece);
    assert_true(m.count > 10);
    assert_int_equal(m.count + m.left_out, 1000);
    assert_int_equal(strlen(m.list[0].message), sizeof m.list[0].message - 1);
    flk_mistakes_free(&m);
}

/* ------------------------------------------------------------------------------------ quantities */

static unit unit_of(const char *name)
{
    unit u;
    text bad;

    assert_true(flk_unit_read(flk_text_of(name), &u, &bad));
    return u;
}

TEST(test_quantities)
{
    static const struct {
        const char *text;
        quantity q;
        const char *bare;
        double number, si, digit;
    } cases[] = {
        {"80 mm", QUANTITY_LENGTH, "m", 80, 0.08, 0.001},
        {"80", QUANTITY_LENGTH, "cm", 80, 0.8, 0.01},
        {" 2.50m ", QUANTITY_LENGTH, "mm", 2.5, 2.5, 0.01},
        {"1.2e2 N", QUANTITY_FORCE, "N", 120, 120, 10},
        {"-5 kN", QUANTITY_FORCE, "N", -5, -5000, 1000},
        {"0.5e-1", QUANTITY_NUMBER, "1", 0.05, 0.05, 0.01},
        {"1.5 %", QUANTITY_NUMBER, "1", 1.5, 0.015, 0.001},
        {"\342\210\2222.50\302\240m", QUANTITY_LENGTH, "mm", -2.5, -2.5, 0.01},
        {"1.5\303\22710\302\263 N", QUANTITY_FORCE, "N", 1500, 1500, 100},
    };
    char why[MESSAGE_SIZE];
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        text t = flk_text_of(cases[i].text);
        quantity_value v;

        print_message("%s\n", cases[i].text);
        assert_true(flk_quantity_read(t, t, cases[i].q, unit_of(cases[i].bare), &v, why));
        assert_true(v.number == cases[i].number);
        assert_close(v.si, cases[i].si, 1e-15);
        assert_close(v.digit, cases[i].digit, 1e-15);
    }
}

TEST(test_no_quantities)
{
    static const struct {
        const char *text;
        quantity q;
        const char *message;
    } cases[] = {
        {"wide", QUANTITY_LENGTH, "expected a length, such as 80 mm, not 'wide'"},
        {"inf mm", QUANTITY_LENGTH, "'inf mm' is not a finite number"},
        {"0x10 mm", QUANTITY_LENGTH, "'0x10 mm' is not a decimal number"},
        {"1,5 mm", QUANTITY_LENGTH, "'1,5 mm': a comma as decimal mark: write 1.5"},
        {"5 kg", QUANTITY_LENGTH, "'5 kg' is a mass; expected a length, such as 80 mm"},
        {"5 s/m", QUANTITY_LENGTH, "'5 s/m' is not a length, such as 80 mm"},
        {"5 mmm", QUANTITY_LENGTH, "unknown unit 'mmm' in '5 mmm'; did you mean 'mm'?"},
        {"5 deg cw", QUANTITY_ANGLE,
         "unknown unit 'cw': counter-clockwise is positive, clockwise negative"},
        {"5 mm#x", QUANTITY_LENGTH, "unknown unit '#x': a comment needs a blank before it"},
        {"1e16 m", QUANTITY_LENGTH, "'1e16 m' is out of range"},
        {"1.5 %", QUANTITY_LENGTH, "'1.5 %': per cent of what? expected a length, such as 80 mm"},
        {"40\302\260C", QUANTITY_ANGLE, "unknown unit 'degC' in '40 degC'; did you mean 'deg'?"},
        {"1e10 rad", QUANTITY_ANGLE, "'1e10 rad' is out of range"},
    };
    char why[MESSAGE_SIZE];
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        text t = flk_text_of(cases[i].text);
        quantity_value v;

        assert_false(flk_quantity_read(t, t, cases[i].q, unit_of("1"), &v, why));
        assert_string_equal(why, cases[i].message);
    }
}

int main(void)
{
    return run_all_tests(NULL);
}
