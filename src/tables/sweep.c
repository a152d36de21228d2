/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sweep.c - the designs of a deck's [sweep], one after the other: rows of each, or a line for each.
**
** Every design is a deck of its own, read from the same text: what it prints depends on its number
** alone, so parts that are put together are the whole, and memory is that of one design.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with SA_RESTART */

#include <float.h>
#include <signal.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <gsl/gsl_math.h>

#include "results/extreme.h"
#include "results/fact.h"
#include "base/format.h"
#include "print.h"
#include "sweep.h"
#include "table.h"

#define MOST_OUTPUTS 64
#define WIDTH 16 /* of a column in the format table */

/* One of the things that are told of every design. */
typedef struct sweep_output {
    enum { OUTPUT_COLUMN, OUTPUT_EXTREME, OUTPUT_FACT } form;
    text name, column; /* max(Ts), Ts */
    int sign;          /* of an extreme */
    int turning;       /* 1: a fact of the turning moment */
    char unit[DECK_NAME_SIZE];
    int has_value; /* of this design */
    double value;
    const char *words;
} sweep_output;

typedef struct sweep_outputs {
    sweep_output list[MOST_OUTPUTS];
    size_t n;
    int needs, turning;
} sweep_outputs;

/* ------------------------------------------------------------------------------ the list of outputs */

static int find_output(const deck *d, text name, sweep_output *x)
{
    column c;
    quantity q;

    memset(x, 0, sizeof *x);
    x->name = name;
    x->column = name;
    x->sign = column_extreme_of(name, &x->column);
    if (column_find(d, x->column, &c)) {
        x->form = x->sign ? OUTPUT_EXTREME : OUTPUT_COLUMN;
        strcpy(x->unit, c.unit);
        return x->sign || d->one_instant;
    }
    if (x->sign || !fact_known(name, &q, &x->turning))
        return 0;
    x->form = OUTPUT_FACT;
    strcpy(x->unit, d->units[q].name);
    return 1;
}

static void note_unknown(const deck *d, const sweep_output *x, mistakes *list)
{
    const char *nearest = x->sign ? column_nearest(d, x->column) : fact_nearest(x->name);
    const char *open = x->sign > 0 ? "max(" : "min(";
    char name[2 * DECK_NAME_SIZE];
    column c;

    if (nearest && x->sign)
        nearest = flk_text_join(name, sizeof name, open, nearest, ")", (char *)NULL);
    flk_mistake(list, d->sweep.output.place, "'%t' %s%h", x->name,
                column_find(d, x->name, &c)
                    ? "has many values: name its extremes, max() or min()"
                    : "is no fact, and no max() or min() of a column, of this deck",
                nearest);
}

/* The deck's outputs; 0 and mistakes in `list` if some are not known. */
static int find_outputs(const deck *d, sweep_outputs *outputs, mistakes *list)
{
    text rest = d->sweep.output.names, name;
    int found = 1;
    column c;

    memset(outputs, 0, sizeof *outputs);
    while (outputs->n < MOST_OUTPUTS && column_next_name(&rest, &name)) {
        sweep_output *x = &outputs->list[outputs->n];

        if (!find_output(d, name, x)) {
            note_unknown(d, x, list);
            found = 0;
            continue;
        }
        if (x->form != OUTPUT_FACT && column_find(d, x->column, &c))
            outputs->needs |= column_need(&c);
        if (x->turning) {
            outputs->turning = 1;
            outputs->needs |= NEED_FORCES;
        }
        outputs->n++;
    }
    if (rest.length && column_next_name(&rest, &name)) {
        flk_mistake(list, d->sweep.output.place, "more than 64 outputs");
        found = 0;
    }
    if (d->sweep.output.names.start && found && !outputs->n) {
        flk_mistake(list, d->sweep.output.place, "output names nothing");
        found = 0;
    }
    return found;
}

int sweep_check(deck *d)
{
    sweep_outputs outputs;

    return find_outputs(d, &outputs, &d->mistakes);
}

/* --------------------------------------------------------------------------- the values of a design */

static void take_fact(const fact *f, void *data)
{
    sweep_outputs *outputs = data;
    size_t i;

    for (i = 0; i < outputs->n; i++) {
        sweep_output *x = &outputs->list[i];

        if (x->form == OUTPUT_FACT && !x->has_value && flk_text_same(x->name, f->name)) {
            x->has_value = 1;
            x->value = f->value;
            x->words = f->words;
        }
    }
}

