/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_number.c - numbers read under every locale, and the pieces of text around them.
*/
#include <float.h>
#include <stdlib.h>

#include "check.h"
#include "locales.h"
#include "base/number.h"

/* ---------------------------------------------------------------------------------------- reading
 */

typedef struct reading {
    const char *text;
    double value;
    const char *rest;
} reading;

/* The hard cases: halfway between two doubles, the ends of the range, powers that are not exact. */
static const reading readings[] = {
    {"0", 0, ""},
    {"66 mm", 66, " mm"},
    {"20mm", 20, "mm"},
    {"10.5 rad/s", 10.5, " rad/s"},
    {".5", 0.5, ""},
    {"5.", 5, ""},
    {"-.5e-1", -0.05, ""},
    {"+3", 3, ""},
    {"1e3m", 1000, "m"},
    {"1E+3", 1000, ""},
    {"5e", 5, "e"},
    {"5e+", 5, "e+"},
    {"5em", 5, "em"},
    {"1.2.3", 1.2, ".3"},
    {"10, 5", 10, ", 5"},
    {"1 000", 1, " 000"},
    {"0001", 1, ""},
    {"0.1", 0x1.999999999999ap-4, ""},
    {"0.3", 0x1.3333333333333p-2, ""},
    {"1e23", 0x1.52d02c7e14af6p+76, ""},
    {"9007199254740993", 9007199254740992.0, ""},
    {"9007199254740995", 9007199254740996.0, ""},
    {"9007199254740993.0000000000000000000000000000001", 9007199254740994.0, ""},
    {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022, ""},
    {"4.9406564584124654e-324", 0x1p-1074, ""},
    {"1.7976931348623157e308", DBL_MAX, ""},
    {"1e-400", 0, ""},
};

static void test_read(void **unused)
{
    size_t i;

    (void)unused;
    for (i = 0; i < COUNT(readings); i++) {
        text rest = flk_text_of(readings[i].text);
        double value = -77;

        print_message("%s\n", readings[i].text);
        assert_int_equal(flk_number_read(&rest, &value), NUMBER_OK);
        assert_true(value == readings[i].value);
        assert_ptr_equal(rest.start,
                         readings[i].text + strlen(readings[i].text) - strlen(readings[i].rest));
        assert_int_equal(rest.length, strlen(readings[i].rest));
    }
}

static void check_refused(const char *string, number_status expected)
{
    text rest = flk_text_of(string);
    double value = -77;

    print_message("%.60s\n", string);
    assert_int_equal(flk_number_read(&rest, &value), expected);
    assert_true(value == -77);
    assert_ptr_equal(rest.start, string);
    assert_int_equal(rest.length, strlen(string));
}

static void test_refused(void **unused)
{
    static const char *const none[] = {"",    " 1",  "mm",    "-",   "+",    ".",
                                       "e5",  ".e5", "-e5",   "+-5", "--5",  ",5",
                                       "(1)", "in",  "index", "na",  "nano", "i"};
    static const char *const not_finite[] = {
        "inf",      "INF",    "+inf",  "-Infinity", "infinity", "nan",      "NaN",     "-nan",
        "nan(0x1)", "inf mm", "1e999", "-1e999",    "1e309",    "2e308 mm", "1e99999", "1.8e308"};
    static const char *const hex[] = {"0x10", "0X1p3", "-0x1", "0x1.8p1 mm", "+0x"};
    static const char *const comma[] = {"1,5", "1,5 mm", "-0,25", "1.000,5", "10,5", "1e3,5"};
    size_t i;

    (void)unused;
    for (i = 0; i < COUNT(none); i++)
        check_refused(none[i], NUMBER_NONE);
    for (i = 0; i < COUNT(not_finite); i++)
        check_refused(not_finite[i], NUMBER_NOT_FINITE);
    for (i = 0; i < COUNT(hex); i++)
        check_refused(hex[i], NUMBER_HEX);
    for (i = 0; i < COUNT(comma); i++)
        check_refused(comma[i], NUMBER_COMMA);
}

static void test_long_numbers(void **unused)
{
    static char digits[5000];
    text rest;
    double value = 0;
    size_t i;

    (void)unused;
    memset(digits, '3', sizeof digits);
    rest.start = digits;
    rest.length = 300;
    assert_int_equal(flk_number_read(&rest, &value), NUMBER_OK);
    assert_close(value, 1e300 / 3, 1e-15);
    assert_int_equal(rest.length, 0);

    for (i = 390; i < 410; i++) { /* around the size of the buffer */
        digits[0] = '0';
        digits[1] = '.';
        rest.start = digits;
        rest.length = i;
        if (flk_number_read(&rest, &value) == NUMBER_OK)
            assert_true(value == 1.0 / 3);
        else
            assert_int_equal(rest.length, i);
    }
    rest.start = digits;
    rest.length = sizeof digits;
    assert_int_equal(flk_number_read(&rest, &value), NUMBER_TOO_LONG);
}

