/* SPDX-License-Identifier: GPL-3.0-or-later
**
** main.c - the command: files in, tables out, exit status.
*/
#define _POSIX_C_SOURCE 200112L

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <gsl/gsl_errno.h>

#include "clash.h"
#include "files.h"
#include "pictures/gnuplot.h"
#include "options.h"
#include "output.h"
#include "tables/sweep.h"

enum { EXIT_ROWS = 1, EXIT_USAGE = 2, EXIT_FILES = 3 };

/* A file that a deck names, kept: the designs of a sweep are of one reading of it. */
typedef struct named_file {
    struct named_file *next;
    char *name; /* as the deck has it, */
    char *contents;
    size_t length;
} named_file;

/* A deck of the command line. */
typedef struct job {
    const options *o;
    const char *name;
    fourlink_source source; /* what it was read from */
    char *text;             /* all of it */
    char *contents;         /* the same for a sweep, else null */
    named_file *files;
    int names_output; /* 1: one of them is to be written */
    deck deck;
    column_list columns;
    int usable;
} job;

static int worse(int status, int other)
{
    return other > status ? other : status;
}

static int complain(const char *what, const char *name, const char *why)
{
    fprintf(stderr, "fourlink: %s %s: %s\n", what, name, why);
    return EXIT_FILES;
}

/* A path relative to the deck's folder; null when out of memory. */
static char *path_beside(const char *deck_name, const char *file_name)
{
    const char *slash = strrchr(deck_name, '/');
    size_t folder = slash && file_name[0] != '/' ? (size_t)(slash - deck_name) + 1 : 0;
    char *path = malloc(folder + strlen(file_name) + 1);

    if (path) {
        memcpy(path, deck_name, folder);
        strcpy(path + folder, file_name);
    }
    return path;
}

/* The deck reader's loader: a file that the deck of a job names. */
static const char *read_named_file(void *host, const char *file_name, unsigned long *length)
{
    job *j = host;
    named_file *f;
    char *path;

    for (f = j->files; f; f = f->next)
        if (strcmp(f->name, file_name) == 0) {
            *length = (unsigned long)f->length;
            return f->contents;
        }
    f = calloc(1, sizeof *f);
    path = path_beside(j->name, file_name);
    if (f)
        f->name = malloc(strlen(file_name) + 1);
    if (!path || !f || !f->name) {
        free(path);
        free(f);
        return NULL;
    }
    strcpy(f->name, file_name);
    j->names_output |= clash_is_output(j->o, path);
    f->contents = files_read_path(path, &f->length);
    f->next = j->files;
    j->files = f;
    free(path);
    *length = (unsigned long)f->length;
    return f->contents;
}

static void close_job(job *j)
{
    while (j->files) {
        named_file *f = j->files;

        j->files = f->next;
        free(f->name);
        free(f->contents);
        free(f);
    }
    columns_free(&j->columns);
    flk_deck_free(&j->deck);
    free(j->text);
}

/* `deck_name` is not null where several decks are worked on: it goes to the mistakes that stand in none
** of them, but in an option or a file of answers. */
static void print_mistakes(const mistakes *m, const char *deck_name)
{
    size_t i;

    for (i = 0; i < m->count; i++) {
        const struct mistake *x = &m->list[i];

        if (!x->place.line)
            fprintf(stderr, "fourlink: %s: error: %s", x->place.source, x->message);
        else
            fprintf(stderr, "%s:%ld: error: %s", x->place.source, x->place.line, x->message);
        if (deck_name && strcmp(x->place.source, deck_name) != 0)
            fprintf(stderr, " (%s)", deck_name);
        putc('\n', stderr);
    }
    if (m->left_out)
        fprintf(stderr, "fourlink: and %lu more mistakes\n", (unsigned long)m->left_out);
}

#define TRIES 1000

/* Read a deck; of a [sweep] the first design that is in order, if there is one among the first, or among as
** many spread over all of them. */
static int read_first_design(job *j)
{
    fourlink_source source = j->source;
    int status = flk_deck_read(&source, &j->deck);
    unsigned long n = j->deck.sweep.n_designs, i;
    deck other;

    for (i = 1; status == 0 && i < n && i < 2 * TRIES; i++) {
        source.design = i < TRIES || n < 2 * TRIES ? i : n / TRIES * (i - TRIES);
        if (flk_deck_read(&source, &other) == 1) {
            flk_deck_free(&j->deck);
            j->deck = other;
            j->source.design = source.design;
            return 1;
        }
        flk_deck_free(&other);
    }
    return status;
}

