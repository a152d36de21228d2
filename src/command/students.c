/* SPDX-License-Identifier: GPL-3.0-or-later
**
** students.c - the files of a folder by the names of students: what was handed in, by whom, and what is
** nobody's.
*/
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "files.h"
#include "students.h"

#define MOST_ENDINGS 3 /* such as .expect.txt */

static const char *const endings[] = {".expect", ".txt", ".csv", NULL};

static const char *ending_of(const char *name)
{
    int i;

    for (i = 0; endings[i]; i++)
        if (flk_text_ends_in(flk_text_of(name), endings[i]))
            return endings[i];
    return NULL;
}

int students_is_text(const char *name)
{
    return ending_of(name) != NULL;
}

text students_stem(const char *path)
{
    text stem = flk_text_of(files_name(path));
    size_t i;
    int k;

    for (k = 0; k < MOST_ENDINGS; k++) {
        for (i = stem.length; i > 1 && stem.start[i - 1] != '.' && stem.length - i < 7; i--)
            if (!flk_text_is_word(stem.start[i - 1]))
                return stem; /* Dr. A. Bek: no ending */
        if (i <= 1 || stem.start[i - 1] != '.')
            break;
        stem.length = i - 1;
    }
    return stem;
}

#define NAME 256

/* The plain letters of U+00C0 to U+017F, in the order of the code points, two for each; "  " is none. */
static const char letters[] = "a a a a a a aec e e e e i i i i d n o o o o o   o u u u u y thss"
                              "a a a a a a aec e e e e i i i i d n o o o o o   o u u u u y thy "
                              "a a a a a a c c c c c c c c d d d d e e e e e e e e e e g g g g "
                              "g g g g h h h h i i i i i i i i i i ijijj j k k k l l l l l l l "
                              "l l l n n n n n n n n n o o o o o o oeoer r r r r r s s s s s s "
                              "s s t t t t t t u u u u u u u u u u u u w w y y y z z z z z z s ";

/* A name in plain letters.  A mark that stands behind its letter, U+0300 to U+036F, is left out. */
static void fold(text t, char out[NAME])
{
    size_t n = 0, i;

    for (i = 0; i < t.length && n + 3 < NAME; i++) {
        unsigned char c = (unsigned char)t.start[i];
        unsigned char next = i + 1 < t.length ? (unsigned char)t.start[i + 1] : 0;

        if (c == ' ' || c == '_' || c == '-' || c == '.') {
            if (n && out[n - 1] != ' ')
                out[n++] = ' ';
        } else if (c >= 0xc3 && c <= 0xc5 && next >= 0x80) {
            const char *plain = letters + 2 * ((c - 0xc3) * 64 + (next & 63));

            out[n++] = plain[0];
            if (plain[1] != ' ')
                out[n++] = plain[1];
            i++;
        } else if ((c == 0xcc && next >= 0x80) || (c == 0xcd && next >= 0x80 && next < 0xb0)) {
            i++;
        } else {
            out[n++] = (char)('A' <= c && c <= 'Z' ? c + ('a' - 'A') : c);
        }
    }
    while (n && out[n - 1] == ' ')
        n--;
    out[n] = '\0';
}

int students_same(text x, text y)
{
    char a[NAME], b[NAME];

    fold(x, a);
    fold(y, b);
    return strcmp(a, b) == 0;
}

static int take_name(void *host, const char *name)
{
    student_files *f = host;
    char **more;

    if (name[0] == '.')
        return 1;
    more = memory_grow(f->names, f->n + 1, sizeof *more);
    if (!more)
        return 0;
    f->names = more;
    more[f->n] = memory_get(strlen(name) + 1, 1);
    if (!more[f->n])
        return 0;
    strcpy(more[f->n++], name);
    return 1;
}

static int compare_names(const void *x, const void *y)
{
    return strcmp(*(char *const *)x, *(char *const *)y);
}

int students_list(student_files *f, const char *folder)
{
    memset(f, 0, sizeof *f);
    if (!system_list(folder, take_name, f))
        return 0;
    if (f->n)
        qsort(f->names, f->n, sizeof *f->names, compare_names);
    f->claimed = memory_get(f->n + 1, sizeof *f->claimed);
    return f->claimed != NULL;
}

void students_free(student_files *f)
{
    size_t i;

    for (i = 0; i < f->n; i++)
        free(f->names[i]);
    free(f->names);
    free(f->claimed);
}

/* How well a file answers to a name: the smaller, the better; 0: not at all. */
static int fit(const char *name, text stem)
{
    const char *ending = ending_of(name);
    text own = flk_text_of(name);
    int kind = !ending ? 4 : ending == endings[0] ? 1 : ending == endings[1] ? 2 : 3;

    if (ending)
        own.length -= strlen(ending);
    if (own.length == stem.length && memcmp(own.start, stem.start, own.length) == 0)
        return kind;
    return students_same(students_stem(name), stem) ? 4 + kind : 0;
}

const char *students_find(student_files *f, text stem)
{
    size_t i, best = f->n;
    int least = 0;

    for (i = 0; i < f->n; i++) {
        int own = fit(f->names[i], stem);

        if (own && (!least || own < least)) {
            least = own;
            best = i;
        }
    }
    if (best == f->n)
        return NULL;
    f->claimed[best] = 1;
    return f->names[best];
}

size_t students_tell_unclaimed(const student_files *f, const char *folder, const char *const *stems)
{
    char own[NAME], words[MESSAGE_SIZE];
    const char *nearest;
    size_t i, k, n = 0;

    for (i = 0; i < f->n; i++) {
        if (f->claimed[i])
            continue;
        n++;
        for (k = 0; k < f->n; k++)
            if (f->claimed[k] &&
                students_same(students_stem(f->names[k]), students_stem(f->names[i])))
                break;
        if (k < f->n) {
            flk_message(words, sizeof words, "'%s' is not read: '%s' is", f->names[i], f->names[k]);
            command_tell("note", folder, 0, words, NULL);
            continue;
        }
        nearest = flk_text_nearest(
            flk_text_of(flk_text_copy(students_stem(f->names[i]), own, sizeof own)), stems);
        flk_message(words, sizeof words,
                    nearest ? "'%s' is nobody's: no deck has its name; the nearest is '%s'"
                            : "'%s' is nobody's: no deck has its name",
                    f->names[i], nearest);
        command_tell("note", folder, 0, words, NULL);
    }
    return n;
}
