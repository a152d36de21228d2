/* SPDX-License-Identifier: GPL-3.0-or-later
**
** parser.c - memory and texts that last as long as the deck.
*/
#include <string.h>

#include "base/spelling.h"
#include "base/utf16.h"
#include "parser.h"

void *flk_reader_keep(parser *p, size_t size)
{
    void *result = flk_deck_keep(p->d, size);

    if (!result)
        p->out_of_memory = 1;
    return result;
}

void *flk_reader_grow(parser *p, void *list, size_t *capacity, size_t n, size_t size)
{
    size_t more = *capacity ? 2 * *capacity : 64;
    void *bigger;

    if (n < *capacity)
        return list;
    bigger = flk_reader_keep(p, more * size);
    if (!bigger)
        return NULL;
    if (n)
        memcpy(bigger, list, n * size);
    *capacity = more;
    return bigger;
}

char *flk_reader_copy(parser *p, text t, const char *ending)
{
    char *copy = flk_reader_keep(p, t.length + strlen(ending) + 1);

    if (!copy)
        return NULL;
    if (t.length)
        memcpy(copy, t.start, t.length);
    return strcpy(copy + t.length, ending) - t.length;
}

text flk_reader_plain(parser *p, text t)
{
    char *copy = flk_spelling_is_plain(t) ? NULL : flk_reader_keep(p, SPELLING_SIZE(t.length));

    return copy ? flk_spelling_plain(t, copy) : t;
}

text flk_reader_utf8(parser *p, text t)
{
    char *copy = flk_utf16_is(t) ? flk_reader_keep(p, UTF16_SIZE(t.length)) : NULL;

    return copy ? flk_utf16_convert(t, copy) : t;
}

text_place flk_reader_end(const parser *p)
{
    text_place place;

    place.source = p->name;
    place.line = p->last_line;
    return place;
}
