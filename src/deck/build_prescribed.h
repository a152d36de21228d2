/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_prescribed.h - builds `input` of [motion]: what is prescribed in place of the crank angle.
*/
#ifndef FOURLINK_DECK_BUILD_PRESCRIBED_H
#define FOURLINK_DECK_BUILD_PRESCRIBED_H

#include "parser.h"

/* 1 if another coordinate than the crank angle is prescribed; refuses keys that are the crank angle's
** then, and otherwise keys that only such a coordinate has.  The range follows from the reach on the
** branches of the table: flk_build_prescribed. */
int flk_build_is_prescribed(parser *p);

#endif