/* A text is not ended by a null character: what stands after it does not count. */
static void test_read_stops_at_the_end(void **unused)
{
    text rest = {"12.34e5", 4};
    double value;

    (void)unused;
    assert_int_equal(flk_number_read(&rest, &value), NUMBER_OK);
    assert_true(value == 12.3);
    rest.start = "1,5";
    rest.length = 2;
    assert_int_equal(flk_number_read(&rest, &value), NUMBER_OK);
    assert_true(value == 1);
    rest.start = "0x1";
    rest.length = 1;
    assert_int_equal(flk_number_read(&rest, &value), NUMBER_OK);
    rest.start = "infinite";
    rest.length = 2;
    assert_int_equal(flk_number_read(&rest, &value), NUMBER_NONE);
}

#define RANDOM_NUMBERS 60000

static void random_number(uint64_t *seed, char *out)
{
    int digits = (int)uniform(seed, 1, 26), point = (int)uniform(seed, 0, 30), i;

    *out = '\0';
    if (uniform(seed, 0, 1) < 0.5)
        strcat(out, "-");
    for (i = 0; i < digits; i++) {
        char digit[3] = ".";

        if (i == point)
            strcat(out, digit);
        digit[0] = (char)('0' + (int)uniform(seed, 0, 10));
        strcat(out, digit);
    }
    if (uniform(seed, 0, 1) < 0.4)
        sprintf(out + strlen(out), "e%d", (int)uniform(seed, -330, 280));
    else if (uniform(seed, 0, 1) <
             0.5) /* where a product or a quotient of doubles is exact, and just beyond */
        sprintf(out + strlen(out), "e%d", (int)uniform(seed, -26, 27));
}

/* The C library in the C locale is the judge of the rounding. */
static void test_rounding(void **unused)
{
    int comma = strcmp(localeconv()->decimal_point, ",") == 0;
    uint64_t seed = 20240517;
    int i, fractions = 0;

    (void)unused;
    for (i = 0; i < RANDOM_NUMBERS; i++) {
        char number[80];
        double expected, value = -77;
        text rest;

        random_number(&seed, number);
        fractions += strchr(number, '.') != NULL;
        setlocale(LC_ALL, "C");
        expected = strtod(number, NULL);
        if (comma)
            assert_true(set_comma_locale());
        rest = flk_text_of(number);
        if (flk_number_read(&rest, &value) != NUMBER_OK ||
            memcmp(&value, &expected, sizeof value) != 0)
            fail_msg("'%s' was read as %.17g, expected %.17g", number, value, expected);
        assert_int_equal(rest.length, 0);
    }
    assert_true(fractions > RANDOM_NUMBERS / 4);
}

/* ---------------------------------------------------------------------------------- pieces of text
 */

static void test_nearest(void **unused)
{
    static const char *const words[] = {"length", "mass",  "gyration", "inertia",
                                        "cg",     "crank", "coupler",  "four-bar",
                                        "m",      "mm",    "F12",      NULL};
    static const struct {
        const char *word, *nearest;
    } cases[] = {
        {"lenght", "length"},
        {"LENGTH", "length"},
        {"legnth", "length"},
        {"lengths", "length"},
        {"mas", "mass"},
        {"gyraton", "gyration"},
        {"cranc", "crank"},
        {"fourbar", "four-bar"},
        {"coulper", "coupler"},
        {"intertia", "inertia"},
        {"gc", "cg"},
        {"Mm", "mm"},
        {"xyzzy", NULL},
        {"foo", NULL},
        {"temperature", NULL},
        {"", NULL},
        {"q", NULL},
    };
    static const char *const nothing[] = {NULL};
    static char long_word[1000];
    text t;
    size_t i;

    (void)unused;
    for (i = 0; i < COUNT(cases); i++) {
        const char *nearest = flk_text_nearest(flk_text_of(cases[i].word), words);

        print_message("%s\n", cases[i].word);
        if (cases[i].nearest) {
            assert_non_null(nearest);
            assert_string_equal(nearest, cases[i].nearest);
        } else {
            assert_null(nearest);
        }
    }
    assert_null(flk_text_nearest(flk_text_of("length"), nothing));
    memset(long_word, 'l', sizeof long_word);
    t.start = long_word;
    t.length = sizeof long_word;
    assert_null(flk_text_nearest(t, words));
}

