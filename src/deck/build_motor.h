/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_motor.h - builds [motor] from values.
*/
#ifndef FOURLINK_DECK_BUILD_MOTOR_H
#define FOURLINK_DECK_BUILD_MOTOR_H

#include "parser.h"

/* The sense in which a speed or a motor turns the crank: -1 clockwise; otherwise 1. */
int flk_build_sense(parser *p);

#endif