/* What the options ask of a deck, and it has not; 1 if there is no such thing. */
static int check_options(const options *o, const job *j)
{
    const char *why = NULL, *name = j->name;

    if (o->check && !j->deck.n_expectations) {
        why = "nothing to check: there is no [expect] or [misprint]";
        name = o->check_file ? o->check_file : j->name;
    } else if (o->matrix && !j->deck.has_forces) {
        why = "--matrix needs masses or loads, which the deck has not";
    } else if (o->format == FORMAT_PAPER && j->deck.design.kind != FOURLINK_FOUR_BAR) {
        why = "--format=paper is for the paper's mechanism, a four-bar";
    } else if (!j->contents && o->parts) {
        why = "--part needs a [sweep], which the deck has not";
    } else if (j->contents && o->n_decks > 1) {
        why = "a [sweep] is worked on alone, not with other decks";
    } else if (j->contents && (o->check || o->matrix || o->summary || o->format == FORMAT_PAPER)) {
        why = "a [sweep] is printed in the formats table and csv; --check, --matrix and --summary "
              "are for one design";
    }
    if (why)
        fprintf(stderr, "%s:1: error: %s\n", name, why);
    return !why;
}

/* Read a deck; the exit status it calls for. */
static int read_job(const char *path, const options *o, text answers, job *j)
{
    size_t length;
    char *contents;
    int status;

    j->o = o;
    j->name = strcmp(path, "-") == 0 ? "<stdin>" : path;
    if (j->name != path && isatty(STDIN_FILENO))
        fputs("fourlink: reading a deck from the keyboard (fourlink --help tells more)\n", stderr);
    contents = files_read(path, &length);
    if (!contents && errno == EFBIG) {
        fprintf(stderr, "%s:1: error: a file of more than 64 MB: not a deck\n", j->name);
        return EXIT_USAGE;
    }
    if (!contents)
        return complain("cannot read", j->name, strerror(errno));
    j->text = contents;
    j->source.name = j->name;
    j->source.text = contents;
    j->source.length = (unsigned long)length;
    j->source.load = read_named_file;
    j->source.host = j;
    j->source.changes = o->changes;
    j->source.n_changes = o->n_changes;
    j->source.answers_name = o->check_file;
    j->source.answers = answers.start;
    j->source.answers_length = (unsigned long)answers.length;
    status = read_first_design(j);
    if (j->names_output)
        return complain("cannot write", "a file that the deck names", "it is an input");
    if (status > 0 && j->deck.sweep.n_variables)
        j->contents = contents;
    if (status < 0)
        return complain("cannot read", j->name, "not enough memory");
    if (status == 0)
        columns_check(&j->deck);
    else
        status = columns_choose(&j->deck, &j->columns);
    if (status < 0)
        return complain("cannot read", j->name, "not enough memory");
    if (status > 0 && j->contents)
        status = sweep_check(&j->deck);
    if (j->deck.mistakes.count) {
        flk_mistakes_sort(&j->deck.mistakes);
        print_mistakes(&j->deck.mistakes, o->n_decks > 1 ? j->name : NULL);
        return EXIT_USAGE;
    }
    if (!check_options(o, j))
        return EXIT_USAGE;
    j->usable = 1;
    return 0;
}

static int check_job(FILE *out, const options *o, job *j, const char *deck_name)
{
    switch (grade_print(out, &j->deck, o->format == FORMAT_CSV, deck_name)) {
    case GRADE_OK:
        return 0;
    case GRADE_DIFFERENCES:
        return EXIT_ROWS;
    case GRADE_MISTAKES:
        print_mistakes(&j->deck.mistakes, o->n_decks > 1 ? j->name : NULL);
        return EXIT_USAGE;
    default:
        return complain("cannot check", j->name, "not enough memory");
    }
}

/* Print what is asked for of an analysis; 0 when out of memory. */
static int print_analysis(FILE *out, const options *o, analysis *a, const job *j,
                          const column_list *header, const char *deck_name, unsigned long *failed)
{
    csv_labels labels = {NULL, NULL, 0};

    labels.deck_name = deck_name;
    if (o->list)
        return list_print(out, a);
    if (o->summary && o->format == FORMAT_CSV)
        summary_print_csv(out, a, &j->columns, deck_name);
    else if (o->summary)
        summary_print(out, a, &j->columns);
    else if (o->matrix)
        *failed = matrix_print(out, a);
    else if (o->format == FORMAT_PAPER)
        *failed = paper_print(out, a);
    else if (o->format == FORMAT_CSV)
        return csv_print(out, a, &j->columns, header, &labels, failed);
    else
        return table_print(out, a, &j->columns, failed);
    return 1;
}

