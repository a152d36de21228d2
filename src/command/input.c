/* SPDX-License-Identifier: GPL-3.0-or-later
**
** input.c - a deck of the command line, opened for results.
*/
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "files.h"
#include "foreign.h"
#include "handout.h"
#include "import.h"
#include "input.h"
#include "rules.h"
#include "terminal.h"
#include "tables/content.h"
#include "view/results.h"
#include "view/view.h"

#define MOST_DEFECTS 10
#define MOST_ROWS_SHOWN 20000 /* in a report or a picture */

/* A file that a deck names.  It is read once, for all designs of a sweep. */
typedef struct named_file {
    struct named_file *next;
    char *name; /* as in the deck */
    char *contents;
    size_t length;
} named_file;

/* Read a file that the deck names. */
static char *read_named(input *in, const char *path, const char *name, size_t *length)
{
    char *contents = NULL;

    if (!in->o->allow_files && !files_is_beside(in->name, name)) {
        if (errno != ENOMEM)
            in->no_file =
                "a deck may name files of its own folder only; --allow-files permits others";
    } else {
        in->names_output |= files_is_output(in->o, path);
        contents = files_read_regular(path, length);
        if (!contents && errno == 0)
            in->no_file = "it is not a regular file";
    }
    if (!contents)
        memory_note_reason(errno);
    return contents;
}

/* Load a file that the deck names, for the deck's reader. */
static const char *load_file(void *host, const char *file_name, unsigned long *length)
{
    input *in = host;
    named_file *f;
    char *path;

    for (f = in->files; f; f = f->next)
        if (strcmp(f->name, file_name) == 0) {
            *length = (unsigned long)f->length;
            return f->contents;
        }
    f = memory_get(1, sizeof *f);
    path = files_beside(in->name, file_name);
    if (!path || !f || (f->name = files_beside("", file_name)) == NULL) {
        free(path);
        free(f);
        return NULL;
    }
    f->contents = read_named(in, path, file_name, &f->length);
    f->next = in->files;
    in->files = f;
    free(path);
    *length = (unsigned long)f->length;
    return f->contents;
}

/* Keep the first mistake, for the sheet. */
static void keep_mistake(input *in, const char *file, long at, const char *message)
{
    if (at)
        flk_message(in->refusal, sizeof in->refusal, "%s:%ld: %s", file, at, message);
    else
        flk_message(in->refusal, sizeof in->refusal, "%s: %s", file, message);
}

/* Tell the only mistake of a file, and keep it. */
static void tell_mistake(input *in, const char *file, const char *message)
{
    keep_mistake(in, file, 1, message);
    command_tell("error", file, 1, message, NULL);
}

/* The mistake in the list of --at, or null. */
static const char *mistake_in_angles(const input *in, char message[400])
{
    const char *list = in->o->at;
    at_item item;
    int status;
    view v;

    view_take(&v, in->results);
    while ((status = at_next(&v, &list, &item, message)) == 1)
        ;
    return status ? message : NULL;
}

/* 1 if a report or a picture is of the rows; a picture of the outputs of a [sweep] is not. */
static int shows_rows(const input *in)
{
    const options *o = in->o;
    plot_kind kind = o->drawing.kind;
    int shows_outputs = in->problem.n_designs && in->problem.has_outputs && kind == PLOT_COLUMNS;

    return o->report || (o->plot && !shows_outputs);
}

/* 1 if a text has the word, in letters of any case. */
static int has_word(const char *start, size_t length, const char *word)
{
    size_t i, k;

    for (i = 0; i < length; i++) {
        for (k = 0; word[k] && i + k < length && (start[i + k] | 0x20) == word[k]; k++)
            ;
        if (!word[k])
            return 1;
    }
    return 0;
}

