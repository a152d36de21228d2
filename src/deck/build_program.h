/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_program.h - builds the program of [motion]: the crank angle, or its speed, over time.
*/
#ifndef FOURLINK_DECK_BUILD_PROGRAM_H
#define FOURLINK_DECK_BUILD_PROGRAM_H

#include "parser.h"

#define MOST_TIMES 1000000 /* rows by time */

/* Build the program of a deck, and its rows; 0 if it has none. */
int flk_build_program(parser *p);

#endif
