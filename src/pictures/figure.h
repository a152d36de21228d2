/* SPDX-License-Identifier: GPL-3.0-or-later
**
** figure.h - a mechanism at one position, drawn to scale.
*/
#ifndef FOURLINK_FIGURE_H
#define FOURLINK_FIGURE_H

#include "picture.h"
#include "sketch.h"
#include "view/geometry.h"

#define FIGURE_THETA "\316\270" /* the Greek letter, in UTF-8 */

/* Half the length of a piston or a block, as a fraction of the drawing; its height as one of its length. */
#define FIGURE_BLOCK 0.055
#define FIGURE_HIGH (7. / 11)

#define FIGURE_NAME 16 /* letters, of a name beside its point */

/* The pins: A crankshaft, B crank pin, C, and D, which is the foot of C on the x axis in a slider-crank.  In
** an inverted slider-crank C, where links 3 and 4 meet, is B. */
typedef struct figure_pins {
    fourlink_vector A, B, C, D;
} figure_pins;

figure_pins figure_place(const picture *p, const fourlink_state *state);

/* An angle in rad, as picture_mark has it. */
char *figure_angle(const picture *p, double angle, int digits, char out[PICTURE_MARK]);

/* Draw thin lines from the pins of a link to a point that is off their line. */
void figure_off(sketch *s, fourlink_vector first, fourlink_vector second, fourlink_vector at);

/* Begin a drawing of the mechanism on a branch, scaled to its whole motion. */
void figure_open(sketch *s, picture *p, fourlink_branch branch);

/* Say where the links are: what moves with them is drawn in a motion as theirs. */
void figure_bodies(sketch *s, const picture *p, const fourlink_state *state);

/* Draw the frame: supports at A and D, or the guide. */
void figure_frame(sketch *s, const picture *p, const fourlink_state *state);

/* Draw a piston or a block around a place, along an axis. */
void figure_piston(sketch *s, pen kind, fourlink_vector at, const fourlink_vector *axis);

/* Draw a lever with its slot. */
void figure_lever(sketch *s, const picture *p, const fourlink_state *state, pen kind);

/* Draw a link of an output that is no block, with its slot. */
void figure_output_link(sketch *s, const picture *p, const fourlink_state *state, int link);

/* Draw the links at one position as lines, with one pen or PEN_OF_LINK; or in full, with letters at the pins,
** the slope and, if wanted, the angles of the links. */
void figure_outline(sketch *s, const picture *p, const fourlink_state *state, pen kind);
void figure_draw(sketch *s, const picture *p, const fourlink_state *state, int has_angles);

/* Draw the angle of a link with its symbol alone: a ray along x, and an arc. */
void figure_arc(sketch *s, const picture *p, const fourlink_state *state, int link);

/* Draw the sense of rotation about A, ahead of the crank. */
void figure_sense(sketch *s, const fourlink_state *state, fourlink_vector A);

/* Put a letter beside a pin, away from the other pins of its links; `y` is x if there is only one link. */
void figure_letter(sketch *s, fourlink_vector pin, fourlink_vector x, fourlink_vector y,
                   const char *letter);

/* Let the next letter, if a script places it, stand outside of the block in which its pin is. */
void figure_beyond_block(sketch *s);

/* Put a name and its value, given in SI units, beside the drawing. */
void figure_note(sketch *s, const picture *p, const char *name, double si, quantity q);

/* Put the angle by which the x axis rises beside the drawing, if it is not 0. */
void figure_slope(sketch *s, const picture *p);

/* Draw the direction of gravity, if a link has weight, and the x axis, if it rises. */
void figure_gravity(sketch *s, const picture *p);

/* The pen of a link: of an output, that of link 3 for the rod, of link 4 for slider or rocker. */
#define FIGURE_PEN(link)                                  \
    ((pen)((link) <= FOURLINK_FOLLOWER ? (link)           \
           : (link) % 2                ? FOURLINK_COUPLER \
                                       : FOURLINK_FOLLOWER))

/* Draw the outline of a link with tracer points, or with pins of outputs: hull.c. */
void hull_draw(sketch *s, const picture *p, const fourlink_state *state, int link);

/* Draw the springs and actuators of a deck at one position: spring.c.  `has_values`: with their forces
** beside the drawing. */
void spring_draw(sketch *s, const picture *p, const fourlink_state *state, int has_values);

/* Draw the paths of C and of the tracer points over the motion. */
void figure_paths(sketch *s, const picture *p, fourlink_branch branch);

/* End a drawing, with a title for its position: "open, theta2 = 40 deg" after some words. */
void figure_close(sketch *s, const picture *p, const fourlink_instant *now, const char *before);

#endif
