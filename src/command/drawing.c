/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawing.c - the picture of a deck, and its report.
*/
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "system/memory.h"
#include "system/system.h"
#include "command.h"
#include "convert.h"
#include "drawing.h"
#include "output.h"
#include "pictures/plot.h"
#include "report/report.h"
#include "view/results.h"

/* What pictures and reports show: the results in the units of the deck. */
typedef struct shown {
    fourlink_source source;
    fourlink_results *results; /* null: the deck has mistakes */
    fourlink_results *own;     /* null: they are those of the input */
} shown;

/* Returns 0 if out of memory. */
static int open_shown(const input *in, shown *x)
{
    x->source = in->source;
    x->source.deck_units = 1;
    x->results = in->results;
    x->own = NULL;
    if (!in->results || in->source.deck_units)
        return 1;
    if (results_open_like(&x->source, in->results, 0, &x->own, NULL, NULL) != FOURLINK_OK)
        return 0;
    x->results = x->own;
    return 1;
}

/* 1 if a text picture has to do without Braille. */
static int is_ascii(const options *o)
{
    static const char *const variables[] = {"LC_ALL", "LC_CTYPE", "LANG"};
    const char *locale = NULL;
    size_t i;

    for (i = 0; i < 3 && !(locale && *locale); i++)
        locale = getenv(variables[i]);
    return o->ascii || !(locale && (strstr(locale, "UTF-8") || strstr(locale, "utf8") ||
                                    strstr(locale, "utf-8") || strstr(locale, "UTF8")));
}

/* Write a picture as a png or a pdf; null, or the reason why not. */
static const char *convert(const plot *x, plot_file file, FILE *out, char reason[CONVERT_REASON])
{
    FILE *svg = system_scratch();
    const char *why;

    if (!svg)
        return strerror(errno);
    plot_write(x, 0, 0, svg);
    why = fflush(svg) == 0 ? convert_svg(svg, file, out, reason) : strerror(errno);
    fclose(svg);
    return why;
}

/* Write a picture to its file; returns the exit status. */
static int write_picture(const drawing *d, const options *o)
{
    plot_file kind = o->drawing.file;
    char reason[CONVERT_REASON];
    const char *path = o->plot, *why = NULL;
    output file;
    int status = output_begin(&file, path);

    if (status)
        return status;
    if (kind == PLOT_PNG || kind == PLOT_PDF)
        why = convert(&d->picture, kind, file.file, reason);
    else if (!plot_write(&d->picture, kind == PLOT_TXT, is_ascii(o), file.file))
        why = "not enough memory";
    status = why ? command_complain("cannot draw", path, why) : 0;
    return command_worse(status, output_end(&file, path, status == 0));
}

static int make_picture(plot *made, const input *in)
{
    plot_request request = in->o->drawing;
    fourlink_mistake mistake;
    fourlink_value error;
    shown x;
    int written = -1;

    memset(made, 0, sizeof *made);
    if (in->o->no_kind &&
        fourlink_results_find(in->results, "structural_error", &error) == FOURLINK_OK)
        request.kind = PLOT_ERROR;
    if (open_shown(in, &x)) {
        request.opened = x.results;
        written = plot_make(made, &x.source, &request, &mistake);
    }
    fourlink_results_free(x.own);
    if (written < 0)
        return command_lacks_memory("cannot draw", in->name);
    if (written > 0)
        return 0;
    command_tell("error", mistake.file, mistake.line, mistake.message, NULL);
    return EXIT_USAGE;
}

/* Tell how many of the rows, or of the lines of a sweep, are missing in a picture, which is printed
** without the table that would tell; returns the exit status. */
static int tell_missing(const input *in, unsigned long missing, unsigned long all, const char *what,
                        const char *why)
{
    char numbers[80];

    if (missing)
        command_say("fourlink: ", in->name, ": ",
                    flk_message(numbers, sizeof numbers, "%ld of %ld ", (long)missing, (long)all),
                    what, " could not be computed", *why ? ": " : "", why, (char *)NULL);
    return missing ? EXIT_ROWS : 0;
}

