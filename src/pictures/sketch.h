/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sketch.h - a drawing to scale: lines, arrows, circles, texts, curves.
*/
#ifndef FOURLINK_SKETCH_H
#define FOURLINK_SKETCH_H

#include "canvas.h"
#include "labels.h"

#define SKETCH_CURVES 32
#define SKETCH_NOTES 120
#define SKETCH_MEANINGS 4
#define SKETCH_TITLES 18 /* of curves, in the key, which is as high as the axes */

/* What is drawn.  With a number it is the same thing at each position of a motion. */
typedef enum sketch_subject {
    SKETCH_OTHER,
    SKETCH_FRAME,
    SKETCH_LINK,   /* by number */
    SKETCH_HULL,   /* of the points of a link */
    SKETCH_OFF,    /* the lines to a place off a link's own, of a load */
    SKETCH_POINT,  /* a tracer point */
    SKETCH_CENTRE, /* of mass, of a link */
    SKETCH_PIN,    /* a joint */
    SKETCH_LETTER, /* of all joints */
    SKETCH_ANGLE,  /* of a link */
    SKETCH_NUMBERS,
    SKETCH_SENSE,
    SKETCH_SLOPE,
    SKETCH_GRAVITY,
    SKETCH_SPRING,
    SKETCH_FORCE, /* of the scene */
    SKETCH_TORQUE,
    SKETCH_SIDE, /* of a polygon */
    SKETCH_CORNER,
    SKETCH_IMAGE,
    SKETCH_PATH,
    SKETCH_WANTED, /* a position */
    SKETCH_MEANING,
    SKETCH_MISSING, /* why there is no arrow, or no position */
    SKETCH_CIRCLES,
    SKETCH_BODY /* a link, for all that moves with it */
} sketch_subject;

/* A line beside the drawing: words, and behind them a value and its unit. */
typedef struct sketch_line_beside {
    unsigned long key;
    char words[LABELS_WORDS], value[LABELS_WORDS], unit[40];
} sketch_line_beside;

/* A curve, or the meaning of a line, in the key; title "": it is not there. */
typedef struct sketch_entry {
    pen p;
    unsigned long key;
    char title[80];
} sketch_entry;

/* An arrow that shows a scale, and its words. */
typedef struct sketch_scale_bar {
    pen p;
    double length;
    char value[LABELS_WORDS], unit[40];
} sketch_scale_bar;

typedef struct sketch {
    canvas *c;
    const fourlink_unit *unit; /* of its axes; all else is in SI units */
    place_box drawn;           /* the drawing so far */
    int is_fixed;              /* 1: it does not grow */
    double size;               /* of the whole */
    double letter;             /* height of a letter, a fraction of the size */
    double block;              /* half the length of a piston or a block */
    int is_window;             /* 1: nothing beyond it is drawn */
    double cosine, sine;       /* of the angle by which it is turned */
    fourlink_vector held;      /* the place that is its origin */
    unsigned long subject;     /* of what is drawn now: the key of its first part, */
    unsigned long part;        /* and of the next */
    fourlink_vector place;     /* of that in the axes of the drawing */
    fourlink_vector shift;     /* the same, or 0 for what is not turned */
    int n_notes;
    sketch_line_beside notes[SKETCH_NOTES];
    labels texts;
    sketch_entry entries[SKETCH_CURVES + SKETCH_MEANINGS]; /* curves first */
    int n_entries;
    sketch_scale_bar scale;  /* of a bare drawing: that of its arrows; length 0: there is none */
    double beyond;           /* of the next text, or 0: sketch_beyond */
    int is_away;             /* 1: it is placed away from a point, */
    fourlink_vector away;    /* this one, */
    unsigned long away_hold; /* held by this frame */
    double shrink; /* 1, or lengths of this drawing of a motion are so many times smaller */
} sketch;

/* Begin a drawing of about this size in the next panel; places are in SI units, the axes in this unit. */
void sketch_open(sketch *s, canvas *c, const fourlink_unit *unit, double size);

/* Turn what follows as the canvas asks (1, as at the beginning), or not (0). */
void sketch_turn(sketch *s, int is_turned);

/* Place the origin. */
void sketch_place(sketch *s, fourlink_vector place);

/* Let this place be where the origin is, at each position of a motion. */
void sketch_hold(sketch *s, fourlink_vector at);

/* Say what the following shows, until it is said again; leave out so many of its parts, which are counted. */
void sketch_show(sketch *s, sketch_subject what, unsigned long number);
void sketch_skip(sketch *s, unsigned long parts);

