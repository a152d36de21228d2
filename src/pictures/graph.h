/* SPDX-License-Identifier: GPL-3.0-or-later
**
** graph.h - columns of a deck as curves over its motion, and their axes.
*/
#ifndef FOURLINK_GRAPH_H
#define FOURLINK_GRAPH_H

#include "picture.h"

#define GRAPH_STEPS 720

/* The smallest and the largest value of curves: of all, and away from dead positions. */
typedef struct graph_extent {
    double low, high;
    double sound_low, sound_high;
    double mu; /* rad, the smallest transmission angle */
} graph_extent;

extern const graph_extent graph_nothing;

void graph_extend(graph_extent *e, double value, double mu);

/* 1 if the picture cuts the curves. */
int graph_is_cut(const graph_extent *e);

/* The index of one of the picture's columns; -1 if the deck does not have it. */
int graph_column(const picture *p, const char *name);

/* Sample k of GRAPH_STEPS + 1 over the motion; 0 if the linkage cannot be assembled there. */
int graph_sample(const picture *p, fourlink_branch branch, int k, double values[PICTURE_COLUMNS],
                 fourlink_instant *now);

/* A curve as it is drawn; y is NaN in its gaps. */
typedef struct graph_line {
    double x[GRAPH_STEPS + 1], y[GRAPH_STEPS + 1];
    int n_points; /* that are not in a gap */
} graph_line;

/* Write column y over column x as $NAME_BRANCH, with breaks where the linkage cannot be assembled.  Angles are
** followed past half a turn; what is rounding becomes 0. */
void graph_put(const picture *p, fourlink_branch branch, const char *name, int x, int y,
               graph_extent *e, graph_line *line);

/* The step of the numbers on the axis of crank angles, which depends on the width of the panel. */
double graph_angle_step(const picture *p, double span);

/* Plot a curve of the panel, up to its title, with gnuplot's line type `line`. */
void graph_plot(picture *p, fourlink_branch branch, const char *name, int line);

#endif
