/* SPDX-License-Identifier: GPL-3.0-or-later
**
** variants.c - the designs of a [sweep] as files, with numbers or with names from a list.
*/
#include <stdio.h>
#include <string.h>

#include "base/message.h"
#include "command.h"
#include "files.h"
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

int variants_open(variants *v, const input *deck, const roster *names)
{
    const char *file = deck->o->names;
    unsigned long designs = deck->problem.n_designs;
    char words[MESSAGE_SIZE];
    int status;

    v->names = names;
    v->n = designs;
    if (!file)
        return 0;
    status = check_names(names, file);
    if (status)
        return status;
    v->n = (unsigned long)names->n;
    if (v->n <= designs && v->n)
        return 0;
    flk_message(words, sizeof words, "%ld names, but the [sweep] of %s has %ld designs", (long)v->n,
                deck->name, (long)designs);
    command_tell("error", file, 0, words, NULL);
    return EXIT_USAGE;
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
