/* SPDX-License-Identifier: GPL-3.0-or-later
**
** joined.c - statistics of designs that were computed before, in a file of csv: the parts of a sweep, joined.
**
** The file is read once, a field at a time.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "base/number.h"
#include "base/system.h"
#include "command.h"
#include "joined.h"
#include "tables/statistics.h"

#define FIELD_SIZE 512

/* What a column of the file is. */
enum { OF_NOTHING = -1, OF_BRANCH = -2 };

typedef struct reader {
    const char *name; /* of the file */
    FILE *file;
    long line;
    char field[FIELD_SIZE]; /* cut off if longer */
    int end;                /* what ended it: ',', '\n' or EOF */
    long *columns;          /* by column: the number of an output, or one of the above */
    unsigned long n_columns;
    fourlink_value *outputs; /* of the file's own columns */
    char *names;             /* of these: name and unit, FIELD_SIZE bytes together */
    unsigned long n_outputs;
} reader;

/* Returns the exit status. */
static int complain(const reader *r, const char *why)
{
    command_tell_mistake(r->name, r->line, why, NULL);
    return EXIT_USAGE;
}

static void put(reader *r, size_t *n, int c)
{
    if (*n + 1 < FIELD_SIZE)
        r->field[(*n)++] = (char)c;
}

/* Read a field, without its quotes.  Returns 0 at the end of the file. */
static int read_field(reader *r)
{
    int c = getc(r->file), is_quoted = c == '"', was = c;
    size_t n = 0;

    if (c == EOF)
        return 0;
    if (is_quoted)
        c = getc(r->file);
    while (c != EOF && (is_quoted || (c != ',' && c != '\n'))) {
        if (is_quoted && c == '"' && (c = getc(r->file)) != '"') {
            is_quoted = 0;
            continue;
        }
        r->line += c == '\n';
        put(r, &n, c);
        c = getc(r->file);
    }
    if (n > 0 && c != ',' && was != '"' && r->field[n - 1] == '\r')
        n--;
    r->field[n] = '\0';
    r->end = c;
    return 1;
}

/* Keep the name of a column as that of an output.  Returns 0 if out of memory. */
static int add_output(reader *r)
{
    char *names = realloc(r->names, (r->n_outputs + 1) * FIELD_SIZE);

    if (!names)
        return 0;
    r->names = names;
    strcpy(names + FIELD_SIZE * r->n_outputs++, r->field);
    return 1;
}

/* Describe the outputs by their names, NAME (UNIT).  Returns 0 if out of memory. */
static int describe_outputs(reader *r)
{
    unsigned long i;

    r->outputs = calloc(r->n_outputs + 1, sizeof *r->outputs);
    for (i = 0; r->outputs && i < r->n_outputs; i++) {
        char *name = r->names + FIELD_SIZE * i, *bracket = strrchr(name, '(');
        size_t last = strlen(name);

        r->outputs[i].name = name;
        r->outputs[i].unit = "";
        if (!bracket || bracket < name + 2 || bracket[-1] != ' ' || name[last - 1] != ')')
            continue;
        name[last - 1] = bracket[-1] = '\0';
        r->outputs[i].unit = bracket + 1;
    }
    return r->outputs != NULL;
}

/* The output of a deck that a column of the file is. */
static long find_output(const reader *r, const fourlink_value *outputs, unsigned long n)
{
    char heading[FIELD_SIZE];
    unsigned long i;

    for (i = 0; i < n; i++)
        if (strcmp(r->field, flk_text_join(heading, sizeof heading, outputs[i].name, " (",
                                           outputs[i].unit, ")", (char *)NULL)) == 0)
            return (long)i;
    return OF_NOTHING;
}

/* Read the header; returns the exit status. */
static int read_header(reader *r, const fourlink_value *outputs, unsigned long n)
{
    int is_after_branch = 0;
    long *more, column;

    r->line = 1;
    do {
        if (!read_field(r))
            break;
        column = OF_NOTHING;
        if (strcmp(r->field, "branch") == 0) {
            column = OF_BRANCH;
            is_after_branch = 1;
        } else if (outputs) {
            column = find_output(r, outputs, n);
        } else if (is_after_branch && strcmp(r->field, "status") != 0) {
            if (!add_output(r))
                return command_complain("cannot read", r->name, "not enough memory");
            column = (long)r->n_outputs - 1;
        }
        more = realloc(r->columns, (r->n_columns + 1) * sizeof *more);
        if (!more)
            return command_complain("cannot read", r->name, "not enough memory");
        r->columns = more;
        r->columns[r->n_columns++] = column;
    } while (r->end == ',');
    if (!describe_outputs(r))
        return command_complain("cannot read", r->name, "not enough memory");
    return is_after_branch ? 0
                           : complain(r, "expected the header of a sweep in csv, such as "
                                         "'design,crank.length (m),branch,mu_min (deg),status'");
}

