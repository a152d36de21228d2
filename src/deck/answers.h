/* SPDX-License-Identifier: GPL-3.0-or-later
**
** answers.h - a file of answers as people write it, in the form of a deck.
*/
#ifndef FOURLINK_DECK_ANSWERS_H
#define FOURLINK_DECK_ANSWERS_H

#include "parser.h"

/* The text of a file of answers with as many lines, in the form of [expect] sections: NAME: VALUE and the
** lines of a spreadsheet, NAME;VALUE;UNIT, become NAME = VALUE UNIT, decimal commas points.  What is no
** value is left out and told among the deck's slips; values below an `at` or a `branch` that is not
** understood are left out. */
text flk_answers_plain(parser *p, text contents);

#endif
