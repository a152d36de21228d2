/* SPDX-License-Identifier: GPL-3.0-or-later
**
** progress.h - the progress of long work, on a terminal.
*/
#ifndef FOURLINK_PROGRESS_H
#define FOURLINK_PROGRESS_H

#include <stdio.h>
#include <time.h>

/* Progress on a terminal, once a second. */
typedef struct progress {
    int is_shown, is_told;
    time_t start, last;
} progress;

/* It is not shown if the output is on the terminal too. */
void progress_begin(progress *p, FILE *out);
void progress_tell(progress *p, unsigned long done, unsigned long of);
void progress_end(const progress *p);

#endif
