/* SPDX-License-Identifier: GPL-3.0-or-later
**
** facts.c - the inputs of a report, its key facts and the extremes of its columns.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "cell.h"
#include "report.h"
#include "tables/sheet.h"
#include "view/notation.h"

/* Write value and unit; words take so many cells. */
static void put_value(report *r, const fourlink_value *v, int cells)
{
    if (v->words) {
        page_print(&r->page, "<td colspan=\"%d\">%s</td>", cells, v->words);
        return;
    }
    cell_put(&r->page, v->value, r->v.problem.digits);
    page_print(&r->page, "<td>%u</td>", v->unit);
}

/* Begin a line with the name of a result. */
static void put_name(report *r, const char *name)
{
    page_print(&r->page, "<tr><th scope=\"row\" data-name=\"%s\">%n</th>", name, name);
}

/* Write the angle of a value as a cell. */
static void put_angle(report *r, const fourlink_value *v)
{
    page_print(&r->page, "<td>");
    if (v->has_angle) {
        cell_number(&r->page, v->angle, r->v.problem.digits);
        page_print(&r->page, "%U", r->v.units[QUANTITY_ANGLE].name);
    }
    page_print(&r->page, "</td>");
}

void report_put_inputs(report *r)
{
    const fourlink_value *inputs;
    unsigned long n, i;

    fourlink_results_list(r->v.results, FOURLINK_INPUTS, &inputs, &n);
    page_section(&r->page, "inputs", "Inputs as understood");
    cell_begin(&r->page, NULL,
               CELL_HEAD("Name") CELL_HEAD("Value") CELL_HEAD("Unit") CELL_HEAD("Meaning"));
    for (i = 0; i < n; i++) {
        page_print(&r->page, "<tr><th scope=\"row\">%s</th>", inputs[i].name);
        put_value(r, &inputs[i], 2);
        page_print(&r->page, "<td>%s</td></tr>\n", inputs[i].meaning);
    }
    cell_end(&r->page);
    page_print(&r->page, "</section>\n");
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
        put_name(r, f->name);
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
        put_name(r, columns[i].name);
        page_print(&r->page, "<td>%u</td>", columns[i].unit);
        put_extreme(r, view_extreme(&extremes, columns[i].handle + FOURLINK_MIN));
        put_extreme(r, view_extreme(&extremes, columns[i].handle + FOURLINK_MAX));
        page_print(&r->page, "</tr>\n");
    }
    cell_end(&r->page);
}

void report_put_facts(report *r)
{
    int i;

    page_section(&r->page, "facts", "All facts and extremes");
    put_facts(r, "Type and key facts", FOURLINK_FACTS_LIMITS);
    put_facts(r, "Turning moment", FOURLINK_FACTS_TURNING);
    put_facts(r, "Actual motion", FOURLINK_FACTS_MOTION);
    for (i = 0; i < r->v.n_branches && r->v.problem.n_rows > 1; i++)
        put_extremes(r, r->v.branches[i]);
    page_print(&r->page, "</section>\n");
}

/* ------------------------------------------------------------------------------ the box of results */

/* What the first page has room for: facts, with their own meanings, and statistics of columns. */
static const struct {
    const char *name, *words;
    int statistic; /* FOURLINK_MAX ...; 0: a fact */
} results[] = {{"theta4_min", NULL, 0},
               {"theta4_max", NULL, 0},
               {"theta4_swing", "range of the angle of link 4", 0},
               {"swing", NULL, 0},
               {"stroke", NULL, 0},
               {"time_ratio", "slow swing or stroke / quick one, in time", 0},
               {"mu_min", NULL, 0},
               {"omega4", "largest speed of link 4", FOURLINK_MAX},
               {"v", "largest speed of the piston", FOURLINK_MAX},
               {"a", "largest acceleration of the piston", FOURLINK_MAX},
               {"F12", "largest force in pin A", FOURLINK_MAX},
               {"F23", "largest force in pin B", FOURLINK_MAX},
               {"F34", "largest force between links 3 and 4", FOURLINK_MAX},
               {"F14", "largest force in pin D", FOURLINK_MAX},
               {"N", "largest force of the guide", FOURLINK_MAX},
               {"Ts", "largest driving torque", FOURLINK_MAX},
               {"Ts", "smallest driving torque", FOURLINK_MIN},
               {"mean_power", NULL, 0},
               {"energy_fluctuation", NULL, 0},
               {"flywheel_inertia", NULL, 0},
               {"mean_speed", NULL, 0},
               {"fluctuation_exact", "coefficient of fluctuation of speed", 0}};

