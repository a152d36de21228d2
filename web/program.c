/* SPDX-License-Identifier: GPL-3.0-or-later
**
** program.c - what the page calls, from worker.js.
**
** A call takes its text from the room that web_room gave, and leaves its answer, JSON or a file, where
** web_answer says.  One deck is open at a time.
*/
#define _POSIX_C_SOURCE 200809L /* open_memstream */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/quantity.h"
#include "base/text.h"
#include "command/command.h"
#include "drawing/svg.h"
#include "pictures/plot.h"
#include "report/interactive.h"
#include "system/memory.h"
#include "tables/json_text.h"
#include "view/results.h"
#include "system.h"

#define CALLED(name) __attribute__((export_name(#name)))
#define MOST_MISTAKES 100
#define CURVE_DIGITS 12
#define HELD_STRIDE 4 /* from step to step of a drawing in which something is dragged */
#define SOLUTIONS 10  /* of a search, that are kept */
#define ALIKE 0.05    /* a linkage that is found again, in parts of its size */
#define WIDTH 520     /* of the mechanism and of a curve alone, which stand beside each other */

int web_main(int argc, char **argv); /* of src/command/main.c */

static char *input;  /* the text of the next call */
static char *deck;   /* the name and the text of the deck */
static char *answer; /* of the last call */
static size_t answer_length;
static FILE *out; /* into `answer` */
static line l;    /* into `out` */
static fourlink_source source;
static view v;                   /* of the deck; its results are null if it has mistakes */
static fourlink_solution *shown; /* of its [synthesis], before something was pulled; or null */
static double *numbers;          /* of web_rows */

/* Room for a text of this length; null if there is none. */
CALLED(web_room) char *web_room(unsigned long length)
{
    free(input);
    return input = memory_get(length + 1, 1);
}

CALLED(web_answer) const char *web_answer(void)
{
    return answer;
}

CALLED(web_answer_length) unsigned long web_answer_length(void)
{
    return (unsigned long)answer_length;
}

/* Memory for a call, which does not depend on whether there was enough for those before. */
static void *begin(size_t n, size_t size)
{
    memory_forget_failure();
    return memory_get(n, size);
}

static int begin_answer(void)
{
    free(answer);
    answer = NULL;
    answer_length = 0;
    out = open_memstream(&answer, &answer_length);
    if (out)
        line_start(&l, out);
    return out != NULL;
}

/* 1; 0 if memory has run out. */
static int end_answer(void)
{
    int failed;

    line_end(&l);
    failed = ferror(out);
    failed |= fclose(out) != 0;
    return !failed;
}

static void put_string(const char *name, const char *words)
{
    line_put(&l, "\"%s\":", name);
    json_text_put(&l, words, "");
}

static void put_number(const char *name, unsigned long value)
{
    line_put(&l, ",\"%s\":%lu", name, value);
}

/* ----------------------------------------------------------------------------------------- messages */

/* What is not printable becomes a question mark, as in the messages of the command. */
static void make_printable(char *words)
{
    text rest = flk_text_of(words);

    while (rest.length) {
        size_t n = flk_text_printable(rest);

        if (!n)
            words[rest.start - words] = '?';
        rest = flk_text_from(rest, n ? n : 1);
    }
}

/* Put a message as the command prints it, with its line in the deck; 0: it is elsewhere. */
static void put_message(int *n, const char *kind, const char *file, long at, const char *message)
{
    char words[2000], number[FORMAT_SIZE];

    flk_text_join(words, sizeof words, at ? "" : "fourlink: ", file, at ? ":" : "",
                  at ? format_general((double)at, 17, number) : "", ": ", kind, ": ", message,
                  (char *)NULL);
    make_printable(words);
    line_put(&l, "%s\n{", (*n)++ ? "," : "");
    put_string("text", words);
    line_put(&l, ",");
    put_string("kind", kind);
    put_number("line", strcmp(file, source.name) == 0 ? (unsigned long)at : 0);
    line_put(&l, "}");
}

static void put_list(int *n, const fourlink_mistake *list, unsigned long count, const char *kind)
{
    unsigned long i;

    for (i = 0; i < count && i < MOST_MISTAKES; i++)
        put_message(n, kind, list[i].file, list[i].line, list[i].message);
}

