/* SPDX-License-Identifier: GPL-3.0-or-later
**
** batch.c - the sheet of decks, or of one deck with the answers of many, one at a time.
**
** The header of a csv has the columns of all decks: for these, all are read once before they are written,
** the first of them stay open, and the others are read again.  What can be read only once, such as standard
** input, is kept as text.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
#include "batch.h"
#include "best.h"
#include "feedback.h"
#include "command.h"
#include "files.h"
#include "marks.h"
#include "output.h"
#include "solve.h"
#include "tables/content.h"
#include "terminal.h"
#include "view/results.h"

#define KEPT 24 /* decks that stay open: half a megabyte each */

/* Many inputs, and what is known of all. */
typedef struct batch {
    const options *o;
    const grade_answers *answers;
    const input *deck; /* null: the inputs are decks */
    size_t n;
    input_text *texts; /* of decks that can be read only once; else null texts */
    input *kept;       /* the first KEPT decks, read before; without results: not kept */
    fourlink_value *header;
    unsigned long n_header;
    int has_designs; /* 1: one of these has a [sweep] */
    int has_sides;   /* 1: one has rows on both sides of its input */
    input variant;   /* of a class with a design for each: that of the student, */
    options of_variant;
    unsigned long n_designs; /* ... of so many; 0: all have the same deck */
    int has_values;          /* 1: a deck has values instead of rows: a line for each branch */
    marks m;
    sheet s;
} batch;

static int complain_of_memory(void)
{
    return command_lacks_memory("cannot start", "");
}

/* ------------------------------------------------------------------------------------------- the header */

/* Add a column, whose results will be closed; 0 if out of memory. */
static int add_column(batch *b, const fourlink_value *column)
{
    fourlink_value *more = memory_grow(b->header, b->n_header + 1, sizeof *more);
    char *words;

    if (!more)
        return 0;
    b->header = more;
    words = memory_get(strlen(column->name) + strlen(column->unit) + 2, 1);
    if (!words)
        return 0;
    more[b->n_header] = *column;
    more[b->n_header].name = strcpy(words, column->name);
    more[b->n_header++].unit = strcpy(words + strlen(words) + 1, column->unit);
    return 1;
}

/* 1 if the command line names columns. */
static int names_columns(const options *o)
{
    static const char key[] = "table.columns=";
    size_t i;

    for (i = 0; i < o->n_changes; i++)
        if (strncmp(o->changes[i].assignment, key, sizeof key - 1) == 0)
            return 1;
    return 0;
}

static int is_same(const fourlink_value *a, const fourlink_value *b)
{
    return strcmp(a->name, b->name) == 0 && strcmp(a->unit, b->unit) == 0;
}

/* Add columns, each name with each unit once: of values, or of rows, of which a deck has each once.  Decks
** mostly have them in one order.  0 if out of memory. */
static int add_list(batch *b, const fourlink_value *list, unsigned long count, int has_values)
{
    unsigned long before = b->n_header, next = 0, n, k, j;

    for (k = 0; k < count; k++) {
        n = has_values ? b->n_header : before;
        for (j = 0; j < n && !is_same(&b->header[(next + j) % n], &list[k]); j++)
            ;
        next += j < n ? j + 1 : 0;
        if (j == n && !add_column(b, &list[k]))
            return 0;
    }
    return 1;
}

/* 1 if each deck has lines of its answer to a question, as values. */
static int asks(const options *o)
{
    return o->solve || o->best;
}

/* Add the columns of the answer to a question; 0 if out of memory. */
static int add_answer(batch *b, input *in)
{
    fourlink_value of_solve[SOLVE_COLUMNS], *of_best = NULL;
    unsigned long n = 0;
    char name[SOLVE_NAME];
    int enough;

    b->has_values = 1;
    if (in->results && b->o->solve)
        n = solve_columns(in, of_solve, name);
    else if (in->results)
        of_best = best_columns(in, &n);
    enough = add_list(b, of_best ? of_best : of_solve, n, 1);
    free(of_best);
    return enough && !memory_has_failed();
}

