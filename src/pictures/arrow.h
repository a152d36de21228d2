/* SPDX-License-Identifier: GPL-3.0-or-later
**
** arrow.h - forces as arrows on one scale.
*/
#ifndef FOURLINK_ARROW_H
#define FOURLINK_ARROW_H

#include "figure.h"

/* A force that acts at a place. */
typedef struct arrow {
    fourlink_vector at; /* m */
    fourlink_vector F;  /* N */
    pen kind;
    int number; /* of the scene's forces, or of a polygon's sides */
    int body;   /* the link with which its place moves; 0: none */
    char name[40];
} arrow;

#define MOST_ARROWS 160

typedef struct arrow_list {
    arrow list[MOST_ARROWS];
    int n;
} arrow_list;

/* Add a force; arrow_add leaves out a force of 0, and says with which link its place moves. */
void arrow_put(arrow_list *arrows, int number, pen kind, const char *name, fourlink_vector at,
               fourlink_vector F);
void arrow_add(arrow_list *arrows, int number, int body, pen kind, const char *name,
               fourlink_vector at, double x, double y);

/* Add a force of the scene, by its number. */
void arrow_add_force(arrow_list *arrows, const picture_row *r, int number);

/* Keep those that act in the window of a drawing that has one. */
void arrow_cut(arrow_list *arrows, const sketch *s);

/* The largest force, N. */
double arrow_largest(const arrow_list *arrows);

/* The largest force of the motion on a branch, N, but for those near dead positions; 0: none is known. */
double arrow_largest_of_motion(picture *p, fourlink_branch branch);

/* The force that the longest arrow stands for: the largest of the motion, but that of these forces where it
** is larger, or so small that none had an arrow. */
double arrow_longest(const arrow_list *arrows, double largest_of_motion);

/* Draw the forces, with so many units of length for a newton, and put their values beside the drawing.  One
** that is small beside `largest` has no arrow: returns how many.  Say below which size. */
int arrow_draw(const arrow_list *arrows, sketch *s, const picture *p, double scale, double largest);
void arrow_note_missing(sketch *s, const picture *p, double largest);

/* Draw the torques of these loads, but those of friction in pins; draw any other torque, at a place that
** moves with a link.  Without a name, as those of springs on a link that is not free, it goes around the
** coil that has name and value. */
void arrow_draw_load_torques(sketch *s, const picture *p, const picture_row *r, int link,
                             int is_free);
void arrow_draw_torque(sketch *s, const picture *p, int number, int body, pen kind,
                       const char *name, fourlink_vector at, double torque);

/* Draw an arrow that shows the scale of a quantity, below the drawing; `largest` is in SI units. */
void arrow_draw_scale(sketch *s, const picture *p, quantity q, double scale, double largest);

#endif
