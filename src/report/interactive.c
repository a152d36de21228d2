/* SPDX-License-Identifier: GPL-3.0-or-later
**
** interactive.c - the interactive drawing of a report: its controls, its rows as JSON, its style and
** its script.
**
** The script computes nothing: it moves what is drawn here.  See moving_json.c and player.js.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "drawing/svg.h"
#include "system/memory.h"
#include "assets.h"
#include "interactive.h"
#include "report.h"
#include "tables/json_text.h"
#include "tables/style.h"
#include "view/notation.h"

#define DIGITS 5       /* of a number that is undefined or unbounded */
#define STEP_DIGITS 10 /* of a crank angle or a time */

static void put_lines(page *p, const char *const *lines)
{
    for (; *lines; lines++)
        page_print(p, "%m\n", *lines);
}

void report_put_style(page *p)
{
    page_print(p, "<style>/*<![CDATA[*/\n");
    put_lines(p, assets_style);
    svg_put_style(p->out);
    page_print(p, "/*]]>*/</style>\n");
}

void report_put_script(page *p)
{
    page_print(p, "<script>//<![CDATA[\n");
    put_lines(p, assets_script);
    page_print(p, "//]]></script>\n");
}

/* ------------------------------------------------------------------------------------ the deck's table */

void interactive_put_label(line *l, const char *name)
{
    char below[NOTATION_SIZE];
    notation n;

    notation_split(name, &n);
    interactive_put(l, "[%q,%q,\"\"]", n.symbol, notation_below(&n, below));
}

static void put_column(line *l, const fourlink_value *c, const style *x)
{
    interactive_put(l, "{\"name\":%q,\"unit\":%q,\"meaning\":%q,\"label\":", c->name, c->unit,
                    c->meaning);
    interactive_put_label(l, c->name);
    line_put(l, ",\"decimals\":%lu%s,\"form\":\"%s\"}", (unsigned long)x->decimals,
             c->flags & FOURLINK_OF_ROUNDING ? ",\"rounding\":true" : "",
             c->flags & FOURLINK_CRANK_ANGLE ? "angle"
             : x->exponent                   ? "exponent"
                                             : "fixed");
}

/* Write the columns, with the style that the format table gives them. */
static void put_columns(line *l, const rows *t, style *styles)
{
    unsigned long j;

    style_find(&t->v, 0, t->table, styles);
    line_put(l, "\"columns\":[");
    for (j = 0; j < t->v.n_columns; j++) {
        line_put(l, j ? ",\n" : "\n");
        put_column(l, &t->v.columns[j], &styles[j]);
    }
    line_put(l, "],\n");
}

static void put_cell(line *l, double x, const fourlink_value *c, const style *how)
{
    char number[FORMAT_SIZE];

    if (!gsl_finite(x))
        json_text_number(l, x, DIGITS);
    else if (c->flags & FOURLINK_CRANK_ANGLE)
        line_number(l, x, STEP_DIGITS);
    else if (how->exponent)
        line_put(l, "%s", format_exponent(x, how->decimals, number));
    else
        line_put(l, "%s", format_fixed(x, how->decimals, number));
}

static void put_table(line *l, const rows *t, const style *styles)
{
    unsigned long i, j;

    line_put(l, "\"table\":[");
    for (i = 0; i < t->n; i++) {
        line_put(l, i ? ",\n[" : "\n[");
        for (j = 0; j < t->v.n_columns; j++) {
            line_put(l, j ? "," : "");
            put_cell(l, t->table[i * t->v.n_columns + j], &t->v.columns[j], &styles[j]);
        }
        line_put(l, "]");
    }
    line_put(l, "]");
}

/* -------------------------------------------------------------------------------------------- branches */

/* Write why the linkage cannot be assembled, by row; "" where it can. */
static void put_reasons(line *l, const rows *t)
{
    unsigned long i, n = 0;

    line_put(l, "\"reasons\":{");
    for (i = 0; i < t->n; i++)
        if (t->status[i] != FOURLINK_OK)
            interactive_put(l, "%s\"%lu\":%q", n++ ? "," : "", i,
                            fourlink_status_text(t->status[i]));
    line_put(l, "},\n");
}

