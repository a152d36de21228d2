/* SPDX-License-Identifier: GPL-3.0-or-later
**
** picture.h - a picture in the making: its deck, and what all kinds of pictures share.
*/
#ifndef FOURLINK_PICTURE_H
#define FOURLINK_PICTURE_H

#include "system/format.h"
#include "canvas.h"
#include "view/scene.h"

/* name; columns and rows of panels, 0: one for each branch; width and height of a panel in pixels; what it
** needs from the deck; the function that draws it; the columns it draws over the crank angle or over time, if
** the deck has them, of A|B the first; what it shows */
#define PLOT_LIST(X)                                                                              \
    X(MECHANISM, "mechanism", 1, 0, 900, 500, PLOT_DRAWING | PLOT_AT | PLOT_FILLED,               \
      picture_mechanism, NULL, "mechanism with its loads and pin forces")                         \
    X(EXERCISE, "exercise", 1, 0, 760, 460, PLOT_DRAWING | PLOT_AT, picture_exercise, NULL,       \
      "figure of an exercise, without answers")                                                   \
    X(MOTION, "motion", 2, 3, 500, 320, PLOT_RANGE | PLOT_ANGLE_AXIS | PLOT_OVER, picture_motion, \
      "slide|theta3,theta4,x,slide_v|omega3,omega4,v,slide_a|alpha3,alpha4,a",                    \
      "positions, velocities and accelerations")                                                  \
    X(FORCES, "forces", 2, 0, 500, 380,                                                           \
      PLOT_FORCES_OF_DECK | PLOT_RANGE | PLOT_ANGLE_AXIS | PLOT_OVER, picture_forces,             \
      "F12,F23,F34,F14,N,Ts,drive", "pin forces and driving torque")                              \
    X(TURNING, "turning-moment", 1, 0, 1000, 420, PLOT_FORCES_OF_DECK | PLOT_ANGLE_AXIS,          \
      picture_turning, NULL, "turning moment over a cycle, with its mean")                        \
    X(POLAR, "polar", 3, 2, 430, 430, PLOT_FORCES_OF_DECK | PLOT_RANGE | PLOT_BY_ANGLE,           \
      picture_polar,                                                                              \
      "F12_along,F12_across,F32_along,F32_across,F23_along,F23_across,F43_along,"                 \
      "F43_across,F34_along,F34_across,F34x,F34y,F14_along,F14_across,Fsx,Fsy",                   \
      "polar diagrams of the pin forces")                                                         \
    X(VECTORS, "vectors", 2, 5, 620, 400, PLOT_DRAWING | PLOT_AT, picture_vectors, NULL,          \
      "polygons of velocity, acceleration and forces")                                            \
    X(LIMITS, "limits", 2, 0, 760, 460, PLOT_DRAWING | PLOT_AT, picture_limits, NULL,             \
      "limits, transmission angle, instantaneous centres")                                        \
    X(KLEIN, "klein", 1, 1, 1050, 600, PLOT_STROKE | PLOT_AT, picture_klein, NULL,                \
      "Klein's construction")                                                                     \
    X(ANIMATION, "animation", 1, 1, 860, 540, PLOT_DRAWING | PLOT_RANGE | PLOT_FILLED,            \
      picture_animation, NULL, "mechanism in motion")                                             \
    X(SPEED, "speed", 3, 0, 430, 360, PLOT_ACTUAL | PLOT_RANGE | PLOT_ANGLE_AXIS, picture_speed,  \
      "omega2,T_motor,Ts,energy", "speed with its mean, torques over the speed, energy")          \
    X(ERROR, "error", 1, 1, 900, 480, PLOT_WANTED | PLOT_RANGE | PLOT_ANGLE_AXIS | PLOT_OVER,     \
      picture_motion, "structural_error", "structural error of a function generator")             \
    X(COLUMNS, "columns", 2, 1, 500, 340, PLOT_RANGE | PLOT_ANGLE_AXIS, picture_columns, NULL,    \
      "columns of the table, or outputs of the sweep")

enum {
    PLOT_FORCES_OF_DECK = 1,
    PLOT_STROKE = 2, /* a piston */
    PLOT_DRAWING = 4,
    PLOT_RANGE = 8,
    PLOT_ANGLE_AXIS = 16,
    PLOT_FILLED = 64,    /* as high as its drawing */
    PLOT_ACTUAL = 128,   /* a motion that is not given */
    PLOT_OVER = 256,     /* over the crank angle or over time */
    PLOT_BY_ANGLE = 512, /* not over time */
    PLOT_AT = 1024,      /* of one position */
    PLOT_WANTED = 2048   /* a linkage found for a function */
};