/* Put the mistakes of a deck or, if there are results, its notes and the defects of a linkage found. */
static void put_messages(fourlink_mistake *list, unsigned long count,
                         const fourlink_results *results)
{
    unsigned long n_defects;
    int n = 0;

    line_put(&l, "\"messages\":[");
    put_list(&n, list, count, results ? "note" : "error");
    if (results && fourlink_deck_defects(fourlink_results_deck(results), MOST_MISTAKES, list,
                                         &n_defects) == FOURLINK_OK)
        put_list(&n, list, n_defects, "defect");
    line_put(&l, "]");
    put_number("more", count > MOST_MISTAKES ? count - MOST_MISTAKES : 0);
}

/* ----------------------------------------------------------------------------------------- the deck */

static void put_value_name(const fourlink_value *v)
{
    line_put(&l, "{");
    put_string("name", v->name);
    line_put(&l, ",\"label\":");
    interactive_put_label(&l, v->name);
    line_put(&l, ",");
    put_string("unit", v->unit);
    line_put(&l, ",");
    put_string("meaning", v->meaning);
    line_put(&l, "}");
}

static void put_names(const char *name, int which)
{
    const fourlink_value *list;
    unsigned long n, i;

    fourlink_results_list(v.results, which, &list, &n);
    line_put(&l, ",\n\"%s\":[", name);
    for (i = 0; i < n; i++) {
        line_put(&l, i ? ",\n" : "\n");
        put_value_name(&list[i]);
    }
    line_put(&l, "]");
}

/* The crank angle, or the time, at which the drawing begins: as drawn, or the first row. */
static double find_start(void)
{
    fourlink_instant now;

    if (v.problem.has_drawn && !v.problem.one_instant &&
        fourlink_results_at(v.results, v.branches[0], v.problem.drawn, NULL, &now, NULL) ==
            FOURLINK_OK)
        return now.row.place;
    return v.problem.motion.from;
}

static void put_deck(void)
{
    int i;

    line_put(&l, ",\n");
    put_string("title", v.problem.title);
    line_put(&l, ",");
    put_string("kind", v.kind.words);
    put_number("rows", v.problem.n_rows);
    put_number("instant", (unsigned long)v.problem.one_instant);
    put_number("designs", v.problem.n_designs);
    put_number("design", v.problem.design + 1);
    put_number("solution", source.synthesis);
    put_number("expected", v.problem.n_expected);
    line_put(&l, ",\"from\":");
    json_text_number(&l, v.problem.motion.from, 17);
    line_put(&l, ",\"start\":");
    json_text_number(&l, find_start(), 17);
    line_put(&l, ",\"branches\":[");
    for (i = 0; i < v.n_branches; i++)
        line_put(&l, "%s\"%s\"", i ? "," : "", fourlink_branch_text((int)v.branches[i]));
    line_put(&l, "]");
    put_names("columns", FOURLINK_COLUMNS);
    put_names("all", FOURLINK_ALL_COLUMNS);
}

/* What a deck is opened after, by the numbers of worker.js: of its [synthesis] the linkage that was shown is followed
** while something is held, and found among all when it is let go. */
enum { AS_WRITTEN, WHILE_HELD, WHEN_LET_GO };

/* Remember the linkage that is shown. */
static void take_shown(int after)
{
    fourlink_solution *found = NULL;

    if (after == AS_WRITTEN || !v.results || !view_find_solution(v.deck, &found) || !found)
        return;
    free(shown);
    shown = found;
}

/* How much lengths and place of a linkage differ from those that were shown, in parts of its size. */
static double difference(const fourlink_solution *x)
{
    double most = gsl_hypot(x->origin.x - shown->origin.x, x->origin.y - shown->origin.y), size = 0;
    int i;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        size = GSL_MAX_DBL(size, shown->design.link[i].length);
        most = GSL_MAX_DBL(most, fabs(x->design.link[i].length - shown->design.link[i].length));
    }
    return x->branch == shown->branch ? most / size : GSL_POSINF;
}

/* The number, from 1, of the linkage that was shown among those that are found now; 1 if it is none of them. */
static unsigned long number_of_shown(const fourlink_deck *found)
{
    fourlink_solution *list = memory_get(SOLUTIONS, sizeof *list);
    unsigned long chosen, n, i, best = 0;

    if (!list || fourlink_deck_solutions(found, SOLUTIONS, list, &chosen, &n) != FOURLINK_OK)
        n = 0;
    n = n < SOLUTIONS ? n : SOLUTIONS;
    for (i = 1; i < n; i++)
        if (difference(&list[i]) < difference(&list[best]))
            best = i;
    if (n && !(difference(&list[best]) <= ALIKE))
        best = 0;
    free(list);
    return best + 1;
}

