/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawing.c - the picture of a deck, drawn by gnuplot, or its script.
*/
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/system.h"
#include "command.h"
#include "drawing.h"
#include "output.h"
#include "pictures/gnuplot.h"

/* Let gnuplot draw a script; returns the exit status. */
static int draw(const char *path, FILE *script)
{
    output file;
    const char *why;
    int status = output_begin(&file, path);

    if (status)
        return status;
    why = gnuplot_run(script, file.file);
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

static int write_script(FILE *script, const input *in)
{
    fourlink_mistake mistake;
    int written = picture_write(script, &in->source, &in->o->drawing, &mistake);

    if (written < 0)
        return command_complain("cannot draw", in->name, "not enough memory");
    if (written > 0)
        return fflush(script) == 0 && !ferror(script)
                   ? 0
                   : command_complain("cannot draw", in->name, strerror(errno));
    command_tell_mistake(mistake.file, mistake.line, mistake.message, NULL);
    return EXIT_USAGE;
}

int drawing_begin(drawing *d, const input *in)
{
    int status;

    d->in = in;
    d->script = system_scratch();
    if (!d->script)
        return command_complain("cannot draw", in->name, strerror(errno));
    status = write_script(d->script, in);
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
        status = o->plot_script ? copy(o->plot_script, d->script) : draw(o->plot, d->script);
    fclose(d->script);
    return status;
}
