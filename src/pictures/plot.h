/* SPDX-License-Identifier: GPL-3.0-or-later
**
** plot.h - pictures of a deck: the kinds of pictures and of files.
*/
#ifndef FOURLINK_PLOT_H
#define FOURLINK_PLOT_H

#include <stdio.h>

#include "picture.h"

/* By plot_kind, with a null pointer at the end: its name, and what it shows. */
extern const char *const plot_names[], *const plot_shows[];

/* By plot_file, with a null pointer at the end: how the name of a file ends. */
extern const char *const plot_endings[];

/* 1 if a kind is of one position. */
int plot_is_of_position(plot_kind kind);

/* PLOT_FILE_COUNT for another name. */
plot_file plot_file_of(const char *name);

#define PLOT_FRAMES 60 /* of a picture that moves */

/* A picture that has been drawn. */
typedef struct plot {
    display frames[PLOT_FRAMES]; /* one, unless it moves */
    int n_frames;
    int repeats; /* 1: the motion ends where it begins */
    plot_caption caption;
} plot;

/* Draw a picture of a deck without mistakes.  Returns 1; 0 and the reason why there is nothing to draw; -1 if
** out of memory.  To be freed whatever came of it. */
int plot_make(plot *x, const fourlink_source *source, const plot_request *request,
              fourlink_mistake *mistake);
void plot_free(plot *x);

/* Write a picture: an SVG, or with `is_text` characters; its lines are Braille or, with `is_ascii`, dots.
** Returns 0 if out of memory. */
int plot_write(const plot *x, int is_text, int is_ascii, FILE *out);

/* Write the figure of an exercise, which has nothing that is computed, of an opened deck, as an SVG for
** a page.  Returns as plot_make. */
int plot_write_exercise(const fourlink_source *source, fourlink_results *opened, FILE *out,
                        fourlink_mistake *mistake);

/* Write it as a figure of a page, without a style sheet. */
void plot_write_figure(const plot *x, FILE *out);

#endif