enum { RESULTS = sizeof results / sizeof results[0] };

/* Find a result on a branch; of one instant, its value there.  0 if there is none. */
static int find_result(report *r, int i, fourlink_branch branch, fourlink_value *found)
{
    const fourlink_problem *p = &r->v.problem;
    int statistic = p->n_rows > 1 ? results[i].statistic : 0;

    if (p->n_rows < 2 && results[i].statistic == FOURLINK_MIN)
        return 0;
    return fourlink_results_find(r->v.results, results[i].name, found) == FOURLINK_OK &&
           !(found->flags & FOURLINK_CRANK_ANGLE) &&
           fourlink_results_get(r->v.results, found->handle + statistic, branch, p->motion.from,
                                found) == FOURLINK_OK &&
           !found->words && !gsl_isnan(found->value);
}

static void put_result(report *r, const fourlink_value *v)
{
    page *p = &r->page;

    page_print(p, "<td>");
    cell_number(p, v->value, r->v.problem.digits);
    page_print(p, "%U", v->unit);
    if (v->has_angle && r->v.problem.n_rows > 1) {
        page_print(p, " <small>at ");
        cell_number(p, v->angle, r->v.problem.digits);
        page_print(p, "%U</small>", r->v.units[QUANTITY_ANGLE].name);
    }
    page_print(p, "</td>");
}

/* Write a line of the box: a result on each branch; once if it is the same on both. */
static void put_results_line(report *r, int i)
{
    fourlink_value found[2];
    int has[2] = {0, 0}, n = r->v.n_branches, k;
    page *p = &r->page;
    const char *words;
    notation symbol;

    for (k = 0; k < n; k++)
        has[k] = find_result(r, i, r->v.branches[k], &found[k]);
    if (!has[0] && !has[1])
        return;
    words = results[i].words ? results[i].words : found[!has[0]].meaning;
    if (r->v.problem.n_rows < 2 && results[i].statistic)
        words += strlen("largest ");
    page_print(p, "<tr><th scope=\"row\">%s", words);
    if (notation_split(results[i].name, &symbol) || !results[i].name[1])
        page_print(p, ", %n", results[i].name);
    page_print(p, "</th>");
    for (k = 0; k < n; k++)
        if (has[k])
            put_result(r, &found[k]);
        else
            page_print(p, "<td></td>");
    page_print(p, "</tr>\n");
}

void report_put_results(report *r)
{
    const fourlink_value *facts;
    page *p = &r->page;
    unsigned long n;
    int i;

    page_section(p, "results", "Results");
    fourlink_results_facts(r->v.results, 0, FOURLINK_FACTS_LIMITS, &facts, &n);
    if (n && facts[0].words)
        page_print(p, "<p class=\"type\">%s.</p>\n", facts[0].words);
    page_print(p, "<div class=\"wide\"><table class=\"results\">\n<thead><tr>" CELL_HEAD("Result"));
    for (i = 0; i < r->v.n_branches; i++)
        page_print(p,
                   r->v.n_branches > 1 ? "<th scope=\"col\">%s branch</th>"
                                       : "<th scope=\"col\">Value%s</th>",
                   r->v.n_branches > 1 ? fourlink_branch_text((int)r->v.branches[i]) : "");
    page_print(p, "</tr></thead>\n<tbody>\n");
    for (i = 0; i < RESULTS; i++)
        put_results_line(r, i);
    page_print(p, "</tbody>\n</table></div>\n</section>\n");
}
