/* SPDX-License-Identifier: GPL-3.0-or-later
**
** variants.c - the designs of a [sweep] as files, with numbers or with names from a list.
*/
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
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

/* Add the name on a line; 1 if it can be used, 0 after a message. */
static int add_name(variants *v, const char *file, long where, text name)
{
    unsigned long i;

    if (!is_file_name(name))
        return refuse(file, where, "'%t' cannot be the name of a file", name) == 0;
    for (i = 0; i < v->n; i++)
        if (flk_text_equal(name, v->names[i]))
            return refuse(file, where, "'%t' is there twice", name) == 0;
    ((char *)name.start)[name.length] = '\0'; /* of v->text */
    v->names[v->n++] = name.start;
    return 1;
}

/* Split the list into lines; returns the exit status. */
static int read_names(variants *v, const char *file, size_t length)
{
    text rest, name;
    long where = 0;

    rest.start = v->text;
    rest.length = length;
    rest = flk_text_without_mark(rest);
    while (flk_text_split(&rest, '\n', &name)) {
        where++;
        name = flk_text_trim(name);
        if (name.length && !add_name(v, file, where, name))
            return EXIT_USAGE;
    }
    return 0;
}

int variants_open(variants *v, const input *deck)
{
    const char *file = deck->o->names;
    unsigned long designs = deck->problem.n_designs;
    char words[MESSAGE_SIZE];
    size_t length = 0;
    int status;

    if (!file) {
        v->n = designs;
        return 0;
    }
    v->text = files_read(file, &length);
    v->names = v->text ? memory_get(length + 1, sizeof *v->names) : NULL;
    if (!v->names)
        return command_complain("cannot read", file, strerror(errno));
    v->text[length] = '\0';
    status = read_names(v, file, length);
    if (status)
        return status;
    if (v->n <= designs && v->n)
        return 0;
    flk_message(words, sizeof words, "%ld names, but the [sweep] of %s has %ld designs", (long)v->n,
                deck->name, (long)designs);
    command_tell("error", file, 0, words, NULL);
    return EXIT_USAGE;
}

void variants_close(variants *v)
{
    free((void *)v->names);
    free(v->text);
}

char *variants_path(const variants *v, const char *folder, const input *deck, unsigned long i,
                    const char *ending)
{
    unsigned long n = deck->problem.n_designs;
    char end[100];
    int digits = 1;

    if (v->names)
        return files_within(folder, flk_text_of(v->names[i]), ending);
    for (; n > 9; n /= 10)
        digits++;
    sprintf(end, "-%0*lu%s", digits, i + 1, ending);
    return files_within(folder, files_stem(deck->name), end);
}