static int is_utf8(const char *s)
{
    const unsigned char *c = (const unsigned char *)s;
    int more;

    while (*c) {
        more = *c < 0x80 ? 0 : (*c & 0xe0) == 0xc0 ? 1 : (*c & 0xf0) == 0xe0 ? 2 : 3;
        if ((*c & 0xc0) == 0x80)
            return 0;
        for (c++; more > 0; more--, c++)
            if ((*c & 0xc0) != 0x80)
                return 0;
    }
    return 1;
}

static void test_copy(void **unused)
{
    static const char *const long_texts[] = {
        "Kurbelschwinge nach Alvi, Abschnitt 5",
        "\303\244\303\266\303\274\303\244\303\266\303\274\303\244\303\266\303\274\303\244\303\266",
        "\342\202\254\342\202\254\342\202\254\342\202\254\342\202\254\342\202\254\342\202\254",
        "a\360\235\204\236\360\235\204\236\360\235\204\236\360\235\204\236\360\235\204\236"};
    static const char control[] = {'a', '\0', 'b', '\n', '\t', '\177', '\303', '\251'};
    char out[64];
    text t;
    size_t i, size;

    (void)unused;
    assert_string_equal(flk_text_copy(flk_text_of("rocker"), out, sizeof out), "rocker");
    assert_string_equal(flk_text_copy(flk_text_of("rocker"), out, 7), "rocker");
    assert_string_equal(flk_text_copy(flk_text_of("rockers"), out, 7), "roc...");
    assert_string_equal(flk_text_copy(flk_text_of(""), out, 7), "");
    t.start = control;
    t.length = sizeof control;
    assert_string_equal(flk_text_copy(t, out, sizeof out), "a?b???\303\251");

    for (i = 0; i < COUNT(long_texts); i++)
        for (size = 8; size <= strlen(long_texts[i]); size++) {
            size_t n;

            memset(out, '#', sizeof out);
            flk_text_copy(flk_text_of(long_texts[i]), out, size);
            n = strlen(out);
            assert_in_range(n, size - 4, size - 1); /* no more lost than one character of UTF-8 */
            assert_true(is_utf8(out));
            assert_string_equal(out + n - 3, "...");
            assert_memory_equal(out, long_texts[i], n - 3);
            assert_true(out[size] == '#');
        }
}

static void test_trim_equal_split(void **unused)
{
    static const char with_null[] = "ab\0cd";
    text t = flk_text_trim(flk_text_of(" \t key \r")), rest, piece, null_inside = {with_null, 5};

    (void)unused;
    assert_int_equal(t.length, 3);
    assert_memory_equal(t.start, "key", 3);
    assert_int_equal(flk_text_trim(flk_text_of(" \t\r")).length, 0);

    assert_true(flk_text_equal(flk_text_of("Crank"), "cRANK"));
    assert_false(flk_text_equal(flk_text_of("Crank"), "cran"));
    assert_false(flk_text_equal(flk_text_of("Cran"), "crank"));
    assert_false(flk_text_equal(flk_text_of("\304"), "\344")); /* letters of ASCII only */
    assert_false(flk_text_equal(null_inside, with_null));

    rest = flk_text_of("a\n\nb");
    assert_true(flk_text_split(&rest, '\n', &piece) && piece.length == 1 && piece.start[0] == 'a');
    assert_true(flk_text_split(&rest, '\n', &piece) && piece.length == 0);
    assert_true(flk_text_split(&rest, '\n', &piece) && piece.length == 1 && piece.start[0] == 'b');
    assert_false(flk_text_split(&rest, '\n', &piece));
}

int main(int argc, char **argv)
{
    const struct CMUnitTest with_point[] = {
        C_LOCALE(test_read),         C_LOCALE(test_refused),
        C_LOCALE(test_long_numbers), C_LOCALE(test_read_stops_at_the_end),
        C_LOCALE(test_rounding),     C_LOCALE(test_nearest),
        C_LOCALE(test_copy),         C_LOCALE(test_trim_equal_split),
    };
    const struct CMUnitTest with_comma[] = {
        COMMA_LOCALE(test_read),
        COMMA_LOCALE(test_refused),
        COMMA_LOCALE(test_rounding),
    };

    if (!asks_for_comma(argc, argv))
        return cmocka_run_group_tests(with_point, NULL, NULL);
    return set_comma_locale() ? cmocka_run_group_tests(with_comma, NULL, NULL) : no_comma_locale();
}
