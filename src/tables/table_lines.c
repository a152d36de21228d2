/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table_lines.c - the parts of the format table that are lines of text: facts, lists, comparisons, designs.
*/
#include <string.h>

#include "base/text.h"
#include "table.h"

/* -------------------------------------------------------------------------------------------- facts */

/* A field with a blank behind it. */
static void put_field(line *l, const char *s, int width)
{
    size_t n = strlen(s), size = (size_t)(width < 0 ? -width : width);

    if (n >= size)
        line_text(l, s, n);
    else
        line_field(l, s, width);
    line_text(l, " ", 1);
}

static void put_fact_in_head(sheet *s, const fourlink_value *f)
{
    char unit[80];

    line_words(&s->l, "# ");
    line_words(&s->l, f->name);
    if (f->branch) {
        line_words(&s->l, " (");
        line_words(&s->l, fourlink_branch_text(f->branch));
        line_words(&s->l, ")");
    }
    line_words(&s->l, ": ");
    if (f->words) {
        line_words(&s->l, f->words);
    } else {
        line_number(&s->l, f->value, 9);
        line_words(&s->l, sheet_unit_behind(f->unit, unit));
    }
    if (f->has_angle) {
        line_words(&s->l, " at theta2 = ");
        line_number(&s->l, f->angle, 9);
    }
    line_words(&s->l, "\n");
}

void table_put_summary_head(sheet *s)
{
    line_words(&s->l, "# ");
    put_field(&s->l, "name", -20);
    put_field(&s->l, "value", 20);
    put_field(&s->l, "unit", -8);
    put_field(&s->l, "theta2", 10);
    put_field(&s->l, s->angle_unit, -3);
    put_field(&s->l, "branch", -8);
    line_words(&s->l, "meaning\n");
}

static void put_fact_of_summary(sheet *s, const fourlink_value *f)
{
    const char *words = f->words ? f->words : sheet_is_finite(f) ? NULL : SHEET_UNBOUNDED;
    char value[FORMAT_SIZE] = "", angle[FORMAT_SIZE] = "";

    if (!words)
        format_general(f->value, 12, value);
    if (f->has_angle)
        format_general(f->angle, 10, angle);
    put_field(&s->l, f->name, -22);
    put_field(&s->l, value, 20);
    put_field(&s->l, f->unit, -8);
    put_field(&s->l, angle, 14);
    put_field(&s->l, f->branch ? fourlink_branch_text(f->branch) : "", -8);
    line_words(&s->l, words ? words : f->meaning);
    line_words(&s->l, "\n");
}

void table_put_fact(sheet *s, const fourlink_value *f)
{
    if (s->content == SHEET_SUMMARY) {
        put_fact_of_summary(s, f);
    } else if (s->content == SHEET_ROWS) {
        put_fact_in_head(s, f);
    } else {
        if (!s->list)
            line_words(&s->l, "\nfact               unit     meaning\n");
        s->list = "facts";
        put_field(&s->l, f->name, -18);
        put_field(&s->l, f->unit, -8);
        line_words(&s->l, f->meaning);
        line_words(&s->l, "\n");
    }
}

/* --------------------------------------------------------------------------------------------- lists */

void table_put_list_head(sheet *s)
{
    put_field(&s->l, "column", -18);
    put_field(&s->l, "unit", -8);
    put_field(&s->l, "meaning", -60);
    line_words(&s->l, "in the sources\n");
}

void table_put_column(sheet *s, const fourlink_value *column)
{
    put_field(&s->l, column->name, -18);
    put_field(&s->l, column->unit, -8);
    if (*column->source) {
        put_field(&s->l, column->meaning, -60);
        line_words(&s->l, column->source);
    } else {
        line_words(&s->l, column->meaning);
    }
    line_words(&s->l, "\n");
}

/* --------------------------------------------------------------------------------------- comparisons */

