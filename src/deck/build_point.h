/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_point.h - builds [point] from values.
*/
#ifndef FOURLINK_DECK_BUILD_POINT_H
#define FOURLINK_DECK_BUILD_POINT_H

#include "parser.h"

/* Check that a name for columns is one word and not too long. */
void flk_build_check_name(parser *p, const section_use *use, const char *columns);

#endif
