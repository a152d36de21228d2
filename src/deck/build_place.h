/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_place.h - builds points of links and of the ground, and directions, in the axes that the engine has.
*/
#ifndef FOURLINK_DECK_BUILD_PLACE_H
#define FOURLINK_DECK_BUILD_PLACE_H

#include "mechanics/kind.h"
#include "parser.h"

/* 1 if a link whose length is optional has none. */
int flk_build_is_without_length(parser *p, const flk_kind *kind, int number);

/* A length in the unit in which a setting is written. */
const char *flk_build_length_in(parser *p, const setting *s, double length, char out[MESSAGE_SIZE]);

/* A vector in the axes of the deck in those of link 1; a place. */
fourlink_vector flk_build_direction(const parser *p, fourlink_vector u);
fourlink_vector flk_build_on_ground(const parser *p, fourlink_vector place);

/* A point of a link or the ground, m, by one of two settings: on its link, or by its place as drawn. */
int flk_build_point(parser *p, const setting *at, const setting *place, int link,
                    fourlink_vector *on_link);

/* A point of a link, in m. */
void flk_build_place(parser *p, const setting *s, int link, fourlink_vector *at);

#endif
