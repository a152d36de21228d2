/* SPDX-License-Identifier: GPL-3.0-or-later
**
** picture.h - pictures of a deck, as scripts for gnuplot.
*/
#ifndef FOURLINK_PICTURE_H
#define FOURLINK_PICTURE_H

#include <stdio.h>

#include "results/row.h"
#include "canvas.h"

/* name; columns and rows of panels, 0: one for each branch; width and height of a panel in pixels; what
** it needs of the deck */
#define PLOT_LIST(X)                                                      \
    X(MECHANISM, "mechanism", 1, 0, 900, 500, PLOT_DRAWING)               \
    X(MOTION, "motion", 2, 3, 500, 320, PLOT_RANGE)                       \
    X(FORCES, "forces", 2, 0, 500, 380, PLOT_FORCES_OF_DECK | PLOT_RANGE) \
    X(TURNING, "turning-moment", 1, 0, 1000, 420, PLOT_FORCES_OF_DECK)    \
    X(POLAR, "polar", 3, 2, 430, 430, PLOT_FORCES_OF_DECK | PLOT_RANGE)   \
    X(VECTORS, "vectors", 3, 3, 550, 400, PLOT_DRAWING)                   \
    X(KLEIN, "klein", 1, 1, 1100, 640, PLOT_SLIDER_CRANK)                 \
    X(ANIMATION, "animation", 1, 1, 860, 540, PLOT_DRAWING | PLOT_RANGE)

enum { PLOT_FORCES_OF_DECK = 1, PLOT_SLIDER_CRANK = 2, PLOT_DRAWING = 4, PLOT_RANGE = 8 };

/* What a drawing has room for. */
#define PLOT_LOADS 40
#define PLOT_POINTS 24

#define PLOT_CODE(code, name, columns, rows, width, height, needs) PLOT_##code,
typedef enum plot_kind { PLOT_LIST(PLOT_CODE) PLOT_COUNT } plot_kind;

/* By plot_kind; ended by a null pointer. */
extern const char *const plot_names[];

/* The kind of file that a name stands for: .svg .png .pdf .txt .gif, and - for the terminal. */
typedef enum plot_file {
    PLOT_SVG,
    PLOT_PNG,
    PLOT_PDF,
    PLOT_TXT,
    PLOT_GIF,
    PLOT_FILE_COUNT
} plot_file;

/* PLOT_FILE_COUNT if the name is none of these. */
plot_file plot_file_of(const char *name);

#define PLOT_POSITIONS 24

typedef struct plot_request {
    plot_kind kind;
    plot_file file;
    const char *picture;           /* the file that the script writes; null: to standard output */
    const char *deck_name;         /* the source, told at the foot of the picture */
    const char *at;                /* the crank angles of --plot-at; null: it was not given */
    double angles[PLOT_POSITIONS]; /* the same, in the deck's unit, of the motion */
    int n_angles;
} plot_request;

/* Write the script of a picture.  1; 0 and a mistake of the deck if there is none to draw. */
int plot_write(FILE *out, deck *d, plot_request *request);

/* The kinds, each in a file of its own; 0: `why` is the reason why there is nothing to draw. */
int plot_mechanism(canvas *on, analysis *a, const plot_request *request, const char **why);
int plot_animation(canvas *on, analysis *a, const char **why);
int plot_motion(canvas *on, analysis *a, const char **why);
int plot_forces(canvas *on, analysis *a, const char **why);
int plot_turning(canvas *on, analysis *a, const char **why);
int plot_polar(canvas *on, analysis *a, const char **why);
int plot_vectors(canvas *on, analysis *a, const plot_request *request, const char **why);
int plot_klein(canvas *on, analysis *a, const plot_request *request, const char **why);

/* Compute the position to draw on a branch: the first of the request, or else of the deck's one
** instant, or else a sixth into the motion, or the first row that the links reach.  A status. */
int plot_position(analysis *a, fourlink_branch branch, const plot_request *request, result *r);

#endif
