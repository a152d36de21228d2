/* SPDX-License-Identifier: GPL-3.0-or-later
**
** labels.h - the places of the texts of a drawing.
*/
#ifndef FOURLINK_LABELS_H
#define FOURLINK_LABELS_H

#include "canvas.h"
#include "view/place.h"

#define LABELS_MOST 120
#define LABELS_OBSTACLES 2000
#define LABELS_WORDS 100

/* A text that is put beside a place after everything else: on the requested side, or where there is room. */
typedef struct label {
    fourlink_vector at;
    double dx, dy; /* the direction, of any length */
    double half;   /* half its width, in pixels */
    double beyond; /* of a drawing that a script moves: how far from its place it begins, in m, */
    fourlink_vector behind;          /* the place away from which it stands; */
    unsigned long hold, behind_hold; /* the frames that hold both */
    int has_leader;                  /* 1: a line leads to its place, if it stands far from it */
    int is_close;                    /* 1: it stands close to its place or nowhere */
    int is_hidden;                   /* 1, when placed: nowhere */
    int side;                        /* of a drawing that moves: its number in labels_motion */
    unsigned long key;               /* what it names: the same at all steps of a motion */
    fourlink_vector middle;          /* of the text, in pixels from the place */
    char words[LABELS_WORDS];
} label;

/* What a text should not cover, and the cost of doing so. */
typedef struct obstacle {
    fourlink_vector from, to;
    double weight;
} obstacle;

typedef struct labels {
    int n, n_obstacles;
    label list[LABELS_MOST];
    obstacle obstacles[LABELS_OBSTACLES];
    place_box drawn; /* the drawing; when placed, with its texts */
    int is_fixed;    /* 1: it does not grow */
    double border;   /* pixels: so far outside of it a text of a fixed drawing may be */
    double scale;    /* unit of length for a pixel, when placed */
} labels;

/* Put the texts of a drawing of this size where they cover least, and choose scale and range for a box of
** so many pixels. */
void labels_place(labels *l, place_box drawn, int is_fixed, double size, double width,
                  double height);

/* ------------------------------------------------------------------------------------------- motion */

/* A text of a drawing that moves stands on the same side of its place at all positions: where it covers least
** at some of them together. */
typedef struct labels_side {
    unsigned long key; /* of the text */
    int candidate;     /* its place, by the number that labels.c gives it */
} labels_side;

typedef enum labels_phase {
    LABELS_MEASURE, /* find the range of all positions */
    LABELS_KEEP,    /* keep the texts of some positions, and what they should not cover */
    LABELS_DRAW     /* draw, with each text on its side */
} labels_phase;

enum { LABELS_KEPT = 18 };

typedef struct labels_motion {
    labels_phase phase;
    int is_first;    /* 1: what stands still may be drawn, at one position for all */
    place_box drawn; /* all positions, without texts */
    labels *kept;    /* room for LABELS_KEPT of them */
    int n_kept;
    labels_side sides[LABELS_MOST];
    int n_sides;
} labels_motion;

/* Keep the texts of a position; choose their sides when all are kept; take them at any position. */
void labels_keep(labels_motion *m, labels *l, double size, double width, double height);
void labels_choose_sides(labels_motion *m);
void labels_take_sides(labels *l, const labels_motion *m, double size, double width, double height);

#endif
