/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table_lines.c - the parts of the format table that are lines of text: facts, lists, comparisons, designs.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "sheet.h"
#include "table_lines.h"
#include "summary.h"
#include "head.h"

/* The text after a value: a blank and the unit, or nothing for a plain number. */
static const char *blank(const char *name)
{
    return strcmp(name, "1") == 0 ? "" : " ";
}

static const char *unit_after(const char *name)
{
    return strcmp(name, "1") == 0 ? "" : name;
}

#define LIST_WIDTH 118

/* A line of a list; on a narrow terminal the sources stand behind the meaning, which goes on below itself. */
static void put_entry(sheet *s, const char *name, const char *unit_name, const char *meaning,
                      const char *source)
{
    int is_narrow = s->width && s->width < LIST_WIDTH;
    size_t start = line_here(&s->l);

    line_put(&s->l, "%-18s %-8s ", name, unit_name);
    line_put(&s->l, !*source ? "%s" : is_narrow ? "%s; %s" : "%-60s %s", meaning, source);
    line_finish(&s->l, start, s->width, 28);
}

/* ------------------------------------------------------------------------------ lists, comparisons */

void table_put_list_head(sheet *s)
{
    put_entry(s, "column", "unit", "meaning", "in the sources");
}

void table_put_listed(sheet *s, const fourlink_value *f)
{
    if (!s->list) {
        line_put(&s->l, "\n");
        put_entry(s, "fact", "unit", "meaning", "");
    }
    s->list = "facts";
    put_entry(s, f->name, f->unit, f->meaning, "");
}

void table_put_column(sheet *s, const fourlink_value *c)
{
    put_entry(s, c->name, c->unit, c->meaning, c->source);
}

#define NARROW 80 /* no room beside the longest verdict for a long path */

void table_put_check(sheet *s, const fourlink_check *c)
{
    size_t start = line_here(&s->l);

    line_put(&s->l, "%-18s %s:%lu: %s = %s", sheet_verdicts[c->verdict], c->file,
             (unsigned long)c->line, c->name, c->printed_text);
    if (c->words[0])
        line_put(&s->l, ", computed %s", c->words);
    else if (c->verdict != FOURLINK_NO_VALUE)
        line_put(&s->l, ", computed %12g%s%s", c->computed, blank(c->unit), unit_after(c->unit));
    if (c->has_place)
        line_put(&s->l, " at %9g %s", c->place, c->place_unit);
    else if (c->has_angle)
        line_put(&s->l, " at %9g %s", c->angle, s->v.units[QUANTITY_ANGLE].name);
    line_put(&s->l, ", %s", fourlink_branch_text((int)c->branch));
    if (c->side)
        line_put(&s->l, ", %s", fourlink_input_side_text(c->side));
    if (c->hint[0])
        line_put(&s->l, "; hint: %s", c->hint);
    line_finish(&s->l, start, s->width, s->width < NARROW ? 4 : 19);
}

/* Write the counts of this deck's comparisons, and its score. */
void table_close_checks(sheet *s)
{
    static const fourlink_verdict order[] = {FOURLINK_AGREES, FOURLINK_MISPRINT, FOURLINK_DIFFERS,
                                             FOURLINK_NO_MISPRINT, FOURLINK_NO_VALUE};
    size_t start;
    int i;

    start = line_here(&s->l);
    for (i = 0; i < 5; i++)
        line_put(&s->l, "%s%s: %lu", i ? ", " : "# ", sheet_verdicts[order[i]],
                 s->checks[order[i]]);
    line_finish(&s->l, start, s->width, 2);
    line_put(&s->l, "# score: %12g of %12g\n", s->right, s->of);
    if (s->mark && s->mark->note[0])
        line_put(&s->l, "# note: %s\n", s->mark->note);
}

void table_put_mark(sheet *s, const sheet_mark *m)
{
    char number[FORMAT_SIZE];

    line_put(&s->l, "%-30s", m->name);
    line_value(&s->l, m->right, 6, 7);
    line_value(&s->l, m->of, 6, 7);
    line_field(&s->l, format_fixed(sheet_percent(m), 1, number), 10);
    if (s->has_roster) {
        line_value(&s->l, m->late, 6, 7);
        line_value(&s->l, m->total, 6, 8);
    }
    line_put(&s->l, *m->note ? "  %s\n" : "%s\n", m->note);
}

/* ------------------------------------------------------------------------------------------- designs */

#define WIDTH 16 /* of a column, at least */
#define ALL 17   /* digits of a whole number */

static size_t width_of(const char *name)
{
    size_t n = strlen(name) + 2;

    return n < WIDTH ? WIDTH : n;
}

/* The line of names, or of units. */
static void put_heading(sheet *s, int units)
{
    unsigned long i;

    line_put(&s->l, "#");
    line_field(&s->l, units ? "" : s->each ? s->each : "design", 9);
    for (i = 0; i < s->n_variables; i++)
        line_field(&s->l, units ? s->variables[i].unit : s->variables[i].name,
                   width_of(s->variables[i].name));
    line_put(&s->l, units ? "          " : "    branch");
    for (i = 0; i < s->n_header; i++)
        line_field(&s->l, units ? s->header[i].unit : s->header[i].name,
                   width_of(s->header[i].name));
    line_put(&s->l, "\n");
}

#define LINE 100

