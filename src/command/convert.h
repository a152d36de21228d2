/* SPDX-License-Identifier: GPL-3.0-or-later
**
** convert.h - runs rsvg-convert, which makes png and pdf of an SVG.
*/
#ifndef FOURLINK_CONVERT_H
#define FOURLINK_CONVERT_H

#include <stdio.h>

#include "pictures/plot.h"

#define CONVERT_REASON 400

/* Make a png, which has two pixels for one, or a pdf.  Returns null, or the reason why there is none;
** `reason` has room for it. */
const char *convert_svg(FILE *svg, plot_file file, FILE *out, char reason[CONVERT_REASON]);

#endif
