/* SPDX-License-Identifier: GPL-3.0-or-later
**
** look.c - colours, widths and dashes.
*/
#include <stddef.h>

#include "look.h"

#define ENTRY(code, name, colour, width, dashes, use) {name, colour, width, dashes, use},
const look look_table[LOOK_COUNT] = {{NULL, NULL, 0, NULL, LOOK_PALE}, LOOK_LIST(ENTRY)};

#define CURVE(colour, dashes) {"curve", colour, 2, dashes, LOOK_ARROW},
const look look_curves[LOOK_CURVE_COUNT] = {LOOK_CURVES(CURVE)};
