/* SPDX-License-Identifier: GPL-3.0-or-later
**
** panel.h - a panel of curves over the crank angle or another column, the first of the picture's columns.
*/
#ifndef FOURLINK_PANEL_H
#define FOURLINK_PANEL_H

#include "graph.h"
#include "room.h"

#define PANEL_CURVES 5

/* The curves of a panel, and the places of its texts. */
typedef struct panel {
    int x_column;      /* of the picture's columns */
    graph_extent e, x; /* of the curves; of another column than the crank angle on the x axis */
    graph_line line[PANEL_CURVES];
    int n;
    int to_scale;     /* 1: x and y have the same scale */
    int is_averaged;  /* 1: the curve of the plan that is averaged over turns */
    int is_unbounded; /* 1: the frame cuts the curves where a value is unbounded */
    room r;
} panel;

#define PANEL_LETTERS 24 /* the longest name, in a key or beside an axis */

/* What a panel shows: columns on a branch, or one column on all branches. */
typedef struct panel_plan {
    int x; /* the column on the x axis */
    int n, column[PANEL_CURVES], branch[PANEL_CURVES];
    int line[PANEL_CURVES]; /* the numbers of their looks, from 1; 0: by their places */
    int by_branch;          /* 1: the key names branches, otherwise columns */
    int n_key;              /* so many curves are named in its key */
    const char *title,
        *y;         /* above the panel, "": nothing; beside the y axis, null: the column's name */
    int n_extremes; /* of the first so many curves */
    int has_zero;   /* 1: magnitudes, whose axis begins at 0 */
    double mean;    /* a line; NaN: none */
    const char *mean_name;
    int by_turn; /* curve by_turn - 1 is averaged over each turn, if there are several */
    int is_free; /* 1: any columns, with their jumps; cut where a value is unbounded */
} panel_plan;

/* Begin a plan over a column. */
void panel_plan_begin(panel_plan *plan, int x);

/* Draw the next panel; returns 0 if it has nothing to draw. */
int panel_draw(picture *p, const panel_plan *plan);

#endif
