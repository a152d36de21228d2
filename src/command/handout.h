/* SPDX-License-Identifier: GPL-3.0-or-later
**
** handout.h - what students get of a deck.
*/
#ifndef FOURLINK_HANDOUT_H
#define FOURLINK_HANDOUT_H

#include <stddef.h>

#include "base/text.h"

/* The name of the section that a line begins, without its brackets and the blanks within; 0 if it begins
** none. */
int handout_section(text row, text *name);

/* Take out of the text of a deck what students do not get: `solver`, [expect], [misprint] and
** [grading].  Returns its new length. */
size_t handout_strip(char *deck, size_t length);

#endif
