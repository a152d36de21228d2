/* SPDX-License-Identifier: GPL-3.0-or-later
**
** convert.h - runs other programs: rsvg-convert, which makes png and pdf of an SVG, and Chromium, which
** prints a page of HTML as pdf.
*/
#ifndef FOURLINK_CONVERT_H
#define FOURLINK_CONVERT_H

#include <stdio.h>

#include "pictures/plot.h"

#define CONVERT_REASON 400

/* Make a png, which has two pixels for one, or a pdf.  Returns null, or the reason why there is none;
** `reason` has room for it. */
const char *convert_svg(FILE *svg, plot_file file, FILE *out, char reason[CONVERT_REASON]);

/* The same for a page of HTML, from its beginning.  Chromium knows HTML by the name of its file: while
** it prints, one stands beside the file `path`. */
const char *convert_page(FILE *page, const char *path, FILE *out, char reason[CONVERT_REASON]);

/* Copy a stream from its beginning; 1, or 0 with errno set. */
int convert_copy(FILE *from, FILE *to);

#endif
