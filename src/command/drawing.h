/* SPDX-License-Identifier: GPL-3.0-or-later
**
** drawing.h - the picture of a deck, drawn by gnuplot, or its script.
*/
#ifndef FOURLINK_DRAWING_H
#define FOURLINK_DRAWING_H

#include "input.h"

/* Draw what the options ask for; returns the exit status. */
int drawing_write(const input *in);

#endif
