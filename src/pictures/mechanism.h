/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mechanism.h - the mechanism at a position of a motion.
*/
#ifndef FOURLINK_MECHANISM_PICTURE_H
#define FOURLINK_MECHANISM_PICTURE_H

#include "picture.h"

/* Draw the mechanism with its loads and pin forces, on the scale of the largest force of the motion, N; of
** a position that the linkage cannot have, the crank. */
void mechanism_draw(picture *p, const picture_row *r, double largest);

/* Draw what is around a small link, from its pin on the ground, enlarged. */
void mechanism_draw_inset(picture *p, const picture_row *r, int link, double largest);

#endif
