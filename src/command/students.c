/* SPDX-License-Identifier: GPL-3.0-or-later
**
** students.c - the students of a class, and which file of a folder each has handed in.
**
** A file is that of a student if its name has
**
**    1. the student's name, in any order of its parts, with blanks between them or without; the longest counts
**    2. or the ID, the user name or the email of the list
**    3. or words of the student's name and no others, such as the surname alone
**
** and no other student fits as well.
*/
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "files.h"
#include "handed.h"
#include "students.h"

/* --------------------------------------------------------------------------------------------- endings */

static const char *const endings[] = {".expect", ".txt", ".csv", NULL};

int students_is_text(const char *name)
{
    int i;

    for (i = 0; endings[i]; i++)
        if (flk_text_ends_in(flk_text_of(name), endings[i]))
            return 1;
    return 0;
}

/* ----------------------------------------------------------------------------------- the words of a name */

#define NAME 256
#define MOST_WORDS 40

/* The words of a name in plain letters, one behind the other. */
typedef struct student_words {
    char letters[NAME];
    int start[MOST_WORDS + 1];
    int n;
} student_words;

/* The plain letters of U+00C0 to U+017F, in the order of the code points, two for each; "  " is none. */
static const char letters[] = "a a a a a a aec e e e e i i i i d n o o o o o   o u u u u y thss"
                              "a a a a a a aec e e e e i i i i d n o o o o o   o u u u u y thy "
                              "a a a a a a c c c c c c c c d d d d e e e e e e e e e e g g g g "
                              "g g g g h h h h i i i i i i i i i i ijijj j k k k l l l l l l l "
                              "l l l n n n n n n n n n o o o o o o oeoer r r r r r s s s s s s "
                              "s s t t t t t t u u u u u u u u u u u u w w y y y z z z z z z s ";

/* Begin another word, if the last one has letters. */
static void end_word(student_words *w, int n)
{
    if (n > w->start[w->n] && w->n + 1 < MOST_WORDS)
        w->start[++w->n] = n;
}

/* The small letter of a capital of two bytes, Greek or Cyrillic, of which the second byte is this; 0 for others. */
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

