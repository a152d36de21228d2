/* SPDX-License-Identifier: GPL-3.0-or-later
**
** summary.c - a summary in the format table: inputs, then results, a line each, 100 columns wide.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "head.h"
#include "summary.h"

#define LINE 100
#define NAME 20
#define UNIT 7
#define ANGLE 9
#define BRANCH 8

/* The columns that a number may take: sign, point and exponent beside its digits. */
static size_t width_of_value(const sheet *s)
{
    return (size_t)s->v.problem.digits + 7;
}

static void put_left(sheet *s, const char *words, size_t width)
{
    size_t n = strlen(words);

    line_put(&s->l, "%s", words);
    if (n < width)
        line_right(&s->l, "", 0, width - n);
}

/* Write name, value and unit; returns the columns used.  A long name takes room of the value. */
static size_t put_value(sheet *s, const fourlink_value *f)
{
    char number[FORMAT_SIZE];
    size_t name = strlen(f->name), width = width_of_value(s), unit_name = strlen(f->unit);
    size_t excess = name > NAME ? name - NAME : 0;

    format_general(f->value, s->v.problem.digits, number);
    put_left(s, f->name, NAME);
    width = GSL_MAX(width > excess ? width - excess : 0, strlen(number) + 1);
    line_field(&s->l, number, width);
    line_put(&s->l, " ");
    put_left(s, f->unit, UNIT);
    return NAME + excess + width + 1 + GSL_MAX(unit_name, UNIT);
}

/* Words follow the name, and end the line. */
static void put_words(sheet *s, const fourlink_value *f)
{
    put_left(s, f->name, NAME);
    line_put(&s->l, "  %s%s%s\n", f->words, f->branch ? ", " : "",
             f->branch ? fourlink_branch_text(f->branch) : "");
}

/* A meaning for which the line has no room is left out: --list has it. */
static void put_meaning(sheet *s, size_t used, const char *meaning)
{
    if (used + 1 + strlen(meaning) <= LINE)
        line_put(&s->l, " %s", meaning);
    line_put(&s->l, "\n");
}

static void put_input(sheet *s, const fourlink_value *input)
{
    if (input->words)
        put_words(s, input);
    else
        put_meaning(s, put_value(s, input), input->meaning);
}

static void put_heading(sheet *s, const char *name)
{
    put_left(s, name, NAME);
    line_field(&s->l, "value", width_of_value(s));
    line_put(&s->l, " ");
    put_left(s, "unit", UNIT);
}

void summary_put_inputs(sheet *s)
{
    char at[FORMAT_SIZE] = "at ";

    head_put_title(s);
    head_put_kind(s);
    put_heading(s, "# input");
    line_put(&s->l, " meaning\n");
    sheet_write_inputs(s, put_input);
    put_heading(s, "# result");
    line_field(&s->l, strncat(at, s->v.units[QUANTITY_ANGLE].name, sizeof at - 4), ANGLE);
    line_put(&s->l, " branch  meaning\n");
}

void summary_put_fact(sheet *s, const fourlink_value *f)
{
    char angle[FORMAT_SIZE] = "";
    size_t used;

    if (f->words) {
        put_words(s, f);
        return;
    }
    used = put_value(s, f) + ANGLE + BRANCH;
    if (f->has_angle)
        format_general(f->angle, s->v.problem.digits, angle);
    line_field(&s->l, angle, ANGLE);
    line_put(&s->l, " ");
    put_left(s, f->branch ? fourlink_branch_text(f->branch) : "", BRANCH - 1);
    put_meaning(s, used, f->meaning);
}