/* The same for the rows of the deck, or of the first design of its sweep. */
static int tell_missing_rows(const input *in)
{
    unsigned long missing, all;
    const char *why;
    view v;

    view_take(&v, in->results);
    if (!view_find_motion(&v))
        return command_lacks_memory("cannot analyse", in->name);
    missing = view_count_missing(&v, &all, &why);
    if (v.range.stops && !missing)
        return tell_missing(in, 1, all + 1, "rows", "the crank comes to rest before the last one");
    return tell_missing(in, missing, all, "rows", why);
}

int drawing_begin(drawing *d, const input *in)
{
    int status;

    d->in = in;
    status = make_picture(&d->picture, in);
    d->is_there = status == 0;
    if (status)
        plot_free(&d->picture);
    return status;
}

int drawing_end(drawing *d, int keep)
{
    const plot_caption *caption = &d->picture.caption;
    const options *o = d->in->o;
    int status = 0;

    if (keep)
        status = write_picture(d, o);
    plot_free(&d->picture);
    if (status || !keep || options_want_table(o))
        return status;
    if (caption->n_lines)
        return tell_missing(d->in, caption->n_missing, caption->n_lines, "lines of the [sweep]",
                            "");
    return tell_missing_rows(d->in);
}

/* ---------------------------------------------------------------------------------------- the report */

/* What became of a report. */
typedef struct made {
    int written; /* 1; 0: there is none, and the mistake says why; -1: out of memory */
    report_outcome outcome;
    fourlink_mistake mistake;
} made;

static void make_report(const input *in, int is_printed, FILE *out, made *m)
{
    report_request request;
    shown x;

    memset(m, 0, sizeof *m);
    m->written = -1;
    memset(&request, 0, sizeof request);
    request.is_printed = is_printed;
    request.at = in->o->drawing.at;
    request.found = in->found;
    if (open_shown(in, &x)) {
        request.opened = x.results;
        m->written = report_write(out, &x.source, &request, &m->outcome, &m->mistake);
    }
    fourlink_results_free(x.own);
}

/* Say what failed, or what the report tells; `status` is that of its file.  Returns the exit status. */
static int tell_report(const char *path, const made *m, int status)
{
    const report_outcome *o = &m->outcome;
    char why[100];

    if (o->reason && !memory_has_failed())
        return command_complain("cannot write", path,
                                flk_text_join(why, sizeof why, "its temporary file: ",
                                              strerror(o->reason), (char *)NULL));
    if (m->written < 0)
        return command_lacks_memory("cannot write", path);
    if (!m->written) {
        command_tell("error", m->mistake.file, m->mistake.line, m->mistake.message, NULL);
        return EXIT_USAGE;
    }
    if (status)
        return status;
    if (o->has_failed)
        command_say("fourlink: ", path, ": rows could not be computed", (char *)NULL);
    if (o->differs)
        command_say("fourlink: ", path, ": expected values differ", (char *)NULL);
    return o->has_failed || o->differs ? EXIT_ROWS : 0;
}

/* Print a page to a file; returns the exit status. */
static int print_page(FILE *html, const char *path)
{
    FILE *pdf = system_scratch();
    char reason[CONVERT_REASON];
    const char *why = pdf ? convert_page(html, path, pdf, reason) : strerror(errno);
    output file;
    int status;

    if (why)
        status = command_complain("cannot print", path, why);
    else if ((status = output_begin(&file, path)) == 0)
        status = output_end(&file, path, convert_copy(pdf, file.file));
    if (pdf)
        fclose(pdf);
    return status;
}

static int report_as_pdf(const input *in, const char *path)
{
    FILE *html = system_scratch();
    int status = 0;
    made m;

    if (!html)
        return command_complain("cannot print", path, strerror(errno));
    make_report(in, 1, html, &m);
    if (m.written > 0 && !m.outcome.reason && !memory_has_failed())
        status = print_page(html, path);
    fclose(html);
    return tell_report(path, &m, status);
}

int drawing_report(const input *in)
{
    const char *path = in->o->report;
    output file;
    int status;
    made m;

    if (flk_text_ends_in(flk_text_of(path), ".pdf"))
        return report_as_pdf(in, path);
    status = output_begin(&file, path);
    if (status)
        return status;
    make_report(in, 0, file.file, &m);
    return tell_report(path, &m, output_end(&file, path, m.written > 0));
}