/* The types that designs of this kind can have, in lines of 100 columns. */
static void put_types(sheet *s)
{
    char type[FORMAT_SIZE], number[FORMAT_SIZE];
    size_t used = 0;
    int i;

    for (i = FOURLINK_CRANK_ROCKER; i < FOURLINK_TYPE_END_; i++) {
        if (!fourlink_has_type((int)s->v.kind.kind, i))
            continue;
        flk_text_join(type, sizeof type, " ", format_fixed(i, 0, number), " ",
                      fourlink_type_text(i), (char *)NULL);
        line_put(&s->l, !used ? "# type:" : used + strlen(type) >= LINE ? ";\n#      " : ";");
        used = !used || used + strlen(type) >= LINE ? sizeof "# type:" : used;
        line_put(&s->l, "%s", type);
        used += strlen(type) + 1;
    }
    line_put(&s->l, "\n");
}

static void put_defects(sheet *s)
{
    char number[FORMAT_SIZE];
    int bit;

    for (bit = 1; bit <= FOURLINK_DEFECT_MISSED; bit *= 2)
        line_put(&s->l, "%s %s %s",
                 bit > 1 ? ";" : "# defects, added:", format_fixed(bit, 0, number),
                 fourlink_defect_text(bit));
    line_put(&s->l, "\n");
}

/* Words of a sweep are in the head, so that each line of a design has numbers alone. */
static void put_legend(sheet *s)
{
    static const int branches[] = {FOURLINK_OPEN, FOURLINK_CROSSED};
    char number[FORMAT_SIZE];
    unsigned long j;
    int i;

    for (i = 0; i < 2; i++)
        line_put(&s->l, "%s %s %s", i ? ";" : "# branch:", format_fixed(branches[i], 0, number),
                 fourlink_branch_text(branches[i]));
    line_put(&s->l, "\n");
    for (j = 0; j < s->n_header; j++)
        if (strcmp(s->header[j].name, "type") == 0)
            put_types(s);
        else if (strcmp(s->header[j].name, "defects") == 0)
            put_defects(s);
}

#define DESIGN 8 /* columns of its number */

/* The line of names, or of units, of values of decks. */
static void put_value_heading(sheet *s, int units)
{
    unsigned long i;

    line_put(&s->l, units ? "#        " : "# branch ");
    if (s->has_designs)
        line_field(&s->l, units ? "" : "design", DESIGN);
    for (i = 0; i < s->n_header; i++)
        line_field(&s->l, units ? s->header[i].unit : s->header[i].name,
                   width_of(s->header[i].name));
    line_put(&s->l, s->n_decks > 1 && !units ? "  deck\n" : "\n");
}

/* Say why a line lacks values, such as those of a row which the motion does not reach. */
static void put_why_lacking(sheet *s, fourlink_branch branch, const sheet_output *outputs)
{
    unsigned long i;

    for (i = 0; i < s->n_header; i++)
        if (outputs[i].why)
            line_put(&s->l, "# %s: %s: %s\n", fourlink_branch_text((int)branch), s->header[i].name,
                     outputs[i].why);
}

/* A line of values; what a deck does not have is nan, or in another unit. */
void table_put_values(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                      const char *why)
{
    unsigned long i;

    (void)why; /* of the line */
    line_put(&s->l, " %-8s", branch ? fourlink_branch_text((int)branch) : "");
    if (s->has_designs && s->design)
        line_value(&s->l, (double)s->design, ALL, DESIGN);
    else if (s->has_designs)
        line_field(&s->l, "-", DESIGN);
    for (i = 0; i < s->n_header; i++) {
        size_t width = width_of(s->header[i].name);

        if (outputs && outputs[i].has_value && outputs[i].v.words)
            line_field(&s->l, outputs[i].v.words, width);
        else if (outputs && outputs[i].is_other)
            line_field(&s->l, "", width);
        else
            line_value(&s->l, outputs && outputs[i].has_value ? outputs[i].v.value : GSL_NAN,
                       outputs ? s->v.problem.digits : 1, width);
    }
    if (s->deck_name) {
        line_put(&s->l, "  ");
        line_words(&s->l, s->deck_name, strlen(s->deck_name));
    }
    line_put(&s->l, "\n");
    if (outputs)
        put_why_lacking(s, branch, outputs);
}

void table_begin_values(sheet *s)
{
    put_value_heading(s, 0);
    put_value_heading(s, 1);
}

void table_begin_scores(sheet *s)
{
    line_put(&s->l, "# %-28s  right     of  per cent%s  note\n", "name",
             s->has_roster ? "   late   total" : "");
}

void table_begin_designs(sheet *s)
{
    head_put_title(s);
    put_legend(s);
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

void table_put_design(sheet *s, fourlink_branch branch, const sheet_output *outputs,
                      const char *why)
{
    int digits = s->v.problem.digits;
    unsigned long i;

    (void)why; /* an output without a value is nan */
    line_value(&s->l, (double)s->design, ALL, 10);
    for (i = 0; i < s->n_variables; i++)
        line_value(&s->l, s->varied[i], digits, width_of(s->variables[i].name));
    line_value(&s->l, (double)branch, ALL, 10);
    for (i = 0; i < s->n_header; i++)
        line_value(&s->l, outputs[i].has_value ? outputs[i].v.value : GSL_NAN, digits,
                   width_of(s->header[i].name)); /* of words, their number */
    line_put(&s->l, "\n");
}

void table_refuse_values(sheet *s, const char *why)
{
    table_put_values(s, (fourlink_branch)0, NULL, why);
}

void table_refuse_rows(sheet *s, const char *why)
{
    sheet_write_gap(s);
    table_refuse(s, why);
}

void table_refuse(sheet *s, const char *why)
{
    if (!s->design) {
        sheet_write_gap(s);
        if (s->mark)
            line_put(&s->l, "# bad answers: %s\n# score: 0 of %12g\n", why, s->mark->of);
        else
            line_put(&s->l, "# bad deck: %s\n# score: 0\n", why);
        s->n_written++;
        return;
    }
    table_put_design_comment(s);
    line_put(&s->l, "# %s\n", why);
}
