/* SPDX-License-Identifier: GPL-3.0-or-later
**
** json.c - the format json, RFC 8259: an object for a deck; for several decks, for the designs of a sweep,
** and in the format jsonl always, one object a line.  Computed numbers have 17 digits, those of the deck
** the fewest that read back; undefined is null, unbounded is "inf" or "-inf".
*/
#include <float.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "json_text.h"
#include "sheet.h"

#define DIGITS (DBL_DIG + 2)

/* A string.  "<" is written as \u003c, so that the text can stand in a <script>. */
static void put_string(line *l, const char *s)
{
    json_text_put(l, s, "<");
}

static void put_number(line *l, double x)
{
    json_text_number(l, x, DIGITS);
}

/* Write "name": with a comma before it, unless it is the first in its object. */
static void put_name(line *l, const char *name, int is_first)
{
    line_text(l, ",", !is_first);
    put_string(l, name);
    line_text(l, ":", 1);
}

static void put_text(line *l, const char *name, const char *words)
{
    put_name(l, name, 0);
    put_string(l, words);
}

static void put_named_number(line *l, const char *name, double value)
{
    put_name(l, name, 0);
    put_number(l, value);
}

/* A number that was given, not computed. */
static void put_given(line *l, const char *name, double value)
{
    put_name(l, name, 0);
    json_text_number(l, value, LINE_SHORTEST);
}

/* Begin an object with a text. */
static void begin_object(line *l, const char *name, const char *words)
{
    line_text(l, "{", 1);
    put_name(l, name, 1);
    put_string(l, words);
}

static void put_value(line *l, const fourlink_value *v, int digits)
{
    if (v->words)
        put_string(l, v->words);
    else
        json_text_number(l, v->value, digits);
}

/* One deck has many lines; several decks, and designs, have one each. */
static void put_newline(sheet *s)
{
    if (!s->deck_name && !s->design && !s->mark)
        line_text(&s->l, "\n", 1);
}

/* Close the open list. */
static void end_list(sheet *s)
{
    if (s->list)
        line_text(&s->l, "]", 1);
    s->list = NULL;
}

/* Begin the next item of a list.  If the list is not the open one, close that and open this. */
static void put_item(sheet *s, const char *list)
{
    int goes_on = s->list && strcmp(s->list, list) == 0;

    if (!goes_on)
        end_list(s);
    line_text(&s->l, ",", 1);
    if (!goes_on) {
        put_newline(s);
        put_name(&s->l, list, 1);
        line_text(&s->l, "[", 1);
    }
    s->list = list;
    put_newline(s);
}

/* Begin an object with name, unit and meaning. */
static void put_described(sheet *s, const fourlink_value *v)
{
    begin_object(&s->l, "name", v->name);
    put_text(&s->l, "unit", v->unit);
    put_text(&s->l, "meaning", v->meaning);
}

static void put_column(sheet *s, const fourlink_value *column)
{
    put_item(s, "columns");
    put_described(s, column);
    line_text(&s->l, "}", 1);
}

static void put_listed_column(sheet *s, const fourlink_value *column)
{
    put_item(s, "columns");
    put_described(s, column);
    put_text(&s->l, "source", column->source);
    line_text(&s->l, "}", 1);
}

static void put_listed_fact(sheet *s, const fourlink_value *fact)
{
    put_item(s, "facts");
    put_described(s, fact);
    line_text(&s->l, "}", 1);
}

static void put_input(sheet *s, const fourlink_value *input)
{
    put_item(s, "inputs");
    put_described(s, input);
    put_name(&s->l, "value", 0);
    put_value(&s->l, input, LINE_SHORTEST);
    line_text(&s->l, "}", 1);
}

/* Begin the object of a deck or a design. */
static void put_labels(sheet *s)
{
    unsigned long i;

    line_text(&s->l, "{", 1);
    if (s->deck_name || !s->design) {
        put_name(&s->l, "deck", 1);
        if (s->deck_name)
            put_string(&s->l, s->deck_name);
        else
            line_put(&s->l, "null");
    }
    if (s->design) {
        put_name(&s->l, s->each ? s->each : "design", !s->deck_name);
        line_number(&s->l, (double)s->design, DIGITS);
    }
    if (s->mark)
        put_text(&s->l, "answers", s->mark->path);
    for (i = 0; i < s->n_variables && s->design; i++)
        put_given(&s->l, s->variables[i].name, s->varied[i]);
}

