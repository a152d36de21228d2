/* SPDX-License-Identifier: GPL-3.0-or-later
**
** gnuplot.h - the program that draws.
*/
#ifndef FOURLINK_GNUPLOT_H
#define FOURLINK_GNUPLOT_H

#include <stdio.h>

typedef enum gnuplot_result {
    GNUPLOT_OK,
    GNUPLOT_MISSING, /* it is not installed */
    GNUPLOT_FAILED,  /* what it says is on standard error */
    GNUPLOT_ERRNO    /* it could not be started: errno says why */
} gnuplot_result;

/* Run gnuplot on a script, which is read from its beginning; the picture goes to `picture`. */
gnuplot_result gnuplot_run(FILE *script, FILE *picture);

#endif
