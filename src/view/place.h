/* SPDX-License-Identifier: GPL-3.0-or-later
**
** place.h - places of a drawing, and boxes around them.
*/
#ifndef FOURLINK_PLACE_H
#define FOURLINK_PLACE_H

#include "fourlink.h"

typedef struct place_box {
    double x_min, x_max, y_min, y_max;
} place_box;

/* A place; a place at a distance from another. */
fourlink_vector place_at(double x, double y);
fourlink_vector place_beside(fourlink_vector p, double dx, double dy);

/* A place at a distance from another in the direction of an angle, in rad; so far along a direction and to
** its left. */
fourlink_vector place_polar(fourlink_vector p, double distance, double angle);
fourlink_vector place_in(fourlink_vector p, fourlink_vector axis, double along, double left);

/* How far a place is from another along a direction, and to its left. */
fourlink_vector place_seen(fourlink_vector p, fourlink_vector axis, fourlink_vector at);

/* The middle of two places, and their distance. */
fourlink_vector place_middle(fourlink_vector p, fourlink_vector q);
double place_distance(fourlink_vector p, fourlink_vector q);

/* An empty box; 1 for one; enlarge a box so that it contains a place. */
extern const place_box place_nothing;
int place_is_empty(const place_box *b);
void place_grow(place_box *b, double x, double y);

/* 1 if two boxes overlap; if the line from p to q crosses a box. */
int place_overlap(const place_box *x, const place_box *y);
int place_crosses(const place_box *b, fourlink_vector p, fourlink_vector q);

/* Cut a line to a box; 0 if it is outside. */
int place_clip(const place_box *b, fourlink_vector *p, fourlink_vector *q);

/* 1, 2 or 5 times a power of ten, at least x. */
double place_round(double x);

#endif
