/* SPDX-License-Identifier: GPL-3.0-or-later
**
** found_text.h - the linkage found for [synthesis] in the text of its deck: comments on what was found and
** checked, and [expect] sections with the wanted values.
*/
#ifndef FOURLINK_DECK_FOUND_TEXT_H
#define FOURLINK_DECK_FOUND_TEXT_H

#include "synthesis.h"

/* A quantity, or a point, with its unit, so that it is read again as the same number; valid as long as the
** deck. */
const char *flk_found_value(struct parser *p, double si, quantity q);
const char *flk_found_point(struct parser *p, fourlink_vector at);

/* Write what the text of the deck begins and ends with; the coupler point has this name. */
void flk_found_write(struct parser *p, const char *point_name);

/* Tell the defects of the linkage found: their names in `defects`, sentences in those of the deck. */
void flk_synthesis_tell_defects(struct parser *p);

#endif
