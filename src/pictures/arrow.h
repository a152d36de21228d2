/* SPDX-License-Identifier: GPL-3.0-or-later
**
** arrow.h - forces as arrows of one scale.
*/
#ifndef FOURLINK_ARROW_H
#define FOURLINK_ARROW_H

#include "figure.h"

/* A force that acts at a place. */
typedef struct arrow {
    fourlink_vector at; /* in the deck's unit of length */
    fourlink_vector F;  /* N */
    pen kind;
    char name[40];
} arrow;

#define MOST_ARROWS 60

typedef struct arrow_list {
    arrow list[MOST_ARROWS];
    int n;
} arrow_list;

/* Add a force; arrow_add does not if it is 0. */
void arrow_put(arrow_list *arrows, pen kind, const char *name, fourlink_vector at,
               fourlink_vector F);
void arrow_add(arrow_list *arrows, pen kind, const char *name, fourlink_vector at, double x,
               double y);

/* Add the force that a link exerts on another, at their pin or at the guide; its weight and its loads. */
void arrow_add_joint(arrow_list *arrows, const picture *p, const picture_row *r, int by, int on);
void arrow_add_loads(arrow_list *arrows, const picture *p, const picture_row *r, int link);

/* The size of the largest, N. */
double arrow_largest(const arrow_list *arrows);

/* Draw them, with so many units of length for a newton; their values stand beside the drawing. */
void arrow_draw(const arrow_list *arrows, sketch *s, const picture *p, double scale);

/* The torques of the loads on a link, and any other. */
void arrow_draw_load_torques(sketch *s, const picture *p, const picture_row *r, int link);
void arrow_draw_torque(sketch *s, const picture *p, pen kind, const char *name, fourlink_vector at,
                       double torque);

/* An arrow that tells the scale of a quantity, below the drawing; `largest` in SI units. */
void arrow_draw_scale(sketch *s, const picture *p, quantity q, double scale, double largest);

#endif
