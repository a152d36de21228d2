/* SPDX-License-Identifier: GPL-3.0-or-later
**
** labels.h - the places of the texts of a drawing.
*/
#ifndef FOURLINK_LABELS_H
#define FOURLINK_LABELS_H

#include "sketch.h"

/* Put the texts where they cover least, and choose scale and range for a box of so many pixels. */
void labels_place(sketch *s, double width, double height);

#endif
