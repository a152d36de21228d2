/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spring.h - springs and dampers in a drawing.
*/
#ifndef FOURLINK_PICTURES_SPRING_H
#define FOURLINK_PICTURES_SPRING_H

#include "figure.h"

/* Draw the springs of a deck at one position; `has_values`: with their forces beside the drawing. */
void spring_draw(sketch *s, const picture *p, const fourlink_state *state, int has_values);

#endif
