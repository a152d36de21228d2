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

#define STEM 256 /* bytes of the name of a deck */

/* Take all answers in the folder, whose files are listed; returns the exit status. */
static int take_all(grade_answers *a)
{
    size_t i;

    a->files = memory_get(a->handed.n + 1, sizeof *a->files);
    for (i = 0; i < a->handed.n && a->files; i++) {
        if (!students_is_text(a->handed.names[i]))
            continue;
        a->files[a->n_files] = files_within(a->folder, flk_text_of(a->handed.names[i]), "");
        if (!a->files[a->n_files++])
            return command_lacks_memory("cannot read", a->folder);
    }
    return a->files ? 0 : command_lacks_memory("cannot read", a->folder);
}

/* 1 if all files of the folder are answers to one deck: --answers says so, or there is none with the
** deck's name. */
static int is_class(const options *o, student_files *handed)
{
    if (o->answers || o->n_decks != 1 || strcmp(o->decks[0], "-") == 0)
        return o->answers != NULL;
    return students_find(handed, files_stem(o->decks[0])) == NULL;
}

int grade_open(grade_answers *a, const options *o)
{
    char words[MESSAGE_SIZE];
    int status;
    size_t i;

    memset(a, 0, sizeof *a);
    if (!o->check_file)
        return 0;
    if (!files_is_folder(o->check_file) && !o->answers) {
        a->text = files_read(o->check_file, &a->length);
        return a->text ? 0 : command_complain("cannot read", o->check_file, strerror(errno));
    }
    a->folder = o->check_file;
    if (!students_list(&a->handed, a->folder))
        return command_complain("cannot read", a->folder, strerror(errno));
    if (!is_class(o, &a->handed))
        return 0;
    status = take_all(a);
    if (!status && o->answers && !a->n_files)
        status = command_complain("cannot read", o->answers,
                                  "no file in this folder ends in .expect, .txt or .csv");
    for (i = 0; i < a->n_files && !status; i++)
        if (files_is_output(o, a->files[i]))
            status = command_complain("cannot write", a->files[i], "it is also read");
    if (a->n_files && !o->answers) {
        flk_message(words, sizeof words,
                    "no file has the name of the deck, so all %ld are answers to it",
                    (long)a->n_files);
        command_tell("note", o->check_file, 0, words, NULL);
    }
    return status;
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

int grade_read(grade_answers *a, const grade_answers *all, const options *o, const char *deck,
               const char *file, char why[400])
{
    student_files handed = all->handed;
    const char *own = NULL;
    int reason;

    memset(a, 0, sizeof *a);
    if (!file && strcmp(deck, "-") == 0) {
        flk_message(why, 400, "standard input has no name: --check needs a file, not a folder");
        command_tell("error", "<stdin>", 0, why, NULL);
        return EXIT_USAGE;
    }
    if (!file && (own = students_find(&handed, files_stem(deck))) == NULL) {
        flk_message(why, 400, "no file of this name in %s", o->check_file);
        command_tell("error", deck, 0, why, NULL);
        return EXIT_FILES;
    }
    a->path = file ? files_beside("", file) : files_within(o->check_file, flk_text_of(own), "");
    if (!a->path)
        return command_lacks_memory("cannot read", deck);
    if (own && !students_is_text(own)) {
        flk_message(why, 400, "%s cannot be read: save it as text or csv", a->path);
        return command_complain("cannot read", a->path, "save it as text or csv");
    }
    if (files_is_output(o, a->path))
        return command_complain("cannot write", a->path, "it is also read");
    a->text = read_answers(o->check_file, a->path, &a->length, &reason);
    if (a->text)
        return 0;
    if (reason == ENOMEM)
        return command_lacks_memory("cannot read", a->path);
    flk_message(why, 400, "cannot read %s: %s", a->path, reason_text(reason));
    return command_complain("cannot read", a->path, reason_text(reason));
}

int grade_tell_unclaimed(const grade_answers *a, const options *o)
{
    const char **stems;
    char *names;
    size_t i;

    if (!a->folder || a->n_files)
        return 0;
    stems = memory_get(o->n_decks + 1, sizeof *stems);
    names = memory_get(o->n_decks * STEM, 1);
    for (i = 0; i < o->n_decks && stems && names; i++)
        stems[i] = flk_text_copy(files_stem(o->decks[i]), names + i * STEM, STEM);
    if (stems && names) {
        stems[o->n_decks] = NULL;
        students_tell_unclaimed(&a->handed, a->folder, stems);
    }
    i = stems && names;
    free(names);
    free((void *)stems);
    return i ? 0 : command_lacks_memory("cannot read", a->folder);
}

void grade_close(grade_answers *a)
{
    size_t i;

    for (i = 0; i < a->n_files; i++)
        free(a->files[i]);
    free(a->files);
    students_free(&a->handed);
    free(a->path);
    free(a->text);
}
