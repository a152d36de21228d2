/* SPDX-License-Identifier: GPL-3.0-or-later
**
** facts.c - the inputs of a report, its key facts and the extremes of its columns.
*/
#include <string.h>

#include <gsl/gsl_math.h>

#include "report.h"
#include "tables/sheet.h"
#include "view/notation.h"
#include "view/results.h"
#include "view/rounding.h"

/* The angle of a value as a cell. */
static void put_angle(report *r, const fourlink_value *v)
{
    page_print(&r->page, "<td>");
    if (v->has_angle)
        page_print(&r->page, "%v%U", v->angle, r->v.problem.digits,
                   r->v.units[QUANTITY_ANGLE].name);
    page_print(&r->page, "</td>");
}

void report_put_inputs(report *r)
{
    const fourlink_value *inputs;
    page *p = &r->page;
    unsigned long n, i;
    int behind = 0;

    fourlink_results_list(r->v.results, FOURLINK_INPUTS, &inputs, &n);
    for (i = 0; i < n; i++)
        if (!inputs[i].words)
            behind = GSL_MAX_INT(behind, page_behind(inputs[i].value, r->v.problem.digits));
    page_fold(p, 0, "Inputs as understood", n);
    page_table(p, NULL, "Name|Value|Unit|Meaning");
    for (i = 0; i < n; i++) {
        const fourlink_value *x = &inputs[i];

        page_print(p, "<tr><th scope=\"row\">%s</th>", x->name);
        if (x->words) {
            page_print(p, "<td colspan=\"2\">%s</td>", x->words);
        } else {
            page_number_cell(p, x->value, r->v.problem.digits, behind);
            page_print(p, "<td>%u</td>", x->unit);
        }
        page_print(p, "<td>%s</td></tr>\n", x->meaning);
    }
    page_table_end(p);
    page_fold_end(p);
}

/* Begin a line with the name of a result. */
static void put_name(report *r, const char *name)
{
    page_print(&r->page, "<tr><th scope=\"row\" data-name=\"%s\">%n</th>", name, name);
}

/* Which columns a table of facts needs, and the letters behind the points of its values. */
typedef struct fact_columns {
    int has_angles, has_branches, behind;
} fact_columns;

static fact_columns columns_of(const report *r, const fourlink_value *facts, unsigned long n)
{
    fact_columns c = {0, 0, 0};
    unsigned long i;

    for (i = 0; i < n; i++) {
        c.has_angles = c.has_angles || facts[i].has_angle;
        c.has_branches = c.has_branches || (r->v.n_branches > 1 && facts[i].branch &&
                                            !sheet_is_on_both(&facts[i], facts, n));
        if (!facts[i].words)
            c.behind = GSL_MAX_INT(c.behind, page_behind(facts[i].value, r->v.problem.digits));
    }
    return c;
}

/* Write a group of facts; one that is the same on both branches once. */
static void put_facts(report *r, const char *heading, int group)
{
    const fourlink_value *facts;
    page *p = &r->page;
    unsigned long n, i;
    char heads[80];
    fact_columns c;

    results_facts(r->v.results, 0, group, &facts, &n);
    if (!n)
        return;
    c = columns_of(r, facts, n);
    page_table_of(p, c.has_branches ? "facts broad" : "facts", heading,
                  flk_text_join(heads, sizeof heads, "Name|Value|Unit",
                                c.has_angles ? "|" PAGE_AT : "", c.has_branches ? "|Branch" : "",
                                "|Meaning", (char *)NULL));
    for (i = 0; i < n; i++) {
        const fourlink_value *f = &facts[i];
        int is_on_both = sheet_is_on_both(f, facts, n);

        if (is_on_both && f->branch == FOURLINK_CROSSED)
            continue;
        put_name(r, f->name);
        if (f->words) {
            page_print(p, "<td colspan=\"%d\">%s</td>", 2 + c.has_angles + c.has_branches,
                       f->words);
        } else {
            page_number_cell(p, f->value, r->v.problem.digits, c.behind);
            page_print(p, "<td>%u</td>", f->unit);
            if (c.has_angles)
                put_angle(r, f);
            if (c.has_branches)
                page_print(p, "<td>%s</td>",
                           f->branch && !is_on_both ? fourlink_branch_text(f->branch) : "");
        }
        page_print(p, "<td>%s</td></tr>\n", f->meaning);
    }
    page_table_end(p);
}

/* The settled smallest or largest value of a column, by its handle; undefined without an extreme.  1 if
** it has one. */
static int find_extreme(const report *r, const view_extremes *extremes, int handle,
                        fourlink_value *x)
{
    const fourlink_value *v = view_extreme(extremes, handle);

    if (v)
        *x = view_settled(&r->v, v);
    return v != NULL;
}

/* Write the smallest value of a column, or the largest, and its angle. */
static void put_extreme(report *r, const view_extremes *extremes, int handle, int behind)
{
    fourlink_value x;

    if (!find_extreme(r, extremes, handle, &x)) {
        page_print(&r->page, "<td></td><td></td>");
        return;
    }
    page_number_cell(&r->page, x.value, r->v.problem.digits, behind);
    put_angle(r, &x);
}

static int is_of_extremes(const fourlink_value *column)
{
    return !(column->flags & (FOURLINK_CRANK_ANGLE | FOURLINK_OF_ROUNDING));
}

