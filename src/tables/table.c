/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table.c - rows to text: the format table.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "results/extreme.h"
#include "results/fact.h"
#include "base/format.h"
#include "print.h"
#include "table.h"

/* How the numbers of a column are written: all alike, so that they stand under each other. */
typedef struct style {
    int decimals;
    int exponent; /* 1: as 1.2e-16 */
    size_t width;
    double limit;         /* a number below it has room in the width, with a sign and a blank */
    extreme_result found; /* the extreme of the column last looked for */
    extreme at;
} style;

#define SAMPLES 200

/* The largest magnitude of each column, over rows spread evenly over the motion; 0 for what is no
** more than the rounding of other columns of the same quantity. */
static void find_sizes(analysis *a, const column_list *columns, double *size)
{
    unsigned long n_rows = a->range.n_rows, samples = n_rows < SAMPLES ? n_rows : SAMPLES, k;
    double of_quantity[QUANTITY_COUNT] = {0};
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i;
    result r;
    size_t j;

    for (j = 0; j < columns->count; j++)
        size[j] = 0;
    for (i = 0; i < n; i++)
        for (k = 0; k < samples; k++) {
            double share = samples > 1 ? (double)k / (double)(samples - 1) : 0;

            analysis_row(a, branches[i], (unsigned long)(share * (double)(n_rows - 1) + 0.5), &r);
            for (j = 0; j < columns->count; j++)
                if (r.status == FOURLINK_OK || column_of_crank(&columns->list[j])) {
                    double x = fabs(column_value(&columns->list[j], &r));

                    size[j] = x > size[j] ? x : size[j];
                }
        }
    for (j = 0; j < columns->count; j++) {
        quantity q = column_quantity(&columns->list[j]);

        of_quantity[q] = size[j] > of_quantity[q] ? size[j] : of_quantity[q];
    }
    for (j = 0; j < columns->count; j++)
        if (size[j] <= 1e-12 * of_quantity[column_quantity(&columns->list[j])])
            size[j] = 0;
}

/* The decimals that write a multiple of the interval exactly, if these are few. */
static int decimals_of_angle(const analysis *a, int otherwise)
{
    const fourlink_motion *motion = &a->d->motion;
    double last = a->range.stops ? motion->from : analysis_end(a), step = 1;
    int decimals;

    for (decimals = 0; decimals < otherwise; decimals++, step *= 10) {
        double x = motion->from * step, y = last * step, z = motion->interval * step;

        if (fabs(x - floor(x + 0.5)) < 1e-9 && fabs(y - floor(y + 0.5)) < 1e-9 &&
            fabs(z - floor(z + 0.5)) < 1e-9)
            return decimals;
    }
    return otherwise;
}

static void find_style(const analysis *a, const column *c, double size, style *s)
{
    char number[FORMAT_SIZE];
    size_t width;

    s->exponent = size > 0 && (size < 1e-6 || size >= 1e9);
    s->decimals = a->d->digits - 1;
    if (column_of_rounding(c)) {
        s->exponent = 1;
        s->decimals = 1;
    } else if (!s->exponent && size > 0) {
        s->decimals -= (int)floor(log10(size));
        if (s->decimals < 0)
            s->decimals = 0;
        if (column_of_crank(c) && column_quantity(c) == QUANTITY_ANGLE)
            s->decimals = decimals_of_angle(a, s->decimals);
    }
    if (s->exponent)
        width = strlen(format_exponent(-1, s->decimals, number));
    else
        width = strlen(format_fixed(-size, s->decimals, number));
    if (strlen(c->name) > width)
        width = strlen(c->name);
    if (strlen(c->unit) > width)
        width = strlen(c->unit);
    s->width = width + 2;
    s->limit = s->exponent ? 0 : pow(10, (double)s->width - s->decimals - 3) - 1;
}

/* A cell's text and its end.  A number that is 0 to the decimals printed carries no sign. */
static const char *cell_text(double x, const style *s, char out[FORMAT_SIZE], const char **end)
{
    const char *c = out + 1;

    if (s->exponent)
        *end = format_exponent_end(x + 0.0, s->decimals, out); /* -0 + 0 is 0 */
    else
        *end = format_fixed_end(x, s->decimals, out);
    if (out[0] != '-')
        return out;
    while (*c == '0' || *c == '.')
        c++;
    return c == *end ? out + 1 : out;
}

/* Names or units of the columns, as a comment above them. */
static void put_names(FILE *out, const column_list *columns, const style *styles, int units)
{
    size_t j;

    putc('#', out);
    for (j = 0; j < columns->count; j++)
        print_right(out, units ? columns->list[j].unit : columns->list[j].name,
                    styles[j].width - (j == 0));
    putc('\n', out);
}

