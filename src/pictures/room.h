/* SPDX-License-Identifier: GPL-3.0-or-later
**
** room.h - a panel of curves: its axes, and places for texts among the curves.
*/
#ifndef FOURLINK_ROOM_H
#define FOURLINK_ROOM_H

#include "sketch.h"

#define ROOM_POINTS 4000
#define ROOM_TEXTS 80

/* A panel with its curves, in pixels from its lower left corner, and the boxes of its texts. */
typedef struct room {
    canvas *on;
    place_box frame;         /* the ranges of the axes */
    double x_scale, y_scale; /* pixels for a unit */
    int n_points, n_texts;
    int rings; /* how far from its place a text may go */
    fourlink_vector point[ROOM_POINTS];
    unsigned char is_start[ROOM_POINTS];
    place_box text[ROOM_TEXTS];
} room;

/* Go on to the next panel, with so many lines above its axes and so many pixels at their right. */
void room_open(room *r, canvas *on, int lines, double right);

/* Widen a frame with so many pixels on all sides until both axes have the same scale; returns it, units for a
** pixel. */
double room_to_scale(const room *r, place_box *frame, double border);

/* Set the ranges of the axes, and the steps of their numbers; 0: as many as fit. */
void room_set_axes(room *r, place_box frame, double x_step, double y_step);

/* Add a curve of so many points that texts should not cover; gaps are not numbers. */
void room_add_curve(room *r, const double *x, const double *y, int n);
void room_add_line(room *r, fourlink_vector from, fourlink_vector to);

/* Keep the box of a text whose middle is at a place of the panel. */
void room_take(room *r, fourlink_vector middle, const char *words);

/* Put a text near a place: preferably on it (dx and dy 0), or in the direction (dx, dy), in the colour of a
** pen, 0: black; keep its box.  Returns 0 if there is no place inside the panel and apart from other texts,
** or, with `keeps_clear`, apart from all curves; otherwise `middle` is that of the text. */
int room_put(room *r, fourlink_vector at, double dx, double dy, int keeps_clear, const char *words,
             int p, fourlink_vector *middle);

#endif
