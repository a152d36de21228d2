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
#include "variants.h"

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

/* Write all designs; those with mistakes are left out, and the exit status tells. */
static int print_all(const input *in)
{
    variants v = {NULL, NULL, 0};
    fourlink_results *results;
    fourlink_mistake mistake;
    unsigned long i;
    int status = variants_open(&v, in);
    int may_write = status == 0;

    for (i = 0; i < v.n && may_write && status != EXIT_FILES; i++) {
        char *path = variants_path(&v, in->o->output, in, i, ".deck");
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
    variants_close(&v);
    return status;
}

int deck_out_print(const input *in)
{
    return in->o->all_designs ? print_all(in) : print(in->results, in->o->output);
}
