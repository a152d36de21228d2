/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table.c - the format table: aligned columns, with everything but numbers on lines that begin with #.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "base/units.h"
#include "table.h"

/* How the numbers of a column are written, so that they are aligned. */
typedef struct style {
    int decimals;
    int exponent; /* 1: as 1.2e-16 */
    size_t width;
    double limit; /* numbers below it fit the width, with a sign and a blank */
    double size;  /* the largest magnitude of the column */
    int has_extreme;
    fourlink_value extreme; /* the last one found */
} style;

#define SAMPLES 200

/* The largest magnitude of each column, in rows spread evenly over the motion; 0 if it is only rounding
** compared with other columns of the same quantity. */
static void find_sizes(sheet *s, style *styles)
{
    unsigned long n_rows = s->problem.n_rows, samples = n_rows < SAMPLES ? n_rows : SAMPLES, k, j;
    double of_quantity[QUANTITY_COUNT] = {0};
    fourlink_branch branches[2];
    int n = sheet_branches(s, branches), i;

    for (j = 0; j < s->n_columns; j++)
        styles[j].size = 0;
    for (i = 0; i < n; i++)
        for (k = 0; k < samples; k++) {
            double share = samples > 1 ? (double)k / (double)(samples - 1) : 0;

            fourlink_results_row(s->results, branches[i],
                                 (unsigned long)(share * (double)(n_rows - 1) + 0.5), s->values,
                                 NULL, NULL);
            for (j = 0; j < s->n_columns; j++)
                if (fabs(s->values[j]) > styles[j].size)
                    styles[j].size = fabs(s->values[j]);
        }
    for (j = 0; j < s->n_columns; j++) {
        double *largest = &of_quantity[flk_quantity_find(s->columns[j].quantity)];

        *largest = GSL_MAX_DBL(*largest, styles[j].size);
    }
    for (j = 0; j < s->n_columns; j++)
        if (styles[j].size <= 1e-12 * of_quantity[flk_quantity_find(s->columns[j].quantity)])
            styles[j].size = 0;
}

/* The number of decimals that writes every crank angle exactly, if it is small. */
static int decimals_of_angle(const sheet *s, int otherwise)
{
    const fourlink_motion *motion = &s->problem.motion;
    double last = motion->from, step = 1;
    fourlink_row row;
    int decimals;

    if (!s->range.stops && fourlink_motion_row(motion, &s->range, s->range.n_rows - 1, &row) == 0)
        last = row.angle;
    for (decimals = 0; decimals < otherwise; decimals++, step *= 10) {
        double x = motion->from * step, y = last * step, z = motion->interval * step;

        if (fabs(x - floor(x + 0.5)) < 1e-9 && fabs(y - floor(y + 0.5)) < 1e-9 &&
            fabs(z - floor(z + 0.5)) < 1e-9)
            return decimals;
    }
    return otherwise;
}

static void find_style(const sheet *s, const fourlink_value *c, style *x)
{
    char number[FORMAT_SIZE];
    size_t width;

    x->exponent = x->size > 0 && (x->size < 1e-6 || x->size >= 1e9);
    x->decimals = s->problem.digits - 1;
    if (c->flags & FOURLINK_OF_ROUNDING) {
        x->exponent = 1;
        x->decimals = 1;
    } else if (!x->exponent && x->size > 0) {
        x->decimals -= (int)floor(log10(x->size));
        if (x->decimals < 0)
            x->decimals = 0;
        if (c->flags & FOURLINK_CRANK_ANGLE)
            x->decimals = decimals_of_angle(s, x->decimals);
    }
    if (x->exponent)
        width = strlen(format_exponent(-1, x->decimals, number));
    else
        width = strlen(format_fixed(-x->size, x->decimals, number));
    if (strlen(c->name) > width)
        width = strlen(c->name);
    if (strlen(c->unit) > width)
        width = strlen(c->unit);
    x->width = width + 2;
    x->limit = x->exponent ? 0 : pow(10, (double)x->width - x->decimals - 3) - 1;
}

/* The text of a cell and its end.  A number that prints as 0 has no sign. */
static const char *cell_text(double value, const style *x, char out[FORMAT_SIZE], const char **end)
{
    const char *c = out + 1;

    if (x->exponent)
        *end = format_exponent_end(value + 0.0, x->decimals, out); /* -0 + 0 is 0 */
    else
        *end = format_fixed_end(value, x->decimals, out);
    if (out[0] != '-')
        return out;
    while (*c == '0' || *c == '.')
        c++;
    return c == *end ? out + 1 : out;
}