/* An extreme: infinite where the column grows beyond all bounds.  Null, or why there is none. */
static const char *find_extreme(analysis *a, fourlink_branch branch, const column *c,
                                sweep_output *x)
{
    extreme found;
    extreme_result status = extreme_find(a, c, branch, x->sign, &found);

    x->has_value = status != EXTREME_NONE;
    x->value = status == EXTREME_FOUND ? found.value : x->sign > 0 ? GSL_POSINF : GSL_NEGINF;
    return x->has_value ? NULL : "the links reach at no angle of the motion";
}

static const char *find_at_instant(analysis *a, fourlink_branch branch, const column *c,
                                   sweep_output *x)
{
    result r;

    analysis_row(a, branch, 0, &r);
    x->has_value = r.status == FOURLINK_OK || column_of_crank(c);
    x->value = x->has_value ? column_value(c, &r) : 0;
    return x->has_value ? NULL : fourlink_status_text(r.status);
}

/* All outputs of a design on a branch.  Null, or the first reason why one of them has no value; facts
** that this design has not are not among these. */
static const char *find_values(analysis *a, fourlink_branch branch, sweep_outputs *outputs)
{
    const char *why = NULL, *reason;
    int has_facts = 0;
    column c;
    size_t i;

    for (i = 0; i < outputs->n; i++) {
        sweep_output *x = &outputs->list[i];

        x->has_value = 0;
        x->words = NULL;
        has_facts |= x->form == OUTPUT_FACT;
        if (x->form == OUTPUT_FACT)
            continue;
        if (!column_find(a->d, x->column, &c))
            reason = "this design has not all columns of the first";
        else if (x->form == OUTPUT_EXTREME)
            reason = find_extreme(a, branch, &c, x);
        else
            reason = find_at_instant(a, branch, &c, x);
        why = why ? why : reason;
    }
    if (has_facts)
        facts_tell(a, (int)branch, outputs->turning, NULL, take_fact, outputs);
    return why;
}

/* ------------------------------------------------------------------------------- a line per design */

/* What the rows of a design begin with in csv. */
static void set_labels(csv_labels *labels, const deck *d, unsigned long design)
{
    labels->deck_name = NULL;
    labels->sweep = &d->sweep;
    labels->design = design;
}

static void put_csv_header(FILE *out, const deck *d, const sweep_outputs *outputs)
{
    csv_labels labels;
    row_buffer row;
    size_t i;

    set_labels(&labels, d, 0);
    row_start(&row, out);
    csv_put_label_names(&row, d, &labels);
    row_text(&row, "branch,", 7);
    for (i = 0; i < outputs->n; i++) {
        csv_heading(&row, outputs->list[i].name, outputs->list[i].unit);
        row_text(&row, ",", 1);
    }
    row_text(&row, "status\r\n", 8);
    row_end(&row);
}

static void put_word(row_buffer *row, const char *word)
{
    row_right(row, word, strlen(word), WIDTH);
}

/* Names, and units below them, as a comment. */
static void put_table_header(FILE *out, const deck *d, const sweep_outputs *outputs)
{
    const deck_variable *v = d->sweep.variables;
    row_buffer row;
    size_t i;

    row_start(&row, out);
    row_text(&row, "#   design", 10);
    for (i = 0; i < d->sweep.n_variables; i++)
        row_right(&row, v[i].name.start, v[i].name.length, WIDTH);
    row_text(&row, "    branch", 10);
    for (i = 0; i < outputs->n; i++)
        row_right(&row, outputs->list[i].name.start, outputs->list[i].name.length, WIDTH);
    row_text(&row, "\n#         ", 11);
    for (i = 0; i < d->sweep.n_variables; i++)
        put_word(&row, d->units[v[i].q].name);
    row_text(&row, "          ", 10);
    for (i = 0; i < outputs->n; i++)
        put_word(&row, outputs->list[i].unit);
    row_text(&row, "\n", 1);
    row_end(&row);
}

static void put_number(row_buffer *row, const deck *d, double x)
{
    char number[FORMAT_SIZE];
    const char *end = format_general_end(x + 0.0, d->digits, number);

    row_right(row, number, (size_t)(end - number), WIDTH);
}

/* Number and quantities of a design, which begin its lines. */
static void put_design(row_buffer *row, const deck *d, unsigned long design, int csv)
{
    char number[FORMAT_SIZE];
    csv_labels labels;
    size_t i;

    if (csv) {
        set_labels(&labels, d, design);
        csv_put_labels(row, &labels);
        return;
    }
    format_fixed((double)(design + 1), 0, number);
    row_right(row, number, strlen(number), 10);
    for (i = 0; i < d->sweep.n_variables; i++)
        put_number(row, d, d->sweep.variables[i].value);
}

