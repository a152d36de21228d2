/* SPDX-License-Identifier: GPL-3.0-or-later
**
** test_utf16.c - texts in UTF-16 become UTF-8: both byte orders, surrogates, what is cut off.
*/
#include "check.h"
#include "base/utf16.h"

#define MARK "\357\273\277"
#define LOST "\357\277\275" /* the replacement character */

/* Big-endian, without the mark; the same in UTF-8. */
static const struct {
    const char *bytes;
    size_t length;
    const char *plain;
} cases[] = {
    {"", 0, ""},
    {"\0a\0 \0=\0\n", 8, "a =\n"},
    {"\0\177\0\200\7\377\10\0", 8, "\177\302\200\337\277\340\240\200"},
    {"\0\260\42\22", 4, "\302\260\342\210\222"}, /* a degree sign, a minus sign */
    {"\327\377\340\0\377\377", 6, "\355\237\277\356\200\200\357\277\277"},
    /* surrogate pairs: the first, the last, U+1F527 */
    {"\330\0\334\0", 4, "\360\220\200\200"},
    {"\333\377\337\377", 4, "\364\217\277\277"},
    {"\330\75\335\47\0m", 6, "\360\237\224\247m"},
    /* without the other */
    {"\330\0", 2, LOST},
    {"\330\0\0m", 4, LOST "m"},
    {"\334\0\0m", 4, LOST "m"},
    {"\330\0\330\0\334\0", 6, LOST "\360\220\200\200"},
    {"\334\0\330\0", 4, LOST LOST},
    {"\337\377\0m", 4, LOST "m"},
    /* a last byte alone */
    {"\0m\0", 3, "m" LOST},
    {"\330\0\334", 3, LOST LOST},
};

static void check_converted(const char *bytes, size_t length, const char *plain)
{
    char *copy = malloc(length),
         *out = malloc(UTF16_SIZE(length)); /* so that each byte beyond is seen */
    text t;

    assert_true(copy && out);
    memcpy(copy, bytes, length);
    t.start = copy;
    t.length = length;
    assert_true(flk_utf16_is(t));
    t = flk_utf16_convert(t, out);
    assert_in_range(t.length, 3, UTF16_SIZE(length));
    assert_memory_equal(t.start, MARK, 3);
    t = flk_text_without_mark(t);
    assert_int_equal(t.length, strlen(plain));
    assert_memory_equal(t.start, plain, t.length);
    free(out);
    free(copy);
}

TEST(test_both_byte_orders)
{
    char bytes[40];
    size_t i, k;

    for (i = 0; i < COUNT(cases); i++) {
        size_t n = cases[i].length;

        memcpy(bytes, "\376\377", 2);
        memcpy(bytes + 2, cases[i].bytes, n);
        check_converted(bytes, n + 2, cases[i].plain);
        for (k = 0; k + 1 < n + 2; k += 2) {
            char first = bytes[k];

            bytes[k] = bytes[k + 1];
            bytes[k + 1] = first;
        }
        check_converted(bytes, n + 2, cases[i].plain);
    }
}

TEST(test_other_texts)
{
    static const char *const others[] = {
        "",         "\377",     "\376",        "title = x", "\357\273\277title = x",
        "\377\377", "\376\376", "\260\377\376"};
    size_t i;

    for (i = 0; i < COUNT(others); i++)
        assert_false(flk_utf16_is(flk_text_of(others[i])));
}

int main(void)
{
    return run_all_tests(NULL);
}