/* Print the designs of a sweep; the exit status. */
static int sweep_job(FILE *out, const options *o, job *j, int *signal_number)
{
    sweep_request request;
    unsigned long failed = 0;
    sweep_result status;

    request.source = j->source;
    request.part = o->parts ? o->part : 1;
    request.parts = o->parts ? o->parts : 1;
    request.csv = o->format == FORMAT_CSV;
    status = sweep_print(out, &j->deck, &request, &failed, signal_number);
    if (status == SWEEP_MEMORY)
        return complain("cannot analyse", j->name, "not enough memory");
    if (status == SWEEP_INTERRUPTED)
        return complain("stopped", j->name, "interrupted: the part can be run again");
    return failed ? EXIT_ROWS : 0;
}

/* Print a deck; the exit status it calls for. */
static int print_job(FILE *out, const options *o, job *j, const column_list *header)
{
    const char *deck_name = o->n_decks > 1 ? j->name : NULL;
    int needs = columns_need(&j->columns), enough;
    unsigned long failed = 0;
    analysis a;

    if (o->check)
        return check_job(out, o, j, deck_name);
    if (o->matrix || ((o->summary || o->list) && j->deck.has_forces))
        needs |= NEED_FORCES;
    enough = analysis_open(&a, &j->deck, needs) &&
             print_analysis(out, o, &a, j, header, deck_name, &failed) && !a.out_of_memory;
    analysis_close(&a);
    if (!enough)
        return complain("cannot analyse", j->name, "not enough memory");
    return failed ? EXIT_ROWS : 0;
}

static int print_jobs(FILE *out, const options *o, job *jobs)
{
    column_list header;
    char name[1024];
    csv_labels labels = {NULL, NULL, 0};
    int status = 0, csv = o->format == FORMAT_CSV && !o->list, printed = 0;
    size_t i, k;

    labels.deck_name = o->n_decks > 1 ? "" : NULL;
    memset(&header, 0, sizeof header);
    for (i = 0; csv && i < o->n_decks; i++)
        for (k = 0; jobs[i].usable && k < jobs[i].columns.count; k++)
            if (!columns_add(&header, &jobs[i].columns.list[k])) {
                columns_free(&header);
                return complain("cannot start", "", "not enough memory");
            }
    if (csv && o->check)
        grade_print_csv_header(out, o->n_decks > 1);
    else if (csv && o->summary)
        summary_print_csv_header(out, o->n_decks > 1);
    else if (csv)
        csv_print_header(out, NULL, &header, &labels);
    for (i = 0; i < o->n_decks; i++) {
        if (!jobs[i].usable && csv && o->check && o->n_decks > 1)
            grade_print_csv_bad_deck(out, jobs[i].name);
        if (!jobs[i].usable)
            continue;
        if (printed++ && !csv)
            fputs("\n\n", out);
        if (o->n_decks > 1 && !csv)
            fprintf(out, "# deck: %s\n",
                    flk_text_copy(flk_text_of(jobs[i].name), name, sizeof name));
        status = worse(status, print_job(out, o, &jobs[i], &header));
    }
    columns_free(&header);
    return status;
}

/* Tell what became of gnuplot; the exit status. */
static int report_gnuplot(gnuplot_result outcome, const char *picture)
{
    switch (outcome) {
    case GNUPLOT_MISSING:
        return complain("cannot draw", picture,
                        "gnuplot is not installed; its package is gnuplot-nox (Debian, Ubuntu) or "
                        "gnuplot. --plot-script writes the script for it");
    case GNUPLOT_FAILED:
        return complain("cannot draw", picture, "gnuplot failed");
    case GNUPLOT_ERRNO:
        return complain("cannot draw", picture, strerror(errno));
    case GNUPLOT_OK:
    default:
        return 0;
    }
}

/* Open an output, "-" being standard output as null is; the exit status. */
static int begin_output(output *o, const char *path)
{
    int status = 0;

    if (!output_open(o, path && strcmp(path, "-") == 0 ? NULL : path)) {
        status = complain("cannot write", path ? path : "standard output", strerror(errno));
        output_discard(o);
    }
    return status;
}

/* Finish an output, or give it up; the exit status. */
static int end_output(output *o, const char *path, int keep)
{
    if (!keep)
        output_discard(o);
    else if (!output_close(o))
        return complain("cannot write", path ? path : "standard output", strerror(errno));
    return 0;
}

