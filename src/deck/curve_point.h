/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve_point.h - a point of a curve: an argument and a value.
*/
#ifndef FOURLINK_DECK_CURVE_POINT_H
#define FOURLINK_DECK_CURVE_POINT_H

#include "parser.h"

/* Where a number starts after a blank, such as the value in "20 deg 32 bar"; the length of the text if there
** is none. */
size_t flk_curve_point_value(text t);

/* Read a point of a curve, ANGLE VALUE: "20 deg 32 bar", or "20 32" in the deck's units.  `is_cut`: it may be
** the rest after a decimal comma. */
int flk_curve_point_read(parser *p, setting *s, text t, quantity q, int is_cut, point *result);
const char *flk_curve_point_example(quantity q);

#endif
