/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_page.c - what a report is written with: texts and numbers in markup, base64, equations, and
** drawings in fewer bytes.
*/
#include <stdio.h>
#include <string.h>

#include "base/quantity.h"
#include "system/xml.h"
#include "check.h"
#include "report/mathml.h"
#include "report/page.h"

static char written[20000];

/* What is in a stream, which is closed. */
static const char *take(FILE *file)
{
    size_t n;

    rewind(file);
    n = fread(written, 1, sizeof written - 1, file);
    written[n] = '\0';
    fclose(file);
    return written;
}

static page new_page(void)
{
    page p;

    memset(&p, 0, sizeof p);
    p.out = tmpfile();
    assert_non_null(p.out);
    return p;
}

/* -------------------------------------------------------------------------------- texts and numbers */

static const char *shown(const char *words, size_t length)
{
    FILE *out = tmpfile();

    assert_non_null(out);
    xml_put(out, words, length);
    return take(out);
}

#define REPLACED "\xef\xbf\xbd"

TEST(test_texts)
{
    assert_string_equal(shown("<a href=\"x\" id='y'>&amp;]]>", 27),
                        "&lt;a href=&quot;x&quot; id=&#39;y&#39;&gt;&amp;amp;]]&gt;");
    assert_string_equal(shown("caf\xc3\xa9 \xf0\x9f\x98\x80\t\n", 12),
                        "caf\xc3\xa9 \xf0\x9f\x98\x80\t\n");
    assert_string_equal(shown("a\r\nb\rc", 6), "a\nb\nc");
    assert_string_equal(shown("\0\x01\x1b\x7f", 4), REPLACED REPLACED REPLACED REPLACED);
    assert_string_equal(shown("\xc2\x85\xef\xbf\xbe\xef\xbf\xbf", 8), REPLACED REPLACED REPLACED);
    /* not UTF-8: a lone byte, an overlong form, a surrogate, above U+10FFFF, cut off by the end */
    assert_string_equal(shown("\xe9.", 2), REPLACED ".");
    assert_string_equal(shown("\xc0\xaf", 2), REPLACED REPLACED);
    assert_string_equal(shown("\xed\xa0\x80", 3), REPLACED REPLACED REPLACED);
    assert_string_equal(shown("\xf4\x90\x80\x80", 4), REPLACED REPLACED REPLACED REPLACED);
    assert_string_equal(shown("\xe2\x82\xac", 2), REPLACED REPLACED);
}

TEST(test_print)
{
    page p = new_page();

    page_print(&p, "%s|%m|%d|%lu|%.4g|%.2f|%.3g|%.2f|100 %%", "<", "<br/>", -3, 7UL, 3.14159265,
               2.0 / 3, -0.0, -0.001);
    assert_string_equal(take(p.out), "&lt;|<br/>|-3|7|3.142|0.67|0|0.00|100 %");
}

static const char *in_base64(const char *bytes)
{
    FILE *file = tmpfile();
    page p = new_page();

    fputs(bytes, file);
    rewind(file);
    page_base64(&p, file);
    fclose(file);
    return take(p.out);
}

/* RFC 4648, section 10 */
TEST(test_base64)
{
    assert_string_equal(in_base64(""), "");
    assert_string_equal(in_base64("f"), "Zg==");
    assert_string_equal(in_base64("fo"), "Zm8=");
    assert_string_equal(in_base64("foo"), "Zm9v");
    assert_string_equal(in_base64("foobar"), "Zm9vYmFy");
    assert_string_equal(in_base64("\xfb\xff\xfe"), "+//+");
}

/* ---------------------------------------------------------------------------------------- equations */

/* The text of markup, without its elements. */
static const char *text_of(char *markup)
{
    char *to = markup, *from = markup;
    int is_tag = 0;

    for (; *from; from++) {
        if (*from == '<')
            is_tag = 1;
        if (!is_tag)
            *to++ = *from;
        if (*from == '>')
            is_tag = 0;
    }
    *to = '\0';
    return markup;
}

/* Metre, newton, second, in which a speed is written twice where the tables have mm/s. */
static fourlink_unit si[QUANTITY_COUNT];

static void set_up_units(void)
{
    static const fourlink_unit one = {"1", 1, 1, 0};
    int i;

    for (i = 0; i < QUANTITY_COUNT; i++)
        si[i] = one;
    si[QUANTITY_LENGTH].name = "m";
    si[QUANTITY_FORCE].name = "N";
    si[QUANTITY_SPEED].name = "mm/s";
    si[QUANTITY_SPEED].down = 1000;
}

static const char *equation(const char *words, double beta)
{
    page p = new_page();
    math m;

    set_up_units();
    math_begin(&m, &p, si);
    math_set(&m, "a", -2);
    math_set(&m, "b", 1.5e-7);
    math_set(&m, "beta", beta);
    math_let(&m, "omega3", words, -0.1234567);
    take(p.out);
    return text_of(written);
}

TEST(test_equations)
{
    /* a negative number has brackets, but not at the beginning; a power of ten; an angle in degrees */
    assert_string_equal(equation("a * b + a", 1), "\n(1)\n\xcf\x89"
                                                  "3=a\xe2\x81\xa2"
                                                  "b+a\n"
                                                  "=\xe2\x88\x92"
                                                  "2\xc2\xb7"
                                                  "1.5\xc2\xb7"
                                                  "10\xe2\x88\x92"
                                                  "7+(\xe2\x88\x92"
                                                  "2)"
                                                  "=\xe2\x88\x92"
                                                  "0.123457\xc2\xa0rad/s\n\n");
    assert_non_null(strstr(equation("sin beta", 0.5), "sin\xe2\x81\xa1"
                                                      "28.6479\xc2\xb0"));
    assert_non_null(strstr(equation("sin beta", -0.5), "(\xe2\x88\x92"
                                                       "28.6479\xc2\xb0)"));
    assert_non_null(strstr(equation("a ^2", 1), "=(\xe2\x88\x92"
                                                "2)2="));
    /* a group is left out where its symbol is 0, with the sign that then begins */
    assert_non_null(strstr(equation("<beta b > + a", 0), "3=a\n"));
    assert_non_null(strstr(equation("<beta b > + a", 1), "3=b+a\n"));
}

int main(void)
{
    return run_all_tests(NULL);
}
