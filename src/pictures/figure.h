/* SPDX-License-Identifier: GPL-3.0-or-later
**
** figure.h - a mechanism at one position, drawn to scale in the deck's unit of length.
*/
#ifndef FOURLINK_FIGURE_H
#define FOURLINK_FIGURE_H

#include "picture.h"
#include "sketch.h"

/* The pins: A crankshaft, B crank pin, C, and D, of a slider-crank the foot of C on the x axis. */
typedef struct figure_pins {
    fourlink_vector A, B, C, D;
} figure_pins;

figure_pins figure_place(const picture *p, const fourlink_state *state);

/* A length, and a place, in the deck's unit. */
double figure_length(const picture *p, double si);
fourlink_vector figure_point(const picture *p, fourlink_vector si);

/* The place of a point of a link, which is given in the link's own axes, m. */
fourlink_vector figure_of_link(const picture *p, const fourlink_state *state, int link,
                               const fourlink_vector *at);

/* Begin a drawing of the mechanism on a branch: the size of its whole motion.  With `all_of_it` there
** is room for all of that, and for nothing more: all positions have one scale. */
void figure_open(sketch *s, picture *p, fourlink_branch branch, int all_of_it);

/* The frame: supports at A and D, or the guide. */
void figure_frame(sketch *s, const picture *p, const fourlink_state *state);

/* A piston about a place. */
void figure_piston(sketch *s, pen kind, fourlink_vector at);

/* The links at one position as lines of a pen, or of PEN_OF_LINK; or in full, with letters at the
** pins, the angles of the links if they are wanted, and the slope. */
void figure_outline(sketch *s, const picture *p, const fourlink_state *state, pen kind);
void figure_draw(sketch *s, const picture *p, const fourlink_state *state, int has_angles);

/* A letter beside a pin, away from the pins of its links; `y` is x if there is one link. */
void figure_letter(sketch *s, fourlink_vector pin, fourlink_vector x, fourlink_vector y,
                   const char *letter);

/* Beside the drawing: a name with its value, in SI units. */
void figure_note(sketch *s, const picture *p, const char *name, double si, quantity q);

/* Beside the drawing: how the line of stroke, or A to D, is turned from the horizontal, if it is. */
void figure_slope(sketch *s, const picture *p);

/* The paths of C and of the tracer points over the motion; `until`: only up to this crank angle, in
** the deck's unit. */
void figure_paths(sketch *s, const picture *p, fourlink_branch branch, const double *until);

/* End a drawing, with a name for its position: "open, theta2 = 40 deg", and what is before that. */
void figure_close(sketch *s, const picture *p, const fourlink_instant *now, const char *before);

#endif
