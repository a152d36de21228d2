/* SPDX-License-Identifier: GPL-3.0-or-later
**
** handout.c - what students get of a deck.
*/
#include <string.h>

#include "base/text.h"
#include "handout.h"

int handout_section(text row, text *name)
{
    if (!row.length || row.start[0] != '[')
        return 0;
    row = flk_text_from(row, 1);
    flk_text_split(&row, ']', name);
    *name = flk_text_trim(*name);
    return 1;
}

/* 1 if students do not get a section. */
static int is_instructors(text name)
{
    return flk_text_equal(name, "expect") || flk_text_equal(name, "misprint") ||
           flk_text_equal(name, "grading");
}

size_t handout_strip(char *deck, size_t length)
{
    int is_left_out = 0, is_top = 1, end;
    text rest, row, name, key, value;
    char *out = deck;

    rest.start = deck;
    rest.length = length;
    end = flk_text_line_end(rest);
    while (rest.start && rest.length) {
        const char *start = rest.start;
        size_t n;

        flk_text_split(&rest, end, &row);
        n = row.length + (rest.start != NULL);
        row = flk_text_trim(row);
        if (handout_section(row, &name)) {
            is_left_out = is_instructors(name);
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