static void put_extremes(report *r, fourlink_branch branch)
{
    const char *of = branch == FOURLINK_OPEN ? "open branch" : "crossed branch";
    const fourlink_value *columns = r->v.columns;
    char caption[60];
    static const int statistics[2] = {FOURLINK_MIN, FOURLINK_MAX};
    int behind[2] = {0, 0}, k;
    view_extremes extremes;
    fourlink_value x;
    int status = view_find_extremes(&r->v, branch, &extremes);
    unsigned long i;

    if (status == FOURLINK_LONG_SEARCH || status == FOURLINK_TOO_LONG) {
        page_print(&r->page, "<p class=\"missing\">No smallest and largest values, %s: %s.</p>\n",
                   of, fourlink_status_text(status));
        r->failed++;
        return;
    }
    flk_text_join(caption, sizeof caption, "Smallest and largest values, ", of, (char *)NULL);
    page_table_of(&r->page, "facts broad", caption,
                  "Column|Unit|Smallest|" PAGE_AT "|Largest|" PAGE_AT);
    for (i = 0; i < r->v.n_columns; i++)
        for (k = 0; k < 2 && is_of_extremes(&columns[i]); k++)
            if (find_extreme(r, &extremes, columns[i].handle + statistics[k], &x))
                behind[k] = GSL_MAX_INT(behind[k], page_behind(x.value, r->v.problem.digits));
    for (i = 0; i < r->v.n_columns; i++) {
        if (!is_of_extremes(&columns[i]))
            continue;
        put_name(r, columns[i].name);
        page_print(&r->page, "<td>%u</td>", columns[i].unit);
        for (k = 0; k < 2; k++)
            put_extreme(r, &extremes, columns[i].handle + statistics[k], behind[k]);
        page_print(&r->page, "</tr>\n");
    }
    page_table_end(&r->page);
}

void report_put_facts(report *r)
{
    int i;

    put_facts(r, "Type and key facts", FOURLINK_FACTS_LIMITS);
    put_facts(r, "Turning moment", FOURLINK_FACTS_TURNING);
    put_facts(r, "Actual motion", FOURLINK_FACTS_MOTION);
    for (i = 0; i < r->v.n_branches && r->v.problem.n_rows > 1; i++)
        put_extremes(r, r->v.branches[i]);
}

/* ------------------------------------------------------------------------------ the box of results */

/* What the first page has room for: facts, with their own meanings, and statistics of columns. */
static const struct {
    const char *name, *words;
    int statistic; /* FOURLINK_MAX ...; 0: a fact */
} results[] = {{"theta4_min", "smallest angle of link 4", 0},
               {"theta4_max", "largest angle of link 4", 0},
               {"theta4_swing", "range of the angle of link 4", 0},
               {"swing", "swing of link 4", 0},
               {"stroke", NULL, 0},
               {"time_ratio", NULL, 0},
               {"mu_min", NULL, 0},
               {"omega4", "largest speed of link 4", FOURLINK_MAX},
               {"v", "largest speed along the stroke", FOURLINK_MAX},
               {"a", "largest acceleration along the stroke", FOURLINK_MAX},
               {"F12", "largest force in pin A", FOURLINK_MAX},
               {"F23", "largest force in pin B", FOURLINK_MAX},
               {"F34", "largest force between links 3 and 4", FOURLINK_MAX},
               {"F14", "largest force in pin D", FOURLINK_MAX},
               {"N", "largest force of the guide", FOURLINK_MAX},
               {"Ts", "largest driving torque", FOURLINK_MAX},
               {"Ts", "smallest driving torque", FOURLINK_MIN},
               {"drive", "largest force or torque of what drives", FOURLINK_MAX},
               {"drive", "smallest force or torque of what drives", FOURLINK_MIN},
               {"mean_power", NULL, 0},
               {"energy_fluctuation", NULL, 0},
               {"flywheel_inertia", NULL, 0},
               {"mean_speed", NULL, 0},
               {"fluctuation_exact", "coefficient of fluctuation of speed", 0}};

enum { RESULTS = sizeof results / sizeof results[0] };

static int is_of_motion(const char *name)
{
    return strcmp(name, "omega4") == 0 || strcmp(name, "v") == 0 || strcmp(name, "a") == 0;
}

/* Find a result on a branch; of one instant, its value there.  0 if there is none; the speeds of a crank
** that stands still say nothing. */
static int find_result(report *r, int i, fourlink_branch branch, fourlink_value *found)
{
    const fourlink_problem *p = &r->v.problem;
    int statistic = p->n_rows > 1 ? results[i].statistic : 0;

    if (p->mechanism.drive && strcmp(results[i].name, "Ts") == 0)
        return 0; /* the crank does not drive */
    if ((p->n_rows < 2 && results[i].statistic == FOURLINK_MIN) ||
        (view_is_still(&r->v) && is_of_motion(results[i].name)))
        return 0;
    return fourlink_results_find(r->v.results, results[i].name, found) == FOURLINK_OK &&
           !(found->flags & FOURLINK_CRANK_ANGLE) &&
           results_get(r->v.results, found->handle + statistic, branch, p->motion.from, found) ==
               FOURLINK_OK &&
           !found->words && !gsl_isnan(found->value);
}

static void put_result(report *r, const fourlink_value *v)
{
    int digits = r->v.problem.digits;

    page_print(&r->page, "<td>%v%U", v->value, digits, v->unit);
    if (v->has_angle && r->v.problem.n_rows > 1)
        page_print(&r->page, " <small>at %v%U</small>", v->angle, digits,
                   r->v.units[QUANTITY_ANGLE].name);
    page_print(&r->page, "</td>");
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

    results_facts(r->v.results, 0, FOURLINK_FACTS_LIMITS, &facts, &n);
    if (n && facts[0].words)
        page_print(p, "<p class=\"type\">%s.</p>\n", facts[0].words);
    page_table_of(p, "results", "Results",
                  r->v.n_branches > 1 ? "Result|open branch|crossed branch" : "Result|Value");
    for (i = 0; i < RESULTS; i++)
        put_results_line(r, i);
    page_table_end(p);
}
