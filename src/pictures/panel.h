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
    int is_unbounded; /* 1: the frame cuts the curves where a value is unbounded */
    room r;
} panel;

/* Go on to the next panel, with a key of n curves; the same over another column than the first. */
void panel_begin(picture *p, panel *q, int n);
void panel_begin_over(picture *p, panel *q, int x, int n);

/* Set the ranges, after the curves; mark the instant of a picture of its cycle. */
void panel_range(const picture *p, panel *q);

/* Over the crank angle, put the extremes of column y on this of the picture's branches, curve i, that are
** in the panel; what is rounding compared with the curves is 0. */
void panel_extremes(const picture *p, panel *q, int y, int branch, int i);

#endif