static void put_value(row_buffer *row, const deck *d, const sweep_output *x, int csv)
{
    char quoted[DECK_NAME_SIZE + 40];

    if (csv) {
        if (x->has_value && x->words)
            row_field(row, x->words);
        else if (x->has_value)
            csv_put_number(row, x->value);
        row_text(row, ",", 1);
    } else if (x->has_value && !x->words) {
        put_number(row, d, x->value);
    } else if (x->has_value) {
        flk_text_join(quoted, sizeof quoted, "\"", x->words, "\"", (char *)NULL);
        row_text(row, "  ", 2);
        row_right(row, quoted, strlen(quoted), WIDTH - 2);
    } else {
        put_word(row, "nan");
    }
}

/* The line of a design on a branch; `why` not null: the reason why it has no values. */
static void put_line(FILE *out, const deck *d, unsigned long design, fourlink_branch branch,
                     const sweep_outputs *outputs, const char *why, int csv)
{
    const char *name = branch_name(branch);
    row_buffer row;
    size_t i;

    row_start(&row, out);
    put_design(&row, d, design, csv);
    if (csv) {
        row_field(&row, name);
        row_text(&row, ",", 1);
    } else {
        row_right(&row, branch == FOURLINK_OPEN ? "\"open\"" : "\"crossed\"", strlen(name) + 2, 10);
    }
    for (i = 0; i < outputs->n; i++)
        put_value(&row, d, &outputs->list[i], csv);
    if (csv)
        row_field(&row, why ? why : fourlink_status_text(FOURLINK_OK));
    row_text(&row, csv ? "\r\n" : "\n", csv ? 2 : 1);
    row_end(&row);
}

static int print_lines(FILE *out, analysis *a, unsigned long design, sweep_outputs *outputs,
                       int csv, unsigned long *failed)
{
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i;

    for (i = 0; i < n; i++) {
        const char *why = find_values(a, branches[i], outputs);

        *failed += why != NULL;
        put_line(out, a->d, design, branches[i], outputs, why, csv);
    }
    return !a->out_of_memory;
}

/* -------------------------------------------------------------------------------- rows of a design */

/* Between the blocks of a table. */
static void put_gap(FILE *out, unsigned long design)
{
    if (design > 0)
        fputs("\n\n", out);
}

static void put_design_comment(FILE *out, const deck *d, unsigned long design)
{
    char number[FORMAT_SIZE], name[DECK_NAME_SIZE];
    size_t i;

    fprintf(out, "# design %s", format_fixed((double)(design + 1), 0, number));
    for (i = 0; i < d->sweep.n_variables; i++) {
        const deck_variable *v = &d->sweep.variables[i];

        fprintf(out, "%s %s = %s %s", i ? "," : ":", flk_text_copy(v->name, name, sizeof name),
                format_general(v->value, 12, number), d->units[v->q].name);
    }
    putc('\n', out);
}

static int print_rows(FILE *out, analysis *a, unsigned long design, const column_list *columns,
                      const column_list *header, int csv, unsigned long *failed)
{
    csv_labels labels;

    if (!csv) {
        put_gap(out, design);
        put_design_comment(out, a->d, design);
        return table_print(out, a, columns, failed);
    }
    set_labels(&labels, a->d, design);
    return csv_print(out, a, columns, header, &labels, failed);
}

/* ------------------------------------------------------------------------------------ all of them */

/* A design that is none: its reason in place of its values, on the branches of the first. */
static void put_mistake(FILE *out, const deck *d, unsigned long design, const deck *first,
                        sweep_outputs *outputs, const column_list *columns, int csv)
{
    const char *why = d->mistakes.count ? d->mistakes.list[0].message : "";
    fourlink_branch branches[2];
    int n = print_branches_of(first, branches), i;
    csv_labels labels;
    size_t k;

    if (!csv) {
        if (!outputs->n)
            put_gap(out, design);
        put_design_comment(out, d, design);
        fprintf(out, "# %s\n", why);
        return;
    }
    set_labels(&labels, d, design);
    for (k = 0; k < outputs->n; k++)
        outputs->list[k].has_value = 0;
    for (i = 0; i < n; i++)
        if (outputs->n)
            put_line(out, d, design, branches[i], outputs, why, csv);
        else
            csv_print_reason(out, columns, &labels, branches[i], why);
}