/* 1 if neither the deck nor the options can have a [sweep]: seen before the deck is opened, which can
** take seconds. */
static int has_no_sweep(const input *in)
{
    size_t i;

    for (i = 0; i < in->o->n_changes; i++)
        if (has_word(in->o->changes[i].assignment, strlen(in->o->changes[i].assignment), "sweep"))
            return 0;
    if (memchr(in->source.text, '\0', in->source.length)) /* in UTF-16 */
        return 0;
    return !in->o->synthesis && !has_word(in->source.text, in->source.length, "sweep");
}

/* Whether the linkage of the deck was found by synthesis, and by a search from many starts. */
static void find_task(input *in, clock_t begun)
{
    unsigned long chosen, n;
    fourlink_solution first;

    if (fourlink_deck_solutions(fourlink_results_deck(in->results), 1, &first, &chosen, &n) !=
        FOURLINK_OK)
        return;
    in->has_task = 1;
    in->has_starts = n > 0 && first.starts > 0;
    terminal_tell_search(in->has_starts ? first.starts : 0, begun);
}

int input_has_values(const input *in)
{
    const fourlink_problem *p = &in->problem;

    return in->results && in->o->content == SHEET_ROWS &&
           (p->n_designs ? p->has_outputs && in->o->n_decks > 1 : p->has_values);
}

/* 1 if a text has more than blanks. */
static int has_words(const char *start, size_t length)
{
    text t;

    t.start = start;
    t.length = length;
    return flk_text_trim(flk_text_without_mark(t)).length > 0;
}

/* Refuse an option that this deck cannot serve; 1 if there is none. */
static int serves_options(input *in)
{
    const options *o = in->o;
    const fourlink_problem *p = &in->problem;
    const char *why = NULL, *name = in->name;
    char message[400];
    rules_deck deck;

    if (o->content == SHEET_CHECK && !p->n_expected && in->has_slips) { /* which are told */
        keep_mistake(in, in->source.answers_name, 0, in->remarks);
        return 0;
    }
    if (o->content == SHEET_CHECK && !p->n_expected) {
        why = in->source.answers && !has_words(in->source.answers, in->source.answers_length)
                  ? "the file is empty"
              : in->deck ? "nothing to check: no values in [expect]"
                         : "nothing to check: no [expect] or [misprint] section";
        name = in->source.answers_name ? in->source.answers_name : in->name;
    } else if (o->design && p->n_designs) {
        why = flk_message(message, sizeof message, "--design=%ld: the [sweep] has %ld designs",
                          (long)o->design, (long)p->n_designs);
    } else {
        deck.problem = *p;
        deck.has_sweep = in->has_sweep;
        deck.has_task = in->has_task;
        deck.has_starts = in->has_starts;
        deck.has_values = input_has_values(in);
        why = rules_broken(o, &deck, message);
    }
    if (!why && p->n_rows > MOST_ROWS_SHOWN && shows_rows(in)) {
        why = flk_message(message, sizeof message,
                          "%ld rows; a %s shows at most 20,000: give a coarser %s with "
                          "--set=motion.%s",
                          (long)p->n_rows, o->report ? "report" : "picture", p->over.step_key,
                          p->over.step_key);
    } else if (!why && (why = mistake_in_angles(in, message)) != NULL) {
        command_tell("error", "--at", 0, why, NULL);
        return 0;
    }
    if (why)
        tell_mistake(in, name, why);
    return !why;
}

/* Print the mistakes of a deck, or the notes on it. */
static void tell_all(const input *in, const fourlink_mistake *list, unsigned long n,
                     const char *what, const char *noun)
{
    const char *name = in->o->n_decks > 1 ? in->name : in->o->variant;
    unsigned long i;

    for (i = 0; i < n && i < MOST_MISTAKES; i++)
        if (in->deck && strcmp(list[i].file, in->source.answers_name) != 0)
            continue;
        else if (list[i].line == 0 && strncmp(list[i].file, "--", 2) == 0)
            command_tell_once(what, list[i].file, list[i].message, name);
        else /* what is imported has lines of its own */
            command_tell(what, list[i].file, in->o->import ? 0 : list[i].line, list[i].message,
                         name);
    command_tell_more(n, noun);
}

