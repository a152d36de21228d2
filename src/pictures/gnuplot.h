/* SPDX-License-Identifier: GPL-3.0-or-later
**
** gnuplot.h - runs gnuplot.
*/
#ifndef FOURLINK_GNUPLOT_H
#define FOURLINK_GNUPLOT_H

#include <stdio.h>

/* Run gnuplot on a script, from its beginning; the picture goes to `picture`.  Returns null, or the reason
** why there is none; gnuplot's own messages go to standard error. */
const char *gnuplot_run(FILE *script, FILE *picture);

#endif
