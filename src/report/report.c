/* SPDX-License-Identifier: GPL-3.0-or-later
**
** report.c - the report of a deck: the order of its sections.
*/
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "system/memory.h"
#include "report.h"
#include "system/xml.h"
#include "tables/at.h"
#include "tables/sheet.h"
#include "view/notation.h"
#include "view/results.h"

#define BLANK_LINES 10 /* for the discussion */

static const char *size_of_paper(const report *r)
{
    const char *length = r->v.results ? r->v.units[QUANTITY_LENGTH].name : "mm";

    return !r->request->is_printed                                  ? ""
           : strcmp(length, "in") == 0 || strcmp(length, "ft") == 0 ? "size: Letter; "
                                                                    : "size: A4; ";
}

/* At the head of each printed page, the title: a string of CSS, within an element of HTML that is XML too. */
static void put_running_title(report *r, const char *title)
{
    static const char special[] = "\"\\<>&'";
    page *p = &r->page;
    size_t n;

    page_print(p, "<style>@page {%s@top-left {font: 8pt serif; content: \"", size_of_paper(r));
    for (; *title; title += n) {
        n = strcspn(title, special);
        xml_put(p->out, title, n);
        if (title[n])
            fprintf(p->out, "\\%02x ", (unsigned)title[n++]);
    }
    page_print(p, "\"} @bottom-left {font: 8pt serif; content: \"Made by fourlink %s\"}}</style>\n",
               fourlink_version());
}

static void put_head(report *r, const char *title)
{
    page_print(&r->page,
               "<!DOCTYPE html>\n"
               "<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
               "<meta charset=\"utf-8\"/>\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
               "<meta name=\"generator\" content=\"fourlink %s\"/>\n<title>%s</title>\n",
               fourlink_version(), title);
    report_put_style(&r->page);
    put_running_title(r, title);
    page_print(&r->page,
               "</head>\n<body>\n<main>\n<header>\n<h1>%s</h1>\n"
               "<p class=\"lines\"><label class=\"line\">Name <input id=\"typed-name\" "
               "autocomplete=\"name\"/></label> <label class=\"line\">Date <input "
               "id=\"typed-date\" autocomplete=\"off\"/></label></p>\n"
               "<p id=\"typed-status\" class=\"typed-status\" role=\"status\"></p>\n</header>\n",
               title);
}

static void put_discussion(report *r)
{
    int i;

    page_print(&r->page,
               "<textarea id=\"typed-discussion\" rows=\"12\" aria-label=\"Discussion\">"
               "</textarea>\n<div class=\"typed\"></div>\n"
               "<p class=\"save\"><button type=\"button\" id=\"typed-save\" hidden=\"hidden\">"
               "Save this report</button></p>\n<div class=\"blank-lines\">");
    for (i = 0; i < BLANK_LINES; i++)
        page_print(&r->page, "<div></div>");
    page_print(&r->page, "</div>\n");
}

/* The sections in their order: what is given, what follows, and how it was checked. */
typedef enum { ALWAYS, WITH_RESULTS, WITH_SOLUTION, WITH_ROWS } need;
static const struct {
    const char *id, *heading;
    need when;
    void (*put)(report *r);
} sections[] = {{"inputs", "Given data", WITH_RESULTS, report_put_inputs},
                {"mechanism", "Mechanism and results", WITH_RESULTS, report_put_mechanism},
                {"synthesis", "Synthesis", WITH_SOLUTION, report_put_synthesis},
                {"sample", "Sample calculation", WITH_RESULTS, report_put_sample},
                {"curves", "Curves and diagrams", WITH_ROWS, report_put_curves},
                {"facts", "All facts and extremes", WITH_RESULTS, report_put_facts},
                {"checks", "Checks", WITH_RESULTS, report_put_checks},
                {"discussion", "Discussion", WITH_RESULTS, put_discussion},
                {"tables", "Tables", WITH_RESULTS, report_put_tables},
                {"deck", "Deck", ALWAYS, report_put_deck}};

#define SECTIONS (sizeof sections / sizeof sections[0])

static int has_section(const report *r, need when)
{
    if (when == WITH_SOLUTION)
        return r->v.results && r->request->found;
    return when == ALWAYS || (r->v.results && (when == WITH_RESULTS || r->has_rows));
}

static void put_contents(report *r)
{
    size_t i;

    page_print(&r->page, "<nav class=\"contents\" aria-label=\"Contents\">\n<ol>\n");
    for (i = 0; i < SECTIONS; i++)
        if (has_section(r, sections[i].when))
            page_print(&r->page, "<li><a href=\"#%s\">%s</a></li>\n", sections[i].id,
                       sections[i].heading);
    page_print(&r->page, "</ol>\n</nav>\n");
}

static void put_page(report *r)
{
    const char *title = r->v.problem.title[0] ? r->v.problem.title : view_file_of(r->source->name);
    size_t i;

    put_head(r, title);
    if (r->v.results)
        put_contents(r);
    for (i = 0; i < SECTIONS && !memory_has_failed(); i++) {
        if (!has_section(r, sections[i].when))
            continue;
        page_section(&r->page, sections[i].id, sections[i].heading);
        sections[i].put(r);
        page_section_end(&r->page);
    }
    page_print(&r->page, "<footer><p>Made by fourlink %s.</p></footer>\n</main>\n",
               fourlink_version());
    if (r->v.results)
        report_put_script(&r->page);
    page_print(&r->page, "</body>\n</html>\n");
}