/* A number, or inf or -inf; NaN for words and for nothing. */
static double value_of(const char *field)
{
    text rest = flk_text_trim(flk_text_of(field));
    double value;

    if (flk_text_same(rest, "inf"))
        return GSL_POSINF;
    if (flk_text_same(rest, "-inf"))
        return GSL_NEGINF;
    return flk_number_read(&rest, &value) == NUMBER_OK && !rest.length ? value : GSL_NAN;
}

/* Read a line into the values of a design.  1; 0 at the end of the file; -1 and a message if it has too few or
** too many fields, or no branch. */
static int read_design(reader *r, double *values, int *words, fourlink_branch *branch)
{
    unsigned long i, n = 0;
    int is_there = 0;

    r->line++;
    for (i = 0; i < r->n_columns; i++)
        if (r->columns[i] >= 0)
            values[r->columns[i]] = GSL_NAN;
    do {
        if (!read_field(r))
            break;
        if (n < r->n_columns && r->columns[n] == OF_BRANCH) {
            is_there = strcmp(r->field, "open") == 0 || strcmp(r->field, "crossed") == 0;
            *branch = r->field[0] == 'o' ? FOURLINK_OPEN : FOURLINK_CROSSED;
        } else if (n < r->n_columns && r->columns[n] >= 0) {
            values[r->columns[n]] = value_of(r->field);
            words[r->columns[n]] = r->field[0] && gsl_isnan(values[r->columns[n]]);
        }
        n++;
    } while (r->end == ',');
    if (!n) {
        r->line--;
        return 0;
    }
    if (n != r->n_columns)
        complain(r, "the number of fields is not that of the header");
    else if (!is_there)
        complain(r, "expected open or crossed in the column branch");
    return n == r->n_columns && is_there ? 1 : -1;
}

static int read_designs(reader *r, statistics *x)
{
    double *values = malloc((x->n_outputs + 1) * sizeof *values);
    int *words = calloc(x->n_outputs + 1, sizeof *words);
    fourlink_branch branch = FOURLINK_OPEN;
    unsigned long i;
    int status = 1;

    while (values && words && !x->out_of_memory &&
           (status = read_design(r, values, words, &branch)) == 1) {
        statistics_add(x, branch, values);
        for (i = 0; i < x->n_outputs; i++)
            if (words[i])
                statistics_add_words(x, branch, i);
    }
    if (!values || !words || x->out_of_memory)
        status = command_complain("cannot read", r->name, "not enough memory");
    else if (status < 0)
        status = EXIT_USAGE;
    else if (ferror(r->file))
        status = command_complain("cannot read", r->name, strerror(errno));
    else if (!x->designs[0] && !x->designs[1])
        status = complain(r, "no designs after the header");
    free(values);
    free(words);
    return status;
}

/* 0 and a message if the file lacks an output of the deck. */
static int has_outputs(const reader *r, const fourlink_value *outputs, unsigned long n)
{
    char message[MESSAGE_SIZE];
    unsigned long i, k;

    for (i = 0; i < n; i++) {
        for (k = 0; k < r->n_columns && r->columns[k] != (long)i; k++)
            ;
        if (k < r->n_columns)
            continue;
        flk_message(message, sizeof message, "there is no column '%s (%s)', an output of the deck",
                    outputs[i].name, outputs[i].unit);
        complain(r, message);
        return 0;
    }
    return 1;
}

static int write_statistics(FILE *out, const options *o, const input *in, reader *r)
{
    const fourlink_value *outputs = NULL, *conditions = NULL;
    unsigned long n = 0, n_conditions = 0;
    statistics x;
    sheet s;
    int status;

    memset(&s, 0, sizeof s);
    if (in) {
        fourlink_results_list(in->results, FOURLINK_OUTPUTS, &outputs, &n);
        fourlink_results_list(in->results, FOURLINK_CONDITIONS, &conditions, &n_conditions);
        s.problem = in->problem;
    }
    status = read_header(r, outputs, n);
    if (status || (in && !has_outputs(r, outputs, n)))
        return status ? status : EXIT_USAGE;
    status = statistics_open(&x, in ? outputs : r->outputs, in ? n : r->n_outputs, conditions,
                             n_conditions)
                 ? read_designs(r, &x)
                 : command_complain("cannot read", r->name, "not enough memory");
    if (!status) {
        s.format = o->format;
        s.content = SHEET_STATISTICS;
        sheet_begin(&s, out, 1);
        statistics_write(&s, in ? in->results : NULL, &x);
    }
    statistics_close(&x);
    return status;
}

int joined_write(FILE *out, const options *o, const input *in)
{
    int is_standard = strcmp(o->statistics_file, "-") == 0, status;
    reader r;

    memset(&r, 0, sizeof r);
    r.name = is_standard ? "<stdin>" : o->statistics_file;
    r.file = is_standard ? stdin : system_open(o->statistics_file, "rb");
    if (!r.file)
        return command_complain("cannot read", r.name, strerror(errno));
    status = write_statistics(out, o, in, &r);
    if (!is_standard)
        fclose(r.file);
    free(r.columns);
    free(r.outputs);
    free(r.names);
    return status;
}
