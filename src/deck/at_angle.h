/* SPDX-License-Identifier: GPL-3.0-or-later
**
** at_angle.h - NAME at ANGLE: the value of a column in the row at a crank angle.
*/
#ifndef FOURLINK_AT_ANGLE_H
#define FOURLINK_AT_ANGLE_H

#include "deck.h"

/* Cut a name into those of the column and the angle; 0 if it is not of this form. */
int flk_at_angle_cut(text name, text *column, text *angle);

/* Read the angle, in the deck's unit; 0 and a message if it is none. */
int flk_at_angle_read(const deck *d, text words, double *angle, char message[MESSAGE_SIZE]);

/* The length of `at ANGLE` at the front of a list in which blanks separate names; 0 if it is not there. */
size_t flk_at_angle_length(text list);

#endif
