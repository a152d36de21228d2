/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawing.c - the picture of a deck, drawn by gnuplot, or its script; its report.
*/
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "system/system.h"
#include "command.h"
#include "drawing.h"
#include "output.h"
#include "pictures/plot.h"
#include "report/report.h"

/* What pictures and reports show: the deck with lengths in the unit in which it writes them. */
typedef struct shown {
    fourlink_source source;
    fourlink_results *results; /* null: the deck has mistakes */
    fourlink_results *own;     /* null: they are those of the input */
} shown;

/* Returns 0 if out of memory. */
static int open_shown(const input *in, shown *x)
{
    view v;

    x->source = in->source;
    x->source.is_drawn = 1;
    x->results = in->results;
    x->own = NULL;
    if (!in->results)
        return 1;
    view_take(&v, in->results);
    if (strcmp(v.drawn_length.name, v.units[QUANTITY_LENGTH].name) == 0)
        return 1;
    if (fourlink_results_open(&x->source, 0, &x->own, NULL, NULL) != FOURLINK_OK)
        return 0;
    x->results = x->own;
    return 1;
}

/* Let gnuplot draw a script; returns the exit status. */
static int draw(const options *o, FILE *script, const plot_caption *caption)
{
    output file;
    const char *path = o->plot, *why;
    char reason[GNUPLOT_REASON];
    int status = output_begin(&file, path);

    if (status)
        return status;
    why = gnuplot_run(script, file.file, o->drawing.file == PLOT_SVG ? caption : NULL, reason);
    status = why ? command_complain("cannot draw", path, why) : 0;
    return command_worse(status, output_end(&file, path, status == 0));
}

/* Copy a script; returns the exit status. */
static int copy(const char *path, FILE *script)
{
    output file;
    int status = output_begin(&file, path), c;

    if (status)
        return status;
    rewind(script);
    while ((c = getc(script)) != EOF)
        putc(c, file.file);
    if (ferror(script))
        status = command_complain("cannot write", path, strerror(errno));
    return command_worse(status, output_end(&file, path, status == 0));
}

static int write_script(FILE *script, const input *in, plot_caption *caption)
{
    plot_request request = in->o->drawing;
    fourlink_mistake mistake;
    fourlink_value error;
    shown x;
    int written = -1;

    if (in->o->no_kind &&
        fourlink_results_find(in->results, "structural_error", &error) == FOURLINK_OK)
        request.kind = PLOT_ERROR;
    if (open_shown(in, &x)) {
        request.opened = x.results;
        written = plot_write(script, &x.source, &request, caption, &mistake);
    }
    fourlink_results_free(x.own);
    if (written < 0)
        return command_complain("cannot draw", in->name, "not enough memory");
    if (written > 0)
        return fflush(script) == 0 && !ferror(script)
                   ? 0
                   : command_complain("cannot draw", in->name, strerror(errno));
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
    missing = view_count_missing(&v, &all, &why);
    if (v.range.stops && !missing)
        return tell_missing(in, 1, all + 1, "rows", "the crank comes to rest before the last one");
    return tell_missing(in, missing, all, "rows", why);
}

int drawing_begin(drawing *d, const input *in)
{
    int status;

    d->in = in;
    d->script = system_scratch();
    if (!d->script)
        return command_complain("cannot draw", in->name, strerror(errno));
    status = write_script(d->script, in, &d->caption);
    if (status) {
        fclose(d->script);
        d->script = NULL;
    }
    return status;
}

int drawing_end(drawing *d, int keep)
{
    const options *o = d->in->o;
    int status = 0;

    if (keep)
        status = o->plot_script ? copy(o->plot_script, d->script) : draw(o, d->script, &d->caption);
    fclose(d->script);
    if (status || !keep || options_want_table(o))
        return status;
    if (d->caption.n_lines)
        return tell_missing(d->in, d->caption.n_missing, d->caption.n_lines, "lines of the [sweep]",
                            "");
    return tell_missing_rows(d->in);
}

/* ---------------------------------------------------------------------------------------- the report */

int drawing_report(const input *in)
{
    const char *path = in->o->report;
    report_outcome outcome;
    fourlink_mistake mistake;
    report_request request;
    shown x;
    output file;
    int status = output_begin(&file, path), written = -1;

    if (status)
        return status;
    request.at = in->o->drawing.at;
    request.found = in->found;
    if (open_shown(in, &x)) {
        request.opened = x.results;
        written = report_write(file.file, &x.source, &request, &outcome, &mistake);
    }
    fourlink_results_free(x.own);
    status = output_end(&file, path, written > 0);
    if (written < 0)
        return command_complain("cannot write", path, fourlink_status_text(FOURLINK_NO_MEMORY));
    if (!written) {
        command_tell("error", mistake.file, mistake.line, mistake.message, NULL);
        return EXIT_USAGE;
    }
    if (status)
        return status;
    if (outcome.gnuplot[0])
        command_say("fourlink: ", path, " has no pictures: ", outcome.gnuplot, (char *)NULL);
    if (outcome.has_failed)
        command_say("fourlink: ", path, ": rows could not be computed", (char *)NULL);
    if (outcome.differs)
        command_say("fourlink: ", path, ": expected values differ", (char *)NULL);
    return outcome.has_failed || outcome.differs ? EXIT_ROWS : 0;
}