static void open_list(sheet *s)
{
    put_labels(s);
    put_text(&s->l, "title", s->v.problem.title);
    put_text(&s->l, "mechanism", s->v.kind.words);
    if (s->v.problem.axes_on_page || s->v.problem.has_drawn)
        put_text(&s->l, "axes", s->v.problem.axes_on_page ? "page" : "ground");
}

static void open_deck(sheet *s)
{
    open_list(s);
    sheet_write_inputs(s, put_input);
}

static void open_rows(sheet *s)
{
    unsigned long i;

    open_deck(s);
    for (i = 0; i < s->v.n_columns; i++)
        put_column(s, &s->v.columns[i]);
}

static void put_fact(sheet *s, const fourlink_value *fact)
{
    put_item(s, "facts");
    put_described(s, fact);
    put_name(&s->l, "value", 0);
    put_value(&s->l, fact, DIGITS);
    put_named_number(&s->l, "theta2", fact->has_angle ? fact->angle : GSL_NAN);
    put_name(&s->l, "branch", 0);
    if (fact->branch)
        put_string(&s->l, fourlink_branch_text(fact->branch));
    else
        line_put(&s->l, "null");
    line_text(&s->l, "}", 1);
}

/* The list of branches holds an object for each branch, which holds a list of rows. */
static void put_block(sheet *s, fourlink_branch branch)
{
    if (s->list && strcmp(s->list, "rows") == 0)
        line_put(&s->l, "]},");
    else {
        end_list(s);
        line_text(&s->l, ",", 1);
        put_newline(s);
        line_put(&s->l, "\"branches\":[");
    }
    begin_object(&s->l, "branch", fourlink_branch_text((int)branch));
    line_put(&s->l, ",\"rows\":[");
    s->list = "branches";
}

static void put_row(sheet *s, const sheet_row *row)
{
    unsigned long i;

    line_text(&s->l, ",", strcmp(s->list, "rows") == 0);
    s->list = "rows";
    put_newline(s);
    begin_object(&s->l, "status", row->status);
    if (s->v.problem.has_both_sides && row->at)
        put_text(&s->l, "side", fourlink_input_side_text(row->at->row.side));
    line_put(&s->l, ",\"values\":");
    for (i = 0; row->values && i < s->v.n_columns; i++) {
        line_text(&s->l, i ? "," : "[", 1);
        put_number(&s->l, row->values[i]);
    }
    line_put(&s->l, row->values ? "]}" : "null}");
}

static void put_check(sheet *s, const fourlink_check *c)
{
    int is_number = !c->words[0] && c->verdict != FOURLINK_NO_VALUE;

    put_item(s, "checks");
    begin_object(&s->l, "result", sheet_verdicts[c->verdict]);
    put_text(&s->l, "file", c->file);
    put_named_number(&s->l, "line", (double)c->line);
    put_text(&s->l, "name", c->name);
    put_given(&s->l, "theta2", c->has_angle ? c->angle : GSL_NAN);
    put_text(&s->l, "branch", fourlink_branch_text((int)c->branch));
    if (c->side)
        put_text(&s->l, "side", fourlink_input_side_text(c->side));
    put_text(&s->l, "unit", c->unit);
    put_text(&s->l, "printed", c->printed_text);
    put_name(&s->l, "computed", 0);
    if (c->words[0])
        put_string(&s->l, c->words);
    else
        put_number(&s->l, is_number ? c->computed : GSL_NAN);
    put_given(&s->l, "tolerance", is_number ? c->tolerance : GSL_NAN);
    if (c->message[0])
        put_text(&s->l, "message", c->message);
    if (c->hint[0])
        put_text(&s->l, "hint", c->hint);
    line_text(&s->l, "}", 1);
}

/* The first line of a sheet of designs or values describes its variables and outputs. */
static void put_header(sheet *s)
{
    unsigned long i;

    for (i = 0; i < s->n_variables; i++)
        put_column(s, &s->variables[i]);
    for (i = 0; i < s->n_header; i++)
        put_column(s, &s->header[i]);
    end_list(s);
    line_put(&s->l, "}\n");
}

static void begin_values(sheet *s)
{
    begin_object(&s->l, "fourlink", fourlink_version());
    s->design = 1; /* one line */
    put_header(s);
    s->design = 0;
}

static void begin_designs(sheet *s)
{
    begin_object(&s->l, "title", s->v.problem.title);
    s->design = 1; /* one line */
    put_header(s);
}