#define PLOT_CODE(code, name, columns, rows, width, height, needs, draw, values, shows) PLOT_##code,
typedef enum plot_kind { PLOT_LIST(PLOT_CODE) PLOT_COUNT } plot_kind;

/* The columns of each kind, as in the list; null: none. */
extern const char *const plot_values[];

/* The kind of a file, by its name: .svg .png .pdf .txt, and - for the terminal. */
typedef enum plot_file { PLOT_SVG, PLOT_PNG, PLOT_PDF, PLOT_TXT, PLOT_FILE_COUNT } plot_file;

#define PICTURE_STEPS 720  /* of a motion */
#define PICTURE_COLUMNS 40 /* of a picture; all kinds together have fewer */

/* A row of a motion, with all columns. */
typedef struct plot_sample {
    int status;
    fourlink_instant now;
    double values[PICTURE_COLUMNS];
} plot_sample;

/* A deck that is open for pictures.  Its samples, PICTURE_STEPS + 1 between two angles on each of the
** branches, are kept for the next curve. */
typedef struct plot_deck {
    fourlink_results *results; /* null: not yet open */
    plot_sample *samples[2];   /* null: none yet */
    double from[2], end[2];
} plot_deck;

void plot_deck_close(plot_deck *d);

/* The panels of PLOT_VECTORS: all, with the mechanism; of a page, which has that, one group of them. */
typedef enum plot_part { PLOT_WHOLE, PLOT_OF_MOTION, PLOT_OF_FORCES } plot_part;

typedef struct plot_request {
    plot_kind kind;
    plot_part part;
    plot_file file;
    const char *at;           /* the crank angles of --plot-at; null: it was not given */
    const char *x;            /* the column of --plot-x; null: it was not given */
    int is_figure;            /* 1: of a page, which has the title, and of one design of a sweep */
    double lone_width;        /* of a single panel, in pixels; 0: as usual */
    fourlink_results *opened; /* of the deck */
    /* where the deck is kept, open with the columns of all kinds, for the next picture; null: it is not */
    plot_deck *kept;
} plot_request;

/* What a picture is called, and in a sentence what it shows; UTF-8, or not: whatever the deck has. */
typedef struct plot_caption {
    char title[256];
    char words[1200];
    unsigned long n_lines,
        n_missing; /* of a sweep's outputs: lines, one for each design and branch, and those
                                         that could not be computed */
} plot_caption;

/* What a drawing has room for; the gas is one more load. */
#define PICTURE_LOADS (TRACKS_LOADS - 2)
#define PICTURE_POSITIONS 24

#define PICTURE_CURVES 24  /* of any columns */
#define PICTURE_NAMES 2000 /* of columns */

/* A picture in the making. */
typedef struct picture {
    const plot_request *request;
    const fourlink_source *source;
    canvas on;
    display *frames; /* of the plot */
    int *n_frames;
    plot_deck own; /* opened for this picture */
    view v;        /* its columns are those of the kind that the deck has */
    int has_inset; /* 1: in a picture of Klein's construction, the crank is drawn enlarged as well */
    int insets[2], n_insets; /* links that are small beside the mechanism: drawn enlarged as well */
    int has_instant;         /* 1: the deck asks for one instant, and the picture shows its cycle */
    double instant;          /* its crank angle, in the deck's unit */
    fourlink_load *loads;    /* room for the loads at one crank angle */
    unsigned long n_lines, n_missing;   /* of a sweep's outputs */
    double from;                        /* the place where its curves begin */
    view_spot spots[PICTURE_POSITIONS]; /* of --plot-at */
    int n_spots;
    const char *why; /* the position is shown that nobody asked for; "": it was asked for */
    char why_words[VIEW_WHY];
    double shown;    /* its crank angle, in the deck's unit */
    double size;     /* of the drawing of a branch, m; */
    int size_branch; /* 0: not yet known */
} picture;

/* One crank angle, with its loads and all that is drawn there. */
typedef struct picture_row {
    fourlink_instant now;
    fourlink_load loads[TRACKS_LOADS];
    tracks numbers;
    scene drawn;
} picture_row;

/* The functions of the kinds.  Those with a panel for each branch are called for each, the others for the
** first. They return null, or the reason why there is nothing to draw. */
#define PLOT_FUNCTION(code, name, columns, rows, width, height, needs, draw, values, shows) \
    const char *draw(picture *p, fourlink_branch branch);
PLOT_LIST(PLOT_FUNCTION)

/* Go on to the next frame of a picture that moves. */
void picture_begin_frame(picture *p);

/* Begin a picture; 0: out of memory.  Close it whatever came of it. */
int picture_open(picture *p, const fourlink_source *source, const plot_request *request);
void picture_close(picture *p);