/* Make a deck unusable. */
static void refuse(input *in)
{
    fourlink_results_free(in->results);
    in->results = NULL;
}

/* 1 for a status that says why the task of a [synthesis] has no linkage. */
static int is_no_linkage(int status)
{
    return status >= FOURLINK_DEPENDENT && status <= FOURLINK_NONE_FOUND;
}

/* Keep what is told of the answers, with the line where values are lost. */
static void keep_remarks(input *in, const fourlink_mistake *list, unsigned long n, int has_line)
{
    char one[MESSAGE_SIZE + 40];
    unsigned long i;

    for (i = 0; i < n && i < MOST_MISTAKES; i++) {
        size_t used = strlen(in->remarks);

        if (!in->source.answers_name || strcmp(list[i].file, in->source.answers_name) != 0)
            continue;
        if (has_line)
            flk_message(one, sizeof one, "line %ld: %s", list[i].line, list[i].message);
        flk_message(in->remarks + used, sizeof in->remarks - used, "%s%s", used ? "; " : "",
                    has_line ? one : list[i].message);
    }
}

static int open_results(input *in)
{
    fourlink_mistake *list = memory_get(MOST_MISTAKES, sizeof *list);
    unsigned long n = 0;
    int status = FOURLINK_NO_MEMORY;

    if (list)
        status = results_open_like(&in->source, in->like, MOST_MISTAKES, &in->results, list, &n);
    if (memory_has_failed()) /* a file that the deck names could not be loaded */
        status = FOURLINK_NO_MEMORY;
    if (in->names_output) {
        status = command_complain("cannot write", "a file that the deck names", "it is also read");
        refuse(in);
    } else if (status == FOURLINK_BAD_DECK || is_no_linkage(status)) {
        keep_mistake(in, list[0].file, list[0].line, list[0].message);
        tell_all(in, list, n, "error", "mistake");
        in->has_mistakes = 1;
        if (in->no_file)
            command_tell("note", in->name, 0, in->no_file, NULL);
        status = status == FOURLINK_BAD_DECK ? EXIT_USAGE : EXIT_ROWS;
    } else if (status != FOURLINK_OK) {
        status = command_lacks_memory("cannot read", in->name);
        refuse(in);
    } else {
        fourlink_results_notes(in->results, MOST_MISTAKES, list, &n);
        if (!in->o->is_again &&
            (in->deck || !in->is_design)) /* told of the deck with the [sweep] or the task */
            tell_all(in, list, n, "note", "note");
        keep_remarks(in, list, n, 0);
        fourlink_results_slips(in->results, MOST_MISTAKES, list, &n);
        tell_all(in, list, n, "error", "mistake");
        keep_remarks(in, list, n, 1);
        in->has_slips = n > 0;
    }
    free(list);
    return status;
}

/* A copy of a text; null with errno set if out of memory. */
static char *copy_text(const input_text *of, size_t *length)
{
    char *copy = memory_get(of->length + 1, 1);

    *length = of->length;
    return copy ? memcpy(copy, of->start, of->length) : NULL;
}

/* Read a text, which may be read again; null with errno set if that fails. */
static char *read_again(const char *path, input_text *once, size_t *length)
{
    input_text copy;
    char *contents;

    if (once && once->start)
        return copy_text(once, length);
    contents = files_read(path, length);
    if (!contents || !once || system_kind_of(path) == SYSTEM_FILE)
        return contents;
    copy.start = contents;
    copy.length = *length;
    once->start = copy_text(&copy, &once->length);
    if (once->start)
        return contents;
    free(contents);
    errno = ENOMEM;
    return NULL;
}