/* A fact in the head of the table. */
static void put_fact(const fact *f, void *data)
{
    FILE *out = data;
    char number[FORMAT_SIZE];

    fprintf(out, "# %s", f->name);
    if (f->branch)
        fprintf(out, " (%s)", branch_name((fourlink_branch)f->branch));
    if (f->words)
        fprintf(out, ": %s\n", f->words);
    else
        fprintf(out, ": %s%s%s", format_general(f->value, 9, number),
                strcmp(f->unit, "1") ? " " : "", strcmp(f->unit, "1") ? f->unit : "");
    if (!f->words && f->has_angle)
        fprintf(out, " at theta2 = %s", format_general(f->theta2, 9, number));
    if (!f->words)
        putc('\n', out);
}

/* The extremes of the columns and where they are, as comments above the rows. */
static void put_extremes(FILE *out, analysis *a, const column_list *columns, style *styles,
                         fourlink_branch branch)
{
    static const style angle = {3, 0, 0, 0, EXTREME_NONE, {0, 0}};
    char number[FORMAT_SIZE];
    int sign, line;
    size_t j;

    for (sign = 1; sign >= -1; sign -= 2) {
        for (j = 0; j < columns->count; j++)
            styles[j].found = column_is_angle_of_crank(&columns->list[j])
                                  ? EXTREME_NONE
                                  : extreme_find(a, &columns->list[j], branch, sign, &styles[j].at);
        for (line = 0; line < 2; line++) {
            putc('#', out);
            for (j = 0; j < columns->count; j++) {
                const style *s = &styles[j];
                const char *cell = "", *end;

                if (s->found == EXTREME_FOUND)
                    cell = line == 0 ? cell_text(s->at.value, s, number, &end)
                                     : cell_text(s->at.angle, &angle, number, &end);
                else if (s->found == EXTREME_UNBOUNDED && line == 0)
                    cell = "none";
                print_right(out, cell, s->width - (j == 0));
            }
            fprintf(out, "  %s\n", line == 1 ? "at theta2" : sign > 0 ? "max" : "min");
        }
    }
}

static void put_row(row_buffer *row, const deck *d, const column_list *columns, const style *styles,
                    const result *r)
{
    char number[FORMAT_SIZE];
    size_t j;

    if (r->status == FOURLINK_OK) {
        for (j = 0; j < columns->count; j++) {
            double x = column_value(&columns->list[j], r);

            if (!(fabs(x) < styles[j].limit) ||
                !row_fixed(row, x, styles[j].decimals, styles[j].width)) {
                const char *end, *cell = cell_text(x, &styles[j], number, &end);

                row_right(row, cell, (size_t)(end - cell), styles[j].width);
            }
        }
        row_text(row, "\n", 1);
    }
    if (!print_is_ordinary(r)) {
        row_end(row);
        fprintf(row->out, "# theta2 = %s %s: %s\n", print_angle(r->row.angle, number),
                d->units[QUANTITY_ANGLE].name, print_status(r));
    }
}

static unsigned long print_branch(FILE *out, analysis *a, const column_list *columns, style *styles,
                                  fourlink_branch branch)
{
    unsigned long k, failed = 0;
    char stop[FORMAT_SIZE + 80];
    row_buffer row;
    result r;

    fprintf(out, "# branch: %s\n", branch_name(branch));
    put_names(out, columns, styles, 0);
    put_names(out, columns, styles, 1);
    if (a->range.n_rows > 1 && !a->d->sweep.n_variables) /* of a sweep max() and min() on request */
        put_extremes(out, a, columns, styles, branch);
    row_start(&row, out);
    for (k = 0; k < a->range.n_rows; k++) {
        analysis_row(a, branch, k, &r);
        put_row(&row, a->d, columns, styles, &r);
        failed += r.status != FOURLINK_OK;
    }
    row_end(&row);
    if (a->range.stops) {
        fprintf(out, "# %s\n", print_stop(a, stop));
        failed++;
    }
    return failed;
}

int table_print(FILE *out, analysis *a, const column_list *columns, unsigned long *failed)
{
    style *styles = malloc(columns->count * sizeof *styles);
    double *size = malloc(columns->count * sizeof *size);
    fourlink_branch branches[2];
    int n = print_branches_of(a->d, branches), i, enough;
    size_t j;

    if (styles && size) {
        find_sizes(a, columns, size);
        for (j = 0; j < columns->count; j++)
            find_style(a, &columns->list[j], size[j], &styles[j]);
        print_head(out, a->d);
        facts_tell(a, 0, 0, NULL, put_fact, out);
        for (i = 0; i < n; i++) {
            if (i > 0)
                fputs("\n\n", out);
            *failed += print_branch(out, a, columns, styles, branches[i]);
        }
    }
    enough = styles && size;
    free(styles);
    free(size);
    return enough;
}
