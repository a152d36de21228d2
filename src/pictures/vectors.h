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

/* The largest force on a link, N.  Draw its free body; `largest` is that of the motion. */
double vectors_largest(const picture *p, const picture_row *r, int link);
void vectors_draw_body(picture *p, const picture_row *r, int link, double largest);

#endif