/* Put the deck of a link in its place, or refuse the file of another tool; returns the exit status. */
static int take_deck(input *in)
{
    char message[400], *deck;
    size_t length;
    text t;

    t.start = in->source.text;
    t.length = in->source.length;
    if (!in->o->import) {
        if (!foreign_refusal(t, in->name, message))
            return 0;
        tell_mistake(in, in->name, message);
        return EXIT_USAGE;
    }
    deck = import_deck(t, in->name, &length);
    if (!deck)
        return memory_has_failed() ? command_lacks_memory("cannot read", in->name) : EXIT_USAGE;
    free(in->text);
    in->source.text = in->text = deck;
    in->source.length = (unsigned long)length;
    return 0;
}

/* Read the text of a deck; returns the exit status. */
static int read_text(input *in, const char *path, input_text *once)
{
    size_t length = 0;
    int reason;

    in->name = strcmp(path, "-") == 0 ? "<stdin>" : path;
    if (in->name != path && !(once && once->start) && system_is_terminal(stdin))
        command_say("fourlink: reading a deck from the keyboard; see fourlink --help",
                    (char *)NULL);
    in->text = read_again(path, once, &length);
    in->source.name = in->name;
    in->source.text = in->text;
    in->source.length = (unsigned long)length;
    if (in->text)
        return take_deck(in);
    if (errno == EFBIG) {
        tell_mistake(in, in->name, "larger than 64 MB: not a deck");
        return EXIT_USAGE;
    }
    reason = errno;
    if (files_is_missing(reason))
        keep_mistake(in, in->name, 0, strerror(reason));
    return command_complain("cannot read", in->name, strerror(reason));
}

/* Set the answers of a deck: those of all decks or, from a folder, those of a student, for null of the
** one with its name.  Returns the exit status. */
static int take_answers(input *in, const char *path, const grade_answers *answers, const student *x)
{
    int status = 0;

    in->source.answers_name = in->o->check_file;
    if (answers->folder) {
        in->student = x;
        status = x ? grade_read(&in->answers, answers, in->o, x, in->refusal)
                   : grade_read_for(&in->answers, answers, in->o, path, &in->student, in->refusal);
        in->source.answers_name = in->answers.path;
        answers = &in->answers;
    }
    in->source.answers = answers->text;
    in->source.answers_length = (unsigned long)answers->length;
    return status;
}

double input_in_line_unit(fourlink_results *results, const char *name, double to_si, double value)
{
    fourlink_value v;

    if (fourlink_results_input(results, name, &v) != FOURLINK_OK || v.to_si == to_si)
        return value;
    return value * to_si / v.to_si;
}

char *input_deck_text(const fourlink_results *results, unsigned long *length)
{
    const fourlink_deck *deck = fourlink_results_deck(results);
    unsigned long size = 0;
    char *contents;

    fourlink_deck_write(deck, NULL, 0, &size);
    contents = memory_get(size + 1, 1);
    if (contents)
        fourlink_deck_write(deck, contents, size + 1, length);
    return contents;
}

int input_write_deck(const input *in, FILE *out)
{
    unsigned long length = 0;
    char *contents = input_deck_text(in->results, &length);

    if (contents)
        fwrite(contents, 1, length, out);
    free(contents);
    return contents != NULL;
}

/* 1 if the deck of the linkage found is reported, or checked by its own [expect] sections. */
static int takes_found(const input *in)
{
    const options *o = in->o;

    return o->synthesis && !in->problem.n_designs &&
           (o->report || (o->content == SHEET_CHECK && !o->check_file));
}

/* In place of a deck, that of the design that is asked for, or of the linkage found; returns the exit
** status. */
static int take_design(input *in)
{
    unsigned long length = 0;
    char *contents = input_deck_text(in->results, &length);

    refuse(in);
    if (!contents)
        return command_lacks_memory("cannot read", in->name);
    if (in->o->is_exercise)
        length = (unsigned long)handout_strip(contents, length);
    free(in->text);
    in->source.text = in->text = contents;
    in->source.length = length;
    in->is_design = 1;
    in->source.changes = NULL;
    in->source.n_changes = 0;
    in->source.synthesis = 0;
    in->source.design = 0;
    return open_results(in);
}

