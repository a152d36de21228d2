/* SPDX-License-Identifier: GPL-3.0-or-later
**
** table.c - the format table: aligned columns, with everything but numbers on lines that begin with #.
*/
#include <math.h>
#include <string.h>

#include "base/digits.h"
#include "base/text.h"
#include "fit.h"
#include "head.h"
#include "sheet.h"
#include "table_lines.h"
#include "summary.h"
#include "view/rounding.h"

static void open_deck(sheet *s)
{
    sheet_write_gap(s);
    if (s->design)
        table_put_design_comment(s);
}

static void open_with_properties(sheet *s)
{
    open_deck(s);
    head_put_properties(s);
}

static void open_rows(sheet *s)
{
    open_deck(s);
    style_find(&s->v, s->at != NULL, s->values, s->layout);
    s->n_pages = fit_columns(s, s->layout);
    head_put_properties(s);
}

static void open_summary(sheet *s)
{
    open_deck(s);
    summary_put_inputs(s);
}

static void open_list(sheet *s)
{
    open_deck(s);
    table_put_list_head(s);
}

/* Write the names or units of the columns as a comment. */
static void put_names(sheet *s, int units)
{
    const style *styles = s->layout;
    size_t hash = 1; /* the first field is shorter by the # */
    unsigned long j, k;

    line_put(&s->l, "#");
    for (k = 0; k < s->v.n_columns; k++)
        if (FIT_HAS(s, &styles[j = styles[k].column])) {
            line_field(&s->l, units ? s->v.columns[j].unit : s->v.columns[j].name,
                       styles[j].width - hash);
            hash = 0;
        }
    line_put(&s->l, "\n");
}

/* The places of the numbers in a line of the present page. */
static void set_cells(sheet *s)
{
    style *styles = s->layout;
    digits_cell *cells = STYLE_CELLS(s);
    unsigned long k;

    styles->n_cells = styles->line = 0;
    for (k = 0; k < s->v.n_columns; k++) {
        unsigned long j = styles[k].column;

        if (!FIT_HAS(s, &styles[j]))
            continue;
        styles->line += styles[j].width;
        flk_digits_cell(&cells[styles->n_cells++], j, styles[j].decimals, styles[j].limit,
                        styles->line);
    }
}

static void block_begins(sheet *s, fourlink_branch branch)
{
    if (s->page > 0)
        line_put(&s->l, "\n");
    else
        line_put(&s->l, s->list ? "\n\n# branch: %s\n" : "# branch: %s\n",
                 fourlink_branch_text((int)branch));
    s->list = "branches";
    s->side = 0;
    set_cells(s);
    put_names(s, 0);
    put_names(s, 1);
}

/* The field of an extreme, or of its crank angle. */
static void put_extreme(sheet *s, const style *x, int at_angle, size_t width)
{
    static const style angle = {3, 0, 0, 0, 0, 0, 0, 0, 0, NULL};
    fourlink_value extreme;

    if (x->extreme)
        extreme = s->at ? view_settled(&s->v, x->extreme) : *x->extreme;
    if (x->extreme && at_angle && extreme.has_angle)
        style_put(&s->l, extreme.angle, &angle, width);
    else if (x->extreme && !at_angle)
        style_put(&s->l, extreme.value, x, width);
    else
        line_field(&s->l, "", width);
}

/* A line of extremes, or of their crank angles.  Its label stands under the crank angle, or at the end. */
static void put_extremes(sheet *s, const char *label, int at_angle)
{
    const style *styles = s->layout;
    int has_lead = fit_begins_with_angle(s);
    size_t hash = 1;
    unsigned long j, k;

    line_put(&s->l, "#");
    for (k = 0; k < s->v.n_columns; k++) {
        if (!FIT_HAS(s, &styles[j = styles[k].column]))
            continue;
        if (has_lead && k == 0)
            line_field(&s->l, at_angle ? "at" : label, styles[j].width - 1);
        else
            put_extreme(s, &styles[j], at_angle, styles[j].width - hash);
        hash = 0;
    }
    if (!has_lead)
        line_put(&s->l, "  %s", at_angle ? "at theta2" : label);
    line_put(&s->l, "\n");
}

/* Write the extremes of the columns and their crank angles as comments below the rows. */
static void block_ends(sheet *s, fourlink_branch branch)
{
    style *styles = s->layout;
    view_extremes extremes;
    unsigned long j;
    int which, status;

    if (s->v.problem.n_rows < 2 || s->design) /* a sweep prints max() and min() only on request */
        return;
    status = view_find_extremes(&s->v, branch, &extremes);
    if (status == FOURLINK_NO_MEMORY) /* which is told */
        return;
    if (status == FOURLINK_LONG_SEARCH) {
        line_put(&s->l, "# max, min: %s\n", fourlink_status_text(status));
        s->failed++;
    }
    if (status == FOURLINK_LONG_SEARCH || status == FOURLINK_TOO_LONG) /* which is written */
        return;
    for (which = FOURLINK_MAX; which <= FOURLINK_MIN; which++) {
        for (j = 0; j < s->v.n_columns; j++)
            styles[j].extreme = view_extreme(&extremes, s->v.columns[j].handle + which);
        put_extremes(s, which == FOURLINK_MAX ? "max" : "min", 0);
        put_extremes(s, "", 1);
    }
}

