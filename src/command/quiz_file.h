/* SPDX-License-Identifier: GPL-3.0-or-later
**
** quiz_file.h - the file of --quiz: a question for each design of a deck, or for the deck.
*/
#ifndef FOURLINK_QUIZ_FILE_H
#define FOURLINK_QUIZ_FILE_H

#include "options.h"

/* Write it, whole or not at all; returns the exit status. */
int quiz_file_write(const options *o);

#endif