/* Add the columns of a deck, or its values; 0 if memory has failed. */
static int add_columns(batch *b, input *in)
{
    const fourlink_value *list;
    unsigned long count = 0;
    int has_values = input_has_values(in);

    if (asks(b->o))
        return add_answer(b, in);
    b->has_values |= has_values;
    b->has_designs |= has_values && in->problem.n_designs > 0;
    b->has_sides |= in->problem.has_both_sides;
    if (in->results)
        fourlink_results_list(in->results, has_values ? FOURLINK_OUTPUTS : FOURLINK_COLUMNS, &list,
                              &count);
    return add_list(b, list, count, has_values) && !memory_has_failed();
}

/* ---------------------------------------------------------------------------------------- the sheet */

static void tell_no_value(const fourlink_check *check, const char *deck_name)
{
    command_tell("error", check->file, check->message_line, check->message, deck_name);
}

/* 1 if memory failed, so that a deck has no score. */
static int has_no_score(const options *o, const input *in)
{
    return o->content == SHEET_CHECK && !in->results && !in->refusal[0];
}

/* The exit status for a deck that was written. */
static int status_of(const sheet *s, const input *in)
{
    if (!in->results)
        return 0; /* already reported */
    if (memory_has_failed())
        return command_lacks_memory("cannot analyse", in->name);
    command_tell_more(s->checks[FOURLINK_NO_VALUE], "mistake");
    if (s->checks[FOURLINK_NO_VALUE] || in->has_slips)
        return EXIT_USAGE;
    return s->failed || s->checks[FOURLINK_DIFFERS] || s->checks[FOURLINK_NO_MISPRINT] ? EXIT_ROWS
                                                                                       : 0;
}

/* Write the values of each design of a [sweep]. */
static void write_designs(sheet *s, const input *in)
{
    fourlink_results *results;
    fourlink_mistake mistake;
    unsigned long i;
    int status;

    s->deck_name = in->name;
    for (i = 0; i < in->problem.n_designs && !memory_has_failed() && !system_caught(); i++) {
        results = NULL;
        status = results_design(in->results, i, 1, &results, &mistake, NULL);
        if (status == FOURLINK_OK || status == FOURLINK_BAD_DECK)
            content_write_design(s, results, in->results, i, NULL, mistake.message);
        fourlink_results_free(results);
    }
    s->design = 0;
}

/* Find what is asked; the [grading] of an exercise is for all.  Returns the exit status. */
static int begin_marks(batch *b)
{
    int status = marks_begin(&b->m, b->o, b->deck, &b->answers->names);

    if (b->m.exercise.deck.results)
        b->o = &b->m.exercise.of_answers;
    if (!status && b->o->feedback)
        status = files_make_folder(b->o->feedback);
    if (!status && b->o->feedback && b->o->check_file &&
        system_is_same(b->o->feedback, b->o->check_file))
        status =
            command_complain("cannot write", b->o->feedback, "the answers of the class are there");
    return status;
}

/* Write an input, or its score alone; returns the exit status. */
static int write_input(batch *b, input *in)
{
    const options *o = b->o;
    sheet *s = &b->s;
    int status, told = 0;
    sheet_mark mark;

    if (has_no_score(o, in)) /* already reported */
        return EXIT_FILES;
    s->failed = 0;
    if (in->deck || o->scores)
        marks_give(&b->m, in, &mark);
    if (memory_has_failed())
        return command_lacks_memory("cannot analyse", in->name);
    if (o->feedback && s->content == SHEET_SCORES)
        told = feedback_write(&b->m, in, &mark);
    s->mark = in->deck ? &mark : NULL;
    if (s->content == SHEET_SCORES)
        content_write_mark(s, &mark);
    else if (asks(o) && in->results)
        return o->solve ? solve_put(s, in) : best_put(s, in);
    else if (b->has_values && in->results && !input_has_values(in))
        content_write(s, NULL, in->name, "its columns are of rows, not values of the deck");
    else if (b->has_values && in->results && in->problem.n_designs)
        write_designs(s, in);
    else
        content_write(s, in->results, in->name, in->refusal);
    status = command_worse(status_of(s, in), told);
    s->mark = NULL;
    return in->results && (in->deck || o->scores) && mark.right < mark.of
               ? command_worse(status, EXIT_ROWS)
               : status;
}