static int is_not_reached(int status)
{
    return status == FOURLINK_TOO_FAR || status == FOURLINK_TOO_NEAR ||
           status == FOURLINK_ROD_TOO_SHORT;
}

/* 65 to 295 deg: not reached: B and D are too far apart */
static void put_reason(sheet *s, const sheet_row *row)
{
    static const char cannot[] = "cannot be assembled: ";
    const char *why = row->status;

    line_put(&s->l, "# ");
    if (row->at) {
        line_put(&s->l, "%12g ", view_shown_place(&s->v, &row->at->row));
        if (row->last != view_shown_place(&s->v, &row->at->row))
            line_put(&s->l, "to %12g ", row->last);
        line_put(&s->l, "%s: %s",
                 s->v.units[s->v.problem.is_prescribed ? s->v.over : QUANTITY_ANGLE].name,
                 is_not_reached(row->at->status) ? "not reached: " : "");
    }
    if (strncmp(why, cannot, sizeof cannot - 1) == 0)
        why += sizeof cannot - 1;
    line_put(&s->l, "%s\n", why);
}

/* A number of any size within its cell; 0 if it leaves no blank there. */
static int put_in_cell(double value, const style *x, char *end)
{
    char number[FORMAT_SIZE];
    size_t n = (size_t)(style_text(value, x, number) - number);

    if (n >= x->width)
        return 0;
    memset(end - x->width, ' ', x->width - n);
    memcpy(end - n, number, n);
    return 1;
}

/* The numbers of the present page in a line; 0, and nothing written, if one does not fit. */
static int put_aligned(sheet *s, const double *values)
{
    const style *styles = s->layout;
    const digits_cell *cells = STYLE_CELLS(s);
    size_t n = styles->n_cells;
    char *begin = line_blanks(&s->l, styles->line + 1);

    while (begin && (n = flk_digits_put(cells, n, values, begin)) > 0) {
        size_t j = cells[--n].value;

        if (!put_in_cell(values[j], &styles[j], begin + cells[n].end)) {
            s->l.length -= styles->line + 1;
            return 0;
        }
    }
    if (begin)
        begin[styles->line] = '\n';
    return begin != NULL;
}

/* The numbers of the present page. */
static void put_numbers(sheet *s, const double *values)
{
    const style *styles = s->layout;
    unsigned long j, k;

    if (put_aligned(s, values))
        return;
    for (k = 0; k < s->v.n_columns; k++)
        if (FIT_HAS(s, &styles[j = styles[k].column]))
            style_put(&s->l, values[j], &styles[j], styles[j].width);
    line_byte(&s->l, '\n');
}

/* Say on which side of an input the rows are that follow. */
static void put_side(sheet *s, const sheet_row *row)
{
    if (!s->v.problem.has_both_sides || !row->at || row->at->row.side == s->side)
        return;
    s->side = row->at->row.side;
    line_put(&s->l, "# side: %s\n", fourlink_input_side_text(s->side));
}

static void put_row(sheet *s, const sheet_row *row)
{
    put_side(s, row);
    if (row->at && row->at->status == FOURLINK_OK)
        put_numbers(s, row->values);
    if (!row->is_ordinary)
        put_reason(s, row);
}

static const sheet_frame of_rows = {NULL, open_rows, NULL, table_refuse_rows},
                         of_summary = {NULL, open_summary, NULL, table_refuse},
                         of_checks = {NULL, open_deck, table_close_checks, table_refuse},
                         of_list = {NULL, open_list, NULL, table_refuse},
                         of_others = {NULL, open_with_properties, NULL, table_refuse},
                         of_designs = {table_begin_designs, NULL, NULL, table_refuse},
                         of_values = {table_begin_values, NULL, NULL, table_refuse_values},
                         of_scores = {table_begin_scores, NULL, NULL, NULL};

const sheet_format table_format = {
    "table", /* name */
    {&of_rows, &of_summary, &of_checks, &of_list, &of_others, &of_designs, &of_values, &of_others,
     &of_scores},         /* frame */
    table_put_column,     /* column */
    table_put_listed,     /* listed */
    NULL,                 /* limit */
    summary_put_fact,     /* fact */
    block_begins,         /* block */
    put_row,              /* row */
    block_ends,           /* end_block */
    table_put_check,      /* check */
    table_put_design,     /* design */
    table_put_values,     /* values */
    STYLE_AND_CELL,       /* layout_size */
    0,                    /* is_by_angle */
    1,                    /* is_brief */
    table_put_mark,       /* mark */
    summary_put_extremes, /* extremes */
    0                     /* is_lines */
};
