/* SPDX-License-Identifier: GPL-3.0-or-later
**
** variants.c - the designs of a [sweep] as files, with numbers or with names from a list.
*/
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "files.h"
#include "output.h"
#include "variants.h"

#define LONGEST_NAME 200 /* bytes */

/* Print a mistake in the list of names; returns the exit status. */
static int refuse(const char *file, long where, const char *format, text name)
{
    char words[MESSAGE_SIZE];

    command_tell("error", file, where, flk_message(words, sizeof words, format, name), NULL);
    return EXIT_USAGE;
}

/* 1 if a name can be that of a file. */
static int is_file_name(text name)
{
    size_t i;

    for (i = 0; i < name.length; i++)
        if ((unsigned char)name.start[i] < ' ' || strchr("/\\:*?\"<>|", name.start[i]))
            return 0;
    return name.start[0] != '.' && name.length <= LONGEST_NAME;
}

/* 1 if an earlier entry has the same name. */
static int is_there(const roster *r, const roster_entry *e)
{
    const roster_entry *other;

    for (other = r->list; other < e; other++)
        if (flk_text_equal(e->name, other->name.start))
            return 1;
    return 0;
}

/* Refuse names that cannot be those of files; returns the exit status. */
static int check_names(const roster *r, const char *file)
{
    size_t i;

    for (i = 0; i < r->n; i++) {
        const roster_entry *e = &r->list[i];

        if (!is_file_name(e->name))
            return refuse(file, e->line, "'%t' cannot be the name of a file", e->name);
        if (is_there(r, e))
            return refuse(file, e->line, "'%t' is there twice", e->name);
    }
    return 0;
}

/* The list that is written beside the files. */
static char *list_path(const char *folder)
{
    return files_within(folder, flk_text_of("class"), ".csv");
}

/* Take the designs of the list that was written before, if there is one; returns the exit status. */
static int take_earlier(roster *names, const char *folder)
{
    char *path = list_path(folder);
    const roster_entry *e;
    int status = 0;
    roster before;
    size_t i;

    if (!path)
        return command_lacks_memory("cannot read", folder);
    if (system_kind_of(path) == SYSTEM_FILE) {
        status = roster_read(&before, path);
        for (i = 0; i < names->n && !status; i++) {
            e = roster_find(&before, names->list[i].name);
            names->list[i].design = e ? e->design : 0;
        }
        roster_free(&before);
    }
    free(path);
    return status;
}

/* Give each student without a design the next free one; returns the exit status. */
static int give_designs(roster *names, const input *deck)
{
    unsigned long designs = deck->problem.n_designs, next = 1;
    char *is_taken = memory_get(names->n + 2, 1), words[MESSAGE_SIZE];
    roster_entry *e;

    if (!is_taken)
        return command_lacks_memory("cannot start", "");
    for (e = names->list; e < names->list + names->n; e++)
        if (e->design <= names->n)
            is_taken[e->design] = 1;
    for (e = names->list; e < names->list + names->n; e++) {
        while (!e->design && is_taken[next])
            next++;
        if (!e->design)
            e->design = next++;
        if (e->design > designs)
            break;
    }
    free(is_taken);
    if (e == names->list + names->n)
        return 0;
    flk_message(words, sizeof words, "%t has design %ld, but the [sweep] of %s has %ld designs",
                e->name, (long)e->design, deck->name, (long)designs);
    command_tell("error", deck->o->names, e->line, words, NULL);
    return EXIT_USAGE;
}

int variants_open(variants *v, const input *deck, roster *names, const char *folder)
{
    const char *file = deck->o->names;
    char words[MESSAGE_SIZE];
    int status;

    v->names = names;
    v->n = file ? (unsigned long)names->n : deck->problem.n_designs;
    if (!file)
        return 0;
    status = check_names(names, file);
    if (!status && names->n && names->design_column < 0)
        status = take_earlier(names, folder);
    if (status)
        return status;
    if (v->n <= deck->problem.n_designs && v->n)
        return give_designs(names, deck);
    flk_message(words, sizeof words, "%ld names, but the [sweep] of %s has %ld designs", (long)v->n,
                deck->name, (long)deck->problem.n_designs);
    command_tell("error", file, 0, words, NULL);
    return EXIT_USAGE;
}

unsigned long variants_design(const variants *v, unsigned long i)
{
    return v->names->n ? v->names->list[i].design : i + 1;
}

int variants_write_list(const variants *v, const char *folder)
{
    char *path = list_path(folder);
    output out;
    int status;

    status = path ? output_begin(&out, path) : command_lacks_memory("cannot write", folder);
    if (!status) {
        roster_write(v->names, out.file);
        status = output_end(&out, path, 1);
    }
    free(path);
    return status;
}

char *variants_path(const variants *v, const char *folder, const input *deck, unsigned long i,
                    const char *ending)
{
    unsigned long n = deck->problem.n_designs;
    char end[100];
    int digits = 1;

    if (v->names->n)
        return files_within(folder, v->names->list[i].name, ending);
    for (; n > 9; n /= 10)
        digits++;
    sprintf(end, "-%0*lu%s", digits, i + 1, ending);
    return files_within(folder, files_stem(deck->name), end);
}
