/* SPDX-License-Identifier: GPL-3.0-or-later
**
** plot.h - pictures of a deck, as gnuplot scripts: the kinds of pictures and of files; and drawn by gnuplot.
*/
#ifndef FOURLINK_PLOT_H
#define FOURLINK_PLOT_H

#include "picture.h"

/* By plot_kind, with a null pointer at the end: its name, and what it shows. */
extern const char *const plot_names[], *const plot_shows[];

/* By plot_file, with a null pointer at the end: how the name of a file ends. */
extern const char *const plot_endings[];

/* 1 if a kind is of one position. */
int plot_is_of_position(plot_kind kind);

/* PLOT_FILE_COUNT for another name. */
plot_file plot_file_of(const char *name);

/* Write the script of a picture of a deck without mistakes.  Returns 1; 0 and the reason why there is nothing
** to draw; -1 if out of memory. */
int plot_write(FILE *out, const fourlink_source *source, const plot_request *request,
               plot_caption *caption, fourlink_mistake *mistake);

#define GNUPLOT_REASON 400

/* Run gnuplot on a script, from its beginning; the picture goes to `out`, an SVG with `caption`, which is
** null for other files.  Returns null, or the reason why there is none; `reason` has room for it. */
const char *gnuplot_run(FILE *script, FILE *out, const plot_caption *caption,
                        char reason[GNUPLOT_REASON]);

/* Write the beginning of an SVG with this caption in place of gnuplot's <title> and <desc>. */
void gnuplot_put_head(FILE *out, const char *head, const plot_caption *caption);

#endif
