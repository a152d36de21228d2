/* SPDX-License-Identifier: GPL-3.0-or-later
**
** main.c - the command: files in, tables out, exit status.
*/
#define _POSIX_C_SOURCE 200112L

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gsl/gsl_errno.h>

#include "options.h"
#include "output.h"

enum { EXIT_ROWS = 1, EXIT_USAGE = 2, EXIT_FILES = 3 };

#define LARGEST_FILE 67108864 /* bytes */

/* A deck of the command line. */
typedef struct job {
    const char *name;
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

/* All of a stream; null with errno set if it cannot be read. */
static char *read_stream(FILE *file, size_t *length)
{
    size_t capacity = 65536, n = 0;
    char *contents = malloc(capacity), *more;

    while (contents) {
        n += fread(contents + n, 1, capacity - n, file);
        if (n < capacity)
            break;
        if (capacity >= LARGEST_FILE) {
            free(contents);
            errno = EFBIG;
            return NULL;
        }
        more = realloc(contents, 2 * capacity);
        if (!more)
            free(contents);
        contents = more;
        capacity *= 2;
    }
    if (contents && ferror(file)) {
        int reason = errno;

        free(contents);
        contents = NULL;
        errno = reason;
    }
    *length = n;
    return contents;
}

static char *read_path(const char *path, size_t *length)
{
    FILE *file;
    char *contents;
    int reason;

    file = fopen(path, "rb");
    if (!file)
        return NULL;
    contents = read_stream(file, length);
    reason = errno;
    fclose(file);
    errno = reason;
    return contents;
}

/* All of a file, or of standard input for "-". */
static char *read_file(const char *path, size_t *length)
{
    return strcmp(path, "-") == 0 ? read_stream(stdin, length) : read_path(path, length);
}

/* A file that a deck names, relative to the deck's folder. */
static char *read_named_file(const char *deck_name, const char *file_name, size_t *length)
{
    const char *slash = strrchr(deck_name, '/');
    size_t folder = slash && file_name[0] != '/' ? (size_t)(slash - deck_name) + 1 : 0;
    char *path = malloc(folder + strlen(file_name) + 1), *contents;

    if (!path)
        return NULL;
    memcpy(path, deck_name, folder);
    strcpy(path + folder, file_name);
    contents = read_path(path, length);
    free(path);
    return contents;
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

/* Put the expectations of the answers in place of the deck's; -1 when out of memory. */
static int use_answers(const char *path, text answers, deck *d)
{
    d->n_expectations = 0;
    return deck_add_expectations(path, answers, d);
}

/* Read a deck; the exit status it calls for. */
static int read_job(const char *path, const options *o, text answers, job *j)
{
    size_t length;
    char *contents;
    text all;
    int status;

    j->name = strcmp(path, "-") == 0 ? "<stdin>" : path;
    if (j->name != path && isatty(STDIN_FILENO))
        fputs("fourlink: reading a deck from the keyboard (fourlink --help tells more)\n", stderr);
    contents = read_file(path, &length);
    if (!contents && errno == EFBIG) {
        fprintf(stderr, "%s:1: error: a file of more than 64 MB: not a deck\n", j->name);
        return EXIT_USAGE;
    }
    if (!contents)
        return complain("cannot read", j->name, strerror(errno));
    all.start = contents;
    all.length = length;
    status = deck_read(j->name, all, read_named_file, o->changes, o->n_changes, &j->deck);
    free(contents);
    if (status < 0)
        return complain("cannot read", j->name, "not enough memory");
    if (status == 0)
        columns_check(&j->deck);
    else
        status = columns_choose(&j->deck, &j->columns);
    if (status < 0)
        return complain("cannot read", j->name, "not enough memory");
    if (status > 0 && answers.start && use_answers(o->check_file, answers, &j->deck) < 0)
        return complain("cannot read", o->check_file, "not enough memory");
    if (j->deck.mistakes.count) {
        mistakes_sort(&j->deck.mistakes);
        print_mistakes(&j->deck.mistakes, o->n_decks > 1 ? j->name : NULL);
        return EXIT_USAGE;
    }
    if (o->check && !j->deck.n_expectations) {
        fprintf(stderr, "%s:1: error: nothing to check: there is no [expect] or [misprint]\n",
                o->check_file ? o->check_file : j->name);
        return EXIT_USAGE;
    }
    if (o->matrix && !j->deck.has_forces) {
        fprintf(stderr, "%s:1: error: --matrix needs masses or loads, which the deck has not\n",
                j->name);
        return EXIT_USAGE;
    }
    if (o->format == FORMAT_PAPER && j->deck.design.kind != FOURLINK_FOUR_BAR) {
        fprintf(stderr, "%s:1: error: --format=paper is for the paper's mechanism, a four-bar\n",
                j->name);
        return EXIT_USAGE;
    }
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
        return csv_print(out, a, &j->columns, header, deck_name, failed);
    else
        return table_print(out, a, &j->columns, failed);
    return 1;
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
    int status = 0, csv = o->format == FORMAT_CSV && !o->list, printed = 0;
    size_t i, k;

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
        csv_print_header(out, &header, o->n_decks > 1);
    for (i = 0; i < o->n_decks; i++) {
        if (!jobs[i].usable && csv && o->check && o->n_decks > 1)
            grade_print_csv_bad_deck(out, jobs[i].name);
        if (!jobs[i].usable)
            continue;
        if (printed++ && !csv)
            fputs("\n\n", out);
        if (o->n_decks > 1 && !csv)
            fprintf(out, "# deck: %s\n", text_copy(text_of(jobs[i].name), name, sizeof name));
        status = worse(status, print_job(out, o, &jobs[i], &header));
    }
    columns_free(&header);
    return status;
}

/* 1 if an input, "-" for standard input, is the file of this status. */
static int is_file(const char *input, const struct stat *file)
{
    struct stat in;
    int status = strcmp(input, "-") == 0 ? fstat(STDIN_FILENO, &in) : stat(input, &in);

    return status == 0 && in.st_dev == file->st_dev && in.st_ino == file->st_ino;
}

/* 1 if the output file is one of the decks, or the file of answers, which it would replace. */
static int is_input(const char *path, const options *o)
{
    struct stat out;
    size_t i;

    if (stat(path, &out) != 0 || !S_ISREG(out.st_mode))
        return 0;
    if (o->check_file && is_file(o->check_file, &out))
        return 1;
    for (i = 0; i < o->n_decks; i++)
        if (is_file(o->decks[i], &out))
            return 1;
    return 0;
}

static int run(const options *o)
{
    job *jobs = calloc(o->n_decks, sizeof *jobs);
    const char *name = o->output ? o->output : "standard output";
    int status = 0, usable = 0;
    char *contents;
    text answers;
    output out;
    size_t i;

    if (!jobs)
        return complain("cannot start", "", "not enough memory");
    answers.start = contents = NULL;
    if (o->check_file) {
        answers.start = contents = read_file(o->check_file, &answers.length);
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
        if (output_open(&out, o->output)) {
            int printed = print_jobs(out.file, o, jobs);

            status = worse(status, printed);
            if (printed == EXIT_FILES)
                output_discard(&out); /* half of the results are none */
            else if (!output_close(&out))
                status = worse(status, complain("cannot write", name, strerror(errno)));
        } else {
            status = worse(status, complain("cannot write", name, strerror(errno)));
            output_discard(&out);
        }
    }
    for (i = 0; i < o->n_decks; i++) {
        columns_free(&jobs[i].columns);
        deck_free(&jobs[i].deck);
    }
    free(jobs);
    free(contents);
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
    options o;
    int status = options_read(argc, argv, &o, message);

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
    } else if (o.output && is_input(o.output, &o)) {
        status = complain("cannot write", o.output, "it is an input");
    } else {
        status = run(&o);
    }
    options_free(&o);
    return status;
}
