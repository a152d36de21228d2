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

static int write_script(FILE *script, const input *in)
{
    fourlink_mistake mistake;
    int written = picture_write(script, &in->source, &in->o->drawing, &mistake);

    if (written > 0)
        return 0;
    if (written < 0)
        return command_complain("cannot draw", in->name, "not enough memory");
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
    script = system_scratch();
    if (!script)
        return command_complain("cannot draw", o->plot, strerror(errno));
    status = write_script(script, in);
    if (!status)
        status = draw(o->plot, script);
    fclose(script);
    return status;
}
