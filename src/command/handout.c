/* SPDX-License-Identifier: GPL-3.0-or-later
**
** handout.c - what students get of a deck.
*/
#include <string.h>

#include "base/text.h"
#include "handout.h"

/* 1 if students do not get a section. */
static int is_instructors(text header)
{
    text name;

    flk_text_split(&header, ']', &name);
    return flk_text_equal(name, "[expect") || flk_text_equal(name, "[misprint") ||
           flk_text_equal(name, "[grading");
}

size_t handout_strip(char *deck, size_t length)
{
    int is_left_out = 0, is_top = 1;
    text rest, row, key, value;
    char *out = deck;

    rest.start = deck;
    rest.length = length;
    while (rest.start && rest.length) {
        const char *start = rest.start;
        size_t n;

        flk_text_split(&rest, '\n', &row);
        n = row.length + (rest.start != NULL);
        row = flk_text_trim(row);
        if (row.length && row.start[0] == '[') {
            is_left_out = is_instructors(row);
            is_top = 0;
        }
        if (is_left_out ||
            (is_top && flk_text_cut(row, "=", &key, &value) && flk_text_equal(key, "solver")))
            continue;
        memmove(out, start, n);
        out += n;
    }
    *out = '\0';
    return (size_t)(out - deck);
}
