/* SPDX-License-Identifier: GPL-3.0-or-later
**
** graph.h - columns of a deck as curves over its motion, and their axes.
*/
#ifndef FOURLINK_GRAPH_H
#define FOURLINK_GRAPH_H

#include "picture.h"

/* A curve as it is drawn: x and y are NaN in its gaps. */
typedef struct graph_line {
    double x[PICTURE_STEPS + 1], y[PICTURE_STEPS + 1];
    double mu[PICTURE_STEPS + 1]; /* rad, the transmission angle */
    int n_points;                 /* that are not in a gap */
} graph_line;

/* The smallest and the largest value of curves: of all, and away from dead positions. */
typedef struct graph_extent {
    double low, high;
    double sound_low, sound_high;
    double mu; /* rad, the smallest transmission angle */
} graph_extent;

graph_extent graph_extent_of(const graph_line *lines, int n, int of_x);

/* 1 if the picture cuts the curves. */
int graph_is_cut(const graph_extent *e);

/* Cut the curves to this range. */
void graph_cut(graph_extent *e, double low, double high);

/* What is shown of the curves, from the smallest to the largest. */
void graph_range(const graph_extent *e, double *low, double *high);

/* The index of one of the picture's columns; -1 if the deck does not have it. */
int graph_column(const picture *p, const char *name);

/* Sample column y over column x, with gaps where the linkage cannot be assembled or one of them has no
** number. Angles are followed past half a turn; what is rounding becomes 0. */
void graph_follow(picture *p, fourlink_branch branch, int x, int y, graph_line *line);

/* The means of both columns over each whole turn of the motion, over the crank angle: a point for each turn.
** 0, and nothing, if there are fewer than three. */
int graph_average(picture *p, fourlink_branch branch, int x, int y, graph_line *line);

/* The first jumps of a curve, each in the step that ends with a sample. */
#define GRAPH_JUMPS 40
typedef struct graph_jumps {
    fourlink_vector from[GRAPH_JUMPS], to[GRAPH_JUMPS];
    int sample[GRAPH_JUMPS], n;
} graph_jumps;

/* Begin a curve, which is named NAME_OF. */
display_item *graph_begin(const picture *p, int stroke, const char *name, const char *of);

/* Draw such a curve of columns x and y, with breaks at its gaps; and unless `jumps` is null or the curve is
** over time, at its jumps, with both ends.  `size` is that of the curve. */
void graph_draw(const picture *p, fourlink_branch branch, int x, int y, const graph_line *line,
                fourlink_vector size, graph_jumps *jumps);

/* Mark a place with a disc of this radius in pixels, black or open. */
void graph_mark(const picture *p, fourlink_vector at, double radius, int is_open);

/* Widen a range by this part of it; an empty one by more. */
void graph_widen(double *low, double *high, double part);

/* The step of the numbers on the axis of crank angles, which depends on the width of the panel. */
double graph_angle_step(const picture *p, double span);

#endif
