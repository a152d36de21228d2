/* SPDX-License-Identifier: GPL-3.0-or-later
**
** wanted.h - the positions for which a linkage was found.
*/
#ifndef FOURLINK_WANTED_H
#define FOURLINK_WANTED_H

#include "picture.h"
#include "sketch.h"

/* Draw what [synthesis] wanted of the linkage that is drawn; nothing for another deck. */
void wanted_draw(sketch *s, picture *p);

#endif
