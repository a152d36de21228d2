/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck_out.c - a deck as output: its text with the values that are computed.
*/
#include <stdio.h>
#include <stdlib.h>

#include "command.h"
#include "deck_out.h"
#include "output.h"

int deck_out_print(const input *in)
{
    const char *path = in->o->output;
    unsigned long length = 0;
    char *contents = input_deck_text(in->results, &length);
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