/* Add the words of a text.  Marks that stand behind their letter, U+0300 to U+036F, and apostrophes are left out. */
static void add_words(student_words *w, text t)
{
    int n = w->start[w->n], small;
    size_t i;

    for (i = 0; i < t.length && n + 3 < NAME; i++) {
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

static void take_words(student_words *w, text t)
{
    w->n = w->start[0] = 0;
    add_words(w, t);
}

static int length_of(const student_words *w)
{
    return w->start[w->n];
}

/* 1 if two have the same words. */
static int are_same(const student_words *x, const student_words *y)
{
    return x->n == y->n && memcmp(x->start, y->start, ((size_t)x->n + 1) * sizeof *x->start) == 0 &&
           strcmp(x->letters, y->letters) == 0;
}

int students_same(text x, text y)
{
    student_words a, b;

    take_words(&a, x);
    take_words(&b, y);
    return are_same(&a, &b);
}

/* 1 if whole words of w, one behind the other, are the letters of `part`, from its word k on and then those before it. */
static int has_turned(const student_words *w, const student_words *part, int k)
{
    int n = length_of(part), first = n - part->start[k], i, j;

    for (i = 0; i < w->n && w->start[i] + n <= length_of(w); i++) {
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

static int has_name(const student_words *w, const student_words *name)
{
    int k;

    for (k = 0; k < name->n; k++)
        if (has_turned(w, name, k))
            return 1;
    return 0;
}

/* 1 if word i of w is one of `of`, or begins one if it is a single letter; *is_whole is set if it is all of it. */
static int is_word_of(const student_words *w, int i, const student_words *of, int *is_whole)
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

/* Words of names of files that are no names; those of dates beside a number. */
static const char *const others[] = {
    "late",     "file",     "final",      "copy",       "answer",   "answers", "hw",
    "homework", "solution", "assignment", "submission", "exercise", "attempt", "onlinetext"};
static const char *const of_dates[] = {"jan", "feb", "mar", "apr", "may", "jun", "jul",
                                       "aug", "sep", "oct", "nov", "dec", "am",  "pm"};

#define COUNT(list) (sizeof(list) / sizeof *(list))
#define DIGITS "0123456789"

static int is_one_of(const char *word, const char *const *list, size_t n)
{
    size_t k;

    for (k = 0; k < n; k++)
        if (strcmp(word, list[k]) == 0)
            return 1;
    return 0;
}

/* 1 if word i is no name: it has a digit, or it is one of those above. */
static int is_other(const student_words *w, int i)
{
    char word[NAME];
    int n = w->start[i + 1] - w->start[i];

    memcpy(word, w->letters + w->start[i], (size_t)n);
    word[n] = '\0';
    return strpbrk(word, DIGITS) || is_one_of(word, others, COUNT(others)) ||
           (strpbrk(w->letters, DIGITS) && is_one_of(word, of_dates, COUNT(of_dates)));
}

/* 1 if the names in w are all of the student, or the student's all in w. */
static int has_part(const student_words *w, const student_words *name)
{
    int i, is_whole = 0, is_within = 1, is_around = name->n > 1, unused;

    for (i = 0; i < w->n && is_within; i++)
        is_within = is_other(w, i) || is_word_of(w, i, name, &is_whole);
    for (i = 0; i < name->n && is_around; i++) {
        unused = 0;
        is_around = is_word_of(name, i, w, &unused) && unused;
    }
    return (is_within && is_whole) || is_around;
}

/* ------------------------------------------------------------------------------------------ the students */

int students_add(students *s, text name, const roster_entry *entry)
{
    student *more, *x;
    student_words words;
    size_t i;

    take_words(&words, name);
    for (i = 0; i < s->n && !entry; i++)
        if (are_same(s->list[i].words, &words))
            return 1;
    more = memory_grow(s->list, s->n + 1, sizeof *more);
    if (!more)
        return 0;
    s->list = more;
    x = &more[s->n];
    memset(x, 0, sizeof *x);
    x->words = memory_get(1, sizeof *x->words);
    if (!x->words)
        return 0;
    *x->words = words;
    x->name = name;
    x->entry = entry;
    s->n++;
    return 1;
}

int students_add_owners(students *s)
{
    size_t i;

    for (i = 0; i < s->n_files; i++)
        if (students_is_text(s->files[i].name) &&
            !students_add(s, handed_who(handed_stem(s->files[i].owner)), NULL))
            return 0;
    return 1;
}

const student *students_find(const students *s, text name)
{
    student_words words;
    size_t i;

    take_words(&words, name);
    for (i = 0; i < s->n; i++)
        if (are_same(s->list[i].words, &words))
            return &s->list[i];
    return NULL;
}

/* -------------------------------------------------------------------------------------------- the files */

/* Where a listed name goes. */
typedef struct listing {
    students *s;
    const char *folder; /* of a student, within the folder; null: the folder itself */
} listing;

static int take_file(void *host, const char *name)
{
    listing *l = host;
    students *s = l->s;
    student_file *more, *f;

    if (name[0] == '.' || strncmp(name, "__MACOSX", 8) == 0 ||
        flk_text_ends_in(flk_text_of(name), ".deck"))
        return 1;
    more = memory_grow(s->files, s->n_files + 1, sizeof *more);
    if (!more)
        return 0;
    s->files = more;
    f = &more[s->n_files];
    f->name = l->folder ? files_within(l->folder, flk_text_of(name), "") : memory_copy(name);
    f->owner = memory_copy(l->folder ? l->folder : name);
    s->n_files++;
    return f->name && f->owner;
}

static int compare_files(const void *x, const void *y)
{
    return strcmp(((const student_file *)x)->name, ((const student_file *)y)->name);
}

static void sort_files(students *s)
{
    if (s->n_files)
        qsort(s->files, s->n_files, sizeof *s->files, compare_files);
}

static void drop_file(student_file *f)
{
    free(f->name);
    free(f->owner);
    f->name = f->owner = NULL;
}

/* 1 if a path is that of a folder which the options name for output. */
static int is_for_output(const char *path, const options *o)
{
    return (o->feedback && system_is_same(path, o->feedback)) ||
           (o->output && !*files_name(o->output) && system_is_same(path, o->output));
}

/* List what is in the folders of students, in their place.  One without files stays as it is. */
static int open_folders(students *s, const char *folder, const options *o)
{
    size_t n = s->n_files, i, k, before;
    int is_open = 1, is_listed;
    listing l;

    l.s = s;
    for (i = 0; i < n && is_open; i++) {
        char *path = files_within(folder, flk_text_of(s->files[i].name), "");

        before = s->n_files;
        l.folder = s->files[i].owner;
        is_listed = path && files_is_folder(path) && system_is_within(folder, path);
        if (is_listed && !is_for_output(path, o))
            is_listed = system_list(path, take_file, &l);
        if (!path || memory_has_failed())
            is_open = 0;
        else if (s->n_files > before || (is_listed && !students_is_text(s->files[i].name)))
            drop_file(&s->files[i]);
        free(path);
    }
    for (i = k = 0; i < s->n_files; i++)
        if (s->files[i].name)
            s->files[k++] = s->files[i];
    s->n_files = k;
    return is_open;
}

int students_list(students *s, const char *folder, const options *o)
{
    listing l;

    memset(s, 0, sizeof *s);
    l.s = s;
    l.folder = NULL;
    if (!system_list(folder, take_file, &l))
        return 0;
    sort_files(s);
    if (!open_folders(s, folder, o))
        return 0;
    sort_files(s);
    return 1;
}

/* -------------------------------------------------------------------------------------- whose file it is */

/* Who may have handed in a file. */
typedef struct candidates {
    student_words who, all; /* of the part that says who, of all of the name */
    student_words parts[3]; /* of pieces between " - " */
    int n_parts;
    size_t first, second; /* students that fit equally well; n of all: none */
} candidates;

static int has_id(const student_words *w, text id)
{
    student_words words;

    take_words(&words, id);
    return length_of(&words) >= 3 && has_turned(w, &words, 0);
}

static int has_an_id(const candidates *c, const student *x)
{
    const roster_entry *e = x->entry;
    text email, user;

    if (!e)
        return 0;
    email = e->email;
    if (!flk_text_split(&email, '@', &user))
        user = email;
    return has_id(&c->all, e->id) || has_id(&c->all, e->user) || has_id(&c->all, user);
}

/* How well a file fits a student by the name, by an ID, by a part of the name: the larger, the better; 0: not at all. */
static int fit_by_name(const candidates *c, const student *x)
{
    if (are_same(&c->who, x->words))
        return NAME;
    return x->words->n > 1 && has_name(&c->who, x->words) ? length_of(x->words) : 0;
}

static int fit_by_part(const candidates *c, const student *x)
{
    int i;

    for (i = 0; i < c->n_parts; i++)
        if (has_part(&c->parts[i], x->words))
            return 1;
    return 0;
}

static int (*const fits[])(const candidates *c, const student *x) = {fit_by_name, has_an_id,
                                                                     fit_by_part};

#define FITS (int)(sizeof fits / sizeof *fits)

/* Find the two that fit best in one way; returns how well. */
static int find_best(const students *s, candidates *c, int way)
{
    int best = 0, own;
    size_t i;

    for (i = 0; i < s->n; i++) {
        own = fits[way](c, &s->list[i]);
        if (own && own == best && c->second == s->n) {
            c->second = i;
        } else if (own > best) {
            best = own;
            c->first = i;
            c->second = s->n;
        }
    }
    return best;
}

/* Of students with the same name, that whose ID a file has. */
static void ask_ids(const students *s, candidates *c, int best)
{
    size_t i, found = s->n, n = 0;

    for (i = 0; i < s->n; i++)
        if (fit_by_name(c, &s->list[i]) == best && has_an_id(c, &s->list[i])) {
            found = i;
            n++;
        }
    if (n == 1) {
        c->first = found;
        c->second = s->n;
    }
}

static void find_candidates(const students *s, const student_file *f, candidates *c)
{
    text stem = handed_stem(f->owner), who = handed_who(stem), rest = who, part;
    int best = 0, way;

    take_words(&c->who, who);
    take_words(&c->all, stem);
    if (strcmp(f->owner, f->name) != 0)
        add_words(&c->all, handed_stem(f->name));
    c->n_parts = 0;
    while (c->n_parts < 2 && flk_text_cut(rest, " - ", &part, &rest))
        take_words(&c->parts[c->n_parts++], part);
    take_words(&c->parts[c->n_parts++], rest);
    c->first = c->second = s->n;
    for (way = 0; way < FITS && !best; way++)
        best = find_best(s, c, way);
    if (way == 1 && c->second < s->n)
        ask_ids(s, c, best);
}

/* The student whose name is the nearest to that of a file; null if none is near. */
static const student *find_nearest(const students *s, const candidates *c, char **turned)
{
    const char *nearest =
        flk_text_nearest(flk_text_of(c->who.letters), (const char *const *)turned);
    int i, unused = 0;
    size_t k;

    for (k = 0; nearest && turned[k] != nearest; k++)
        ;
    if (nearest)
        return &s->list[k / 2];
    for (k = 0; k < s->n; k++)
        for (i = 0; i < c->who.n; i++)
            if (c->who.start[i + 1] - c->who.start[i] > 1 &&
                is_word_of(&c->who, i, s->list[k].words, &unused) && unused)
                return &s->list[k];
    return NULL;
}

/* The names of all, first name first and surname first, without blanks; null if out of memory. */
static char **turn_names(const students *s)
{
    char **turned = memory_get(2 * s->n + 1, sizeof *turned);
    size_t i;

    for (i = 0; i < s->n && turned; i++) {
        const student_words *w = s->list[i].words;
        int last = w->n > 1 ? w->start[w->n - 1] : 0;

        turned[2 * i] = memory_copy(w->letters);
        turned[2 * i + 1] = memory_get(NAME, 1);
        if (!turned[2 * i] || !turned[2 * i + 1])
            break;
        strcpy(turned[2 * i + 1], w->letters + last);
        strncat(turned[2 * i + 1], w->letters, (size_t)last);
    }
    return turned;
}

static void free_names(char **turned, size_t n)
{
    size_t i;

    for (i = 0; i < 2 * n && turned; i++)
        free(turned[i]);
    free(turned);
}

/* Tell that a file is nobody's, or may be of two. */
static void tell_unclaimed(const students *s, const char *folder, const student_file *f,
                           const candidates *c, char **turned)
{
    const student *nearest = NULL;
    char words[MESSAGE_SIZE];

    if (c->second < s->n) {
        flk_message(words, sizeof words, "'%s' is not marked: it may be of '%t' or of '%t'",
                    f->name, s->list[c->first].name, s->list[c->second].name);
    } else if (!students_is_text(f->name)) {
        flk_message(words, sizeof words, "'%s' is not read: it is no text or csv", f->name);
    } else if ((nearest = find_nearest(s, c, turned)) != NULL) {
        flk_message(words, sizeof words, "'%s' is nobody's; the nearest name is '%t'", f->name,
                    nearest->name);
    } else {
        flk_message(words, sizeof words, "'%s' is nobody's: no name is near", f->name);
    }
    command_tell("note", folder, 0, words, NULL);
}

/* Give a student another file: that of the later date counts, and one that is no text only without others. */
static void give(student *x, const char *folder, const char *name)
{
    double date, other;
    const char *told, *marked;
    char words[MESSAGE_SIZE];

    if (!x->file) {
        x->file = name;
        return;
    }
    if (students_is_text(x->file) != students_is_text(name)) {
        marked = students_is_text(name) ? name : x->file;
        told = marked == name ? x->file : name;
        flk_message(words, sizeof words, "'%s' is not read: '%s' is", told, marked);
    } else if (x->second) {
        marked = x->file;
        flk_message(words, sizeof words, "another file of '%t': '%s' is not marked", x->name, name);
    } else {
        date = handed_date(flk_text_of(name));
        other = handed_date(flk_text_of(x->file));
        marked = !date || !other || date == other ? NULL : date > other ? name : x->file;
        told = marked == name ? x->file : name;
        if (!marked)
            x->second = name;
        flk_message(words, sizeof words,
                    marked ? "two files of '%t': '%s' is not marked, '%s' is later"
                           : "two files of '%t': neither '%s' nor '%s' is marked",
                    x->name, marked ? told : x->file, marked ? marked : name);
    }
    command_tell("note", folder, 0, words, NULL);
    x->file = marked ? marked : x->file;
}

int students_match(students *s, const char *folder)
{
    char **turned = turn_names(s);
    candidates *c = memory_get(1, sizeof *c);
    int is_done = turned && c && !memory_has_failed();
    size_t i;

    for (i = 0; i < s->n_files && is_done; i++) {
        find_candidates(s, &s->files[i], c);
        if (c->first < s->n && c->second == s->n)
            give(&s->list[c->first], folder, s->files[i].name);
        else
            tell_unclaimed(s, folder, &s->files[i], c, turned);
    }
    free(c);
    free_names(turned, s->n);
    return is_done;
}

void students_free(students *s)
{
    size_t i;

    for (i = 0; i < s->n_files; i++)
        drop_file(&s->files[i]);
    for (i = 0; i < s->n; i++)
        free(s->list[i].words);
    free(s->files);
    free(s->list);
}
