/* SPDX-License-Identifier: GPL-3.0-or-later
**
** csv.c - the format csv, RFC 4180: one header for all decks, then a line for each row, fact, comparison or
** design.  Lines end in LF; computed numbers have 17 digits, those of the deck the fewest that read back;
** what is undefined is empty, what is unbounded inf or -inf.
*/
#include <float.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "base/text.h"
#include "sheet.h"

#define DIGITS (DBL_DIG + 2)

/* 1 if a spreadsheet would compute a text; a number with its unit is none. */
static int is_formula(const char *s)
{
    text rest = flk_text_of(s);
    double number;

    if (!*s || !strchr("=+-@\t\r", *s))
        return 0;
    if (strcmp(s, "-inf") != 0 && flk_number_read(&rest, &number) == NUMBER_NONE)
        return 1;
    return strpbrk(rest.start, "=+@|!('\"") != NULL;
}

/* A field that holds a comma, a quote or an end of line is quoted, and its quotes are doubled.  A formula
** gets an apostrophe, which makes it text. */
static void put_words(line *l, const char *s)
{
    size_t is_quoted = strpbrk(s, ",\"\r\n") ? 1 : 0, n;

    line_text(l, "\"", is_quoted);
    line_text(l, "'", is_formula(s) ? 1 : 0);
    for (; (n = strcspn(s, "\"\n")), s[n]; s += n + 1) {
        line_words(l, s, n);
        line_text(l, s[n] == '"' ? "\"\"" : "\n", s[n] == '"' ? 2 : 1);
    }
    line_words(l, s, n);
    line_text(l, "\"", is_quoted);
}

/* NAME (UNIT) and a comma */
static void put_heading(line *l, const fourlink_value *column)
{
    char words[400];

    put_words(
        l, flk_text_join(words, sizeof words, column->name, " (", column->unit, ")", (char *)NULL));
    line_byte(l, ',');
}

/* The names of the fields of put_labels. */
static void put_label_names(sheet *s)
{
    if (s->n_decks > 1)
        line_put(&s->l, "deck,");
    if (s->has_designs)
        line_put(&s->l, "design,");
    if (s->n_decks <= 1 && (s->n_variables || s->each))
        line_put(&s->l, "%s,", s->each ? s->each : "design");
}

static void begin_summary(sheet *s)
{
    put_label_names(s);
    line_put(&s->l, "name,value,unit,theta2,branch\n");
}

static void begin_checks(sheet *s)
{
    put_label_names(s);
    line_put(&s->l,
             "file,line,result,name,theta2,branch,%sunit,printed,computed,tolerance,score,of,"
             "note\n",
             s->has_sides ? "side," : "");
}

static void begin_scores(sheet *s)
{
    unsigned long i;

    line_put(&s->l, "name,right,of,percent,note%s", s->has_roster ? ",id,late,total" : "");
    for (i = 0; i < s->n_questions; i++) {
        line_byte(&s->l, ',');
        put_words(&s->l, s->questions[i].name);
    }
    line_byte(&s->l, '\n');
}

static void begin_rows(sheet *s)
{
    unsigned long i;

    put_label_names(s);
    for (i = 0; i < s->n_variables; i++)
        put_heading(&s->l, &s->variables[i]);
    line_put(&s->l, s->has_sides ? "branch,side," : "branch,");
    for (i = 0; i < s->n_header; i++)
        put_heading(&s->l, &s->header[i]);
    line_put(&s->l, "status\n");
}

/* The first fields of a row: the deck, or the design with its variables. */
static void put_labels(sheet *s)
{
    unsigned long i;

    if (s->deck_name) {
        put_words(&s->l, s->deck_name);
        line_byte(&s->l, ',');
    }
    if (s->design)
        line_put(&s->l, "%lu,", s->design);
    else if (s->has_designs)
        line_byte(&s->l, ',');
    for (i = 0; i < s->n_variables && s->design; i++) {
        line_number(&s->l, s->varied[i], LINE_SHORTEST);
        line_byte(&s->l, ',');
    }
}

static void put_value(line *l, const fourlink_value *v, int digits)
{
    if (v->words)
        put_words(l, v->words);
    else
        line_number(l, v->value, digits);
}

static void put_entry(sheet *s, const fourlink_value *f, int digits)
{
    put_labels(s);
    put_words(&s->l, f->name);
    line_put(&s->l, ",");
    put_value(&s->l, f, digits);
    line_put(&s->l, ",%s,", f->unit);
    if (f->has_angle)
        line_number(&s->l, f->angle, DIGITS);
    line_put(&s->l, ",%s\n", f->branch ? fourlink_branch_text(f->branch) : "");
}

static void put_fact(sheet *s, const fourlink_value *fact)
{
    put_entry(s, fact, DIGITS);
}

static void put_input(sheet *s, const fourlink_value *input)
{
    put_entry(s, input, LINE_SHORTEST);
}

static void open_rows(sheet *s)
{
    long *under = s->layout;
    unsigned long i;

    for (i = 0; i < s->n_header; i++)
        under[i] = sheet_column_under(s, i);
}

static void open_summary(sheet *s)
{
    sheet_write_inputs(s, put_input);
}

/* The side of an input, of a deck of which the rows are on both; else "". */
static const char *side_of(const sheet *s, int side)
{
    return s->v.problem.has_both_sides && side ? fourlink_input_side_text(side) : "";
}

