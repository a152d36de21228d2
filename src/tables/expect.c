/* SPDX-License-Identifier: GPL-3.0-or-later
**
** expect.c - a deck's values as [expect] sections, for --check.
**
** A value without a tolerance agrees within half of its last digit.  All values of a column have the
** same last digit, chosen so that this is 0.05 to 0.5 per cent of the column's largest value: near its
** zeros a column is not asked for more than elsewhere.  With [grading] the last digit does not matter.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "content.h"
#include "head.h"
#include "style.h"
#include "view/results.h"

/* rad: nearer to a dead position values say nothing about the size of a column. */
#define SOUND 0.17

/* Of a value whose tolerance is that of [grading]. */
#define GRADED_DIGITS 6

/* Not the crank angle, which is `at`; not the time, which an angle can have twice; not rounding. */
static int is_asked(const fourlink_value *column)
{
    return !(column->flags & (FOURLINK_CRANK_ANGLE | FOURLINK_OF_ROUNDING)) &&
           strcmp(column->quantity, "time") != 0;
}

/* A value is divided by 10^exponent. */
static void find_style(style *x)
{
    double size = x->size > 0 ? x->size : 1;

    x->decimals = (int)ceil(-log10(0.01 * size) - 1e-9);
    x->exponent = x->decimals < 0 || size < 1e-4 ? 3 * (int)floor(log10(size) / 3) : 0;
    x->decimals += x->exponent;
}

/* A name without its value; its unit is a comment, so that an empty line is no answer. */
static void put_form_name(sheet *s, const char *name, const char *unit_name)
{
    int has_unit = *unit_name && strcmp(unit_name, "1") != 0;

    line_put(&s->l, "%s = %s%s\n", name, has_unit ? "          # " : "", has_unit ? unit_name : "");
}

static void put_value(sheet *s, const fourlink_value *column, const style *x, double value)
{
    char number[FORMAT_SIZE];

    if (s->is_form) {
        put_form_name(s, column->name, column->unit);
        return;
    }
    if (!gsl_finite(value)) {
        line_put(&s->l, "# %s is %s here\n", column->name,
                 gsl_isnan(value) ? "not defined" : "unbounded");
        return;
    }
    line_put(&s->l, "%s = %s", column->name,
             s->v.problem.is_graded
                 ? format_general(value, GRADED_DIGITS, number)
                 : format_fixed(value / pow(10, x->exponent), x->decimals, number));
    if (x->exponent && !s->v.problem.is_graded)
        line_put(&s->l, "e%s", format_fixed(x->exponent, 0, number));
    line_put(&s->l, strcmp(column->unit, "1") == 0 ? "\n" : " %s\n", column->unit);
}

/* The values at a place, in a unit. */
static void put_section(sheet *s, fourlink_branch branch, int side, double place, const char *of,
                        int status)
{
    const style *styles = s->layout;
    unsigned long j;

    if (status != FOURLINK_OK) {
        line_put(&s->l, "\n# at %15g %s, %s: %s\n", place, of, fourlink_branch_text((int)branch),
                 fourlink_status_text(status));
        s->failed += !view_goes_to(&s->v, status);
        return;
    }
    line_put(&s->l, "\n[expect]\n");
    /* The instant of an input may be given by its crank angle. */
    if (s->at || !s->v.problem.one_instant || !s->v.problem.is_prescribed)
        line_put(&s->l, "at = %15g %s\n", place, of);
    line_put(&s->l, "branch = %s\n", fourlink_branch_text((int)branch));
    if (side)
        line_put(&s->l, "side = %s\n", fourlink_input_side_text(side));
    for (j = 0; j < s->v.n_columns; j++)
        if (is_asked(&s->v.columns[j]))
            put_value(s, &s->v.columns[j], &styles[j], s->values[j]);
}

static void put_at(sheet *s, fourlink_branch branch, const view_spot *spot)
{
    fourlink_instant at;

    put_section(s, branch, spot->side, spot->at,
                s->v.units[spot->is_place ? s->v.over : QUANTITY_ANGLE].name,
                sheet_find_at(s, branch, spot, &at));
}

/* A revolution at constant speed ends with its first row again. */
static void write_rows(sheet *s, fourlink_branch branch)
{
    unsigned long n = s->v.problem.n_rows, k;
    fourlink_instant now;
    int status;

    for (k = 0; k < (view_repeats(&s->v) && n > 1 ? n - 1 : n); k++) {
        status = fourlink_results_row(s->v.results, branch, k, s->values, &now, NULL);
        put_section(s, branch, view_side_of_row(&s->v, k), now.row.place, s->v.problem.over.unit,
                    status);
        if (sheet_is_over(s, &now))
            break;
    }
}

/* --------------------------------------------------------------------------------------------- a form */

/* Begin a section of a form. */
static void put_form_place(sheet *s, const fourlink_check *c)
{
    line_put(&s->l, "\n[expect]\n");
    if (c->has_angle)
        line_put(&s->l, "at = %15g %s\n", c->has_place ? c->place : c->angle,
                 c->has_place ? c->place_unit : s->v.units[QUANTITY_ANGLE].name);
    line_put(&s->l, "branch = %s\n", fourlink_branch_text((int)c->branch));
    if (c->side)
        line_put(&s->l, "side = %s\n", fourlink_input_side_text(c->side));
}

/* What the deck's own [expect] asks. */
static void write_asked(sheet *s)
{
    fourlink_check c, before;
    unsigned long i, n = 0;

    memset(&before, 0, sizeof before);
    for (i = 0; i < s->v.problem.n_expected; i++) {
        if (!results_check(s->v.results, i, &c))
            return;
        if (c.is_misprint)
            continue; /* not asked for */
        if (!n++ || c.has_angle != before.has_angle || c.angle != before.angle ||
            c.has_place != before.has_place || c.place != before.place ||
            c.branch != before.branch || c.side != before.side)
            put_form_place(s, &c);
        put_form_name(s, c.name, c.unit);
        before = c;
    }
}

static void write_form(sheet *s)
{
    head_put_title(s);
    line_put(&s->l, "# Write each value behind its = sign, with its unit.\n");
    if (s->v.problem.n_expected)
        write_asked(s);
}

void expect_write(sheet *s)
{
    style *styles = s->layout;
    int i;
    unsigned long j;

    if (s->is_form)
        write_form(s);
    if (s->is_form && s->v.problem.n_expected)
        return;
    style_find_sizes(&s->v, SOUND, 1, s->values, styles);
    for (j = 0; j < s->v.n_columns; j++)
        find_style(&styles[j]);
    if (s->v.problem.is_graded && !s->is_form)
        line_put(&s->l, "# Values agree within the tolerances of [grading].\n");
    else if (!s->is_form)
        line_put(
            &s->l,
            "# Values agree within half of their last digit.  For another tolerance add a line "
            "such as\n# 'tolerance = 1 %s' to a section.\n",
            "%");
    for (i = 0; i < s->v.n_branches; i++)
        if (s->at)
            sheet_for_each_at(s, s->v.branches[i], put_at);
        else
            write_rows(s, s->v.branches[i]);
}