/* Write the drawings of a branch, the k-th; 0 without memory. */
static int put_panels(line *l, const rows *t, const interactive_form *form, int branch)
{
    moving *x = memory_get(1, sizeof *x);
    moving_panel *panel = memory_get(1, sizeof *panel);
    moving_steps steps;
    int done, n = 0, count, k;

    steps.at = t->steps;
    steps.n = t->n;
    done = x && panel && moving_open(x, t->source, t->v.results, t->branch, &steps);
    line_put(l, "\"panels\":[");
    if (done && form->sheets)
        x->sheet = form->sheets[branch];
    count = !done ? 0 : form->is_brief ? 1 : moving_count(x);
    for (k = 0; done && k < count; k++) {
        if (moving_draw(x, k, panel)) {
            interactive_put_comma(l, &n);
            done = moving_json_put(l, panel);
        }
        motion_close(&panel->list);
        done = done && !memory_has_failed();
    }
    line_put(l, "],\n");
    if (done && form->sheets)
        form->sheets[branch] = x->sheet;
    if (x)
        moving_close(x);
    free(x);
    free(panel);
    return done;
}

static int put_branch(line *l, const rows *t, const style *styles, const interactive_form *form,
                      int branch)
{
    int done;

    line_put(l, "{\"name\":\"%s\",\n", fourlink_branch_text((int)t->branch));
    put_reasons(l, t);
    done = put_panels(l, t, form, branch);
    put_table(l, t, styles);
    line_put(l, "}");
    return done;
}

static void put_steps(line *l, const rows *t, double start)
{
    unsigned long i, first = 0;

    line_put(l, "\"over\":\"%s\",\n\"steps\":[", t->v.problem.over.name);
    for (i = 0; i < t->n; i++) {
        line_put(l, i ? "," : "");
        line_number(l, view_over(&t->v, t->steps[i]), STEP_DIGITS);
        if (fabs(t->steps[i] - start) < fabs(t->steps[first] - start))
            first = i;
    }
    line_put(l, "],\n\"start\":%lu,\n", first);
}

int interactive_write(FILE *out, rows *t, const fourlink_branch *branches, int n,
                      const interactive_form *form)
{
    style *styles = memory_get(t->v.n_columns + 1, sizeof *styles);
    int i, done = styles != NULL;
    line l;

    line_start(&l, out);
    line_put(&l, "{\n");
    if (styles) {
        put_columns(&l, t, styles);
        put_steps(&l, t, form->start);
        interactive_put_scene(&l, t);
    }
    line_put(&l, "\"branches\":[\n");
    for (i = 0; done && i < n; i++) {
        rows_compute(t, branches[i]);
        line_put(&l, i ? ",\n" : "");
        done = put_branch(&l, t, styles, form, i);
    }
    line_put(&l, "]}\n");
    line_end(&l);
    free(styles);
    return done;
}

/* ------------------------------------------------------------------------------------------ the markup */

static const char *const controls[] = {
    "<div class=\"controls\" id=\"fourlink-controls\" hidden=\"hidden\">",
    "<label for=\"fourlink-angle\">Crank angle <span "
    "class=\"theta\">\316\270<sub>2</sub></span></label>",
    "<input type=\"range\" id=\"fourlink-angle\" min=\"0\" max=\"1\" step=\"1\" value=\"0\"/>",
    "<output for=\"fourlink-angle\" id=\"fourlink-shown\"></output>",
    "<button type=\"button\" id=\"fourlink-play\">Play</button>",
    "<fieldset id=\"fourlink-branches\" hidden=\"hidden\"><legend>Assembly "
    "mode</legend></fieldset>",
    "</div>",
    NULL};

/* The drawing of the mechanism, with its controls; without rows the results alone.  The results are
** between it and the other drawings. */
static void put_drawing(report *r, rows *t, double start)
{
    page *p = &r->page;
    interactive_form form;

    memset(&form, 0, sizeof form);
    form.start = start;
    page_print(p, "<div class=\"drawing\">\n");
    put_lines(p, controls);
    page_print(p, "<div id=\"fourlink-panels\" data-why=\"%s\" hidden=\"hidden\"></div>\n", r->why);
    report_put_results(r);
    page_print(p, "<div id=\"fourlink-more\" hidden=\"hidden\"></div>\n"
                  "<p id=\"fourlink-status\" role=\"status\" class=\"reader\"></p>\n</div>\n"
                  "<script type=\"application/json\" id=\"fourlink-rows\">");
    interactive_write(p->out, t, r->v.branches, r->v.n_branches, &form);
    page_print(p, "</script>\n");
}

void report_put_interactive(report *r)
{
    double start = r->now.status == FOURLINK_OK ? r->now.row.angle : GSL_NAN;
    rows *t = memory_get(1, sizeof *t);

    if (!t)
        return;
    if (rows_open(t, r->source, r->v.results, start)) {
        if (r->now.status == FOURLINK_OK)
            start = r->now.row.place;
        put_drawing(r, t, start);
    } else {
        report_put_results(r);
    }
    rows_close(t);
    free(t);
}
