/* SPDX-License-Identifier: GPL-3.0-or-later
**
** csv.c - the format csv, RFC 4180: one header for all decks, then a line for each row, fact, comparison or
** design.  Lines end in CR LF; numbers have 17 digits.
*/
#include <float.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "sheet.h"

#define DIGITS (DBL_DIG + 2)

/* Fields with a comma, a quote or the end of a line in them stand in quotes, and quotes in them are
** doubled. */
static void put_words(line *l, const char *s)
{
    if (!strpbrk(s, ",\"\r\n")) {
        line_words(l, s);
        return;
    }
    line_text(l, "\"", 1);
    for (; *s; s++)
        line_text(l, *s == '"' ? "\"\"" : s, *s == '"' ? 2 : 1);
    line_text(l, "\"", 1);
}

static void put_comma(line *l)
{
    line_text(l, ",", 1);
}

static void end_row(line *l)
{
    line_text(l, "\r\n", 2);
}

/* NAME (UNIT) */
static void put_heading(line *l, const fourlink_value *column)
{
    char words[400];

    put_words(
        l, flk_text_join(words, sizeof words, column->name, " (", column->unit, ")", (char *)NULL));
}

static void begin(sheet *s)
{
    unsigned long i;

    if (s->n_decks > 1)
        line_words(&s->l, "deck,");
    if (s->content == SHEET_SUMMARY) {
        line_words(&s->l, "name,value,unit,theta2,branch");
    } else if (s->content == SHEET_CHECK) {
        line_words(&s->l, "file,line,result,name,theta2,branch,unit,printed,computed,tolerance");
    } else {
        if (s->n_variables)
            line_words(&s->l, "design,");
        for (i = 0; i < s->n_variables; i++) {
            put_heading(&s->l, &s->variables[i]);
            put_comma(&s->l);
        }
        line_words(&s->l, "branch,");
        for (i = 0; i < s->n_header; i++) {
            put_heading(&s->l, &s->header[i]);
            put_comma(&s->l);
        }
        line_words(&s->l, "status");
    }
    end_row(&s->l);
}

/* What rows begin with: the deck, or the design with its quantities. */
static void put_labels(sheet *s)
{
    unsigned long i;

    if (s->deck_name) {
        put_words(&s->l, s->deck_name);
        put_comma(&s->l);
    }
    if (s->design) {
        line_number(&s->l, (double)s->design, DIGITS);
        put_comma(&s->l);
    }
    for (i = 0; i < s->n_variables; i++) {
        line_number(&s->l, s->varied[i], DIGITS);
        put_comma(&s->l);
    }
}

static void put_row(sheet *s, const sheet_row *row)
{
    const long *under = s->layout;
    unsigned long i;

    put_labels(s);
    line_words(&s->l, fourlink_branch_text((int)row->branch));
    put_comma(&s->l);
    for (i = 0; i < s->n_header; i++) {
        double x = row->values && under[i] >= 0 ? row->values[under[i]] : GSL_NAN;

        if (x == x)
            line_number(&s->l, x, DIGITS);
        put_comma(&s->l);
    }
    put_words(&s->l, row->status);
    end_row(&s->l);
}

static void open_deck(sheet *s)
{
    long *under = s->layout;
    unsigned long i;

    for (i = 0; s->content == SHEET_ROWS && i < s->n_header; i++)
        under[i] = sheet_column_under(s, i);
}

static void put_fact(sheet *s, const fourlink_value *fact)
{
    if (s->content != SHEET_SUMMARY)
        return;
    put_labels(s);
    line_words(&s->l, fact->name);
    put_comma(&s->l);
    if (fact->words)
        put_words(&s->l, fact->words);
    else if (sheet_is_finite(fact))
        line_number(&s->l, fact->value, DIGITS);
    else
        line_words(&s->l, SHEET_UNBOUNDED);
    put_comma(&s->l);
    line_words(&s->l, fact->unit);
    put_comma(&s->l);
    if (fact->has_angle)
        line_number(&s->l, fact->angle, DIGITS);
    put_comma(&s->l);
    line_words(&s->l, fact->branch ? fourlink_branch_text(fact->branch) : "");
    end_row(&s->l);
}

static void put_check(sheet *s, const fourlink_check *c)
{
    int is_number = !c->words[0] && c->verdict != FOURLINK_NO_VALUE;

    put_labels(s);
    put_words(&s->l, c->file);
    put_comma(&s->l);
    line_number(&s->l, (double)c->line, DIGITS);
    put_comma(&s->l);
    line_words(&s->l, sheet_verdicts[c->verdict]);
    put_comma(&s->l);
    put_words(&s->l, c->name);
    put_comma(&s->l);
    if (c->has_angle)
        line_number(&s->l, c->angle, DIGITS);
    put_comma(&s->l);
    line_words(&s->l, fourlink_branch_text((int)c->branch));
    put_comma(&s->l);
    line_words(&s->l, c->unit);
    put_comma(&s->l);
    put_words(&s->l, c->printed_text);
    put_comma(&s->l);
    if (is_number)
        line_number(&s->l, c->computed, DIGITS);
    else
        put_words(&s->l, c->words);
    put_comma(&s->l);
    if (is_number)
        line_number(&s->l, c->tolerance, DIGITS);
    end_row(&s->l);
}

static void put_design(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                       const char *why)
{
    unsigned long i;

    put_labels(s);
    line_words(&s->l, fourlink_branch_text((int)branch));
    put_comma(&s->l);
    for (i = 0; i < s->n_header; i++) {
        if (outputs && outputs[i].has_value && outputs[i].v.words)
            put_words(&s->l, outputs[i].v.words);
        else if (outputs && outputs[i].has_value)
            line_number(&s->l, outputs[i].v.value, DIGITS);
        put_comma(&s->l);
    }
    put_words(&s->l, why ? why : fourlink_status_text(FOURLINK_OK));
    end_row(&s->l);
}

/* A deck that could not be read has a line with no more than that; a design its reason on each branch. */
static void refuse(sheet *s, const char *why)
{
    fourlink_branch branches[2];
    int n, i;

    if (!s->design) {
        put_labels(s);
        line_words(&s->l, ",,");
        line_words(&s->l, why);
        line_words(&s->l, ",,,,,,,");
        end_row(&s->l);
        return;
    }
    n = sheet_branches(s, branches);
    for (i = 0; i < n; i++)
        put_design(s, branches[i], NULL, why);
}

const sheet_format csv_format = {
    "csv",        1 << SHEET_ROWS | 1 << SHEET_SUMMARY | 1 << SHEET_CHECK | 1 << SHEET_DESIGNS,
    begin,        open_deck,
    NULL,         put_fact,
    NULL,         put_row,
    put_check,    put_design,
    refuse,       NULL,
    sizeof(long), 0};
