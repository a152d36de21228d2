/* SPDX-License-Identifier: GPL-3.0-or-later
**
** facts.c - the inputs of a report, its key facts and the extremes of its columns.
*/
#include "cell.h"
#include "report.h"
#include "tables/sheet.h"

/* Write name, value and unit; words take so many cells. */
static void put_value(report *r, const fourlink_value *v, int cells)
{
    page *p = &r->page;

    page_print(p, "<tr><th scope=\"row\">%s</th>", v->name);
    if (v->words)
        page_print(p, "<td colspan=\"%d\">%s</td>", cells, v->words);
    else
        cell_put(p, v->value, r->v.problem.digits);
    page_print(p, v->words ? "" : "<td>%s</td>", cell_unit(v->unit));
}

/* Write the angle of a value as a cell. */
static void put_angle(report *r, const fourlink_value *v)
{
    page_print(&r->page, "<td>");
    if (v->has_angle) {
        cell_number(&r->page, v->angle, r->v.problem.digits);
        page_print(&r->page, " %s", r->v.units[QUANTITY_ANGLE].name);
    }
    page_print(&r->page, "</td>");
}

static void put_inputs(report *r)
{
    const fourlink_value *inputs;
    unsigned long n, i;

    fourlink_results_list(r->v.results, FOURLINK_INPUTS, &inputs, &n);
    cell_begin(&r->page, "Inputs as understood",
               CELL_HEAD("Name") CELL_HEAD("Value") CELL_HEAD("Unit") CELL_HEAD("Meaning"));
    for (i = 0; i < n; i++) {
        put_value(r, &inputs[i], 2);
        page_print(&r->page, "<td>%s</td></tr>\n", inputs[i].meaning);
    }
    cell_end(&r->page);
}

/* Write a group of facts; one that is the same on both branches once. */
static void put_facts(report *r, const char *heading, int group)
{
    const fourlink_value *facts;
    unsigned long n, i;

    fourlink_results_facts(r->v.results, 0, group, &facts, &n);
    if (!n)
        return;
    cell_begin(&r->page, heading,
               CELL_HEAD("Name") CELL_HEAD("Value") CELL_HEAD("Unit") CELL_AT CELL_HEAD("Branch")
                   CELL_HEAD("Meaning"));
    for (i = 0; i < n; i++) {
        const fourlink_value *f = &facts[i];
        int is_on_both = sheet_is_on_both(f, facts, n);

        if (is_on_both && f->branch == FOURLINK_CROSSED)
            continue;
        put_value(r, f, 4);
        if (!f->words) {
            put_angle(r, f);
            page_print(&r->page, "<td>%s</td>",
                       f->branch && !is_on_both ? fourlink_branch_text(f->branch) : "");
        }
        page_print(&r->page, "<td>%s</td></tr>\n", f->meaning);
    }
    cell_end(&r->page);
}

/* Write the smallest value of a column, or the largest, and its angle; null: it has none. */
static void put_extreme(report *r, const fourlink_value *v)
{
    if (!v) {
        page_print(&r->page, "<td></td><td></td>");
        return;
    }
    cell_put(&r->page, v->value, r->v.problem.digits);
    put_angle(r, v);
}

static void put_extremes(report *r, fourlink_branch branch)
{
    const fourlink_value *columns = r->v.columns;
    view_extremes extremes;
    int status = view_find_extremes(&r->v, branch, &extremes);
    unsigned long i;

    if (status == FOURLINK_LONG_SEARCH || status == FOURLINK_TOO_LONG) {
        page_print(&r->page, "<p class=\"missing\">No smallest and largest values, %s: %s.</p>\n",
                   branch == FOURLINK_OPEN ? "open branch" : "crossed branch",
                   fourlink_status_text(status));
        r->failed++;
        return;
    }
    cell_begin(&r->page,
               branch == FOURLINK_OPEN ? "Smallest and largest values, open branch"
                                       : "Smallest and largest values, crossed branch",
               CELL_HEAD("Column") CELL_HEAD("Unit") CELL_HEAD("Smallest")
                   CELL_AT CELL_HEAD("Largest") CELL_AT);
    for (i = 0; i < r->v.n_columns; i++) {
        if (columns[i].flags & (FOURLINK_CRANK_ANGLE | FOURLINK_OF_ROUNDING))
            continue;
        page_print(&r->page, "<tr><th scope=\"row\">%s</th><td>%s</td>", columns[i].name,
                   cell_unit(columns[i].unit));
        put_extreme(r, view_extreme(&extremes, columns[i].handle + FOURLINK_MIN));
        put_extreme(r, view_extreme(&extremes, columns[i].handle + FOURLINK_MAX));
        page_print(&r->page, "</tr>\n");
    }
    cell_end(&r->page);
}

void report_put_facts(report *r)
{
    int i;

    page_section(&r->page, "facts", "Inputs and key facts");
    put_inputs(r);
    put_facts(r, "Type and key facts", FOURLINK_FACTS_LIMITS);
    put_facts(r, "Turning moment", FOURLINK_FACTS_TURNING);
    put_facts(r, "Actual motion", FOURLINK_FACTS_MOTION);
    for (i = 0; i < r->v.n_branches && r->v.problem.n_rows > 1; i++)
        put_extremes(r, r->v.branches[i]);
    page_print(&r->page, "</section>\n");
}
