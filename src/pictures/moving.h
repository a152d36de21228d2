/* SPDX-License-Identifier: GPL-3.0-or-later
**
** moving.h - drawings over a motion: those of a report and of the page.
*/
#ifndef FOURLINK_MOVING_H
#define FOURLINK_MOVING_H

#include "drawing/motion.h"
#include "labels.h"
#include "picture.h"

/* Draw so many positions with one range, one scale, and texts that stand still, unless a script places them:
** `draw` is called for some of them twice, before the last call for each, and looks at the phase in
** p->on.motion. `range` is theirs; an empty one is found. */
void moving_run(picture *p, place_box *range, int n, void draw(picture *p, const void *what, int k),
                const void *what);

/* The drawings of a motion on a branch: the mechanism, its small links enlarged, polygons of velocity and
** acceleration, and free bodies. */
typedef enum moving_size { MOVING_WHOLE, MOVING_HALF, MOVING_THIRD } moving_size;

typedef struct moving_panel {
    char title[80];
    moving_size size;
    double width, height; /* pixels */
    place_box box, axes;  /* of the drawing, in pixels and in the deck's unit of length */
    motion list;
} moving_panel;

/* Steps of a motion: crank angles or times in the deck's unit; those of times are rows of the deck. */
typedef struct moving_steps {
    const double *at;
    unsigned long n;
} moving_steps;

/* Where the mechanism is drawn. */
typedef struct moving_sheet {
    double width, height; /* pixels; 0: as in a report, and as high as it needs */
    place_box range;      /* empty: it is found; on a page, in its axes */
} moving_sheet;

typedef struct moving_step moving_step;

/* What a motion is drawn from. */
typedef struct moving {
    picture p;
    plot_request request;
    fourlink_branch branch;
    moving_steps steps;
    moving_step *solved; /* all of them */
    picture_row row;     /* the one that is drawn */
    double largest;      /* force, N */
    moving_sheet sheet;
} moving;

/* Begin the drawings of a branch; 0 without memory.  Close them whatever came of it. */
int moving_open(moving *x, const fourlink_source *source, fourlink_results *results,
                fourlink_branch branch, const moving_steps *steps);
void moving_close(moving *x);

/* Their number; draw one of them.  Returns 0 if there is nothing to draw; then, as always, close its list. */
int moving_count(const moving *x);
int moving_draw(moving *x, int k, moving_panel *panel);

#endif
