/* SPDX-License-Identifier: GPL-3.0-or-later
**
** feedback.c - a text, or a page, for each student: what was asked, given, right or wrong, and why.
**
** Computed values are in it only with feedback = answers in [grading].  Nothing of another student is.
*/
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/message.h"
#include "base/quantity.h"
#include "system/memory.h"
#include "command.h"
#include "feedback.h"
#include "files.h"
#include "output.h"
#include "pictures/plot.h"
#include "report/page.h"
#include "view/results.h"

/* What is told of a question, and of an answer to it. */
typedef struct told {
    char question[400]; /* "theta4, angle of the rocker, at 60 deg" */
    char marks[80];     /* "1 of 2" */
    char answer[160];   /* as it was written, with its unit */
    int is_right;
    char remark[1000]; /* why it is wrong, and its line */
} told;

static void tell_question(told *t, const marks *m, const input *in, unsigned long i)
{
    const fourlink_check *q = marks_asked(m, i);
    char at[100] = "";
    fourlink_value v;

    if (q->has_place)
        flk_message(at, sizeof at, ", at %g %s", q->place, q->place_unit);
    else if (q->has_angle)
        flk_message(at, sizeof at, ", at %g %s", q->angle, m->unit_of_angle);
    memset(&v, 0, sizeof v);
    if (in->results)
        results_value(in->results, q->name, q->branch, q->angle, &v);
    flk_message(t->question, sizeof t->question, "%s%s%s%s%s", q->name,
                v.meaning && v.meaning[0] ? ", " : "", v.meaning ? v.meaning : "", at,
                q->branch == FOURLINK_CROSSED ? ", crossed" : "");
    flk_message(t->marks, sizeof t->marks, "%g of %g",
                gsl_isnan(m->questions[i].got) ? 0 : m->questions[i].got, m->questions[i].of);
}

/* Add words to a remark, behind the others. */
static void remark(told *t, const char *words)
{
    size_t n = strlen(t->remark);

    flk_text_join(t->remark + n, sizeof t->remark - n, n ? "; " : "", words, (char *)NULL);
}

static void tell_answer(told *t, const input *in, const fourlink_check *c)
{
    int is_bare = !flk_quantity_unit_text(flk_text_of(c->printed_text)).length;
    char words[MESSAGE_SIZE];

    t->remark[0] = '\0';
    t->is_right = c->verdict == FOURLINK_AGREES;
    flk_message(t->answer, sizeof t->answer, "%s%s%s", c->printed_text,
                is_bare && in->source.deck_units && !(t->is_right && c->hint[0]) ? " " : "",
                is_bare && in->source.deck_units && !(t->is_right && c->hint[0]) ? c->unit : "");
    if (c->verdict == FOURLINK_NO_VALUE)
        remark(t, c->message);
    else if (c->hint[0])
        remark(t, c->hint);
    if (in->problem.shows_answers && c->verdict == FOURLINK_DIFFERS && !c->words[0])
        remark(t, flk_message(words, sizeof words, "computed %.6g %s", c->computed, c->unit));
    if (c->line && !t->is_right)
        remark(t, flk_message(words, sizeof words, "line %ld", c->line));
}

/* Find the next answer to a question from value k of the input on, which is then behind it; 0 if there
** is none. */
static int next_answer(told *t, const marks *m, const input *in, unsigned long i, unsigned long *k)
{
    fourlink_check c;

    while (in->results && *k < in->problem.n_expected) {
        results_check(in->results, (*k)++, &c);
        if (marks_question(m, &c) != (long)i)
            continue;
        tell_answer(t, in, &c);
        return 1;
    }
    return 0;
}

/* The lengths and the speed of the deck: "ground 80 mm, crank 20 mm, ..., speed 300 rpm". */
static void tell_deck(const input *in, char out[400])
{
    const fourlink_value *list;
    fourlink_value x;
    unsigned long n = 0, i;
    char name[80];
    size_t used;

    out[0] = '\0';
    if (in->results)
        fourlink_results_list(in->results, FOURLINK_INPUTS, &list, &n);
    for (i = 0; i < n; i++) {
        flk_text_copy(flk_text_of(list[i].name), name, sizeof name);
        if (strcmp(name, "motion.speed") == 0)
            strcpy(name, "speed");
        else if (flk_text_ends_in(flk_text_of(name), ".length"))
            *strrchr(name, '.') = '\0';
        else
            continue;
        used = strlen(out);
        if (fourlink_results_input(in->results, list[i].name, &x) == FOURLINK_OK &&
            !gsl_isnan(x.value))
            flk_message(out + used, 400 - used, "%s%s %.6g %s", used ? ", " : "", name, x.value,
                        x.unit);
    }
}

/* Why there are no marks, or what is told of all answers; "": nothing. */
static const char *remark_on_all(const input *in)
{
    return in->results ? in->remarks : in->refusal;
}

/* ------------------------------------------------------------------------------------------- a text */

