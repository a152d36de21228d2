/* SPDX-License-Identifier: GPL-3.0-or-later
**
** svg.h - title and description of an SVG file.
*/
#ifndef FOURLINK_SVG_H
#define FOURLINK_SVG_H

#include "picture.h"

/* Write the beginning of gnuplot's SVG with this title and description instead of gnuplot's own. */
void svg_put_head(FILE *out, const char *head, size_t length, const plot_caption *caption);

#endif
