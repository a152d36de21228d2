/* SPDX-License-Identifier: GPL-3.0-or-later
**
** friction_circle.h - the friction circles of a link's pins, to which the forces of the pins are tangents.
*/
#ifndef FOURLINK_FRICTION_CIRCLE_H
#define FOURLINK_FRICTION_CIRCLE_H

#include "arrow.h"

/* The circle of a pin of a link, in the deck's unit of length; radius 0: no friction. */
typedef struct friction_circle {
    double radius;
    double arm; /* of the force about the pin, positive if that turns the link counter-clockwise */
} friction_circle;

/* The circle of joint 0 to 3, A to D, at which the force F, in N, acts on a link. */
friction_circle friction_circle_of(const picture *p, const picture_row *r, int joint, int link,
                                   fourlink_vector F);

/* How many times larger than a drawing of this size its circles are drawn, so that the larger of two can
** be seen. */
double friction_circle_scale(double size, const friction_circle *x, const friction_circle *y);

/* Where a force touches its circle, drawn so many times larger. */
fourlink_vector friction_circle_touch(const friction_circle *x, double scale, fourlink_vector pin,
                                      fourlink_vector F);

/* Draw a circle; put beside the drawing how much larger they are. */
void friction_circle_draw(sketch *s, const friction_circle *x, double scale, fourlink_vector pin);
void friction_circle_note(sketch *s, double scale);

#endif
