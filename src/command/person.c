/* SPDX-License-Identifier: GPL-3.0-or-later
**
** person.c - names of people, compared by their words.
*/
#include <string.h>

#include "person.h"

/* The plain letters of U+00C0 to U+017F, in the order of the code points, two for each; "  " is none. */
static const char letters[] = "a a a a a a aec e e e e i i i i d n o o o o o   o u u u u y thss"
                              "a a a a a a aec e e e e i i i i d n o o o o o   o u u u u y thy "
                              "a a a a a a c c c c c c c c d d d d e e e e e e e e e e g g g g "
                              "g g g g h h h h i i i i i i i i i i ijijj j k k k l l l l l l l "
                              "l l l n n n n n n n n n o o o o o o oeoer r r r r r s s s s s s "
                              "s s t t t t t t u u u u u u u u u u u u w w y y y z z z z z z s ";

/* Begin another word, if the last one has letters. */
static void end_word(person_words *w, int n)
{
    if (n > w->start[w->n] && w->n + 1 < PERSON_WORDS)
        w->start[++w->n] = n;
}

/* The small letter of a capital of two bytes, Greek or Cyrillic, of which the second byte is this; 0 for
** others. */
static int small_letter(unsigned char c, unsigned char next, char *first)
{
    int is_greek = c == 0xce && next >= 0x91 && next <= 0xa9;

    if (!is_greek && !(c == 0xd0 && next >= 0x80 && next <= 0xaf))
        return 0;
    if (is_greek) {
        *first = (char)(next < 0xa0 ? 0xce : 0xcf);
        return next < 0xa0 ? next + 0x20 : next - 0x20;
    }
    *first = (char)(next >= 0x90 && next < 0xa0 ? 0xd0 : 0xd1);
    return next < 0x90 ? next + 0x10 : next < 0xa0 ? next + 0x20 : next - 0x20;
}

void person_add(person_words *w, text t)
{
    int n = w->start[w->n], small;
    size_t i;

    for (i = 0; i < t.length && n + 3 < PERSON_NAME; i++) {
        unsigned char c = (unsigned char)t.start[i];
        unsigned char next = i + 1 < t.length ? (unsigned char)t.start[i + 1] : 0;

        if (c == '\'' || c == '`') {
            continue;
        } else if (c == 0xe2 && next == 0x80 && i + 2 < t.length &&
                   ((unsigned char)t.start[i + 2] & 0xfe) == 0x98) {
            i += 2;
        } else if (c == '_' || !flk_text_is_word(c)) {
            end_word(w, n);
        } else if (c >= 0xc3 && c <= 0xc5 && next >= 0x80) {
            const char *plain = letters + 2 * ((c - 0xc3) * 64 + (next & 63));

            w->letters[n++] = plain[0];
            if (plain[1] != ' ')
                w->letters[n++] = plain[1];
            i++;
        } else if ((small = small_letter(c, next, &w->letters[n])) != 0) {
            w->letters[n + 1] = (char)small;
            n += 2;
            i++;
        } else if ((c == 0xcc && next >= 0x80) || (c == 0xcd && next >= 0x80 && next < 0xb0)) {
            i++;
        } else {
            w->letters[n++] = (char)('A' <= c && c <= 'Z' ? c + ('a' - 'A') : c);
        }
    }
    end_word(w, n);
    w->letters[w->start[w->n]] = '\0';
}

void person_take(person_words *w, text t)
{
    w->n = w->start[0] = 0;
    person_add(w, t);
}

int person_length(const person_words *w)
{
    return w->start[w->n];
}

int person_are_same(const person_words *x, const person_words *y)
{
    return x->n == y->n && memcmp(x->start, y->start, ((size_t)x->n + 1) * sizeof *x->start) == 0 &&
           strcmp(x->letters, y->letters) == 0;
}

int person_same(text x, text y)
{
    person_words a, b;

    person_take(&a, x);
    person_take(&b, y);
    return person_are_same(&a, &b);
}

int person_has_turned(const person_words *w, const person_words *part, int k)
{
    int n = person_length(part), first = n - part->start[k], i, j;

    for (i = 0; i < w->n && w->start[i] + n <= person_length(w); i++) {
        const char *at = w->letters + w->start[i];

        if (memcmp(at, part->letters + part->start[k], (size_t)first) != 0 ||
            memcmp(at + first, part->letters, (size_t)part->start[k]) != 0)
            continue;
        for (j = i + 1; j <= w->n; j++)
            if (w->start[j] == w->start[i] + n)
                return 1;
    }
    return 0;
}

int person_has_name(const person_words *w, const person_words *name)
{
    int k;

    for (k = 0; k < name->n; k++)
        if (person_has_turned(w, name, k))
            return 1;
    return 0;
}

int person_is_word(const person_words *w, int i, const person_words *of, int *is_whole)
{
    int n = w->start[i + 1] - w->start[i], k, is_there = 0;

    for (k = 0; k < of->n; k++) {
        int length = of->start[k + 1] - of->start[k];

        if ((n == length || n == 1) &&
            memcmp(w->letters + w->start[i], of->letters + of->start[k], (size_t)n) == 0) {
            is_there = 1;
            *is_whole |= n == length;
        }
    }
    return is_there;
}