/* Tell the defects of the linkage that was found. */
static void tell_defects(input *in)
{
    fourlink_mistake list[MOST_DEFECTS];
    unsigned long n = 0, i;

    fourlink_deck_defects(fourlink_results_deck(in->results), MOST_DEFECTS, list, &n);
    for (i = 0; i < n && i < MOST_DEFECTS; i++)
        command_tell("defect", list[i].file, list[i].line, list[i].message, NULL);
    in->has_defects = n > 0;
}

/* Open what has been read; returns the exit status. */
static int open_input(input *in)
{
    const options *o = in->o;
    char message[400];
    clock_t begun;
    int status;

    if (!in->has_sweep && rules_without_sweep(o, message) && has_no_sweep(in)) {
        tell_mistake(in, in->name, message);
        return EXIT_USAGE;
    }
    in->source.load = load_file;
    in->source.host = in;
    in->source.units = o->units;
    in->source.deck_units = o->format == &table_format;
    if (!in->is_design) {
        in->source.changes = o->changes;
        in->source.n_changes = (unsigned long)o->n_changes;
        in->source.design = o->design ? o->design - 1 : FOURLINK_ANY_DESIGN;
        in->source.effort = o->effort;
        in->source.synthesis = !o->synthesis ? 0 : o->solution ? o->solution : 1;
    }
    begun = clock();
    status = open_results(in);
    if (status || !in->results)
        return status;
    fourlink_deck_problem(fourlink_results_deck(in->results), &in->problem);
    in->has_sweep |= in->problem.n_designs > 0;
    if (in->problem.n_designs)
        in->n_designs = in->problem.n_designs;
    if (o->synthesis)
        find_task(in, begun);
    if (o->synthesis && (o->design || !in->problem.n_designs)) {
        tell_defects(in);
        if (o->report && !view_find_solution(fourlink_results_deck(in->results), &in->found)) {
            refuse(in);
            return command_lacks_memory("cannot read", in->name);
        }
    }
    if ((o->design && in->problem.n_designs >= o->design) || takes_found(in)) {
        status = take_design(in);
        if (status || !in->results)
            return status;
    }
    fourlink_deck_problem(fourlink_results_deck(in->results), &in->problem);
    in->source.design = in->problem.design;
    if (serves_options(in))
        return 0;
    refuse(in);
    return EXIT_USAGE;
}

int input_read(input *in, const char *path, const options *o, const grade_answers *answers,
               input_text *once)
{
    int status;

    in->o = o;
    status = read_text(in, path, once);
    if (!status)
        status = take_answers(in, path, answers, NULL);
    return status ? status : open_input(in);
}

int input_read_answers(input *in, const input *deck, const options *o, const grade_answers *answers,
                       const student *x)
{
    int status;

    in->o = o;
    in->deck = deck;
    in->like = deck->results;
    in->name = deck->name;
    in->source = deck->source;
    in->is_design = deck->is_design;
    in->has_sweep = deck->has_sweep;
    in->has_task = deck->has_task;
    in->has_starts = deck->has_starts;
    status = take_answers(in, in->name, answers, x);
    return status ? status : open_input(in);
}

int input_read_without(input *in, const options *o, options *own, const char *path,
                       const input *with)
{
    grade_answers none;

    memset(in, 0, sizeof *in);
    memset(&none, 0, sizeof none);
    *own = *o;
    own->content = SHEET_SUMMARY;
    own->check_file = NULL;
    own->design = o->design ? o->design : 1;
    in->like = with ? with->results : NULL;
    return input_read(in, path, own, &none, NULL);
}

void input_close(input *in)
{
    while (in->files) {
        named_file *f = in->files;

        in->files = f->next;
        free(f->name);
        free(f->contents);
        free(f);
    }
    refuse(in);
    free(in->text);
    free(in->found);
    grade_close(&in->answers);
}
