/* SPDX-License-Identifier: GPL-3.0-or-later
**
** terminal.h - the terminal that results are shown on.
*/
#ifndef FOURLINK_TERMINAL_H
#define FOURLINK_TERMINAL_H

#include <stdio.h>
#include <time.h>

#include "tables/sheet.h"

/* The width of the terminal in characters; 0 if the stream is a file or a pipe.  COLUMNS comes first, then
** what the terminal says; a terminal that says nothing has 80. */
unsigned long terminal_width(FILE *out);

/* 1 if a stream is shown in colour: on a terminal, unless NO_COLOR is set or the terminal is dumb; or as
** --color says. */
int terminal_has_colour(FILE *out, const char *colour);

/* Set the width and the colours of a sheet. */
void terminal_set_up(sheet *s, FILE *out, int is_wide, const char *colour);

/* Tell on a terminal how long a search from so many starts took, if that is a second or more. */
void terminal_tell_search(unsigned long starts, clock_t begun);

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
