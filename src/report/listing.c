/* SPDX-License-Identifier: GPL-3.0-or-later
**
** listing.c - the deck of a report: its text as it is, and what is wrong with it.
*/
#include <stdlib.h>
#include <string.h>

#include "base/utf16.h"
#include "system/memory.h"
#include "system/xml.h"
#include "report.h"

/* The first mistake, or note, at a line of the deck; null if there is none. */
static const fourlink_mistake *find_note(const report *r, long line)
{
    unsigned long i;

    for (i = 0; i < r->n_notes && i < REPORT_MISTAKES; i++)
        if (r->notes[i].line == line && strcmp(r->notes[i].file, r->source->name) == 0)
            return &r->notes[i];
    return NULL;
}

static void put_notes(report *r)
{
    unsigned long i;

    if (!r->n_notes)
        return;
    page_print(&r->page, r->v.results ? "<h3>Notes on the deck</h3>\n<ul>\n"
                                      : "<h3>Mistakes in the deck</h3>\n<ul class=\"mistakes\">\n");
    for (i = 0; i < r->n_notes && i < REPORT_MISTAKES; i++) {
        const fourlink_mistake *note = &r->notes[i];

        if (find_note(r, note->line))
            page_print(&r->page, "<li><a href=\"#line-%lu\">line %lu</a>: %s</li>\n",
                       (unsigned long)note->line, (unsigned long)note->line, note->message);
        else if (note->line)
            page_print(&r->page, "<li>%s, line %lu: %s</li>\n", note->file,
                       (unsigned long)note->line, note->message);
        else
            page_print(&r->page, "<li>%s: %s</li>\n", note->file, note->message);
    }
    if (r->n_notes > REPORT_MISTAKES)
        page_print(&r->page, "<li>and %lu more</li>\n", r->n_notes - REPORT_MISTAKES);
    page_print(&r->page, "</ul>\n");
    if (!r->v.results)
        page_print(&r->page, "<p>Nothing was computed.</p>\n");
}

/* The text, each line an element that a style can number, so that the text itself stays as it is. */
static void put_text(report *r)
{
    text rest, line;
    char *utf8;
    long n = 1;

    rest.start = r->source->text;
    rest.length = (size_t)r->source->length;
    utf8 = flk_utf16_is(rest) ? memory_get(UTF16_SIZE(rest.length), 1) : NULL;
    if (utf8)
        rest = flk_text_without_mark(flk_utf16_convert(rest, utf8));
    if (rest.length && rest.start[rest.length - 1] == '\n')
        rest.length--;
    page_print(&r->page, "<pre class=\"deck\">");
    for (; flk_text_split(&rest, '\n', &line); n++) {
        const char *element = find_note(r, n) ? "mark" : "span";

        page_print(&r->page, "<%m class=\"text-line\" id=\"line-%lu\">", element, (unsigned long)n);
        xml_put(r->page.out, line.start,
                line.length && line.start[line.length - 1] == '\r' ? line.length - 1 : line.length);
        page_print(&r->page, "</%m>\n", element);
    }
    page_print(&r->page, "</pre>\n");
    free(utf8);
}

static void put_changes(report *r)
{
    unsigned long i;

    if (!r->source->n_changes)
        return;
    page_print(&r->page, "<h3>Changes by options</h3>\n<ul>\n");
    for (i = 0; i < r->source->n_changes; i++)
        page_print(&r->page, "<li>%s: <code>%s</code></li>\n", r->source->changes[i].origin,
                   r->source->changes[i].assignment);
    page_print(&r->page, "</ul>\n");
}

void report_put_deck(report *r)
{
    if (r->v.problem.n_designs)
        page_print(&r->page,
                   "<p>The deck has a sweep of %lu designs; this report is of design %lu.</p>\n",
                   r->v.problem.n_designs, r->v.problem.design + 1);
    put_notes(r);
    put_text(r);
    put_changes(r);
}