/* What the drawings of a motion say of what follows, until the next subject: the link or the ground with
** which it moves.  Before that, a link is told: its origin, which moves with what is said then, and its
** axis.  Or it is upright at a place that moves with what is said before, or goes along the way from
** such a place to another link's; stretched, it becomes longer with the way.  In other drawings they do
** nothing. */
void sketch_with(sketch *s, int link);
void sketch_body(sketch *s, int link, fourlink_vector origin, fourlink_vector axis);
void sketch_upright(sketch *s, fourlink_vector at);
void sketch_along(sketch *s, fourlink_vector from, int link, fourlink_vector to, int is_stretched);

/* Draw only what is in a square around a place, with this half side. */
void sketch_window(sketch *s, fourlink_vector middle, double half);

/* 1 if a place is in what is drawn. */
int sketch_shows(const sketch *s, fourlink_vector at);

/* Keep room for a place; keep no more room than is included. */
void sketch_include(sketch *s, fourlink_vector p);

void sketch_line(sketch *s, pen p, fourlink_vector from, fourlink_vector to);
void sketch_arrow(sketch *s, pen p, fourlink_vector from, fourlink_vector to);

/* Draw a vector at a place, with so many units of length for one of its own, and its name at the end, or
** "". */
void sketch_vector(sketch *s, pen p, fourlink_vector at, fourlink_vector v, double scale,
                   const char *name);

/* Draw a point, a pin, a centre of mass, or a wanted place, whose radii are fractions of the drawing's
** size; `name` is for those who read the file. */
void sketch_dot(sketch *s, fourlink_vector at, const char *name);
void sketch_pin(sketch *s, fourlink_vector at, const char *name);
void sketch_centre(sketch *s, fourlink_vector at, const char *name);
void sketch_ring(sketch *s, fourlink_vector at, const char *name);

/* Mark a place of a drawing that moves by a name alone. */
void sketch_mark(sketch *s, fourlink_vector at, const char *name);

/* Draw an arc from one angle to another, in rad; or a spiral, which goes from one radius to another. */
void sketch_arc(sketch *s, pen p, fourlink_vector centre, double radius, double from, double to);
void sketch_spiral(sketch *s, pen p, fourlink_vector centre, double inner, double outer,
                   double from, double to);

/* Draw an arc with a head at its end; from one angle to another, in either sense. */
void sketch_turn_arrow(sketch *s, pen p, fourlink_vector centre, double radius, double from,
                       double to);

/* Draw a torque about a point: an arc with a head, counter-clockwise for sign > 0. */
void sketch_torque(sketch *s, pen p, fourlink_vector centre, double radius, double sign);

/* Put a text beside a point, in the direction (dx, dy) if there is room. */
void sketch_text(sketch *s, fourlink_vector at, double dx, double dy, const char *words);

/* The same beside a pin; let the next text, if a script places it, stand farther from its place than this, as
** that of a pin in a block. */
void sketch_letter(sketch *s, fourlink_vector at, double dx, double dy, const char *words);
void sketch_beyond(sketch *s, double radius);

/* Let it be placed away from a point that moves with what is said now. */
void sketch_away(sketch *s, fourlink_vector from);

/* The same with a line to the point, if the text stands far from it or near another such point. */
void sketch_name(sketch *s, fourlink_vector at, double dx, double dy, const char *words);

/* The same close to it, or not at all. */
void sketch_number(sketch *s, fourlink_vector at, double dx, double dy, const char *words);

/* The same at an angle of a circle, in rad, outside of it. */
void sketch_text_around(sketch *s, fourlink_vector centre, double radius, double angle,
                        const char *words);

/* Put a line of text beside the drawing, below the one before, in a format of flk_message; or words, with a
** value behind them and its unit, which may change in a motion.  A subject has one of them. */
void sketch_note(sketch *s, const char *format, ...);
void sketch_value(sketch *s, const char *words, const char *value, const char *unit);

/* Draw an arrow of this length below the drawing, with what it stands for. */
void sketch_scale(sketch *s, pen p, double length, const char *value, const char *unit);

/* Draw a support: a triangle on hatched ground below the point. */
void sketch_support(sketch *s, fourlink_vector at);

/* Draw ground along y from x1 to x2, hatched on its lower (side -1) or upper side (1). */
void sketch_ground(sketch *s, double x1, double x2, double y, double side);

/* Draw a curve; its gaps are not numbers.  There may be SKETCH_CURVES of them. */
void sketch_curve(sketch *s, pen p, const char *title, const fourlink_vector *points, int n);

/* Put a line of this pen and its meaning into the key, after the curves. */
void sketch_key(sketch *s, pen p, const char *meaning);

/* The width of what is beside the drawing, in pixels; put it there: margin.c. */
double sketch_margin_width(const sketch *s);
void sketch_put_margin(const sketch *s);

/* Finish the drawing, with axes of equal scale around it; its title in a format of flk_message. */
void sketch_close(sketch *s, const char *format, ...);

#endif