void table_put_check(sheet *s, const fourlink_check *c)
{
    char unit[80];

    put_field(&s->l, sheet_verdicts[c->verdict], -18);
    line_words(&s->l, c->file);
    line_words(&s->l, ":");
    line_number(&s->l, (double)c->line, 10);
    line_words(&s->l, ": ");
    line_words(&s->l, c->name);
    line_words(&s->l, " = ");
    line_words(&s->l, c->printed_text);
    if (c->words[0]) {
        line_words(&s->l, ", computed ");
        line_words(&s->l, c->words);
    } else if (c->verdict != FOURLINK_NO_VALUE) {
        line_words(&s->l, ", computed ");
        line_number(&s->l, c->computed, 12);
        line_words(&s->l, sheet_unit_behind(c->unit, unit));
    }
    if (c->has_angle) {
        line_words(&s->l, " at ");
        line_number(&s->l, c->angle, 9);
        line_words(&s->l, " ");
        line_words(&s->l, s->angle_unit);
    }
    line_words(&s->l, ", ");
    line_words(&s->l, fourlink_branch_text((int)c->branch));
    line_words(&s->l, "\n");
}

/* The counts of this deck's comparisons. */
void table_close(sheet *s)
{
    static const fourlink_verdict order[] = {FOURLINK_AGREES, FOURLINK_MISPRINT, FOURLINK_DIFFERS,
                                             FOURLINK_NO_MISPRINT, FOURLINK_NO_VALUE};
    int i;

    if (s->content != SHEET_CHECK)
        return;
    for (i = 0; i < 5; i++) {
        line_words(&s->l, i ? ", " : "# ");
        line_words(&s->l, sheet_verdicts[order[i]]);
        line_words(&s->l, ": ");
        line_number(&s->l, (double)s->checks[order[i]], 10);
    }
    line_words(&s->l, "\n");
}

/* ------------------------------------------------------------------------------------------- designs */

#define WIDTH 16 /* of a column */

/* The line of names, or of units. */
static void put_heading(sheet *s, int units)
{
    unsigned long i;

    line_words(&s->l, units ? "#         " : "#   design");
    for (i = 0; i < s->n_variables; i++)
        line_field(&s->l, units ? s->variables[i].unit : s->variables[i].name, WIDTH);
    line_words(&s->l, units ? "          " : "    branch");
    for (i = 0; i < s->n_header; i++)
        line_field(&s->l, units ? s->header[i].unit : s->header[i].name, WIDTH);
    line_words(&s->l, "\n");
}

void table_begin(sheet *s)
{
    if (s->content != SHEET_DESIGNS)
        return;
    if (s->problem.title[0]) {
        line_words(&s->l, "# ");
        line_words(&s->l, s->problem.title);
        line_words(&s->l, "\n");
    }
    put_heading(s, 0);
    put_heading(s, 1);
}

void table_put_design_comment(sheet *s)
{
    unsigned long i;

    line_words(&s->l, "# design ");
    line_number(&s->l, (double)s->design, 17);
    for (i = 0; i < s->n_variables; i++) {
        line_words(&s->l, i ? ", " : ": ");
        line_words(&s->l, s->variables[i].name);
        line_words(&s->l, " = ");
        line_number(&s->l, s->varied[i], 12);
        line_words(&s->l, " ");
        line_words(&s->l, s->variables[i].unit);
    }
    line_words(&s->l, "\n");
}

static void put_number(sheet *s, double value, int digits, int width)
{
    char number[FORMAT_SIZE];

    line_field(&s->l, format_general(value + 0.0, digits, number), width);
}

/* Words in double quotes. */
static void put_quoted(sheet *s, const char *words, int width)
{
    char quoted[200];

    line_field(&s->l, flk_text_join(quoted, sizeof quoted, "\"", words, "\"", (char *)NULL), width);
}

void table_put_design(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                      const char *why)
{
    unsigned long i;

    (void)why; /* what has no value is nan */
    put_number(s, (double)s->design, 17, 10);
    for (i = 0; i < s->n_variables; i++)
        put_number(s, s->varied[i], s->problem.digits, WIDTH);
    put_quoted(s, fourlink_branch_text((int)branch), 10);
    for (i = 0; i < s->n_header; i++)
        if (!outputs[i].has_value) {
            line_field(&s->l, "nan", WIDTH);
        } else if (outputs[i].v.words) {
            line_words(&s->l, "  ");
            put_quoted(s, outputs[i].v.words, WIDTH - 2);
        } else {
            put_number(s, outputs[i].v.value, s->problem.digits, WIDTH);
        }
    line_words(&s->l, "\n");
}

void table_refuse(sheet *s, const char *why)
{
    if (!s->design)
        return;
    if (s->content == SHEET_ROWS)
        sheet_write_gap(s);
    table_put_design_comment(s);
    line_words(&s->l, "# ");
    line_words(&s->l, why);
    line_words(&s->l, "\n");
}
