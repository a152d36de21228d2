/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table_statistics.c - the statistics of a sweep in the format table: a line of numbers for each output and
** branch, under a comment that names them.
*/
#include <string.h>

#include "table.h"

#define USUAL_DIGITS 6
#define LEAST_DIGITS 4
#define WIDTH 10 /* of a column, so that a line has 98 characters */

/* The columns of more digits than usual are as wide as these can be, with sign, point and exponent. */
static size_t width_of(const sheet *s)
{
    return s->v.problem.digits > USUAL_DIGITS ? (size_t)s->v.problem.digits + 8 : WIDTH;
}

/* A number has fewer digits if the column then has room for it, but not fewer than 4; if that is not
** enough, it has all, and the line is longer. */
static void put_number(sheet *s, double value)
{
    int all = s->v.problem.digits, digits = all;
    char number[FORMAT_SIZE];

    format_general(value, digits, number);
    while (strlen(number) >= width_of(s) && --digits >= LEAST_DIGITS)
        format_general(value, digits, number);
    if (digits < LEAST_DIGITS)
        format_general(value, all, number);
    line_field(&s->l, number, width_of(s));
}

static void put_heading(sheet *s)
{
    int i;

    line_put(&s->l, "#  count");
    for (i = 0; i < SHEET_STATISTICS_COUNT; i++)
        line_field(&s->l, sheet_statistic_names[i], width_of(s));
    line_put(&s->l, "\n");
    s->list = "statistics";
}

void table_put_statistic(sheet *s, const sheet_statistic *x)
{
    int i;

    if (!s->list)
        put_heading(s);
    line_put(&s->l, "# %s%s%s%s, %s branch\n", x->output->name, x->output->unit[0] ? " (" : "",
             x->output->unit, x->output->unit[0] ? ")" : "", fourlink_branch_text((int)x->branch));
    line_value(&s->l, (double)x->count, 17, 8);
    for (i = 0; i < SHEET_STATISTICS_COUNT; i++)
        put_number(s, x->values[i]);
    line_put(&s->l, "\n");
}

void table_put_yield(sheet *s, const sheet_yield *y)
{
    line_put(&s->l,
             "# yield, %s branch: %4g %s (95 %s interval %4g to %4g %s), %lu of %lu designs: %s\n",
             fourlink_branch_text((int)y->branch), y->percent, "%", "%", y->low, y->high, "%",
             y->passed, y->designs, y->condition);
}