/* Open `source`; when something is let go, with the linkage that was followed. */
static int open_source(int after, fourlink_results **results, fourlink_mistake *list,
                       unsigned long *n)
{
    int status;

    source.near = after == WHILE_HELD ? shown : NULL;
    status = results_open(&source, MOST_MISTAKES, results, list, n);
    source.near = NULL;
    if (status != FOURLINK_OK || after != WHEN_LET_GO || !shown)
        return status;
    source.synthesis = number_of_shown(fourlink_results_deck(*results));
    if (source.synthesis == 1)
        return status;
    fourlink_results_free(*results);
    return results_open(&source, MOST_MISTAKES, results, list, n);
}

/* Open the deck whose name, of this length and with its final zero, and whose text are in the room, with a
** solution of its [synthesis], from 1.  Answers with its messages and, if it has no mistakes, what there is to
** see.  Returns a status. */
CALLED(web_open)
int web_open(unsigned long name_length, unsigned long length, unsigned long solution, int after)
{
    fourlink_mistake *list = begin(MOST_MISTAKES, sizeof *list);
    unsigned long n = 0;
    fourlink_results *results = NULL;
    int status = FOURLINK_NO_MEMORY;

    take_shown(after);
    fourlink_results_free(v.results);
    v.results = NULL;
    free(deck);
    deck = input;
    input = NULL;
    memset(&source, 0, sizeof source);
    source.name = deck;
    source.text = deck + name_length;
    source.length = length;
    source.design = FOURLINK_ANY_DESIGN;
    source.synthesis = solution;
    source.deck_units = 1;
    if (list)
        status = open_source(after, &results, list, &n);
    if (status == FOURLINK_OK) {
        view_take(&v, results);
        source.design = v.problem.design;
        fourlink_results_notes(results, MOST_MISTAKES, list, &n);
    }
    if (status != FOURLINK_NO_MEMORY && begin_answer()) {
        line_put(&l, "{");
        put_messages(list, n, results);
        if (results)
            put_deck();
        line_put(&l, "}\n");
        if (!end_answer())
            status = FOURLINK_NO_MEMORY;
    }
    free(list);
    return status;
}

/* ---------------------------------------------------------------------------------- drawing, curves */

/* What of the drawings is wanted, by the numbers of worker.js. */
enum {
    SCENE_WHOLE,
    SCENE_HELD, /* something is dragged: the mechanism at fewer steps, on the sheet that it had */
    SCENE_BRIEF /* the mechanism; the diagrams are not seen */
};

/* Answer with the moving drawings, of all branches or of one, at `at` too, a crank angle or NaN. */
CALLED(web_scene) int web_scene(int branch, double at, int wanted)
{
    static moving_sheet sheets[2];
    fourlink_branch one = (fourlink_branch)branch;
    rows *t = begin(1, sizeof *t);
    interactive_form form;
    int done = 0, k;

    for (k = 0; k < 2 && wanted != SCENE_HELD; k++) {
        sheets[k].width = WIDTH;
        sheets[k].height = 0;
        sheets[k].range = place_nothing;
    }
    for (k = 0; branch && k < v.n_branches && v.branches[k] != one; k++)
        ;
    k = k < v.n_branches ? k : 0; /* a linkage found anew may have another branch */
    one = v.branches[k];
    form.start = at;
    form.is_brief = wanted != SCENE_WHOLE;
    form.sheets = &sheets[k];
    if (t && rows_open(t, &source, v.results, at) && begin_answer()) {
        if (wanted == SCENE_HELD)
            rows_thin(t, HELD_STRIDE, at);
        done =
            interactive_write(out, t, branch ? &one : v.branches, branch ? 1 : v.n_branches, &form);
        done &= end_answer();
    }
    if (t)
        rows_close(t);
    free(t);
    return done;
}

/* Put the first column at the steps of a branch. */
static void put_over(const rows *t)
{
    unsigned long i;

    line_put(&l, "[");
    for (i = 0; i < t->n; i++) {
        line_put(&l, i ? "," : "");
        json_text_number(&l, t->table[i * t->v.n_columns], CURVE_DIGITS);
    }
    line_put(&l, "]");
}

