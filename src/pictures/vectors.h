/* SPDX-License-Identifier: GPL-3.0-or-later
**
** vectors.h - polygons of velocity and acceleration, and free bodies, at a position of a motion.
*/
#ifndef FOURLINK_VECTORS_H
#define FOURLINK_VECTORS_H

#include "picture.h"

/* The longest side of a polygon, in SI units.  Draw it; one of a motion that is larger than `most` is drawn
** smaller. */
double vectors_size(const picture_row *r, const scene_polygon *d);
void vectors_draw_polygon(picture *p, const picture_row *r, const scene_polygon *d, double most);

/* Draw the free body of a link; `largest` is the largest force of the motion, N. */
void vectors_draw_body(picture *p, const picture_row *r, int link, double largest);

#endif
