/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck_out.c - decks as output: the text of a deck with the values that are computed.
*/
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "command.h"
#include "deck_out.h"
#include "files.h"
#include "output.h"

/* Write an open deck to a file, or to standard output; returns the exit status. */
static int print(const fourlink_results *results, const char *path)
{
    unsigned long length = 0;
    char *contents = input_deck_text(results, &length);
    output out;
    int status;

    if (!contents)
        return command_complain("cannot write", path ? path : "the deck", "not enough memory");
    status = output_begin(&out, path);
    if (!status) {
        fwrite(contents, 1, length, out.file);
        status = output_end(&out, path, 1);
    }
    free(contents);
    return status;
}

#define MOST_DIGITS 10 /* of the number of a design */

/* FOLDER/NAME-N.deck, with as many digits as the largest N has: memory to free, or null. */
static char *path_of(const input *in, unsigned long i)
{
    const char *name = strcmp(in->name, "<stdin>") == 0 ? "deck" : files_name(in->name);
    size_t length = strlen(name), room = strlen(in->o->output) + length + 40;
    char *path = malloc(room);
    unsigned long n = in->problem.n_designs;
    char number[MOST_DIGITS + 20], *start = number + MOST_DIGITS - 1;

    for (; n > 9; n /= 10)
        start--;
    sprintf(number, "%0*lu", MOST_DIGITS, i + 1);
    if (length > 5 && strcmp(name + length - 5, ".deck") == 0)
        length -= 5;
    if (path)
        sprintf(path, "%s%.*s-%s.deck", in->o->output, (int)length, name, start);
    return path;
}

/* Write all designs; those with mistakes are left out, and the exit status tells. */
static int print_all(const input *in)
{
    fourlink_results *results;
    fourlink_mistake mistake;
    unsigned long i;
    int status = 0;

    for (i = 0; i < in->problem.n_designs && status != EXIT_FILES; i++) {
        char *path = path_of(in, i);
        int opened = fourlink_results_design(in->results, i, 1, &results, &mistake, NULL);

        if (!path || opened == FOURLINK_NO_MEMORY) {
            status = command_complain("cannot write", in->o->output, "not enough memory");
        } else if (opened != FOURLINK_OK) {
            command_tell_mistake(mistake.file, mistake.line, mistake.message, path);
            status = command_worse(status, EXIT_USAGE);
        } else {
            status = command_worse(status, print(results, path));
            fourlink_results_free(results);
        }
        free(path);
    }
    return status;
}

int deck_out_print(const input *in)
{
    return in->o->all_designs ? print_all(in) : print(in->results, in->o->output);
}
