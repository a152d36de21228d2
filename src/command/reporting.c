/* SPDX-License-Identifier: GPL-3.0-or-later
**
** reporting.c - the report of a deck, in a file.
*/
#include <stdio.h>

#include "command.h"
#include "output.h"
#include "report/report.h"
#include "writers.h"

int reporting_write(const input *in)
{
    const char *path = in->o->report;
    report_outcome outcome;
    fourlink_mistake mistake;
    report_request request;
    input_drawn drawn;
    output file;
    int status = output_begin(&file, path), written = -1;

    if (status)
        return status;
    request.at = in->o->drawing.at;
    request.found = in->found;
    if (input_open_drawn(in, &drawn) == FOURLINK_OK) {
        request.opened = drawn.results;
        written = report_write(file.file, &drawn.source, &request, &outcome, &mistake);
    }
    input_close_drawn(&drawn);
    if (written < 0) {
        output_end(&file, path, 0);
        return command_complain("cannot write", path, fourlink_status_text(FOURLINK_NO_MEMORY));
    }
    if (!written) {
        command_tell_mistake(mistake.file, mistake.line, mistake.message, NULL);
        output_end(&file, path, 0);
        return EXIT_USAGE;
    }
    status = output_end(&file, path, 1);
    if (status)
        return status;
    if (outcome.gnuplot[0])
        command_say("fourlink: ", path, " has no pictures: ", outcome.gnuplot, (char *)NULL);
    if (outcome.has_failed)
        command_say("fourlink: ", path, ": rows could not be computed, or expected values differ",
                    (char *)NULL);
    return outcome.has_failed ? EXIT_ROWS : 0;
}
