/* SPDX-License-Identifier: GPL-3.0-or-later
**
** main.c - the command: decks in, sheets and pictures out, exit status.
*/
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/system.h"
#include "best.h"
#include "command.h"
#include "deck_out.h"
#include "designs.h"
#include "drawing.h"
#include "files.h"
#include "input.h"
#include "output.h"
#include "reporting.h"
#include "terminal.h"
#include "tables/content.h"

static void tell_no_value(const fourlink_check *check, const char *deck_name)
{
    command_tell_mistake(check->file, check->message_line, check->message, deck_name);
}

/* The columns of all decks, each name with each unit once; null if out of memory. */
static fourlink_value *union_of_columns(const input *inputs, size_t n_inputs, unsigned long *n)
{
    const fourlink_value *list;
    fourlink_value *all = NULL, *more;
    unsigned long count, k, j;
    size_t i;

    *n = 0;
    for (i = 0; i < n_inputs; i++) {
        count = 0;
        if (inputs[i].results)
            fourlink_results_list(inputs[i].results, FOURLINK_COLUMNS, &list, &count);
        more = realloc(all, (*n + count + 1) * sizeof *all);
        if (!more) {
            free(all);
            return NULL;
        }
        all = more;
        for (k = 0; k < count; k++) {
            for (j = 0; j < *n; j++)
                if (strcmp(all[j].name, list[k].name) == 0 &&
                    strcmp(all[j].unit, list[k].unit) == 0)
                    break;
            if (j == *n)
                all[(*n)++] = list[k];
        }
    }
    return all;
}

/* 1 if reading or memory failed, so that a deck has no score. */
static int has_no_score(const options *o, const input *in)
{
    return o->content == SHEET_CHECK && !in->results && !in->refusal[0];
}

/* The exit status for a deck that was written. */
static int status_of(const sheet *s, const input *in)
{
    if (!in->results)
        return 0; /* already reported */
    if (s->out_of_memory)
        return command_complain("cannot analyse", in->name, "not enough memory");
    command_tell_more(s->checks[FOURLINK_NO_VALUE], "mistake");
    if (s->checks[FOURLINK_NO_VALUE])
        return EXIT_USAGE;
    return s->failed || s->checks[FOURLINK_DIFFERS] || s->checks[FOURLINK_NO_MISPRINT] ? EXIT_ROWS
                                                                                       : 0;
}

/* Write all decks; returns the exit status. */
static int write_decks(FILE *out, const options *o, const input *inputs)
{
    fourlink_value *header;
    int status = 0;
    size_t i;
    sheet s;

    memset(&s, 0, sizeof s);
    s.format = o->format;
    s.content = o->content;
    s.at = o->at;
    s.n_decks = (int)o->n_decks;
    s.no_value = tell_no_value;
    s.width = o->wide ? 0 : terminal_width(out);
    s.header = header = union_of_columns(inputs, o->n_decks, &s.n_header);
    if (!header)
        return command_complain("cannot start", "", "not enough memory");
    content_begin(&s, out, 1);
    for (i = 0; i < o->n_decks; i++) {
        if (has_no_score(o, &inputs[i])) { /* already reported */
            status = EXIT_FILES;
            continue;
        }
        s.out_of_memory = 0;
        content_write(&s, inputs[i].results, inputs[i].name, inputs[i].refusal);
        status = command_worse(status, status_of(&s, &inputs[i]));
    }
    free(header);
    return status;
}

/* Write what the options ask for; returns the exit status. */
static int write_sheet(const options *o, const input *inputs, int *signal_number)
{
    output out;
    int status, written;

    if (o->print_deck)
        return deck_out_print(&inputs[0]);
    status = output_begin(&out, o->output);

    if (status)
        return status;
    if (o->best)
        written = best_write(out.file, &inputs[0], signal_number);
    else if (inputs[0].results && inputs[0].problem.n_designs && o->content != SHEET_LIST)
        written = designs_write(out.file, &inputs[0], signal_number);
    else
        written = write_decks(out.file, o, inputs);
    /* incomplete results are not kept */
    return command_worse(written, output_end(&out, o->output, written != EXIT_FILES));
}

/* Write the sheet and the picture, neither if the picture is refused; returns the exit status. */
static int write_all(const options *o, const input *inputs, int usable, int *signal_number)
{
    drawing d;
    int status = 0;

    d.script = NULL;
    if ((o->plot || o->plot_script) && inputs[0].results)
        status = drawing_begin(&d, &inputs[0]);
    if (status == EXIT_USAGE)
        return status;
    if (options_want_table(o) && (usable || (o->content == SHEET_CHECK && o->n_decks > 1)))
        status = command_worse(status, write_sheet(o, inputs, signal_number));
    if (d.script)
        status = command_worse(status, drawing_end(&d, !*signal_number));
    return status;
}

static int run(const options *o)
{
    input *inputs = calloc(o->n_decks + 1, sizeof *inputs);
    int status = 0, usable = 0, signal_number = 0;
    grade_answers answers;
    size_t i;

    if (!inputs)
        return command_complain("cannot start", "", "not enough memory");
    status = grade_open(&answers, o);
    if (status) {
        free(inputs);
        return status;
    }
    for (i = 0; i < o->n_decks; i++) {
        status = command_worse(status, input_read(&inputs[i], o->decks[i], o, &answers));
        usable += inputs[i].results != NULL;
    }
    status = command_worse(status, write_all(o, inputs, usable, &signal_number));
    if (o->report && (inputs[0].results || inputs[0].has_mistakes) && !signal_number)
        status = command_worse(status, reporting_write(&inputs[0]));
    for (i = 0; i < o->n_decks; i++)
        input_close(&inputs[i]);
    free(inputs);
    grade_close(&answers);
    if (signal_number) {
        fflush(stdout);
        raise(signal_number); /* so that the caller sees the signal */
    }
    return status;
}

/* Write the help, or the version. */
static int write_text(int is_help)
{
    if (is_help)
        options_put_help(stdout);
    else
        puts("fourlink " FOURLINK_VERSION "\nLicence GPL-3.0-or-later; there is no warranty.");
    return fflush(stdout) == 0 && !ferror(stdout)
               ? 0
               : command_complain("cannot write", "standard output", strerror(errno));
}

int main(int argc, char **argv)
{
    char message[400];
    options o;
    int status;

    system_begin(&argc, &argv);
    output_prepare();
    status = options_read(argc, argv, &o, message);
    if (status < 0) {
        status = command_complain("cannot start", "", "not enough memory");
    } else if (status == 0) {
        fputs("fourlink: ", stderr);
        command_print(message);
        fputs("\nTry 'fourlink --help'.\n", stderr);
        status = EXIT_USAGE;
    } else if (o.help || o.version) {
        status = write_text(o.help);
    } else {
        status = files_tell_clash(&o);
        if (!status)
            status = run(&o);
    }
    options_free(&o);
    return status;
}