static void begin_sheet(batch *b, FILE *out)
{
    const options *o = b->o;
    sheet *s = &b->s;

    memset(s, 0, sizeof *s);
    s->format = o->format;
    s->content = o->scores ? SHEET_SCORES : b->has_values ? SHEET_VALUES : o->content;
    s->wrong_first = s->format == &table_format;
    s->at = o->at;
    s->n_decks = (int)o->n_decks;
    s->no_value = tell_no_value;
    terminal_set_up(s, out, o->wide, o->colour);
    s->questions = b->m.questions;
    s->n_questions = s->content == SHEET_SCORES ? b->m.n : 0;
    s->has_roster = b->m.names->n > 0 && b->m.names->has_header;
    s->is_form = o->form;
    s->has_designs = b->has_designs;
    s->has_sides = b->has_sides;
    s->header = b->header;
    s->n_header = b->n_header;
    content_begin(s, out, 1);
}

static void batch_close(batch *b)
{
    unsigned long k;
    size_t i;

    for (k = 0; k < b->n_header; k++)
        free((void *)b->header[k].name);
    for (i = 0; i < b->n && b->texts; i++)
        free(b->texts[i].start);
    for (i = 0; i < KEPT && b->kept; i++)
        input_close(&b->kept[i]);
    free(b->kept);
    free(b->header);
    free(b->texts);
    marks_free(&b->m);
    input_close(&b->variant);
}

/* Open the deck of answers in a file without them, if it is an exercise, with [expect] and [grading]; then
** they are asked for the values of its [expect], as those of a class. */
static int open_exercise(const input *in, input *deck, options *of_deck)
{
    memset(deck, 0, sizeof *deck);
    if (in->o->content != SHEET_CHECK || in->deck || !in->results || !in->source.answers ||
        in->answers.path || in->is_design || !in->problem.is_graded ||
        strcmp(in->name, "<stdin>") == 0)
        return 0;
    command_be_silent(1);
    input_read_without(deck, in->o, of_deck, in->o->decks[0], in);
    command_be_silent(0);
    return deck->results && deck->problem.n_expected > 0;
}

int batch_write_one(FILE *out, input *in, const grade_answers *answers)
{
    input deck, of_exercise = *in;
    options of_deck;
    int status;
    batch b;

    if (open_exercise(in, &deck, &of_deck)) {
        of_exercise.deck = &deck;
        in = &of_exercise;
    }
    memset(&b, 0, sizeof b);
    b.o = in->o;
    b.answers = answers;
    b.deck = in->deck;
    status = begin_marks(&b);
    if (!status && !add_columns(&b, in))
        status = complain_of_memory();
    if (!status) {
        begin_sheet(&b, out);
        status = write_input(&b, in);
    }
    batch_close(&b);
    input_close(&deck);
    return status;
}

/* ------------------------------------------------------------------------------------------ many inputs */

/* The design of a student, from 1; 0: the list gives none. */
static unsigned long design_of(const batch *b, const student *x)
{
    const roster *names = &b->answers->names;

    return names->design_column < 0 ? (unsigned long)(x->entry - names->list) + 1
                                    : x->entry->design;
}

/* Find whether each student has a design of the deck's [sweep]; returns the exit status. */
static int find_designs(batch *b)
{
    char words[MESSAGE_SIZE];

    if (!b->deck || !b->deck->n_designs || b->o->design)
        return 0;
    b->n_designs = b->deck->n_designs;
    if (!b->answers->names.n) {
        flk_message(
            words, sizeof words,
            "the [sweep] has %ld designs: --names=FILE says whose is which, --design=N takes "
            "one for all",
            (long)b->n_designs);
        command_tell("error", b->deck->name, 0, words, NULL);
        return EXIT_USAGE;
    }
    if (b->answers->names.design_column < 0)
        command_tell("note", b->o->names, 0,
                     "no column has the heading design: the number of a student's row counts",
                     NULL);
    return 0;
}

/* Read the deck of a student's design in silence, and then the answers to it; returns the exit status. */
static int read_variant(batch *b, const student *x, input *in)
{
    unsigned long design = design_of(b, x);
    int status;

    input_close(&b->variant);
    memset(&b->variant, 0, sizeof b->variant);
    if (!design || design > b->n_designs) {
        flk_message(
            in->refusal, sizeof in->refusal,
            design ? "design %ld: the [sweep] has %ld designs"
                   : "no design in the list: --design=all with --names and --print-deck gives one",
            (long)design, (long)b->n_designs);
        in->student = x;
        in->deck = b->deck;
        command_tell("error", b->o->names, x->entry->line, in->refusal, NULL);
        return EXIT_USAGE;
    }
    b->of_variant = *b->o;
    b->of_variant.design = design;
    command_be_silent(1);
    status = input_read_without(&b->variant, &b->of_variant, &b->of_variant, b->o->decks[0], NULL);
    command_be_silent(0);
    if (b->variant.results)
        return input_read_answers(in, &b->variant, b->o, b->answers, x);
    memcpy(in->refusal, b->variant.refusal, sizeof in->refusal);
    in->student = x;
    in->deck = b->deck;
    return status;
}

