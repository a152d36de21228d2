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
    double dx, dy;          /* the direction, of any length */
    double half;            /* half its width, in pixels */
    int has_leader;         /* 1: a line leads to its place, if it stands far from it */
    int is_close;           /* 1: it stands close to its place or nowhere */
    int is_hidden;          /* 1, when placed: nowhere */
    fourlink_vector middle; /* of the text, in pixels from the place */
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
    int is_steady; /* 1: all texts stand on the requested side, as in an animation they must not jump */
    double scale; /* unit of length for a pixel, when placed */
} labels;

/* Put the texts of a drawing of this size where they cover least, and choose scale and range for a box of
** so many pixels. */
void labels_place(labels *l, place_box drawn, int is_fixed, double size, double width,
                  double height);

#endif
