/* SPDX-License-Identifier: GPL-3.0-or-later
**
** point.h - points that every deck has by name: the pins B and C, the centres of mass G2, G3 and G4.
*/
#ifndef FOURLINK_POINT_H
#define FOURLINK_POINT_H

#include "deck/deck.h"

/* Names and meanings. */
#define FLK_POINT_LIST(X)                 \
    X(B, "the pin B")                     \
    X(C, "the pin C")                     \
    X(G2, "the centre of mass of link 2") \
    X(G3, "the centre of mass of link 3") \
    X(G4, "the centre of mass of link 4")

#define FLK_POINT_CODE(name, meaning) FLK_POINT_##name,
typedef enum flk_point_code { FLK_POINT_LIST(FLK_POINT_CODE) FLK_POINT_COUNT } flk_point_code;

/* Returns why a deck does not have this point, or null: then *link is its link and *at its place in the
** link's own axes.  A [point] of the same name hides it. */
const char *flk_point_find(const deck *d, flk_point_code code, int *link, fourlink_vector *at);

#endif
