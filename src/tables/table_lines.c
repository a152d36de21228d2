/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table_lines.c - the parts of the format table that are lines of text: facts, lists, comparisons, designs.
*/
#include <string.h>

#include "base/text.h"
#include "table.h"

/* The text after a value: a blank and the unit, or nothing for a plain number. */
static const char *blank(const char *unit)
{
    return strcmp(unit, "1") == 0 ? "" : " ";
}

static const char *unit_after(const char *unit)
{
    return strcmp(unit, "1") == 0 ? "" : unit;
}

void table_put_head(sheet *s)
{
    if (s->content == SHEET_LIST)
        line_put(&s->l, "%-18s %-8s %-60s in the sources\n", "column", "unit", "meaning");
    if (s->content == SHEET_CHECK || s->content == SHEET_LIST)
        return;
    sheet_write_title(s);
    if (s->content == SHEET_STATISTICS)
        return;
    sheet_write_mechanism(s);
    if (s->content == SHEET_SUMMARY)
        line_put(&s->l, "# %-20s %20s %-8s %10s %-3s %-8s meaning\n", "name", "value", "unit",
                 "theta2", s->angle_unit, "branch");
}

/* -------------------------------------------------------------------------------------------- facts */

static void put_fact_in_head(sheet *s, const fourlink_value *f)
{
    line_put(&s->l, "# %s", f->name);
    if (f->branch)
        line_put(&s->l, " (%s)", fourlink_branch_text(f->branch));
    if (f->words)
        line_put(&s->l, ": %s", f->words);
    else
        line_put(&s->l, ": %9g%s%s", f->value, blank(f->unit), unit_after(f->unit));
    if (f->has_angle)
        line_put(&s->l, " at theta2 = %9g", f->angle);
    line_put(&s->l, "\n");
}

static void put_fact_of_summary(sheet *s, const fourlink_value *f)
{
    const char *words = f->words ? f->words : sheet_is_finite(f) ? NULL : SHEET_UNBOUNDED;
    char value[FORMAT_SIZE] = "", angle[FORMAT_SIZE] = "";

    if (!words)
        format_general(f->value, 12, value);
    if (f->has_angle)
        format_general(f->angle, 10, angle);
    line_put(&s->l, "%-22s %20s %-8s %14s %-8s %s\n", f->name, value, f->unit, angle,
             f->branch ? fourlink_branch_text(f->branch) : "", words ? words : f->meaning);
}

void table_put_fact(sheet *s, const fourlink_value *f)
{
    if (s->content == SHEET_SUMMARY) {
        put_fact_of_summary(s, f);
    } else if (s->content == SHEET_ROWS) {
        put_fact_in_head(s, f);
    } else {
        if (!s->list)
            line_put(&s->l, "\n%-18s %-8s meaning\n", "fact", "unit");
        s->list = "facts";
        line_put(&s->l, "%-18s %-8s %s\n", f->name, f->unit, f->meaning);
    }
}

/* ------------------------------------------------------------------------------ lists, comparisons */

void table_put_column(sheet *s, const fourlink_value *c)
{
    line_put(&s->l, *c->source ? "%-18s %-8s %-60s %s\n" : "%-18s %-8s %s%s\n", c->name, c->unit,
             c->meaning, c->source);
}

void table_put_check(sheet *s, const fourlink_check *c)
{
    line_put(&s->l, "%-18s %s:%lu: %s = %s", sheet_verdicts[c->verdict], c->file,
             (unsigned long)c->line, c->name, c->printed_text);
    if (c->words[0])
        line_put(&s->l, ", computed %s", c->words);
    else if (c->verdict != FOURLINK_NO_VALUE)
        line_put(&s->l, ", computed %12g%s%s", c->computed, blank(c->unit), unit_after(c->unit));
    if (c->has_angle)
        line_put(&s->l, " at %9g %s", c->angle, s->angle_unit);
    line_put(&s->l, c->hint[0] ? ", %s; hint: %s\n" : ", %s\n",
             fourlink_branch_text((int)c->branch), c->hint);
}

/* Write the counts of this deck's comparisons, and its score. */
void table_close(sheet *s)
{
    static const fourlink_verdict order[] = {FOURLINK_AGREES, FOURLINK_MISPRINT, FOURLINK_DIFFERS,
                                             FOURLINK_NO_MISPRINT, FOURLINK_NO_VALUE};
    unsigned long score, of;
    int i;

    if (s->content != SHEET_CHECK)
        return;
    score = sheet_score(s, &of);
    for (i = 0; i < 5; i++)
        line_put(&s->l, "%s%s: %lu%s", i ? ", " : "# ", sheet_verdicts[order[i]],
                 s->checks[order[i]], i < 4 ? "" : "\n");
    line_put(&s->l, "# score: %lu of %lu\n", score, of);
}

/* ------------------------------------------------------------------------------------------- designs */

#define WIDTH 16 /* of a column */

/* The line of names, or of units. */
static void put_heading(sheet *s, int units)
{
    unsigned long i;

    line_put(&s->l, units ? "#         " : "#   design");
    for (i = 0; i < s->n_variables; i++)
        line_field(&s->l, units ? s->variables[i].unit : s->variables[i].name, WIDTH);
    line_put(&s->l, units ? "          " : "    branch");
    for (i = 0; i < s->n_header; i++)
        line_field(&s->l, units ? s->header[i].unit : s->header[i].name, WIDTH);
    line_put(&s->l, "\n");
}

void table_begin(sheet *s)
{
    if (s->content != SHEET_DESIGNS)
        return;
    sheet_write_title(s);
    put_heading(s, 0);
    put_heading(s, 1);
}

void table_put_design_comment(sheet *s)
{
    unsigned long i;

    line_put(&s->l, "# design %lu", s->design);
    for (i = 0; i < s->n_variables; i++)
        line_put(&s->l, "%s %s = %12g %s", i ? "," : ":", s->variables[i].name, s->varied[i],
                 s->variables[i].unit);
    line_put(&s->l, "\n");
}

static void put_number(sheet *s, double value)
{
    char number[FORMAT_SIZE];

    line_field(&s->l, format_general(value + 0.0, s->problem.digits, number), WIDTH);
}

static void put_quoted(sheet *s, const char *words, size_t width)
{
    char quoted[200];

    line_field(&s->l, flk_text_join(quoted, sizeof quoted, "\"", words, "\"", (char *)NULL), width);
}

void table_put_design(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                      const char *why)
{
    char number[FORMAT_SIZE];
    unsigned long i;

    (void)why; /* an output without a value is nan */
    line_field(&s->l, format_fixed((double)s->design, 0, number), 10);
    for (i = 0; i < s->n_variables; i++)
        put_number(s, s->varied[i]);
    put_quoted(s, fourlink_branch_text((int)branch), 10);
    for (i = 0; i < s->n_header; i++)
        if (!outputs[i].has_value) {
            line_field(&s->l, "nan", WIDTH);
        } else if (outputs[i].v.words) {
            line_put(&s->l, "  ");
            put_quoted(s, outputs[i].v.words, WIDTH - 2);
        } else {
            put_number(s, outputs[i].v.value);
        }
    line_put(&s->l, "\n");
}

void table_refuse(sheet *s, const char *why)
{
    if (!s->design) {
        sheet_write_gap(s);
        line_put(&s->l, "# bad deck: %s\n# score: 0\n", why);
        s->n_written++;
        return;
    }
    if (s->content == SHEET_ROWS)
        sheet_write_gap(s);
    table_put_design_comment(s);
    line_put(&s->l, "# %s\n", why);
}
