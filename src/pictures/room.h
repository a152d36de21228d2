/* SPDX-License-Identifier: GPL-3.0-or-later
**
** room.h - places for texts among the curves of a panel.
*/
#ifndef FOURLINK_ROOM_H
#define FOURLINK_ROOM_H

#include "sketch.h"

#define ROOM_POINTS 4000
#define ROOM_TEXTS 80

/* A panel with its curves, in pixels from its lower left corner, and the boxes of its texts. */
typedef struct room {
    double x_min, y_min, x_scale, y_scale; /* pixels for a unit */
    double width, height;
    int n_points, n_texts, starts; /* starts: the next point begins a curve */
    int rings;                     /* how far from its place a text may go */
    fourlink_vector point[ROOM_POINTS];
    unsigned char is_start[ROOM_POINTS];
    place_box text[ROOM_TEXTS];
} room;

/* Begin the present panel of a canvas with these ranges of its axes. */
void room_open(room *r, const canvas *on, double x_min, double x_max, double y_min, double y_max);

/* Add a point to a curve that texts should not cover; begin another curve. */
void room_point(room *r, double x, double y);
void room_break(room *r);

/* Keep the box of a text whose middle is at a place of the panel. */
void room_take(room *r, fourlink_vector middle, const char *words);

/* Find the middle of a text near a place: preferably on it (dx and dy 0), or in the direction (dx, dy); and
** keep its box.  Returns 0 if there is no place inside the panel and apart from other texts, or, with
** `keeps_clear`, apart from all curves. */
int room_find(room *r, fourlink_vector at, double dx, double dy, int keeps_clear, const char *words,
              fourlink_vector *middle);

#endif
