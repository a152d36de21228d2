/* SPDX-License-Identifier: GPL-3.0-or-later
**
** progress.c - the progress of long work, on a terminal.
*/
#include "base/system.h"
#include "progress.h"

void progress_begin(progress *p, FILE *out)
{
    p->is_shown = system_is_terminal(stderr) && !system_is_terminal(out);
    p->is_told = 0;
    p->start = p->last = time(NULL);
}

void progress_tell(progress *p, unsigned long done, unsigned long of)
{
    double share = (double)done / (double)of;
    time_t now = p->is_shown ? time(NULL) : p->last;

    if (now == p->last || now <= p->start + 1)
        return;
    p->last = now;
    p->is_told = 1;
    fprintf(stderr, "\rfourlink: %lu of %lu designs, %.0f %%, %.0f s to go    ", done, of,
            100 * share, difftime(now, p->start) * (1 / share - 1));
}

void progress_end(const progress *p)
{
    if (p->is_told)
        fprintf(stderr, "\r%75s\r", "");
}
