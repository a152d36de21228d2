/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_spelling.c - what people type for a value, in plain characters.
*/
#include "check.h"
#include "base/spelling.h"

#define MINUS "\342\210\222"
#define NO_BREAK "\302\240"
#define THIN "\342\200\211"
#define DEGREE "\302\260"
#define TWO "\302\262"
#define THREE "\302\263"
#define RAISED_MINUS "\342\201\273"
#define DOT "\302\267"
#define TIMES "\303\227"

static const struct {
    const char *typed, *plain;
} cases[] = {
    {"20 mm", "20 mm"},
    {"", ""},
    {MINUS "5 mm", "-5 mm"},
    {"\342\200\223"
     "5 mm",
     "-5 mm"},
    {"four\342\200\221"
     "bar",
     "four-bar"},
    {"5" NO_BREAK "mm", "5 mm"},
    {"5" THIN "mm", "5 mm"},
    {"5\342\200\257mm", "5 mm"},
    {"30" DEGREE, "30 deg"},
    {"30 " DEGREE, "30 deg"},
    {DEGREE, "deg"},
    {"30" DEGREE "/s" TWO, "30 deg/s^2"},
    {"3 kg" DOT "m" TWO, "3 kg*m^2"},
    {"3 N" TIMES "m", "3 N*m"},
    {MINUS "2\317\200/3", "-2pi/3"},
    {"3 N\342\213\205mm", "3 N*mm"},
    {"5 rad s" RAISED_MINUS "\302\271", "5 rad s^-1"},
    {"mm\342\201\264", "mm^4"},
    {"1.5" TIMES "10^3 N", "1.5e3 N"},
    {"1.5 " TIMES " 10^-3 N", "1.5e-3 N"},
    {"1.5 " TIMES NO_BREAK "10" THREE " N", "1.5e3 N"},
    {"1.5" DOT "10" RAISED_MINUS THREE " N", "1.5e-3 N"},
    {"2*10^12 N", "2e12 N"},
    {"5." TIMES "10^3", "5.e3"},
    {"(1" TIMES "10^3, 2" TIMES "10^3) N", "(1e3, 2e3) N"},
    /* no powers of ten */
    {"2*10 N", "2*10 N"},
    {"2^10", "2^10"},
    {"2*10^ N", "2*10^ N"},
    {"2*10^-N", "2*10^-N"},
    {TIMES "10^3 N", "*10^3 N"},
    {"N*10^3", "N*10^3"},
    {"2*100^3", "2*100^3"},
    /* what it does not know */
    {"K\303\266nig", "K\303\266nig"},
    {"5 \302\265m", "5 \302\265m"},
    {"\342\210", "\342\210"},
    {"\302", "\302"},
    {"20\260/s", "20 deg/s"}, /* Latin-1 */
    {"\303\260", "\303\260"},
    {"20 mm \302\261 1 mm", "20 mm \302\261 1 mm"},
};

TEST(test_plain)
{
    size_t i;

    for (i = 0; i < COUNT(cases); i++) {
        size_t n = strlen(cases[i].typed);
        char out[SPELLING_SIZE(100)];
        text t = flk_spelling_plain(flk_text_of(cases[i].typed), out);

        print_message("%s\n", cases[i].typed);
        assert_true(n <= 100);
        assert_int_equal(t.length, strlen(cases[i].plain));
        assert_memory_equal(t.start, cases[i].plain, t.length);
        if (strcmp(cases[i].typed, cases[i].plain) != 0 && !strchr(cases[i].typed, '^'))
            assert_false(flk_spelling_is_plain(flk_text_of(cases[i].typed)));
    }
    assert_true(flk_spelling_is_plain(flk_text_of("20 mm at 30 deg")));
}

/* The longest that can become of each character fits. */
TEST(test_room)
{
    static const char *const pieces[] = {DEGREE,           "1" DEGREE, TWO,  MINUS,
                                         "1" TIMES "10^3", "x",        TIMES};
    size_t i, k;

    for (i = 0; i < COUNT(pieces); i++) {
        char typed[800] = "", out[SPELLING_SIZE(800)];

        for (k = 0; k < 100; k++)
            strcat(typed, pieces[i]);
        assert_true(flk_spelling_plain(flk_text_of(typed), out).length <
                    SPELLING_SIZE(strlen(typed)));
    }
}

TEST(test_blanks)
{
    text t = flk_text_trim(flk_text_of(NO_BREAK " \t" THIN "a" NO_BREAK "b\342\200\257\r"));
    assert_int_equal(t.length, 4);
    assert_memory_equal(t.start, "a" NO_BREAK "b", 4);
    assert_int_equal(flk_text_trim(flk_text_of(NO_BREAK)).length, 0);
    assert_int_equal(flk_text_trim(flk_text_of("\240")).length, 1); /* not UTF-8 */
    assert_int_equal(flk_text_trim(flk_text_of("\302")).length, 1);
}

int main(void)
{
    return run_all_tests(NULL);
}