static void put_cell(line *l, double value, const style *x, size_t width)
{
    char number[FORMAT_SIZE];
    const char *end, *cell = cell_text(value, x, number, &end);

    line_right(l, cell, (size_t)(end - cell), width);
}

static void open_deck(sheet *s)
{
    style *styles = s->layout;
    unsigned long j;

    sheet_write_gap(s);
    if (s->design)
        table_put_design_comment(s);
    if (s->content == SHEET_ROWS) {
        find_sizes(s, styles);
        for (j = 0; j < s->n_columns; j++)
            find_style(s, &s->columns[j], &styles[j]);
    }
    table_put_head(s);
}

/* Write the names or units of the columns as a comment. */
static void put_names(sheet *s, int units)
{
    const style *styles = s->layout;
    unsigned long j;

    line_put(&s->l, "#");
    for (j = 0; j < s->n_columns; j++)
        line_field(&s->l, units ? s->columns[j].unit : s->columns[j].name,
                   styles[j].width - (j == 0));
    line_put(&s->l, "\n");
}

static void find_extreme(sheet *s, fourlink_branch branch, int sign, const fourlink_value *c,
                         style *x)
{
    char name[80];

    flk_text_join(name, sizeof name, sign > 0 ? "max(" : "min(", c->name, ")", (char *)NULL);
    x->has_extreme =
        !(c->flags & FOURLINK_CRANK_ANGLE) &&
        fourlink_results_value(s->results, name, branch, 0, &x->extreme) == FOURLINK_OK;
}

/* Write the extremes of the columns and their crank angles as comments above the rows. */
static void put_extremes(sheet *s, fourlink_branch branch)
{
    static const style angle = {3, 0, 0, 0, 0, 0, {0}};
    style *styles = s->layout;
    int sign, at_angle;
    unsigned long j;

    for (sign = 1; sign >= -1; sign -= 2) {
        for (j = 0; j < s->n_columns; j++)
            find_extreme(s, branch, sign, &s->columns[j], &styles[j]);
        for (at_angle = 0; at_angle < 2; at_angle++) {
            line_put(&s->l, "#");
            for (j = 0; j < s->n_columns; j++) {
                const style *x = &styles[j];
                size_t width = x->width - (j == 0);

                if (x->has_extreme && at_angle && x->extreme.has_angle)
                    put_cell(&s->l, x->extreme.angle, &angle, width);
                else if (x->has_extreme && !at_angle && sheet_is_finite(&x->extreme))
                    put_cell(&s->l, x->extreme.value, x, width);
                else
                    line_field(&s->l, x->has_extreme && !at_angle ? "none" : "", width);
            }
            line_put(&s->l, at_angle ? "  at theta2\n" : sign > 0 ? "  max\n" : "  min\n");
        }
    }
}

static void put_block(sheet *s, fourlink_branch branch)
{
    line_put(&s->l, "%s# branch: %s\n", s->list ? "\n\n" : "", fourlink_branch_text((int)branch));
    s->list = "branches";
    put_names(s, 0);
    put_names(s, 1);
    if (s->problem.n_rows > 1 && !s->design) /* a sweep prints max() and min() only on request */
        put_extremes(s, branch);
}

static void put_reason(sheet *s, const sheet_row *row)
{
    if (row->at)
        line_put(&s->l, "# theta2 = %12g %s: %s\n", row->at->row.angle, s->angle_unit, row->status);
    else
        line_put(&s->l, "# %s\n", row->status);
}

static void put_row(sheet *s, const sheet_row *row)
{
    const style *styles = s->layout;
    unsigned long j;

    if (row->at && row->at->status == FOURLINK_OK) {
        for (j = 0; j < s->n_columns; j++)
            if (!(fabs(row->values[j]) < styles[j].limit) ||
                !line_fixed(&s->l, row->values[j], styles[j].decimals, styles[j].width))
                put_cell(&s->l, row->values[j], &styles[j], styles[j].width);
        line_text(&s->l, "\n", 1);
    }
    if (!row->is_ordinary)
        put_reason(s, row);
}

const sheet_format table_format = {
    "table",                        /* name */
    (1 << SHEET_CONTENT_COUNT) - 1, /* writes */
    table_begin,                    /* begin */
    open_deck,                      /* open */
    table_put_column,               /* column */
    table_put_fact,                 /* fact */
    put_block,                      /* block */
    put_row,                        /* row */
    table_put_check,                /* check */
    table_put_design,               /* design */
    table_refuse,                   /* refuse */
    table_close,                    /* close */
    sizeof(style),                  /* layout_size */
    0,                              /* is_by_angle */
    table_put_statistic,            /* statistic */
    table_put_yield                 /* yield */
};