/* A design that has been read; 0 when out of memory. */
static int print_good_design(FILE *out, deck *d, unsigned long design, const column_list *columns,
                             sweep_outputs *outputs, const column_list *header, int csv,
                             unsigned long *failed)
{
    analysis a;
    int enough = 0;

    if (!d->solver)
        d->solver = SOLVER_DYAD;
    if (analysis_open(&a, d, outputs->n ? outputs->needs : columns_need(columns)))
        enough = outputs->n ? print_lines(out, &a, design, outputs, csv, failed)
                            : print_rows(out, &a, design, columns, header, csv, failed);
    analysis_close(&a);
    return enough;
}

/* One design; 0 when out of memory. */
static int print_design(FILE *out, const sweep_request *request, unsigned long design,
                        const deck *first, sweep_outputs *outputs, const column_list *header,
                        unsigned long *failed)
{
    fourlink_source source = request->source;
    column_list columns;
    deck d;
    int status;

    memset(&columns, 0, sizeof columns);
    source.design = design;
    status = flk_deck_read(&source, &d);
    if (status > 0 && !outputs->n)
        status = columns_choose(&d, &columns);
    if (status == 0) {
        put_mistake(out, &d, design, first, outputs, header, request->csv);
        ++*failed;
        status = 1;
    } else if (status > 0) {
        status =
            print_good_design(out, &d, design, &columns, outputs, header, request->csv, failed);
    }
    columns_free(&columns);
    flk_deck_free(&d);
    return status > 0;
}

static volatile sig_atomic_t stopped_by;

static void on_signal(int number)
{
    stopped_by = number;
}

/* What is told while it lasts, where someone looks at it. */
static void tell_progress(unsigned long done, unsigned long of, time_t start, time_t *last)
{
    double share = (double)done / (double)of;
    time_t now = time(NULL);

    if (now == *last)
        return;
    *last = now;
    fprintf(stderr, "\rfourlink: %lu of %lu designs, %.0f %%, %.0f s to go    ", done, of,
            100 * share, difftime(now, start) * (1 / share - 1));
}

/* Where part k of n ends: k D / n, rounded down.  n is at most 10^6: the product is exact. */
static unsigned long end_of_part(unsigned long designs, unsigned long k, unsigned long n)
{
    return designs / n * k + (unsigned long)((double)(designs % n) * (double)k / (double)n);
}

sweep_result sweep_print(FILE *out, const deck *d, const sweep_request *request,
                         unsigned long *failed, int *signal_number)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    unsigned long from = end_of_part(d->sweep.n_designs, request->part - 1, request->parts);
    unsigned long to = end_of_part(d->sweep.n_designs, request->part, request->parts), i;
    struct sigaction action, old[3];
    int watched = isatty(STDERR_FILENO) && !isatty(fileno(out)), enough = 1, told = 0;
    time_t start = time(NULL), last = start;
    sweep_outputs outputs;
    column_list columns;
    csv_labels labels;
    deck first = *d;

    memset(&columns, 0, sizeof columns);
    find_outputs(d, &outputs, &first.mistakes);
    if (!outputs.n && columns_choose(&first, &columns) <= 0)
        return SWEEP_MEMORY;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART; /* a line that is being written is written to its end */
    sigemptyset(&action.sa_mask);
    stopped_by = 0;
    for (i = 0; i < 3; i++)
        if (sigaction(signals[i], NULL, &old[i]) == 0 && old[i].sa_handler != SIG_IGN)
            sigaction(signals[i], &action, NULL);
    set_labels(&labels, d, 0);
    if (request->part == 1 && outputs.n) {
        if (!request->csv && d->title[0])
            fprintf(out, "# %s\n", d->title);
        if (request->csv)
            put_csv_header(out, d, &outputs);
        else
            put_table_header(out, d, &outputs);
    } else if (request->part == 1 && request->csv) {
        csv_print_header(out, d, &columns, &labels);
    }
    for (i = from; i < to && enough && !stopped_by && !ferror(out); i++) {
        enough = print_design(out, request, i, d, &outputs, &columns, failed);
        if (watched && time(NULL) > start + 1) {
            tell_progress(i + 1 - from, to - from, start, &last);
            told = 1;
        }
    }
    if (told)
        fprintf(stderr, "\r%75s\r", "");
    for (i = 0; i < 3; i++)
        sigaction(signals[i], &old[i], NULL);
    columns_free(&columns);
    *signal_number = (int)stopped_by;
    return !enough ? SWEEP_MEMORY : stopped_by ? SWEEP_INTERRUPTED : SWEEP_OK;
}
