/* SPDX-License-Identifier: GPL-3.0-or-later
**
** summary.c - a summary in the format table: inputs, results, extremes of columns, a line each.
**
** Lines are 100 columns wide, or as a terminal: there long meanings are broken; all are left out where it is
** narrow.  Most fit 80 columns.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "sheet.h"
#include "summary.h"
#include "head.h"
#include "view/rounding.h"

#define LINE 100
#define NAME 20
#define UNIT 6
#define BRANCH 8         /* of extremes */
#define LEAST_MEANING 20 /* letters of it in a line */
#define MEANING 200

/* Of extremes, so that those with 17 digits fit the line. */
#define EXTREME_NAME 15
#define EXTREME_ANGLE 10
#define EXTREME_DIGITS 7 /* of an angle, at most */

/* The columns that a number may take: sign, point and exponent beside its digits. */
static size_t width_of_value(const sheet *s)
{
    return (size_t)s->v.problem.digits + 7;
}

/* Write a number in a field, of which the name before it has taken some; returns the columns used. */
static size_t put_number(sheet *s, double value, int digits, size_t taken)
{
    size_t width = width_of_value(s);

    return line_value(&s->l, value, digits, width - GSL_MIN(taken, width));
}

/* Write name, value and unit; returns the columns used. */
static size_t put_value(sheet *s, const fourlink_value *f)
{
    size_t excess = line_left(&s->l, f->name, NAME);
    size_t used = NAME + excess + put_number(s, f->value, s->v.problem.digits, excess);

    line_put(&s->l, " ");
    return used + 1 + UNIT + line_left(&s->l, f->unit, UNIT);
}

static const char *name_of_branch(int branch)
{
    return branch ? fourlink_branch_text(branch) : "";
}

/* Words follow the name, and end the line. */
static void put_words(sheet *s, const fourlink_value *f)
{
    size_t start = line_here(&s->l);

    line_left(&s->l, f->name, NAME);
    line_put(&s->l, "  %s%s%s", f->words, f->branch ? ", " : "", name_of_branch(f->branch));
    line_finish(&s->l, start, s->width, NAME + 2);
}

/* A meaning for which the line has no room is left out: --list has it. */
static void put_meaning(sheet *s, size_t start, size_t used, const char *meaning)
{
    size_t width = s->width ? s->width : LINE;

    if (used + 1 + (s->width ? LEAST_MEANING : strlen(meaning)) <= width)
        line_put(&s->l, " %s", meaning);
    line_finish(&s->l, start, s->width, used + 1);
}

static void put_input(sheet *s, const fourlink_value *input)
{
    size_t start = line_here(&s->l);

    if (input->words)
        put_words(s, input);
    else
        put_meaning(s, start, put_value(s, input), input->meaning);
}

/* Returns the columns used. */
static size_t put_heading(sheet *s, const char *name)
{
    line_left(&s->l, name, NAME);
    line_field(&s->l, "value", width_of_value(s));
    line_put(&s->l, " ");
    line_left(&s->l, "unit", UNIT);
    return NAME + width_of_value(s) + 1 + UNIT;
}

void summary_put_inputs(sheet *s)
{
    size_t start;

    head_put_title(s);
    head_put_kind(s);
    start = line_here(&s->l);
    put_meaning(s, start, put_heading(s, "# input"), "meaning");
    sheet_write_inputs(s, put_input);
    start = line_here(&s->l);
    put_meaning(s, start, put_heading(s, "# result"),
                s->v.n_branches > 1                 ? "meaning"
                : s->v.branches[0] == FOURLINK_OPEN ? "meaning, on the open branch"
                                                    : "meaning, on the crossed branch");
}

/* What a fact means; where there are two branches, of which; its crank angle. */
static const char *meaning_of(const sheet *s, const fourlink_value *f, char out[MEANING])
{
    const char *branch = s->v.n_branches > 1 ? name_of_branch(f->branch) : "";
    char number[FORMAT_SIZE];

    return flk_text_join(
        out, MEANING, f->meaning, *branch ? ", " : "", branch, f->has_angle ? ", at " : "",
        f->has_angle ? format_general(f->angle, s->v.problem.digits, number) : "",
        f->has_angle ? " " : "", f->has_angle ? s->v.units[QUANTITY_ANGLE].name : "", (char *)NULL);
}

void summary_put_fact(sheet *s, const fourlink_value *f)
{
    size_t start = line_here(&s->l);
    char meaning[MEANING];

    if (f->words)
        put_words(s, f);
    else
        put_meaning(s, start, put_value(s, f), meaning_of(s, f, meaning));
}

/* A measure of rounding has no angle, and two digits. */
static void put_extreme(sheet *s, const fourlink_value *f, int digits, size_t taken)
{
    fourlink_value x = view_settled(&s->v, f);

    put_number(s, x.value, digits, taken);
    if (x.has_angle)
        line_value(&s->l, x.angle, GSL_MIN(digits, EXTREME_DIGITS), EXTREME_ANGLE);
    else
        line_field(&s->l, "", EXTREME_ANGLE);
}

/* Go on in a second line where a terminal has no room for both extremes; returns the line's beginning. */
static size_t put_gap(sheet *s, size_t start)
{
    size_t width = EXTREME_NAME + 2 * (width_of_value(s) + EXTREME_ANGLE) + UNIT + BRANCH;

    if (!s->width || s->width >= width)
        return start;
    line_finish(&s->l, start, s->width, EXTREME_NAME);
    start = line_here(&s->l);
    line_left(&s->l, "", EXTREME_NAME);
    return start;
}

/* The heading of crank angles: at deg. */
static const char *at_unit(const sheet *s, char at[FORMAT_SIZE])
{
    return flk_text_join(at, FORMAT_SIZE, "at ", s->v.units[QUANTITY_ANGLE].name, (char *)NULL);
}

static void put_heading_of_extremes(sheet *s)
{
    size_t start = line_here(&s->l);
    char at[FORMAT_SIZE];

    line_left(&s->l, "# column", EXTREME_NAME);
    line_field(&s->l, "min", width_of_value(s));
    line_field(&s->l, at_unit(s, at), EXTREME_ANGLE);
    start = put_gap(s, start);
    line_field(&s->l, "max", width_of_value(s));
    line_field(&s->l, at, EXTREME_ANGLE);
    line_put(&s->l, " unit   branch");
    line_finish(&s->l, start, s->width, EXTREME_NAME);
}

void summary_put_extremes(sheet *s, const fourlink_value *column, const fourlink_value *least,
                          const fourlink_value *most, int branch)
{
    int digits = column->flags & FOURLINK_OF_ROUNDING ? 2 : s->v.problem.digits;
    size_t start;

    if (!s->list)
        put_heading_of_extremes(s);
    s->list = "extremes";
    start = line_here(&s->l);
    put_extreme(s, least, digits, line_left(&s->l, column->name, EXTREME_NAME));
    start = put_gap(s, start);
    put_extreme(s, most, digits, 0);
    line_put(&s->l, " %-6s %s", column->unit, name_of_branch(branch));
    line_finish(&s->l, start, s->width, EXTREME_NAME);
}