/* Have gnuplot draw a script; the exit status. */
static int draw_picture(const char *path, FILE *script)
{
    output picture;
    int status = begin_output(&picture, path);

    if (status)
        return status;
    status = report_gnuplot(gnuplot_run(script, picture.file), path);
    return worse(status, end_output(&picture, path, status == 0));
}

/* Write the script of a picture; the exit status. */
static int write_script(FILE *script, const options *o, job *j)
{
    fourlink_mistake mistake;
    plot_request request;

    request.kind = o->plot_kind;
    request.file = o->plot_file;
    request.picture = o->plot_script && o->plot && strcmp(o->plot, "-") != 0 ? o->plot : NULL;
    request.at = o->plot_at;
    if (picture_write(script, &j->source, &request, &mistake))
        return 0;
    fprintf(stderr, "fourlink: %s: error: %s\n", mistake.file, mistake.message);
    return EXIT_USAGE;
}

/* The picture that is asked for, or its script; the exit status. */
static int plot_job(const options *o, job *j)
{
    FILE *script;
    output file;
    int status;

    if (o->plot_script) {
        status = begin_output(&file, o->plot_script);
        if (status)
            return status;
        status = write_script(file.file, o, j);
        return worse(status, end_output(&file, o->plot_script, status == 0));
    }
    script = tmpfile();
    if (!script)
        return complain("cannot draw", o->plot, strerror(errno));
    status = write_script(script, o, j);
    if (!status)
        status = draw_picture(o->plot, script);
    fclose(script);
    return status;
}

static int run(const options *o)
{
    job *jobs = calloc(o->n_decks, sizeof *jobs);
    int status = 0, usable = 0, signal_number = 0;
    char *contents;
    text answers;
    output out;
    size_t i;

    if (!jobs)
        return complain("cannot start", "", "not enough memory");
    answers.start = contents = NULL;
    if (o->check_file) {
        answers.start = contents = files_read(o->check_file, &answers.length);
        if (!contents) {
            free(jobs);
            return complain("cannot read", o->check_file, strerror(errno));
        }
    }
    for (i = 0; i < o->n_decks; i++) {
        status = worse(status, read_job(o->decks[i], o, answers, &jobs[i]));
        usable += jobs[i].usable;
    }
    if (usable) {
        int written = begin_output(&out, o->output);

        if (!written) {
            int printed = jobs[0].contents && !o->list
                              ? sweep_job(out.file, o, &jobs[0], &signal_number)
                              : print_jobs(out.file, o, jobs);

            status = worse(status, printed);
            /* half of the results are none */
            written = end_output(&out, o->output, printed != EXIT_FILES);
        }
        status = worse(status, written);
    }
    if ((o->plot || o->plot_script) && jobs[0].usable && !signal_number)
        status = worse(status, plot_job(o, &jobs[0]));
    for (i = 0; i < o->n_decks; i++)
        close_job(&jobs[i]);
    free(jobs);
    free(contents);
    if (signal_number) {
        fflush(stdout);
        raise(signal_number); /* what called the program is to know */
    }
    return status;
}

static int finish_text(void)
{
    return fflush(stdout) == 0 && !ferror(stdout)
               ? 0
               : complain("cannot write", "standard output", strerror(errno));
}

static int print_help(void)
{
    const char *const *line;

    for (line = options_help; *line; line++)
        puts(*line);
    return finish_text();
}

int main(int argc, char **argv)
{
    char message[400];
    const char *input;
    options o;
    int status = options_read(argc, argv, &o, message);

    output_prepare();
    gsl_set_error_handler_off(); /* what GSL reports is looked at where it is called */
    if (status < 0) {
        status = complain("cannot start", "", "not enough memory");
    } else if (status == 0) {
        fprintf(stderr, "fourlink: %s\nTry 'fourlink --help'.\n", message);
        status = EXIT_USAGE;
    } else if (o.help) {
        status = print_help();
    } else if (o.version) {
        printf("fourlink %s\nLicence GPL-3.0-or-later; there is no warranty.\n",
               fourlink_version());
        status = finish_text();
    } else if ((input = clash_input_among_outputs(&o)) != NULL) {
        status = complain("cannot write", input, "it is an input");
    } else if ((input = clash_output_given_twice(&o)) != NULL) {
        status = complain("cannot write", input, "two results would be written to it");
    } else {
        status = run(&o);
    }
    options_free(&o);
    return status;
}
