/* SPDX-License-Identifier: GPL-3.0-or-later
**
** utf16.c - texts in UTF-16, as Notepad and PowerShell save them, in UTF-8.
*/
#include "utf16.h"

#define REPLACEMENT 0xfffdUL

static int is_little_endian(text t)
{
    return t.length >= 2 && (unsigned char)t.start[0] == 0xff && (unsigned char)t.start[1] == 0xfe;
}

int flk_utf16_is(text t)
{
    return is_little_endian(t) || (t.length >= 2 && (unsigned char)t.start[0] == 0xfe &&
                                   (unsigned char)t.start[1] == 0xff);
}

/* The two bytes at the front as a number; the replacement character if there is only one. */
static unsigned long code_unit(text t, int is_little)
{
    const unsigned char *c = (const unsigned char *)t.start;

    if (t.length < 2)
        return REPLACEMENT;
    return is_little ? c[0] + 256UL * c[1] : 256UL * c[0] + c[1];
}

/* Take the next character off the front: two bytes, or four of a surrogate pair. */
static unsigned long take(text *t, int is_little)
{
    unsigned long first = code_unit(*t, is_little), second;

    *t = flk_text_from(*t, t->length < 2 ? t->length : 2);
    if (first < 0xd800 || first > 0xdfff)
        return first;
    second = code_unit(*t, is_little);
    if (first > 0xdbff || second < 0xdc00 || second > 0xdfff)
        return REPLACEMENT;
    *t = flk_text_from(*t, 2);
    return 0x10000 + ((first - 0xd800) << 10) + (second - 0xdc00);
}

/* Write a character in UTF-8.  Returns the end of what was written. */
static char *put_utf8(unsigned long c, char *out)
{
    int more = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3; /* bytes after the first */
    static const unsigned char first[] = {0, 0xc0, 0xe0, 0xf0};

    *out++ = (char)(first[more] | (c >> 6 * more));
    while (more-- > 0)
        *out++ = (char)(0x80 | ((c >> 6 * more) & 0x3f));
    return out;
}

text flk_utf16_convert(text t, char *out)
{
    int is_little = is_little_endian(t);
    char *end = out;

    while (t.length)
        end = put_utf8(take(&t, is_little), end);
    t.start = out;
    t.length = (size_t)(end - out);
    return t;
}