static void put_text(line *l, const marks *m, const input *in, const sheet_mark *mark)
{
    char deck[400];
    unsigned long i, k;
    told t;
    int n;

    if (in->results && in->problem.title[0])
        line_put(l, "%s\n", in->problem.title);
    line_put(l, "%s: %9g of %9g marks\n", mark->name, mark->right, mark->of);
    tell_deck(in, deck);
    line_put(l, deck[0] ? "%s\n" : "", deck);
    line_put(l, remark_on_all(in)[0] ? "%s\n" : "", remark_on_all(in));
    for (i = 0; i < m->n; i++) {
        tell_question(&t, m, in, i);
        line_put(l, "\n%s: %s\n", t.question, t.marks);
        for (n = 0, k = 0; next_answer(&t, m, in, i, &k); n++)
            line_put(l, t.remark[0] ? "  %s: %s; %s\n" : "  %s: %s\n", t.answer,
                     t.is_right ? "right" : "wrong", t.remark);
        line_put(l, n ? "" : "  no answer\n");
    }
}

/* ------------------------------------------------------------------------------------------- a page */

/* Put the figure of the exercise, from the deck without answers; nothing if it cannot be drawn. */
static void put_figure(FILE *out, const input *in)
{
    const input *deck = in->deck ? in->deck : in;
    fourlink_source source = deck->source;
    fourlink_results *opened = NULL;
    fourlink_mistake mistake;
    unsigned long n;

    source.name = files_name(source.name);
    source.answers = NULL;
    source.deck_units = 1;
    if (results_open(&source, 1, &opened, &mistake, &n) == FOURLINK_OK)
        plot_write_exercise(&source, opened, out, &mistake);
    fourlink_results_free(opened);
}

static void put_page(FILE *out, const marks *m, const input *in, const sheet_mark *mark)
{
    const char *title = in->results && in->problem.title[0] ? in->problem.title : "Answers";
    char deck[400];
    unsigned long i, k;
    told t;
    page p;
    int n;

    memset(&p, 0, sizeof p);
    p.out = out;
    page_print(
        &p,
        "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
        "<meta charset=\"utf-8\"/>\n<title>%s: %s</title>\n<style>body {font-family: "
        "sans-serif; max-width: 52em; margin: 1em auto} td, th {text-align: left; "
        "padding: 0.2em 0.8em 0.2em 0; vertical-align: top}</style>\n</head>\n<body>\n",
        title, mark->name);
    page_print(&p, "<h1>%s</h1>\n<p>%s: %.6g of %.6g marks</p>\n", title, mark->name, mark->right,
               mark->of);
    tell_deck(in, deck);
    page_print(&p, "<p>%s</p>\n<p>%s</p>\n", deck, remark_on_all(in));
    put_figure(out, in);
    page_print(&p,
               "<table>\n<tr><th>question</th><th>your answer</th><th></th><th>marks</th></tr>\n");
    for (i = 0; i < m->n; i++) {
        tell_question(&t, m, in, i);
        for (n = 0, k = 0; next_answer(&t, m, in, i, &k); n++)
            page_print(&p, "<tr><td>%s</td><td>%s</td><td>%s%s%s</td><td>%s</td></tr>\n",
                       n ? "" : t.question, t.answer, t.is_right ? "right" : "wrong",
                       t.remark[0] ? ": " : "", t.remark, n ? "" : t.marks);
        if (!n)
            page_print(&p, "<tr><td>%s</td><td>no answer</td><td></td><td>%s</td></tr>\n",
                       t.question, t.marks);
    }
    page_print(&p, "</table>\n</body>\n</html>\n");
}

/* How many students of the list have the name of this one. */
static int count_names(const marks *m, const roster_entry *e)
{
    size_t i;
    int n = 0;

    for (i = 0; i < m->names->n; i++)
        n += flk_text_equal(m->names->list[i].name, e->name.start);
    return n;
}

/* The name of a student's file: the student's, of several with one name also the line of the list; what
** cannot be in the name of a file becomes "_". */
static void name_file(const marks *m, const input *in, const sheet_mark *mark, char out[300])
{
    const roster_entry *e = in->student ? in->student->entry : NULL;
    char *c;

    flk_message(out, 300, e && count_names(m, e) > 1 ? "%s, line %ld" : "%s", mark->name,
                e ? e->line : 0);
    for (c = out; *c; c++)
        if (strchr("/\\:*?\"<>|", *c) || (c == out && *c == '.'))
            *c = '_';
}

int feedback_write(const marks *m, const input *in, const sheet_mark *mark)
{
    const char *folder = m->o->feedback;
    char name[300];
    char *path;
    line *l = memory_get(1, sizeof *l);
    output out;
    int status;

    name_file(m, in, mark, name);
    path = files_within(folder, flk_text_of(name), m->o->is_html ? ".html" : ".txt");
    status = path && l ? output_begin(&out, path) : command_lacks_memory("cannot write", folder);
    if (!status) {
        if (m->o->is_html) {
            put_page(out.file, m, in, mark);
        } else {
            line_start(l, out.file);
            put_text(l, m, in, mark);
            line_end(l);
        }
        status = output_end(&out, path, 1);
    }
    free(l);
    free(path);
    return status;
}
