/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawing.c - the picture of a deck, drawn by gnuplot, or its script.
*/
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "command.h"
#include "drawing.h"
#include "output.h"
#include "pictures/gnuplot.h"

/* Tell what became of gnuplot; the exit status. */
static int tell_gnuplot(gnuplot_result outcome, const char *path)
{
    switch (outcome) {
    case GNUPLOT_MISSING:
        return command_complain(
            "cannot draw", path,
            "gnuplot is not installed; its package is gnuplot-nox (Debian, Ubuntu) or "
            "gnuplot. --plot-script writes the script for it");
    case GNUPLOT_FAILED:
        return command_complain("cannot draw", path, "gnuplot failed");
    case GNUPLOT_ERRNO:
        return command_complain("cannot draw", path, strerror(errno));
    case GNUPLOT_OK:
    default:
        return 0;
    }
}

/* Have gnuplot draw a script; the exit status. */
static int draw(const char *path, FILE *script)
{
    output file;
    int status = output_begin(&file, path);

    if (status)
        return status;
    status = tell_gnuplot(gnuplot_run(script, file.file), path);
    return command_worse(status, output_end(&file, path, status == 0));
}

static int write_script(FILE *script, const input *in)
{
    const options *o = in->o;
    plot_request request;
    fourlink_mistake mistake;

    memset(&request, 0, sizeof request);
    request.kind = o->plot_kind;
    request.file = o->plot_file;
    request.picture = o->plot_script && o->plot && strcmp(o->plot, "-") != 0 ? o->plot : NULL;
    request.at = o->plot_at;
    if (picture_write(script, &in->source, &request, &mistake))
        return 0;
    command_tell_mistake(mistake.file, mistake.line, mistake.message, NULL);
    return EXIT_USAGE;
}

int drawing_write(const input *in)
{
    const options *o = in->o;
    FILE *script;
    output file;
    int status;

    if (o->plot_script) {
        status = output_begin(&file, o->plot_script);
        if (status)
            return status;
        status = write_script(file.file, in);
        return command_worse(status, output_end(&file, o->plot_script, status == 0));
    }
    script = tmpfile();
    if (!script)
        return command_complain("cannot draw", o->plot, strerror(errno));
    status = write_script(script, in);
    if (!status)
        status = draw(o->plot, script);
    fclose(script);
    return status;
}