/* 1 if the name of column i of the header stands before it with another unit. */
static int stands_before(const sheet *s, unsigned long i)
{
    unsigned long k;

    for (k = 0; k < i && strcmp(s->header[k].name, s->header[i].name) != 0; k++)
        ;
    return k < i;
}

static void put_design(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                       const char *why)
{
    unsigned long i;

    put_labels(s);
    if (branch)
        put_text(&s->l, "branch", fourlink_branch_text((int)branch));
    for (i = 0; i < s->n_header; i++) {
        if (outputs ? outputs[i].is_other : stands_before(s, i))
            continue;
        put_name(&s->l, s->header[i].name, 0);
        if (outputs && outputs[i].has_value)
            put_value(&s->l, &outputs[i].v, outputs[i].v.line_unit ? LINE_SHORTEST : DIGITS);
        else
            line_put(&s->l, "null");
    }
    put_text(&s->l, "status", why ? why : fourlink_status_text(FOURLINK_OK));
    line_put(&s->l, "}\n");
}

static void refuse_values(sheet *s, const char *why)
{
    put_design(s, (fourlink_branch)0, NULL, why);
}

/* A line for each branch. */
static void refuse_design(sheet *s, const char *why)
{
    int i;

    for (i = 0; i < s->v.n_branches; i++)
        put_design(s, s->v.branches[i], NULL, why);
}

/* Written instead of a deck, or of a design of which more than a line would be written. */
static void refuse(sheet *s, const char *why)
{
    put_labels(s);
    if (s->design) {
        put_text(&s->l, "status", why);
    } else {
        put_text(&s->l, "status", s->mark ? "bad answers" : "bad deck");
        put_named_number(&s->l, "score", 0);
        if (s->mark)
            put_named_number(&s->l, "of", s->mark->of);
        put_text(&s->l, "message", why);
    }
    line_put(&s->l, "}\n");
}

static void end_deck(sheet *s)
{
    line_put(&s->l, s->list ? "]}\n" : "}\n");
}

static void close_deck(sheet *s)
{
    put_newline(s);
    end_deck(s);
}

static void close_rows(sheet *s)
{
    put_newline(s);
    line_put(&s->l, "]}");
    end_deck(s);
}

static void close_checks(sheet *s)
{
    put_newline(s);
    end_list(s);
    put_named_number(&s->l, "score", s->right);
    put_named_number(&s->l, "of", s->of);
    if (s->mark && s->mark->note[0])
        put_text(&s->l, "note", s->mark->note);
    end_deck(s);
}

static void put_mark(sheet *s, const sheet_mark *m)
{
    begin_object(&s->l, "name", m->name);
    put_named_number(&s->l, "right", m->right);
    put_named_number(&s->l, "of", m->of);
    put_named_number(&s->l, "percent", sheet_percent(m));
    put_text(&s->l, "note", m->note);
    if (s->has_roster) {
        put_text(&s->l, "id", m->id);
        put_named_number(&s->l, "late", m->late);
        put_named_number(&s->l, "total", m->total);
    }
    line_put(&s->l, "}\n");
}

static const sheet_frame of_rows = {NULL, open_rows, close_rows, refuse},
                         of_summary = {NULL, open_deck, close_deck, refuse},
                         of_checks = {NULL, open_deck, close_checks, refuse},
                         of_list = {NULL, open_list, close_deck, refuse},
                         of_designs = {begin_designs, NULL, NULL, refuse_design},
                         of_values = {begin_values, NULL, NULL, refuse_values},
                         of_scores = {NULL, NULL, NULL, NULL};

#define JSON(name, is_lines)                                                        \
    {                                                                               \
        name, {&of_rows,    &of_summary, &of_checks, &of_list,  NULL,               \
               &of_designs, &of_values,  NULL,       &of_scores}, /* frame */       \
            put_listed_column,                                    /* column */      \
            put_listed_fact,                                      /* listed */      \
            put_fact,                                             /* limit */       \
            put_fact,                                             /* fact */        \
            put_block,                                            /* block */       \
            put_row,                                              /* row */         \
            NULL,                                                 /* end_block */   \
            put_check,                                            /* check */       \
            put_design,                                           /* design */      \
            put_design,                                           /* values */      \
            0,                                                    /* layout_size */ \
            0,                                                    /* is_by_angle */ \
            0,                                                    /* is_brief */    \
            put_mark,                                             /* mark */        \
            NULL,                                                 /* extremes */    \
            is_lines                                                                \
    }

const sheet_format json_format = JSON("json", 0), jsonl_format = JSON("jsonl", 1);
