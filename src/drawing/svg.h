/* SPDX-License-Identifier: GPL-3.0-or-later
**
** svg.h - a display list as an SVG.
*/
#ifndef FOURLINK_SVG_H
#define FOURLINK_SVG_H

#include <stdio.h>

#include "display.h"

/* Write a picture with this title and description.  A figure of a page has no style sheet and no ground of
** its own: svg_put_style writes the style once for all. */
void svg_write(FILE *out, const display *d, const char *title, const char *description,
               int is_figure);

/* The class of an item, as it stands in an SVG. */
const char *svg_class(const display_item *x, char out[30]);

/* The style sheet of all figures. */
void svg_put_style(FILE *out);

/* A picture that moves: so many frames with one panel each; `repeats`: the motion ends where it begins. */
void svg_write_motion(FILE *out, const display *frames, int n, int repeats, const char *title,
                      const char *description);

#endif
