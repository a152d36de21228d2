/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_mechanism.h - builds the mechanism from values: its kind; of each link its length, mass, centre of
** mass, moment of inertia; whether it can be assembled.
*/
#ifndef FOURLINK_DECK_BUILD_MECHANISM_H
#define FOURLINK_DECK_BUILD_MECHANISM_H

#include "parser.h"

/* The next element of the machine's list, for the load, spring or gas of a section; null if out of memory. */
flk_element *flk_build_element(parser *p, section_use *use);

/* 1 if the kind of the mechanism has this key. */
int flk_build_has(const parser *p, key_code key);

/* The direction of x of link 1 from the horizontal. */
double flk_build_inclination(parser *p);

/* Check the link of a load or a point; 0 and a mistake if the mechanism has no such link. */
int flk_build_check_link(parser *p, const section_use *use, const setting *link);

#endif