/* Draw the columns over the first of them. */
static int put_figure(const fourlink_source *chosen, const rows *t)
{
    plot *drawn_plot = memory_get(1, sizeof *drawn_plot);
    char over[40];
    fourlink_mistake mistake;
    plot_request request;
    int made = -1;

    memset(&request, 0, sizeof request);
    request.kind = PLOT_COLUMNS;
    flk_text_join(over, sizeof over, t->v.columns[0].name, (char *)NULL);
    if (strcmp(over, t->v.problem.over.name) != 0)
        request.x = over;
    request.is_figure = 1;
    request.lone_width = WIDTH;
    request.opened = t->v.results;
    if (drawn_plot) {
        made = plot_make(drawn_plot, chosen, &request, &mistake);
        line_end(&l);
        if (made > 0)
            plot_write_figure(drawn_plot, out);
        plot_free(drawn_plot);
    }
    free(drawn_plot);
    return made >= 0;
}

/* Answer with columns as curves; the room has "table.columns=X,Y,...", Y are drawn over X.  In the first
** line, X at the steps of the drawing, by branch. */
CALLED(web_curve) int web_curve(void)
{
    fourlink_source chosen = source;
    rows *t = begin(1, sizeof *t);
    fourlink_change change;
    int i, done = 0;

    change.origin = "columns";
    change.assignment = input;
    chosen.changes = &change;
    chosen.n_changes = 1;
    if (t && rows_open(t, &chosen, NULL, v.problem.one_instant ? v.problem.motion.from : GSL_NAN) &&
        begin_answer()) {
        line_put(&l, "[");
        for (i = 0; i < v.n_branches; i++) {
            line_put(&l, i ? "," : "");
            rows_compute(t, v.branches[i]);
            put_over(t);
        }
        line_put(&l, "]\n");
        done = put_figure(&chosen, t);
        done &= end_answer();
    }
    if (t)
        rows_close(t);
    free(t);
    return done;
}

/* -------------------------------------------------------------------------- numbers, the command */

/* Rows of the deck's columns: for each its values and then its status.  Null without memory. */
CALLED(web_rows) const double *web_rows(int branch, unsigned long first, unsigned long n)
{
    const fourlink_value *list;
    unsigned long width, i;

    fourlink_results_list(v.results, FOURLINK_COLUMNS, &list, &width);
    free(numbers);
    numbers = memory_get((n + 1) * (width + 1), sizeof *numbers);
    for (i = 0; numbers && i < n; i++) {
        double *row = numbers + i * (width + 1);

        row[width] =
            fourlink_results_row(v.results, (fourlink_branch)branch, first + i, row, NULL, NULL);
    }
    return numbers;
}

CALLED(web_status_text) const char *web_status_text(int status)
{
    return fourlink_status_text(status);
}

/* Run the command: the room has `n` arguments, each with its final zero, and then the text of the deck, whose
** name is the last of them.  What it prints goes to the streams of worker.js.  Returns its exit status; 3
** without memory. */
CALLED(web_command) int web_command(int n, unsigned long length)
{
    char **arguments = begin((size_t)n + 1, sizeof *arguments), *at = input;
    int i, status;

    for (i = 0; arguments && i < n; i++) {
        arguments[i] = at;
        at += strlen(at) + 1;
    }
    if (!arguments)
        return EXIT_FILES;
    web_system_put(arguments[n - 1], at, length);
    status = web_main(n, arguments);
    fflush(NULL);
    free(arguments);
    return status;
}

/* A file that the command has written: its name, or null if there are no more of them, and its contents. */
CALLED(web_written_name) const char *web_written_name(int k)
{
    const web_file *file = web_system_written(k);

    return file ? file->name : NULL;
}

CALLED(web_written) const char *web_written(int k)
{
    return web_system_written(k)->text;
}

CALLED(web_written_length) unsigned long web_written_length(int k)
{
    return (unsigned long)web_system_written(k)->length;
}

/* Answer with the style sheet of all drawings; returns 0 without memory. */
CALLED(web_style) int web_style(void)
{
    if (!begin_answer())
        return 0;
    svg_put_style(out);
    return end_answer();
}

/* Answer with the name in the room, typeset; returns 0 without memory. */
CALLED(web_label) int web_label(void)
{
    if (!begin_answer())
        return 0;
    interactive_put_label(&l, input);
    return end_answer();
}

/* The value in SI units of the quantity in the room, such as "40 mm", read as the deck reads it; NaN if
** it is none. */
CALLED(web_quantity) double web_quantity(int is_angle)
{
    quantity q = is_angle ? QUANTITY_ANGLE : QUANTITY_LENGTH;
    char message[MESSAGE_SIZE];
    text t = flk_text_of(input);
    double value;

    return v.results && view_read(&v, q, t, t, &value, message) ? view_si(&v, q, value) : GSL_NAN;
}
