/* SPDX-License-Identifier: GPL-3.0-or-later
**
** tables.c - the tables of a report: a format of a sheet that writes HTML, and the same rows as csv.
*/
#include <errno.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "system/memory.h"
#include "system/system.h"
#include "system/xml.h"
#include "report.h"
#include "tables/style.h"
#include "tables/content.h"

#define MOST_ON_PAPER 1000 /* rows of a table that is printed although it is folded */

/* A sheet, which is its first member, and the report that it is written into. */
typedef struct html_sheet {
    sheet s;
    report *r;
} html_sheet;

static page *page_of(sheet *s)
{
    return &((html_sheet *)s)->r->page;
}

/* ------------------------------------------------------------------------------ rows */

static void open_rows(sheet *s)
{
    style_find(&s->v, 0, s->values, s->layout);
}

/* The letters in a line tell the style how small a table is on paper. */
static void open_block(sheet *s, fourlink_branch branch)
{
    const style *styles = s->layout;
    page *p = page_of(s);
    unsigned long letters = 0, j;
    char title[60];

    s->side = 0;
    for (j = 0; j < s->v.n_columns; j++)
        letters += (unsigned long)styles[j].width;
    flk_text_join(title, sizeof title, "Rows of the ", fourlink_branch_text((int)branch), " branch",
                  (char *)NULL);
    page_fold(p, s->v.problem.n_rows > MOST_ON_PAPER, title, s->v.problem.n_rows);
    page_print(p,
               "<div class=\"wide\"><table class=\"rows\" style=\"--letters: %lu\">\n<thead><tr>",
               letters);
    for (j = 0; j < s->v.n_columns; j++)
        page_print(p, "<th scope=\"col\" title=\"%s\" data-name=\"%s\">%n<br/>%u</th>",
                   s->v.columns[j].meaning, s->v.columns[j].name, s->v.columns[j].name,
                   s->v.columns[j].unit);
    page_print(p, "</tr></thead>\n<tbody>\n");
}

/* A number with the decimals of its column. */
static void put_styled(page *p, double value, const style *x)
{
    char number[FORMAT_SIZE];

    if (!gsl_finite(value)) {
        page_print(p, "<td>%v</td>", value, 0);
        return;
    }
    style_text(value, x, number);
    page_print(p, "<td>%m</td>", number);
}

static void put_row(sheet *s, const sheet_row *row)
{
    const style *styles = s->layout;
    page *p = page_of(s);
    unsigned long j;

    if (s->v.problem.has_both_sides && row->at && row->at->row.side != s->side) {
        s->side = row->at->row.side;
        page_print(p, "<tr><td colspan=\"%lu\">%s is %s:</td></tr>\n", s->v.n_columns,
                   s->v.problem.over.words, fourlink_input_side_text(s->side));
    }
    page_print(p, "<tr>");
    if (row->at && row->at->status == FOURLINK_OK)
        for (j = 0; j < s->v.n_columns; j++)
            put_styled(p, row->values[j], &styles[j]);
    if (row->is_ordinary) {
        page_print(p, "</tr>\n");
        return;
    }
    if (row->at && row->at->status == FOURLINK_OK)
        page_print(p, "</tr>\n<tr>");
    page_print(p, "<td colspan=\"%lu\">", s->v.n_columns);
    if (row->at && row->last != row->at->row.angle)
        page_print(p, "%.9g to %.9g%U: ", row->at->row.angle, row->last,
                   s->v.units[QUANTITY_ANGLE].name);
    else if (row->at)
        page_print(p, "%.9g%U: ", row->at->row.angle, s->v.units[QUANTITY_ANGLE].name);
    page_print(p, "%s</td></tr>\n", row->status);
}

static void close_block(sheet *s, fourlink_branch branch)
{
    (void)branch;
    page_table_end(page_of(s));
    page_fold_end(page_of(s));
}

/* ------------------------------------------------------------------------------ comparisons */

