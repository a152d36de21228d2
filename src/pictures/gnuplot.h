/* SPDX-License-Identifier: GPL-3.0-or-later
**
** gnuplot.h - the program that draws.
*/
#ifndef FOURLINK_GNUPLOT_H
#define FOURLINK_GNUPLOT_H

#include <stdio.h>

/* Run gnuplot on a script, which is read from its beginning; the picture goes to `picture`.  Null, or why
** there is none; what gnuplot says of it is on standard error. */
const char *gnuplot_run(FILE *script, FILE *picture);

#endif
