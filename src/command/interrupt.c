/* SPDX-License-Identifier: GPL-3.0-or-later
**
** interrupt.c - long work: signals that stop it, and its progress.
*/
#define _XOPEN_SOURCE 600 /* POSIX.1-2001, with SA_RESTART */

#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "interrupt.h"

static volatile sig_atomic_t stopped_by;
static struct sigaction old_actions[3];

static void on_signal(int number)
{
    stopped_by = number;
}

void interrupt_watch(int begin)
{
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action;
    int i;

    memset(&action, 0, sizeof action);
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART; /* finish the line that is being written */
    sigemptyset(&action.sa_mask);
    if (begin)
        stopped_by = 0;
    for (i = 0; i < 3; i++)
        if (!begin)
            sigaction(signals[i], &old_actions[i], NULL);
        else if (sigaction(signals[i], NULL, &old_actions[i]) == 0 &&
                 old_actions[i].sa_handler != SIG_IGN)
            sigaction(signals[i], &action, NULL);
}

int interrupt_signal(void)
{
    return (int)stopped_by;
}

void progress_begin(progress *p, FILE *out)
{
    p->is_shown = isatty(STDERR_FILENO) && !isatty(fileno(out));
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