static void end_checks(sheet *s)
{
    if (s->list)
        page_table_end(page_of(s));
    s->list = NULL;
}

static void put_check(sheet *s, const fourlink_check *c)
{
    int is_number = !c->words[0] && c->verdict != FOURLINK_NO_VALUE;
    int agrees = c->verdict == FOURLINK_AGREES || c->verdict == FOURLINK_MISPRINT;
    page *p = page_of(s);

    if (!s->list)
        page_table(p, "Expected values",
                   "Name|" PAGE_AT "|Branch|Expected|Computed|Unit|Tolerance|Result");
    s->list = "checks";
    page_print(p, "<tr class=\"%s\"><th scope=\"row\">%s</th><td>", agrees ? "agrees" : "differs",
               c->name);
    if (c->has_place)
        page_print(p, "%.9g%U", c->place, c->place_unit);
    else if (c->has_angle)
        page_print(p, "%.9g%U", c->angle, s->v.units[QUANTITY_ANGLE].name);
    if (c->side)
        page_print(p, ", %s", fourlink_input_side_text(c->side));
    page_print(p, "</td><td>%s</td><td>%s</td>", fourlink_branch_text((int)c->branch),
               c->printed_text);
    if (is_number)
        page_print(p, "<td>%v</td><td>%u</td><td>%v</td>", c->computed, 9, c->unit, c->tolerance,
                   0);
    else
        page_print(p, "<td>%s</td><td>%u</td><td></td>", c->words, c->unit);
    page_print(p, "<td>%s%s%s</td></tr>\n", sheet_verdicts[c->verdict],
               c->message[0] || c->hint[0] ? ": " : "",
               c->verdict == FOURLINK_NO_VALUE ? c->message : c->hint);
}

static const sheet_frame of_rows = {NULL, open_rows, end_checks, NULL},
                         of_checks = {NULL, NULL, end_checks, NULL};

static const sheet_format html_format = {
    "html",                                                           /* name */
    {&of_rows, NULL, &of_checks, NULL, NULL, NULL, NULL, NULL, NULL}, /* frame */
    NULL,                                                             /* column */
    NULL,                                                             /* listed */
    NULL,                                                             /* limit */
    NULL,                                                             /* fact */
    open_block,                                                       /* block */
    put_row,                                                          /* row */
    close_block,                                                      /* end_block */
    put_check,                                                        /* check */
    NULL,                                                             /* design */
    NULL,                                                             /* values */
    sizeof(style),                                                    /* layout_size */
    0,                                                                /* is_by_angle */
    1,                                                                /* is_brief */
    NULL,                                                             /* mark */
    NULL,                                                             /* extremes */
    0                                                                 /* is_lines */
};

/* ------------------------------------------------------------------------------ sections */

/* Write contents of the deck in a format, to the page or to another stream. */
static void write_sheet(report *r, sheet_content content, const sheet_format *format, FILE *out)
{
    html_sheet h;

    memset(&h, 0, sizeof h);
    h.r = r;
    h.s.format = format;
    h.s.content = content;
    h.s.n_decks = 1;
    fourlink_results_list(r->v.results, FOURLINK_COLUMNS, &h.s.header, &h.s.n_header);
    content_begin(&h.s, out, 1);
    content_write(&h.s, r->v.results, r->source->name, NULL);
    if (format == &html_format) {
        r->failed += h.s.failed;
        r->differing += h.s.checks[FOURLINK_DIFFERS] + h.s.checks[FOURLINK_NO_MISPRINT] +
                        h.s.checks[FOURLINK_NO_VALUE];
    }
}

/* The name of the deck's file without folder and ending. */
static text name_of_deck(const report *r)
{
    text name = flk_text_of(view_file_of(r->source->name)), before, after;

    return flk_text_cut_last(name, ".", &before, &after) && before.length ? before : name;
}

