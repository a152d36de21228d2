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

    fourlink_results_list(r->v.results, FOURLINK_INPUTS, &inputs, &n);
    page_fold(p, 0, "Inputs as understood", n);
    page_table(p, NULL, "Name|Value|Unit|Meaning");
    for (i = 0; i < n; i++) {
        const fourlink_value *x = &inputs[i];

        if (x->words)
            page_print(p,
                       "<tr><th scope=\"row\">%s</th><td colspan=\"2\">%s</td><td>%s</td></tr>\n",
                       x->name, x->words, x->meaning);
        else
            page_row(p, "%s|%v|%u|%s", x->name, x->value, r->v.problem.digits, x->unit, x->meaning);
    }
    page_table_end(p);
    page_fold_end(p);
}

/* Begin a line with the name of a result. */
static void put_name(report *r, const char *name)
{
    page_print(&r->page, "<tr><th scope=\"row\" data-name=\"%s\">%n</th>", name, name);
}

/* Write a group of facts; one that is the same on both branches once. */
static void put_facts(report *r, const char *heading, int group)
{
    const fourlink_value *facts;
    page *p = &r->page;
    unsigned long n, i;

    results_facts(r->v.results, 0, group, &facts, &n);
    if (!n)
        return;
    page_table(p, heading, "Name|Value|Unit|" PAGE_AT "|Branch|Meaning");
    for (i = 0; i < n; i++) {
        const fourlink_value *f = &facts[i];
        int is_on_both = sheet_is_on_both(f, facts, n);

        if (is_on_both && f->branch == FOURLINK_CROSSED)
            continue;
        put_name(r, f->name);
        if (f->words) {
            page_print(p, "<td colspan=\"4\">%s</td>", f->words);
        } else {
            page_print(p, "<td>%v</td><td>%u</td>", f->value, r->v.problem.digits, f->unit);
            put_angle(r, f);
            page_print(p, "<td>%s</td>",
                       f->branch && !is_on_both ? fourlink_branch_text(f->branch) : "");
        }
        page_print(p, "<td>%s</td></tr>\n", f->meaning);
    }
    page_table_end(p);
}

/* Write the smallest value of a column, or the largest, and its angle; null: it has none. */
static void put_extreme(report *r, const fourlink_value *v)
{
    fourlink_value x;

    if (!v) {
        page_print(&r->page, "<td></td><td></td>");
        return;
    }
    x = view_settled(&r->v, v);
    page_print(&r->page, "<td>%v</td>", x.value, r->v.problem.digits);
    put_angle(r, &x);
}

static void put_extremes(report *r, fourlink_branch branch)
{
    const char *of = branch == FOURLINK_OPEN ? "open branch" : "crossed branch";
    const fourlink_value *columns = r->v.columns;
    char caption[60];
    view_extremes extremes;
    int status = view_find_extremes(&r->v, branch, &extremes);
    unsigned long i;

    if (status == FOURLINK_LONG_SEARCH || status == FOURLINK_TOO_LONG) {
        page_print(&r->page, "<p class=\"missing\">No smallest and largest values, %s: %s.</p>\n",
                   of, fourlink_status_text(status));
        r->failed++;
        return;
    }
    flk_text_join(caption, sizeof caption, "Smallest and largest values, ", of, (char *)NULL);
    page_table(&r->page, caption, "Column|Unit|Smallest|" PAGE_AT "|Largest|" PAGE_AT);
    for (i = 0; i < r->v.n_columns; i++) {
        if (columns[i].flags & (FOURLINK_CRANK_ANGLE | FOURLINK_OF_ROUNDING))
            continue;
        put_name(r, columns[i].name);
        page_print(&r->page, "<td>%u</td>", columns[i].unit);
        put_extreme(r, view_extreme(&extremes, columns[i].handle + FOURLINK_MIN));
        put_extreme(r, view_extreme(&extremes, columns[i].handle + FOURLINK_MAX));
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
} results[] = {{"theta4_min", NULL, 0},
               {"theta4_max", NULL, 0},
               {"theta4_swing", "range of the angle of link 4", 0},
               {"swing", NULL, 0},
               {"stroke", NULL, 0},
               {"time_ratio", "slow swing or stroke / quick one, in time", 0},
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
