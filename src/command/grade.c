/* SPDX-License-Identifier: GPL-3.0-or-later
**
** grade.c - the answers that decks are checked against: a file, one of a folder for each deck, or all
** of a folder for one deck.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "files.h"
#include "grade.h"
#include "handed.h"
#include "person.h"

/* 1 if all files of the folder are answers to one deck: --answers says so, or there is none with the
** deck's name. */
static int is_class(const options *o, const students *s)
{
    size_t i;

    if (o->answers || o->n_decks != 1 || strcmp(o->decks[0], "-") == 0)
        return o->answers != NULL;
    for (i = 0; i < s->n_files; i++)
        if (person_same(handed_who(handed_stem(s->files[i].owner)), files_stem(o->decks[0])))
            return 0;
    return 1;
}

/* Find the students: those of the list, of the files, or of the decks; 0 if memory fails. */
static int add_students(grade_answers *a, const options *o)
{
    const roster_entry *e;
    int is_done = 1;
    size_t i;

    if (a->is_class && !a->names.n)
        return students_add_owners(&a->students);
    for (i = 0; i < a->names.n && a->is_class && is_done; i++)
        is_done = students_add(&a->students, a->names.list[i].name, &a->names.list[i]);
    for (i = 0; i < o->n_decks && !a->is_class && is_done; i++) {
        e = roster_find(&a->names, files_stem(o->decks[i]));
        is_done = students_find(&a->students, files_stem(o->decks[i])) != NULL ||
                  students_add(&a->students, files_stem(o->decks[i]), e);
    }
    return is_done;
}

/* Refuse a folder without answers, or an answer that would be written; returns the exit status. */
static int check_files(const grade_answers *a, const options *o)
{
    int is_output = 0;
    long n = 0;
    size_t i;
    char *path, words[MESSAGE_SIZE];

    for (i = 0; i < a->students.n_files && a->is_class; i++) {
        path = files_within(a->folder, flk_text_of(a->students.files[i].name), "");
        if (!path)
            return command_lacks_memory("cannot read", a->folder);
        n += students_is_text(path);
        is_output = files_is_output(o, path);
        if (is_output)
            command_complain("cannot write", path, "it is also read");
        free(path);
        if (is_output)
            return EXIT_FILES;
    }
    if (!n && a->is_class)
        return command_complain("cannot read", a->folder,
                                "no file in this folder ends in .expect, .txt or .csv");
    if (a->is_class && !o->answers) {
        flk_message(words, sizeof words,
                    "no file has the name of the deck, so all %ld are answers to it", n);
        command_tell("note", o->check_file, 0, words, NULL);
    }
    return 0;
}

static int open_folder(grade_answers *a, const options *o)
{
    int status;

    a->folder = o->check_file;
    if (!students_list(&a->students, a->folder, o))
        return memory_has_failed() ? command_lacks_memory("cannot read", a->folder)
                                   : command_complain("cannot read", a->folder, strerror(errno));
    a->is_class = is_class(o, &a->students);
    status = check_files(a, o);
    if (!status && !add_students(a, o))
        status = command_lacks_memory("cannot read", a->folder);
    return status;
}

int grade_match(grade_answers *a, const options *o)
{
    return !a->folder || students_match(&a->students, a->folder, a->is_class || o->n_decks > 1)
               ? 0
               : command_lacks_memory("cannot read", a->folder);
}

int grade_open(grade_answers *a, const options *o)
{
    int status;

    memset(a, 0, sizeof *a);
    status = o->names ? roster_read(&a->names, o->names) : 0;
    if (status || !o->check_file)
        return status;
    if (o->answers || files_is_folder(o->check_file))
        return open_folder(a, o);
    a->text = files_read(o->check_file, &a->length);
    return a->text ? 0 : command_complain("cannot read", o->check_file, strerror(errno));
}

/* Why a file of answers is not read, beside the reasons of the system. */
enum { NOT_REGULAR = 0, ELSEWHERE = -1 };

static const char *reason_text(int reason)
{
    return reason == NOT_REGULAR ? "it is not a regular file"
           : reason == ELSEWHERE ? "it is a link to a file outside the folder"
                                 : strerror(reason);
}

/* Read a file of the folder; null and the reason if it cannot be read, is a device, a FIFO or a folder, or is
** elsewhere, where messages must not quote it. */
static char *read_answers(const char *folder, const char *path, size_t *length, int *reason)
{
    char *contents;

    if (system_kind_of(path) == SYSTEM_FILE && !system_is_within(folder, path)) {
        memory_note_reason(errno);
        *reason = errno ? errno : ELSEWHERE;
        return NULL;
    }
    contents = files_read_regular(path, length);
    *reason = errno;
    return contents;
}

int grade_read(grade_answers *a, const grade_answers *all, const options *o, const student *x,
               char why[400])
{
    int reason;

    memset(a, 0, sizeof *a);
    if (!x->file || x->second) {
        flk_message(why, 400, x->second ? "two files, '%s' and '%s': neither is marked" : "no file",
                    x->file, x->second);
        return x->second ? EXIT_FILES : EXIT_ROWS; /* which is told */
    }
    a->path = files_within(o->check_file, flk_text_of(x->file), "");
    if (!a->path)
        return command_lacks_memory("cannot read", x->file);
    if (!students_is_text(x->file) && system_kind_of(a->path) == SYSTEM_FILE) {
        flk_message(why, 400, "%s cannot be read: save it as text or csv", a->path);
        return command_complain("cannot read", a->path, "save it as text or csv");
    }
    if (files_is_output(o, a->path))
        return command_complain("cannot write", a->path, "it is also read");
    a->text = read_answers(all->folder, a->path, &a->length, &reason);
    if (a->text)
        return 0;
    if (reason == ENOMEM)
        return command_lacks_memory("cannot read", a->path);
    flk_message(why, 400, "cannot read %s: %s", a->path, reason_text(reason));
    return command_complain("cannot read", a->path, reason_text(reason));
}

int grade_read_for(grade_answers *a, const grade_answers *all, const options *o, const char *deck,
                   const student **x, char why[400])
{
    memset(a, 0, sizeof *a);
    if (strcmp(deck, "-") == 0) {
        flk_message(why, 400, "standard input has no name: --check needs a file, not a folder");
        command_tell("error", "<stdin>", 0, why, NULL);
        return EXIT_USAGE;
    }
    *x = students_find(&all->students, files_stem(deck));
    if (*x && (*x)->file)
        return grade_read(a, all, o, *x, why);
    flk_message(why, 400, "no file of this name in %s", o->check_file);
    command_tell("error", deck, 0, why, NULL);
    return EXIT_FILES;
}

void grade_close(grade_answers *a)
{
    roster_free(&a->names);
    students_free(&a->students);
    free(a->path);
    free(a->text);
}