/* Read the place of the request. */
static int read_spot(report *r, view_spot *spot, fourlink_mistake *mistake)
{
    const char *list = r->request->at;
    char message[400];
    at_item item;

    if (at_next(&r->v, &list, &item, message) != 1)
        return view_refuse(mistake, "--plot-at", message, "");
    if (item.column)
        return view_refuse(mistake, "--plot-at", "a report needs a crank angle, such as 30 deg",
                           "");
    *spot = item.spot;
    return !list ||
           view_refuse(mistake, "--plot-at", "a report shows one position, not several", "");
}

/* Find the position of the sample calculation: that at its crank angle, which pictures have too. */
static int find_sample(report *r, fourlink_mistake *mistake)
{
    const char *at = r->request->at;
    char number[FORMAT_SIZE], typeset[NOTATION_SIZE], why[VIEW_WHY];
    view_spot spot;

    if (at && !read_spot(r, &spot, mistake))
        return 0;
    view_find_position(&r->v, r->v.branches[0], at ? &spot : NULL, &r->now, r->loads);
    if (r->now.status == FOURLINK_OK)
        view_find_along(&r->v, r->v.branches[0], r->v.problem.has_both_sides ? r->now.row.side : 0,
                        r->now.row.place, NULL, &r->now, r->loads);
    notation_unit(r->v.units[QUANTITY_ANGLE].name, typeset);
    flk_text_join(r->at, sizeof r->at, r->now.row.angle < 0 ? "\342\210\222" : "", /* a minus */
                  format_general(fabs(r->now.row.angle), 6, number),
                  isalpha((unsigned char)*typeset) ? "\302\240" : "", typeset, (char *)NULL);
    if (!at && r->now.status == FOURLINK_OK)
        flk_text_join(r->why, sizeof r->why, view_tell_position(&r->v, &r->now, r->loads, why),
                      (char *)NULL);
    r->drawn_at = r->request->at;
    if (!r->v.problem.over.is_crank_angle && !r->request->at && r->now.status == FOURLINK_OK)
        r->drawn_at =
            flk_text_join(r->exact, sizeof r->exact, format_general(r->now.row.place, 17, number),
                          " ", r->v.problem.over.unit, (char *)NULL);
    return 1;
}

/* 1; 0 and the reason why not; -1 if out of memory. */
static int open_deck(report *r, fourlink_mistake *mistake)
{
    const char *why;
    unsigned long n;

    view_take(&r->v, r->request->opened);
    if (!view_find_motion(&r->v))
        return -1;
    r->has_rows = view_count_missing(&r->v, &n, &why) < n;
    fourlink_results_notes(r->v.results, REPORT_MISTAKES, r->notes, &r->n_notes);
    r->loads = memory_get(r->v.problem.n_loads + 1, sizeof *r->loads);
    r->row_loads = memory_get(r->v.problem.n_loads + 1, sizeof *r->row_loads);
    return r->loads && r->row_loads ? find_sample(r, mistake) : -1;
}

/* Read a deck with mistakes again, for these.  The same. */
static int find_mistakes(report *r)
{
    fourlink_results *results = NULL;

    results_open(r->source, REPORT_MISTAKES, &results, r->notes, &r->n_notes);
    fourlink_results_free(results);
    return 1;
}

/* Free what a report has taken; returns `opened`, or -1 if memory or a file has failed. */
static int close_report(report *r, int opened)
{
    plot_deck_close(&r->drawn);
    free(r->loads);
    free(r->row_loads);
    free(r->notes);
    return memory_has_failed() || r->reason ? -1 : opened;
}

/* The same as open_deck, or find_mistakes. */
static int open_report(report *r, FILE *out, const fourlink_source *source,
                       const report_request *request, fourlink_mistake *mistake)
{
    memset(r, 0, sizeof *r);
    r->page.out = out;
    r->source = source;
    r->request = request;
    r->notes = memory_get(REPORT_MISTAKES, sizeof *r->notes);
    if (!r->notes)
        return -1;
    return request->opened ? open_deck(r, mistake) : find_mistakes(r);
}

int report_write(FILE *out, const fourlink_source *source, const report_request *request,
                 report_outcome *outcome, fourlink_mistake *mistake)
{
    report r;
    int opened = open_report(&r, out, source, request, mistake);

    if (opened > 0)
        put_page(&r);
    outcome->has_failed = r.failed > 0;
    outcome->differs = r.differing > 0;
    outcome->reason = r.reason;
    return close_report(&r, opened);
}

int report_write_sample(FILE *out, const fourlink_source *source, const report_request *request,
                        fourlink_mistake *mistake)
{
    report r;
    int opened = open_report(&r, out, source, request, mistake);

    if (opened > 0)
        report_put_sample(&r);
    return close_report(&r, opened);
}
