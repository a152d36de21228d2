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
#include "command.h"
#include "drawing.h"
#include "files.h"
#include "input.h"
#include "marks.h"
#include "output.h"
#include "terminal.h"
#include "variants.h"
#include "writers.h"
#include "tables/content.h"

static void tell_no_value(const fourlink_check *check, const char *deck_name)
{
    command_tell("error", check->file, check->message_line, check->message, deck_name);
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

/* Write an input, or its score alone; returns the exit status. */
static int write_input(sheet *s, const options *o, const input *in, marks *m)
{
    int status;
    sheet_mark mark;

    s->out_of_memory = 0;
    if (in->deck || o->scores)
        marks_give(m, in, &mark);
    s->mark = in->deck ? &mark : NULL;
    if (s->content == SHEET_SCORES)
        content_write_mark(s, &mark);
    else
        content_write(s, in->results, in->name, in->refusal);
    status = status_of(s, in);
    s->mark = NULL;
    return in->results && (in->deck || o->scores) && mark.right < mark.of
               ? command_worse(status, EXIT_ROWS)
               : status;
}

/* Write all inputs: decks, or one deck with the answers of many; returns the exit status. */
static int write_decks(FILE *out, const options *o, const input *inputs, size_t n)
{
    fourlink_value *header;
    int status = 0;
    size_t i;
    marks m;
    sheet s;

    status = marks_find(&m, inputs, n);
    if (status)
        return status;
    memset(&s, 0, sizeof s);
    s.format = o->format;
    s.content = o->scores ? SHEET_SCORES : o->content;
    s.wrong_first = s.format == &table_format;
    s.at = o->at;
    s.n_decks = (int)o->n_decks;
    s.no_value = tell_no_value;
    s.width = o->wide ? 0 : terminal_width(out);
    s.header = header = union_of_columns(inputs, n, &s.n_header);
    if (!header) {
        marks_free(&m);
        return command_complain("cannot start", "", "not enough memory");
    }
    content_begin(&s, out, 1);
    for (i = 0; i < n; i++)
        if (has_no_score(o, &inputs[i])) /* already reported */
            status = EXIT_FILES;
        else
            status = command_worse(status, write_input(&s, o, &inputs[i], &m));
    free(header);
    marks_free(&m);
    return status;
}

/* Write the text of a deck with the values that are computed; returns the exit status. */
static int write_deck(FILE *out, const input *in)
{
    unsigned long length = 0;
    char *contents = input_deck_text(in->results, &length);

    if (!contents)
        return command_complain("cannot write", in->name, "not enough memory");
    fwrite(contents, 1, length, out);
    free(contents);
    return 0;
}

/* 1 if nothing but rows is asked for. */
static int prints_rows(const options *o)
{
    return o->content == SHEET_ROWS && !o->at && !o->best;
}

/* 1 if the deck of a linkage found is printed, or the list of all solutions. */
static int prints_found(const options *o, const input *in)
{
    return o->synthesis && prints_rows(o) && in->results && !in->problem.n_designs;
}

/* Write what the options ask for; returns the exit status. */
static int write_sheet(const options *o, const input *inputs, size_t n)
{
    output out;
    int status = output_begin(&out, o->output), written;

    if (status)
        return status;
    if (o->lists_all)
        written = catalogue_write(out.file, o);
    else if (o->print_deck || (prints_found(o, &inputs[0]) && !o->has_format))
        written = write_deck(out.file, &inputs[0]);
    else if (o->best)
        written = best_write(out.file, &inputs[0]);
    else if (prints_found(o, &inputs[0]) && !inputs[0].is_design)
        written = solutions_write(out.file, &inputs[0]);
    else if (inputs[0].results && inputs[0].problem.n_designs && o->content != SHEET_LIST)
        written = designs_write(out.file, &inputs[0]);
    else
        written = write_decks(out.file, o, inputs, n);
    /* incomplete results are not kept */
    return command_worse(written, output_end(&out, o->output, written != EXIT_FILES));
}

/* Write the sheet and the picture, neither if the picture is refused; returns the exit status. */
static int write_all(const options *o, const input *inputs, size_t n, int usable)
{
    drawing d;
    int status = 0;

    d.script = NULL;
    if ((o->plot || o->plot_script) && inputs[0].results)
        status = drawing_begin(&d, &inputs[0]);
    if (status == EXIT_USAGE)
        return status;
    if (options_want_table(o) &&
        (usable || (o->content == SHEET_CHECK && (n > 1 || inputs[0].deck || o->scores))))
        status = command_worse(status, write_sheet(o, inputs, n));
    if (d.script)
        status = command_worse(status, drawing_end(&d, !system_caught()));
    return status;
}

/* Read n inputs, write what is asked for, and close them; returns the exit status.  `deck` is not null
** for a deck with the answers of many. */
static int run_inputs(const options *o, const grade_answers *answers, const input *deck)
{
    size_t n = deck ? answers->n_files : o->n_decks, i;
    input *inputs = calloc(n + 1, sizeof *inputs);
    int status = 0, usable = 0;

    if (!inputs)
        return command_complain("cannot start", "", "not enough memory");
    for (i = 0; i < n; i++) {
        status = command_worse(status, deck ? input_read_answers(&inputs[i], deck, o, answers, i)
                                            : input_read(&inputs[i], o->decks[i], o, answers));
        usable += inputs[i].results != NULL;
        status = command_worse(status, inputs[i].has_defects ? EXIT_ROWS : 0);
    }
    status = command_worse(status, write_all(o, inputs, n, usable));
    if (o->report && (inputs[0].results || inputs[0].has_mistakes) && !system_caught())
        status = command_worse(status, drawing_report(&inputs[0]));
    for (i = 0; i < n; i++)
        input_close(&inputs[i]);
    free(inputs);
    return status;
}

static const grade_answers no_answers = {NULL, NULL, 0, NULL, NULL, 0};

/* Grade the answers of many to one deck, which is read without them first; returns the exit status. */
static int run_class(const options *o, const grade_answers *answers)
{
    options of_deck = *o;
    input deck;
    int status;

    memset(&deck, 0, sizeof deck);
    of_deck.content = SHEET_SUMMARY;
    of_deck.check_file = NULL;
    status = input_read(&deck, o->decks[0], &of_deck, &no_answers);
    if (deck.results)
        status = command_worse(status, run_inputs(o, answers, &deck));
    input_close(&deck);
    return status;
}

/* Run one design of a [sweep] for a file of its own; returns the exit status. */
static int run_variant(const options *o, const char *path, unsigned long i)
{
    options one = *o;
    int status;

    one.all_designs = 0;
    one.design = i + 1;
    one.is_again = i > 0;
    one.variant = path;
    *(o->report ? &one.report : &one.output) = path;
    status = files_tell_clash(&one);
    return status ? status : run_inputs(&one, &no_answers, NULL);
}

/* Write a file for each design of a [sweep]; returns the exit status. */
static int run_variants(const options *o)
{
    const char *folder = o->report ? o->report : o->output;
    options of_deck = *o;
    variants v = {NULL, NULL, 0};
    int status, may_write = 0;
    unsigned long i;
    input deck;

    memset(&deck, 0, sizeof deck);
    of_deck.content = SHEET_ROWS;
    of_deck.report = NULL;
    of_deck.is_again = 1;
    status = input_read(&deck, o->decks[0], &of_deck, &no_answers);
    if (deck.results) {
        status = variants_open(&v, &deck);
        may_write = status == 0;
    }
    for (i = 0; i < v.n && may_write && status != EXIT_FILES && !system_caught(); i++) {
        char *path = variants_path(&v, folder, &deck, i,
                                   o->report       ? ".html"
                                   : o->print_deck ? ".deck"
                                                   : ".expect");

        status = command_worse(
            status, path ? run_variant(o, path, i)
                         : command_complain("cannot write", folder, "not enough memory"));
        free(path);
    }
    variants_close(&v);
    input_close(&deck);
    return status;
}

static int run(const options *o)
{
    int status;
    grade_answers answers;

    status = grade_open(&answers, o);
    if (!status)
        status = o->lists_all      ? write_sheet(o, NULL, 0)
                 : o->all_designs  ? run_variants(o)
                 : answers.n_files ? run_class(o, &answers)
                                   : run_inputs(o, &answers, NULL);
    grade_close(&answers);
    if (system_caught()) {
        fflush(stdout);
        raise(system_caught()); /* so that the caller sees the signal */
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
        command_say("fourlink: ", message, (char *)NULL);
        command_say("Try 'fourlink --help'.", (char *)NULL);
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
