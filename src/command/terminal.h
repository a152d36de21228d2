/* SPDX-License-Identifier: GPL-3.0-or-later
**
** terminal.h - the terminal that results are shown on.
*/
#ifndef FOURLINK_TERMINAL_H
#define FOURLINK_TERMINAL_H

#include <stdio.h>

/* The width of the terminal in characters; 0 if the stream is a file or a pipe.  COLUMNS comes first, then
** what the terminal says; a terminal that says nothing has 80. */
unsigned long terminal_width(FILE *out);

#endif
