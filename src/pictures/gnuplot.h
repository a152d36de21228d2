/* SPDX-License-Identifier: GPL-3.0-or-later
**
** gnuplot.h - runs gnuplot.
*/
#ifndef FOURLINK_GNUPLOT_H
#define FOURLINK_GNUPLOT_H

#include "picture.h"

#define GNUPLOT_REASON 400

/* Run gnuplot on a script, from its beginning; the picture goes to `out`, an SVG with `caption`, which is
** null for other files.  Returns null, or the reason why there is none, for which there is room in `reason`. */
const char *gnuplot_run(FILE *script, FILE *out, const plot_caption *caption,
                        char reason[GNUPLOT_REASON]);

#endif