/* Open its deck with these columns, and with a further assignment, unless these are null; one instant
** becomes a whole cycle.  1; 0 and its first mistake, or out of memory. */
int picture_reopen(picture *p, const char *columns, const char *further, fourlink_mistake *mistake);

/* The column to draw over, and those columns of the kind's list, or of all kinds' for a deck that is kept,
** that the deck has. */
void picture_choose(const picture *p, char out[PICTURE_NAMES]);

/* 1 for a column of the kind's list. */
int picture_draws(const picture *p, const char *column);

/* 1 if the picture shows the outputs of the deck's sweep; draw them as `columns`. */
int picture_has_outputs(const picture *p);
const char *picture_outputs(picture *p);

/* The names of the columns to draw: first that of the x axis, then those of the table.  1; 0 and the
** reason. */
int picture_choose_columns(const picture *p, char out[PICTURE_NAMES], fourlink_mistake *mistake);

/* The number of panels of `columns`. */
int picture_column_panels(const picture *p);

/* The room that a drawing needs: size.c. */

/* The largest number of lines beside a drawing: angles, forces, torques, and the key; for free bodies, of
** each link. */
int size_lines_beside(const picture *p, int each_link);

/* The size of the drawing of a mechanism, in m: the larger side of the room of its motion, on any branch. */
double size_of_motion(const picture *p);

/* Its width for a height of 1, with some room around it. */
double size_aspect(const picture *p);

/* Find the links that are small beside the whole: the crank, and a rocker. */
void size_find_insets(picture *p);

/* The height of a panel of this width, when the insets are known, in which the mechanism fills the axes
** on all branches. */
double size_height(const picture *p, double width);

/* 1 if the deck has counterweights at a radius; open it again with them or without, by an assignment; free
** that.  Returns 0 if it cannot be opened, as without memory. */
int picture_has_balance(const picture *p);
int picture_open_balance(picture *p, const char *apply, picture *other);

/* A value and its unit, with the blank between them if there is one. */
typedef struct picture_number {
    char value[FORMAT_SIZE], unit[NOTATION_SIZE];
} picture_number;

/* A crank angle, in the deck's unit: 60 and the degree sign, or 1.047 rad. */
#define PICTURE_MARK (FORMAT_SIZE + 64)
void picture_angle(const picture *p, double angle, int digits, picture_number *out);
char *picture_mark(const picture *p, double angle, int digits, char out[PICTURE_MARK]);

/* Subscripts, in UTF-8. */
#define SUB_1 "\342\202\201"
#define SUB_2 "\342\202\202"
#define SUB_3 "\342\202\203"
#define SUB_4 "\342\202\204"
#define SUB_S "\342\202\233"

/* A value in SI units; "NAME = VALUE UNIT" or "VALUE UNIT" of it.  A name has so many letters at most. */
#define PICTURE_NAME 24
void picture_value(const picture *p, double si, quantity q, picture_number *out);
#define PICTURE_WORDS 120
char *picture_words(const picture *p, const char *name, double si, quantity q,
                    char out[PICTURE_WORDS]);

/* rad/s, of the crank at the first row; of the actual motion its mean over a cycle, if it has one. */
double picture_speed_of(const picture *p, fourlink_branch branch);

/* Why there is nothing to draw: no row of the motion can be computed on a branch. */
const char *picture_no_rows(const picture *p, fourlink_branch branch);

/* 1 if a column is a crank angle on which the samples lie at equal steps. */
int picture_is_over_angle(const picture *p, int column);

/* Begin curves where the last turn of a motion of several begins, on a branch; 1 if there are several. */
int picture_take_last_turn(picture *p, fourlink_branch branch);

/* The place after k of so many equal steps of the motion. */
double picture_place(const picture *p, double k, int steps);

/* The side of an input there, if the rows are on both; else 0. */
int picture_side(const picture *p, double k, int steps);

/* All that is known after k of so many equal steps of the motion, by angle or by time; of rows by time,
** PICTURE_STEPS is a multiple of `steps`.  As fourlink_results_row. */
int picture_sample(const picture *p, fourlink_branch branch, double k, int steps, double *values,
                   fourlink_instant *now, fourlink_load *loads);

/* The samples of a branch over the motion that is drawn; null without memory. */
const plot_sample *picture_samples(picture *p, fourlink_branch branch);

/* The position there, without forces; returns a status. */
int picture_state(const picture *p, fourlink_branch branch, double k, int steps,
                  fourlink_instant *now);

/* The position to draw on a branch: the first of the request, otherwise as view_find_position has it, and
** why; the same with all that is drawn there.  Returns a status. */
int picture_position(picture *p, fourlink_branch branch, fourlink_instant *now,
                     fourlink_load *loads);
int picture_row_find(picture *p, fourlink_branch branch, picture_row *r);

#endif
