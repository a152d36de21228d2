/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table_statistics.c - the statistics of a sweep in the format table: a line of numbers for each output and
** branch, under a comment that names them.
*/
#include <gsl/gsl_math.h>

#include "table.h"

#define WIDTH 12

static void put_number(sheet *s, double value)
{
    char number[FORMAT_SIZE];

    format_general(value + 0.0, s->problem.digits ? s->problem.digits : 6, number);
    line_field(&s->l, gsl_isnan(value) ? "nan" : number, WIDTH);
}

static void put_heading(sheet *s)
{
    static const char *const names[] = {"mean", "std_dev", "min",  "5 %", "25 %",
                                        "50 %", "75 %",    "95 %", "max"};
    size_t i;

    line_put(&s->l, "#  count");
    for (i = 0; i < sizeof names / sizeof names[0]; i++)
        line_field(&s->l, names[i], WIDTH);
    line_put(&s->l, "\n");
    s->list = "statistics";
}

void table_put_statistic(sheet *s, const sheet_statistic *x)
{
    char number[FORMAT_SIZE];
    int i;

    if (!s->list)
        put_heading(s);
    line_put(&s->l, "# %s%s%s%s, %s branch\n", x->output->name, x->output->unit[0] ? " (" : "",
             x->output->unit, x->output->unit[0] ? ")" : "", fourlink_branch_text((int)x->branch));
    line_field(&s->l, format_fixed((double)x->count, 0, number), 8);
    put_number(s, x->mean);
    put_number(s, x->deviation);
    put_number(s, x->least);
    for (i = 0; i < SHEET_QUANTILES; i++)
        put_number(s, x->quantiles[i]);
    put_number(s, x->most);
    line_put(&s->l, "\n");
}

void table_put_yield(sheet *s, const sheet_yield *y)
{
    line_put(&s->l,
             "# yield, %s branch: %4g %s (95 %s interval %4g to %4g %s), %lu of %lu designs: %s\n",
             fourlink_branch_text((int)y->branch), y->percent, "%", "%", y->low, y->high, "%",
             y->passed, y->designs, y->condition);
}