/* Read input i; returns the exit status. */
static int read_input(batch *b, size_t i, input *in)
{
    const student *x = b->deck ? &b->answers->students.list[i] : NULL;
    int status;

    memset(in, 0, sizeof *in);
    if (x && x->file && b->n_designs)
        status = read_variant(b, x, in);
    else if (x)
        status = input_read_answers(in, b->deck, b->o, b->answers, x);
    else
        status = input_read(in, b->o->decks[i], b->o, b->answers, &b->texts[i]);
    return command_worse(status, in->has_defects ? EXIT_ROWS : 0);
}

/* Read all inputs, in silence, for what must be known of all; returns the exit status.  Those of which
** nothing is to be told stay open. */
static int scan(batch *b)
{
    int enough = 1, is_read, may_keep = !b->deck && !asks(b->o);
    input none, *in;
    size_t i;

    b->kept = memory_get(KEPT, sizeof *b->kept);
    for (i = 0; i < b->n && b->kept && enough && !system_caught(); i++) {
        in = i < KEPT ? &b->kept[i] : &none;
        command_be_silent(1);
        is_read = read_input(b, i, in) == 0;
        is_read &= !command_be_silent(0);
        enough = add_columns(b, in);
        if (may_keep && is_read && i < KEPT)
            continue;
        input_close(in);
        memset(in, 0, sizeof *in);
    }
    return b->kept && enough ? 0 : complain_of_memory();
}

/* Take input i, or read it; returns the exit status. */
static int take_input(batch *b, size_t i, input *in)
{
    if (!b->kept || i >= KEPT || !b->kept[i].results)
        return read_input(b, i, in);
    *in = b->kept[i];
    memset(&b->kept[i], 0, sizeof *in);
    return 0;
}

/* 1 if the sheet has a part for this input: a deck without results is named among comparisons only. */
static int is_shown(const batch *b, const input *in)
{
    return in->results || b->o->content == SHEET_CHECK || b->has_values;
}

/* Read and write each; returns the exit status.  Nothing is written if there is nothing to show. */
static int write_all(batch *b)
{
    int status = 0, written = 0, begun = 0, opened;
    output out;
    input in;
    size_t i;

    for (i = 0; i < b->n && !system_caught(); i++) {
        status = command_worse(status, take_input(b, i, &in));
        if (memory_has_failed()) { /* which is told */
            input_close(&in);
            break;
        }
        if (is_shown(b, &in) && !begun) {
            if (!b->n_header && !add_columns(b, &in)) {
                input_close(&in);
                return complain_of_memory();
            }
            opened = output_begin(&out, b->o->output);
            if (opened) {
                input_close(&in);
                return command_worse(status, opened);
            }
            begin_sheet(b, out.file);
            begun = 1;
        }
        if (begun)
            written = command_worse(written, write_input(b, &in));
        input_close(&in);
    }
    /* incomplete results are not kept */
    if (begun)
        written = command_worse(written, output_end(&out, b->o->output, written != EXIT_FILES));
    return command_worse(status, written);
}

int batch_run(const options *o, const grade_answers *answers, const input *deck)
{
    int status;
    batch b;

    memset(&b, 0, sizeof b);
    b.o = o;
    b.answers = answers;
    b.deck = deck;
    b.n = deck ? answers->students.n : o->n_decks;
    b.texts = memory_get(b.n + 1, sizeof *b.texts);
    status = b.texts ? begin_marks(&b) : complain_of_memory();
    if (!status)
        status = find_designs(&b);
    if (!status &&
        (asks(o) || (o->content == SHEET_ROWS && (o->format == &csv_format || names_columns(o)))))
        status = scan(&b);
    if (!status)
        status = write_all(&b);
    batch_close(&b);
    return status;
}