/* The rows as csv in a temporary file; null with errno set. */
static FILE *write_csv(report *r)
{
    FILE *csv = system_scratch();
    int reason;

    if (!csv)
        return NULL;
    write_sheet(r, SHEET_ROWS, &csv_format, csv);
    if (fflush(csv) == 0 && !ferror(csv)) {
        rewind(csv);
        return csv;
    }
    reason = errno;
    fclose(csv);
    errno = reason;
    return NULL;
}

/* The rows as csv, and a button that saves them. */
static void put_csv(report *r)
{
    FILE *csv = write_csv(r);
    text name = name_of_deck(r);
    char part[4096];
    size_t n;

    if (!csv) {
        r->reason = errno;
        memory_note_reason(errno);
        return;
    }
    page_print(&r->page, "<button type=\"button\" data-save=\"");
    xml_put(r->page.out, name.start, name.length);
    page_print(&r->page, ".csv\" data-from=\"csv-rows\" hidden=\"hidden\">Save the tables as CSV"
                         "</button>\n<pre id=\"csv-rows\" hidden=\"hidden\">");
    while ((n = fread(part, 1, sizeof part, csv)) > 0)
        xml_put(r->page.out, part, n);
    if (ferror(csv))
        r->reason = errno;
    page_print(&r->page, "</pre>\n");
    fclose(csv);
}

void report_put_tables(report *r)
{
    write_sheet(r, SHEET_ROWS, &html_format, r->page.out);
    put_csv(r);
}

/* The largest difference of the forces of two solutions, relative to the largest force. */
static double difference(const report *r, const fourlink_forces *f, const fourlink_forces *g)
{
    double x[9], y[9], most = 0, size = 0;
    int i;

    fourlink_unknowns(&r->v.problem.mechanism, f, x);
    fourlink_unknowns(&r->v.problem.mechanism, g, y);
    for (i = 0; i < 9; i++) {
        char letter = fourlink_unknown_text((int)r->v.design->kind, i)[0];

        if (letter == 'M' || letter == 'T')
            continue; /* a couple */
        most = GSL_MAX_DBL(most, fabs(x[i] - y[i]));
        size = GSL_MAX_DBL(size, fabs(x[i]));
    }
    return size > 0 ? most / size : 0;
}

/* Compare both solutions of the nine equations in all rows of a branch. */
static void put_agreement(report *r, fourlink_branch branch)
{
    double residual = 0, differs = 0;
    unsigned long n = 0, i;
    fourlink_instant now;
    fourlink_forces forces;
    fourlink_state state;

    for (i = 0; i < r->v.problem.n_rows; i++) {
        if (fourlink_results_row(r->v.results, branch, i, NULL, &now, r->row_loads) !=
                FOURLINK_OK ||
            fourlink_analyse_dyad(&r->v.problem.mechanism, branch, &now.row.crank, r->row_loads,
                                  r->v.problem.n_loads, &state, &forces) != FOURLINK_OK)
            continue;
        residual = GSL_MAX_DBL(residual, fabs(now.forces.residual));
        differs = GSL_MAX_DBL(differs, difference(r, &now.forces, &forces));
        n++;
    }
    page_row(&r->page, "%s|%lu|%.2g|%.2g", fourlink_branch_text((int)branch), n, residual, differs);
}

void report_put_checks(report *r)
{
    page *p = &r->page;
    int i;

    if (r->v.problem.has_forces) {
        page_print(p,
                   "<p>The residual is the driving torque of the nine equations less that of "
                   "virtual work, relative to the largest term of the balance.  The nine equations "
                   "are solved as a matrix and, eliminated by hand, in closed form; the difference "
                   "of their pin forces is relative to the largest.</p>\n");
        page_table(p, "Balance of power, and two solutions of the nine equations",
                   "Branch|Rows|Largest residual|Largest difference");
        for (i = 0; i < r->v.n_branches; i++)
            put_agreement(r, r->v.branches[i]);
        page_table_end(p);
    }
    if (r->v.problem.n_expected)
        write_sheet(r, SHEET_CHECK, &html_format, p->out);
    else
        page_print(p, "<p>The deck has no expected values.</p>\n");
}
