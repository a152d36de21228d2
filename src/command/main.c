/* SPDX-License-Identifier: GPL-3.0-or-later
**
** main.c - the command: decks in, sheets and pictures out, exit status.
*/
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "system/system.h"
#include "batch.h"
#include "command.h"
#include "drawing.h"
#include "files.h"
#include "input.h"
#include "output.h"
#include "pins.h"
#include "variants.h"
#include "catalogue.h"
#include "quiz_file.h"
#include "solutions.h"
#include "best.h"
#include "solve.h"
#include "rules.h"
#include "terminal.h"
#include "designs.h"
#include "tables/content.h"

/* Write the text of a deck with the values that are computed; returns the exit status. */
static int write_deck(FILE *out, input *in)
{
    if (in->o->pins)
        return in->results ? pins_write(out, in) : 0;
    return input_write_deck(in, out) ? 0 : command_lacks_memory("cannot write", in->name);
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
static int write_sheet(const options *o, input *in, const grade_answers *answers)
{
    output out;
    int status = output_begin(&out, o->output), written;

    if (status)
        return status;
    if (o->solve && (o->print_deck || o->format == &table_format))
        written = solve_write(out.file, in);
    else if (o->print_deck || (prints_found(o, in) && !o->has_format))
        written = write_deck(out.file, in);
    else if (o->best && !o->has_format)
        written = best_write(out.file, in);
    else if (prints_found(o, in) && !in->is_design)
        written = solutions_write(out.file, in);
    else if (in->results && in->problem.n_designs && o->content != SHEET_LIST && !o->best)
        written = designs_write(out.file, in);
    else
        written = batch_write_one(out.file, in, answers);
    /* incomplete results are not kept */
    return command_worse(written, output_end(&out, o->output, written != EXIT_FILES));
}

/* 1 if the sheet has something of a deck, also of one with mistakes where a line says why. */
static int is_shown(const options *o, const input *in)
{
    return in->results || (o->content == SHEET_CHECK && o->scores) ||
           (o->format->is_lines && (o->content == SHEET_CHECK || o->solve || o->best));
}

/* Write the sheet and the picture, neither if the picture is refused; returns the exit status. */
static int write_all(const options *o, input *in, const grade_answers *answers)
{
    drawing d;
    int status = 0;

    d.is_there = 0;
    if (o->plot && in->results)
        status = drawing_begin(&d, in);
    if (status == EXIT_USAGE)
        return status;
    if (options_want_table(o) && is_shown(o, in))
        status = command_worse(status, write_sheet(o, in, answers));
    if (d.is_there)
        status = command_worse(status, drawing_end(&d, !system_caught()));
    return status;
}

/* Read a deck, write what is asked for, and close it; returns the exit status. */
static int run_one(const options *o, const grade_answers *answers)
{
    input in;
    int status;

    memset(&in, 0, sizeof in);
    status = input_read(&in, o->decks[0], o, answers, NULL);
    status = command_worse(status, in.has_defects ? EXIT_ROWS : 0);
    status = command_worse(status, write_all(o, &in, answers));
    if (o->report && (in.results || in.has_mistakes) && !system_caught())
        status = command_worse(status, drawing_report(&in));
    input_close(&in);
    return status;
}

/* Write the list of all columns and facts; returns the exit status. */
static int run_catalogue(const options *o)
{
    output out;
    int status = output_begin(&out, o->output), written;

    if (status)
        return status;
    written = catalogue_write(out.file, o);
    return command_worse(written, output_end(&out, o->output, written == 0));
}

static const grade_answers no_answers;

/* Grade the answers of many to one deck, which is read without them first; returns the exit status. */
static int run_class(const options *o, const grade_answers *answers)
{
    options of_deck;
    input deck;
    int status = input_read_without(&deck, o, &of_deck, o->decks[0], NULL);

    if (deck.results)
        status = command_worse(status, batch_run(o, answers, &deck));
    input_close(&deck);
    return status;
}

/* Run one design of a [sweep] for a file of its own; returns the exit status. */
static int run_variant(const options *o, const char *path, unsigned long design, int is_again)
{
    options one = *o;
    int status;

    one.all_designs = 0;
    one.design = design;
    one.is_again = is_again;
    one.variant = path;
    *(o->report ? &one.report : o->plot ? &one.plot : &one.output) = path;
    status = files_tell_clash(&one);
    return status ? status : run_one(&one, &no_answers);
}

/* The folder for a file of each design. */
static const char *folder_of(const options *o)
{
    return o->report ? o->report : o->plot ? o->plot : o->output;
}

/* Write the file of design i; returns the exit status. */
static int write_variant(const options *o, const variants *v, const input *deck, unsigned long i,
                         const char *ending)
{
    const char *folder = folder_of(o);
    char *path = variants_path(v, folder, deck, i, ending);
    int status = path ? run_variant(o, path, variants_design(v, i), i > 0 || o->form)
                      : command_lacks_memory("cannot write", folder);

    free(path);
    return status;
}

/* Write the form of student i; one that is there may be filled in, and stays.  Returns the exit status. */
static int write_form(const options *o, const variants *v, const input *deck, unsigned long i,
                      unsigned long *n_kept)
{
    char *path = variants_path(v, folder_of(o), deck, i, ".txt");
    int is_there = path && system_kind_of(path) == SYSTEM_FILE;

    free(path);
    if (!is_there)
        return write_variant(o, v, deck, i, ".txt");
    ++*n_kept;
    return 0;
}

static void tell_kept(const char *folder, unsigned long n)
{
    char words[MESSAGE_SIZE];

    flk_message(words, sizeof words,
                n == 1 ? "%ld form is there already, and stays as it is"
                       : "%ld forms are there already, and stay as they are",
                (long)n);
    command_tell("note", folder, 0, words, NULL);
}

/* Write the files of all designs, and with decks for the students of a list the forms to fill in, and
** the list with their designs; returns the exit status. */
static int write_variants(const options *o, const variants *v, const input *deck)
{
    int is_class = o->names && o->print_deck, status = 0;
    options of_form = *o, own = *o;
    unsigned long i, n_kept = 0;

    own.is_exercise = o->names && (o->print_deck || o->report);
    of_form.content = SHEET_EXPECT;
    of_form.form = 1;
    of_form.print_deck = 0;
    for (i = 0; i < v->n && status != EXIT_FILES && !system_caught(); i++) {
        status = command_worse(status, write_variant(&own, v, deck, i,
                                                     o->report       ? ".html"
                                                     : o->plot       ? ".svg"
                                                     : o->print_deck ? ".deck"
                                                                     : ".expect"));
        if (is_class && deck->problem.n_expected)
            status = command_worse(status, write_form(&of_form, v, deck, i, &n_kept));
    }
    if (n_kept)
        tell_kept(o->output, n_kept);
    if (is_class && status != EXIT_FILES && !system_caught())
        status = command_worse(status, variants_write_list(v, o->output));
    return status;
}

/* Write a file for each design of a [sweep]; returns the exit status. */
static int run_variants(const options *o, grade_answers *answers)
{
    const char *folder = folder_of(o);
    options of_deck = *o;
    variants v;
    int status;
    input deck;

    memset(&v, 0, sizeof v);
    memset(&deck, 0, sizeof deck);
    of_deck.content = SHEET_ROWS;
    of_deck.report = of_deck.plot = NULL;
    of_deck.is_again = 1;
    status = input_read(&deck, o->decks[0], &of_deck, &no_answers, NULL);
    if (deck.results) {
        status = variants_open(&v, &deck, &answers->names, folder);
        if (!status)
            status = files_make_folder(folder);
        if (!status)
            status = write_variants(o, &v, &deck);
    }
    input_close(&deck);
    return status;
}

/* Say why options cannot be served; returns the exit status. */
static int refuse(const char *why)
{
    command_say("fourlink: ", why, (char *)NULL);
    command_say("Try 'fourlink --help'.", (char *)NULL);
    return EXIT_USAGE;
}

static int run(options *o)
{
    int status;
    char message[400];
    grade_answers answers;

    status = grade_open(&answers, o);
    o->is_class = answers.is_class && !o->answers;
    if (!status && rules_broken(o, NULL, message))
        status = refuse(message);
    if (!status)
        status = grade_match(&answers, o);
    if (!status)
        status = o->lists_all       ? run_catalogue(o)
                 : o->quiz          ? quiz_file_write(o)
                 : o->all_designs   ? run_variants(o, &answers)
                 : answers.is_class ? run_class(o, &answers)
                 : o->n_decks > 1   ? batch_run(o, &answers, NULL)
                                    : run_one(o, &answers);
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
    const char *why = message;
    options o;
    int status;

    system_begin(&argc, &argv);
    output_prepare();
    status = options_read(argc, argv, &o, message);
    if (status == 1)
        why = rules_broken(&o, NULL, message);
    if (status < 0) {
        status = command_lacks_memory("cannot start", "");
    } else if (why) {
        status = refuse(why);
    } else if (o.help || o.version) {
        status = write_text(o.help);
    } else {
        command_be_coloured(terminal_has_colour(stderr, o.colour));
        status = files_tell_clash(&o);
        if (!status)
            status = run(&o);
    }
    options_free(&o);
    return command_end(status);
}
