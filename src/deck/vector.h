/* SPDX-License-Identifier: GPL-3.0-or-later
**
** vector.h - forces and points of links from the text of a deck.
*/
#ifndef FOURLINK_DECK_VECTOR_H
#define FOURLINK_DECK_VECTOR_H

#include "parser.h"

/* Read a force (10 N at 30 deg, (10, 5) N, or 10 N along +x), or a point of a link (also mid, 50 %), from a
** piece of the setting's value. */
int flk_vector_read_piece(parser *p, setting *s, text t, quantity q, point *result);

/* Read a point of a link; the parts that are set separately. */
int flk_vector_read(parser *p, setting *s, quantity q);
/* The point at these distances from the origin and the end of a link of a length, to the left of its line
** (1) or to the right (-1):
**
**    x = (l^2 + r^2 - q^2) / (2 l),   y = +-sqrt(r^2 - x^2)
**
** 0 if there is none. */
int flk_vector_by_distances(double from_origin, double from_end, double length, int side, double *x,
                            double *y);

/* Read two places, (0, 10) mm, (200, 10) mm, as the points of a curve. */
int flk_vector_read_line(parser *p, setting *s, quantity q);

void flk_vector_read_parts(parser *p, setting *s, quantity q);

/* Sine and cosine, exact for whole quarters of a turn. */
void flk_vector_direction(double angle, double *x, double *y);

#endif
