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
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "files.h"
#include "handed.h"
#include "person.h"
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
static int is_other(const person_words *w, int i)
{
    char word[PERSON_NAME];
    int n = w->start[i + 1] - w->start[i];

    memcpy(word, w->letters + w->start[i], (size_t)n);
    word[n] = '\0';
    return strpbrk(word, DIGITS) || is_one_of(word, others, COUNT(others)) ||
           (strpbrk(w->letters, DIGITS) && is_one_of(word, of_dates, COUNT(of_dates)));
}

/* 1 if the names in w are all of the student, or the student's all in w. */
static int has_part(const person_words *w, const person_words *name)
{
    int i, is_whole = 0, is_within = 1, is_around = name->n > 1, unused;

    for (i = 0; i < w->n && is_within; i++)
        is_within = is_other(w, i) || person_is_word(w, i, name, &is_whole);
    for (i = 0; i < name->n && is_around; i++) {
        unused = 0;
        is_around = person_is_word(name, i, w, &unused) && unused;
    }
    return (is_within && is_whole) || is_around;
}

/* ----------------------------------------------------------------------------------------- the students */

int students_add(students *s, text name, const roster_entry *entry)
{
    student *more, *x;
    person_words words;
    size_t i;

    person_take(&words, name);
    for (i = 0; i < s->n && !entry; i++)
        if (person_are_same(s->list[i].words, &words))
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
    person_words words;
    size_t i;

    person_take(&words, name);
    for (i = 0; i < s->n; i++)
        if (person_are_same(s->list[i].words, &words))
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
        errno = 0;
        is_listed = path && files_is_folder(path) && system_is_within(folder, path);
        if (is_listed && !is_for_output(path, o))
            is_listed = system_list(path, take_file, &l);
        if (!is_listed)
            memory_note_reason(errno);
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

/* ------------------------------------------------------------------------------------- whose file it is */

/* Who may have handed in a file. */
typedef struct candidates {
    person_words who, all; /* of the part that says who, of all of the name */
    person_words parts[3]; /* of pieces between " - " */
    int n_parts;
    size_t first, second; /* students that fit equally well; n of all: none */
} candidates;

static int has_id(const person_words *w, text id)
{
    person_words words;

    person_take(&words, id);
    return person_length(&words) >= 3 && person_has_turned(w, &words, 0);
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

/* How well a file fits a student by the name, by an ID, by a part of the name: the larger, the better;
** 0: not at all. */
static int fit_by_name(const candidates *c, const student *x)
{
    if (person_are_same(&c->who, x->words))
        return PERSON_NAME;
    return x->words->n > 1 && person_has_name(&c->who, x->words) ? person_length(x->words) : 0;
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

    person_take(&c->who, who);
    person_take(&c->all, stem);
    if (strcmp(f->owner, f->name) != 0)
        person_add(&c->all, handed_stem(f->name));
    c->n_parts = 0;
    while (c->n_parts < 2 && flk_text_cut(rest, " - ", &part, &rest))
        person_take(&c->parts[c->n_parts++], part);
    person_take(&c->parts[c->n_parts++], rest);
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
                person_is_word(&c->who, i, s->list[k].words, &unused) && unused)
                return &s->list[k];
    return NULL;
}

/* The names of all, first name first and surname first, without blanks; null if out of memory. */
static char **turn_names(const students *s)
{
    char **turned = memory_get(2 * s->n + 1, sizeof *turned);
    size_t i;

    for (i = 0; i < s->n && turned; i++) {
        const person_words *w = s->list[i].words;
        int last = w->n > 1 ? w->start[w->n - 1] : 0;

        turned[2 * i] = memory_copy(w->letters);
        turned[2 * i + 1] = memory_get(PERSON_NAME, 1);
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
        marked = date == 0 || other == 0 || date == other ? NULL : date > other ? name : x->file;
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

int students_match(students *s, const char *folder, int is_class)
{
    char **turned = turn_names(s);
    candidates *c = memory_get(1, sizeof *c);
    int is_done = turned && c && !memory_has_failed();
    size_t i;

    for (i = 0; i < s->n_files && is_done; i++) {
        find_candidates(s, &s->files[i], c);
        if (c->first < s->n && c->second == s->n)
            give(&s->list[c->first], folder, s->files[i].name);
        else if (is_class)
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