static void put_row(sheet *s, const sheet_row *row)
{
    const long *under = s->layout;
    const char *branch = fourlink_branch_text((int)row->branch);
    unsigned long i;

    put_labels(s);
    line_text(&s->l, branch, strlen(branch));
    line_byte(&s->l, ',');
    if (s->has_sides)
        line_put(&s->l, "%s,", side_of(s, row->at ? row->at->row.side : 0));
    for (i = 0; i < s->n_header; i++) {
        double x = row->values && under[i] >= 0 ? row->values[under[i]] : GSL_NAN;

        if (x == x) /* not NaN */
            line_number(&s->l, x, DIGITS);
        line_byte(&s->l, ',');
    }
    put_words(&s->l, row->status);
    line_byte(&s->l, '\n');
}

static void put_check(sheet *s, const fourlink_check *c)
{
    put_labels(s);
    put_words(&s->l, c->file);
    line_put(&s->l, ",%lu,%s,", (unsigned long)c->line, sheet_verdicts[c->verdict]);
    put_words(&s->l, c->name);
    line_byte(&s->l, ',');
    if (c->has_angle)
        line_number(&s->l, c->angle, LINE_SHORTEST);
    line_put(&s->l, ",%s,", fourlink_branch_text((int)c->branch));
    if (s->has_sides)
        line_put(&s->l, "%s,", side_of(s, c->side));
    line_put(&s->l, "%s,", c->unit);
    put_words(&s->l, c->printed_text);
    line_byte(&s->l, ',');
    if (c->words[0] || c->verdict == FOURLINK_NO_VALUE) {
        put_words(&s->l, c->words);
        line_put(&s->l, ",");
    } else {
        line_put(&s->l, "%17g,", c->computed);
        line_number(&s->l, c->tolerance, LINE_SHORTEST);
    }
    line_put(&s->l, ",,,");
    put_words(&s->l, c->verdict == FOURLINK_NO_VALUE ? c->message : c->hint);
    line_byte(&s->l, '\n');
}

static void put_design(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                       const char *why)
{
    unsigned long i;

    put_labels(s);
    line_put(&s->l, "%s,", branch ? fourlink_branch_text((int)branch) : "");
    for (i = 0; i < s->n_header; i++) {
        if (outputs && outputs[i].has_value)
            put_value(&s->l, &outputs[i].v, outputs[i].v.line_unit ? LINE_SHORTEST : DIGITS);
        line_byte(&s->l, ',');
    }
    put_words(&s->l, why ? why : fourlink_status_text(FOURLINK_OK));
    line_byte(&s->l, '\n');
}

/* The line of a deck that has a score, or mistakes; `of` is NaN if nothing is known of what is asked. */
static void put_score(sheet *s, const char *result, double right, double of, const char *note)
{
    put_labels(s);
    put_words(&s->l, s->mark ? s->mark->path : "");
    line_put(&s->l, s->has_sides ? ",,%s,,,,,,,,,%12g," : ",,%s,,,,,,,,%12g,", result, right);
    if (!gsl_isnan(of))
        line_put(&s->l, "%12g", of);
    line_byte(&s->l, ',');
    put_words(&s->l, note);
    line_byte(&s->l, '\n');
}

static void close_checks(sheet *s)
{
    put_score(s, "score", s->right, s->of, s->mark ? s->mark->note : "");
}

static void refuse_values(sheet *s, const char *why)
{
    put_design(s, (fourlink_branch)0, NULL, why);
}

/* A deck with mistakes has one line that says so; a design has one with the reason for each branch. */
static void refuse(sheet *s, const char *why)
{
    int n = s->design ? s->v.n_branches : 0, i;

    if (!s->design)
        put_score(s, s->mark ? "bad answers" : "bad deck", 0, s->mark ? s->mark->of : GSL_NAN, why);
    for (i = 0; i < n; i++)
        put_design(s, s->v.branches[i], NULL, why);
}

static void put_mark(sheet *s, const sheet_mark *m)
{
    unsigned long i;

    put_words(&s->l, m->name);
    line_put(&s->l, ",%12g,%12g", m->right, m->of);
    if (m->of > 0)
        line_put(&s->l, ",%12g,", sheet_percent(m));
    else
        line_put(&s->l, ",,");
    put_words(&s->l, m->note);
    if (s->has_roster) {
        line_byte(&s->l, ',');
        put_words(&s->l, m->id);
        line_put(&s->l, ",%12g,%12g", m->late, m->total);
    }
    for (i = 0; i < s->n_questions; i++) {
        line_byte(&s->l, ',');
        if (!gsl_isnan(s->questions[i].got))
            line_number(&s->l, s->questions[i].got, DIGITS);
    }
    line_byte(&s->l, '\n');
}

static const sheet_frame of_rows = {begin_rows, open_rows, NULL, refuse},
                         of_summary = {begin_summary, open_summary, NULL, refuse},
                         of_checks = {begin_checks, NULL, close_checks, refuse},
                         of_designs = {begin_rows, NULL, NULL, refuse},
                         of_values = {begin_rows, NULL, NULL, refuse_values},
                         of_scores = {begin_scores, NULL, NULL, NULL};

const sheet_format csv_format = {
    "csv", /* name */
    {&of_rows, &of_summary, &of_checks, NULL, NULL, &of_designs, &of_values, NULL,
     &of_scores}, /* frame */
    NULL,         /* column */
    NULL,         /* listed */
    NULL,         /* limit */
    put_fact,     /* fact */
    NULL,         /* block */
    put_row,      /* row */
    NULL,         /* end_block */
    put_check,    /* check */
    put_design,   /* design */
    put_design,   /* values */
    sizeof(long), /* layout_size */
    0,            /* is_by_angle */
    0,            /* is_brief */
    put_mark,     /* mark */
    NULL,         /* extremes */
    0             /* is_lines */
};
