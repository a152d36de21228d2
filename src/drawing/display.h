/* SPDX-License-Identifier: GPL-3.0-or-later
**
** display.h - the display list of a picture: lines, arrows, curves, areas, discs and texts on panels.
**
** svg.c and terminal.c write it.  Items are added to the present panel in the units of its axes, or as
** parts of its box; when the panel ends, they become pixels from the upper left corner of the picture, and
** curves are cut to the box.  A panel that has no box ends without items of its axes.
*/
#ifndef FOURLINK_DISPLAY_H
#define FOURLINK_DISPLAY_H

#include <stddef.h>

#include "view/look.h"
#include "view/place.h"

/* How lines and texts look: the looks of the table; the paths of further points; curves by number, and their
** jumps. */
#define PEN_CODE(code, name, colour, width, dashes, use) PEN_##code,
typedef enum pen {
    PEN_OF_LINK,                   /* each link has its own */
    LOOK_LIST(PEN_CODE) PEN_COUNT, /* from here: the paths of further points */
    PEN_PATHS = PEN_COUNT + 23,
    PEN_CURVE, /* + 0, 1, ... */
    PEN_JUMP = PEN_CURVE + 12,
    PEN_GRID = PEN_JUMP + 12,
    PEN_AXIS
} pen;
#undef PEN_CODE

/* The look of a pen, and the class that an SVG gives it. */
look display_look(int stroke);
const char *display_class(int stroke, char out[20]);

typedef enum display_sort {
    DISPLAY_LINE,
    DISPLAY_ARROW, /* a line with a head at its end */
    DISPLAY_ARC,   /* around its place, which becomes a polyline */
    DISPLAY_CURVE, /* any number of places, cut to the box; NaN: a gap */
    DISPLAY_ABOVE, /* the area between a curve and a level, above and below it */
    DISPLAY_BELOW,
    DISPLAY_DISC,   /* a pin, or a point of a link: `is_open` in white */
    DISPLAY_CENTRE, /* a centre of mass: a disc in black and white quarters */
    DISPLAY_MARK,   /* a point of a curve, `size` in pixels; `is_open`: a ring */
    DISPLAY_TEXT,
    DISPLAY_FRAME /* which is not drawn: see below */
} display_sort;

#define DISPLAY_HEAD 0.025      /* of the width of the box: the head of an arrow */
#define DISPLAY_ARC_STEP 0.1037 /* rad, of an arc's polyline: no round angle is a multiple of it */

typedef enum display_align { DISPLAY_LEFT, DISPLAY_MIDDLE, DISPLAY_RIGHT } display_align;

/* Where an item belongs: to the drawing; beside it, to its key or its values; below it, to its scales. */
typedef enum display_part {
    DISPLAY_DRAWING,
    DISPLAY_KEY,
    DISPLAY_NOTE,
    DISPLAY_SCALE
} display_part;

/* What is drawn later lies in front. */
enum { DISPLAY_BACK, DISPLAY_CURVES, DISPLAY_LINES, DISPLAY_FRONT, DISPLAY_LAYERS };

/* What moves as one has a frame: its coordinates in it are the same at all steps of a motion.  A place
** says by which frame it is held, by the key of an item of this sort, or 0 for the sheet.  The places of
** a frame are its origin, and one on its x axis, unless it is upright: a place of its own, of a body
** that turns, or one that something else holds.  With the size 1, coordinates along x are parts of the
** way between the two. */

typedef struct display_item {
    display_sort sort;
    int pen, layer;
    display_part part;
    int in_box; /* 1: places are fractions of the box, from its lower left corner */
    size_t first,
        n; /* its places; a text with two is a label, which a script places beside the first, away
                        from the second */
    double dx, dy; /* pixels to the right and down, from the place */
    double
        size; /* of a disc its radius, in units of the axes; of a head its length, in pixels; of a label
                     how far from its place it begins, in units of the axes */
    double level;      /* of an area */
    double from, span; /* rad, counter-clockwise: where an arc begins, and how far it goes */
    double radius
        [2]; /* of an arc at its beginning and end, in units of the axes; when placed, in pixels */
    fourlink_vector centre; /* of an arc that is placed */
    int is_open; /* of a disc or a mark: white; of an arrow: its head is never shorter than this; of an
                    area: a polygon already */
    display_align align;
    int is_boxed;              /* 1: a text on a white ground */
    int is_upright;            /* 1: a text that runs upwards */
    size_t words, value, unit; /* of a text, one behind the other: offsets; 0: "" */
    size_t name;               /* in the file: an offset */
    unsigned long key; /* what it shows: the same at all steps of a motion; 0: what stands still */
} display_item;

typedef struct display_panel {
    double left, top, width, height; /* of the box, in pixels */
    place_box axes;                  /* what it shows */
    size_t first, n;                 /* its items */
} display_panel;

typedef struct display {
    double width, height; /* of the picture, in pixels */
    display_panel *panels;
    size_t n_panels, panels_capacity;
    display_item *items;
    size_t n_items, items_capacity;
    fourlink_vector *places;
    size_t n_places, places_capacity;
    unsigned long *holds; /* by place: the frame that holds it */
    size_t holds_capacity;
    unsigned long hold; /* of the places that are added next */
    char *words;
    size_t n_words, words_capacity;
    unsigned long key; /* of the items that are added next */
    display_item none; /* takes the place of an item for which there is no memory */
} display;

/* An empty picture; free its memory. */
void display_open(display *d);
void display_close(display *d);

/* Make it empty again. */
void display_clear(display *d);

/* Begin a panel; what follows belongs to it. */
void display_begin_panel(display *d);

/* End it: its box in pixels, its axes. */
void display_end_panel(display *d, place_box box, place_box axes);

/* Forget the last panel and its items. */
void display_drop_panel(display *d);

/* Keep a text; returns its offset. */
size_t display_keep(display *d, const char *words);
const char *display_words(const display *d, size_t offset);

/* The words of a text, its value and its unit. */
enum { DISPLAY_WORDS = 300 }; /* of one that has a value */
const char *display_text_of(const display *d, const display_item *x, char out[DISPLAY_WORDS]);

/* Put a value and its unit behind the words of an item. */
void display_set_value(display *d, display_item *x, const char *value, const char *unit);

/* Add an item to the panel; a dummy when out of memory. */
display_item *display_add(display *d, display_sort sort, int stroke, int layer);

/* Add a place to the last item. */
void display_add_place(display *d, fourlink_vector at);

/* The coordinates of a place in a frame that is there now, by its two places. */
fourlink_vector display_seen(const display_item *frame, const fourlink_vector now[2],
                             fourlink_vector at);

/* Add a line, an arrow, a text. */
display_item *display_line(display *d, int stroke, int layer, fourlink_vector from,
                           fourlink_vector to);
display_item *display_arc(display *d, int stroke, fourlink_vector centre, double from, double span);
display_item *display_text(display *d, int stroke, fourlink_vector at, display_align align,
                           const char *words);

/* The next of the polylines of an item that has been cut: 0 at the end.  `from` begins at 0. */
int display_next_piece(const display *d, const display_item *x, size_t *from, size_t *n);

/* The next place of a piece that has to be drawn, as those between are on a straight line; n behind the
** last. */
size_t display_next_bend(const fourlink_vector *at, size_t i, size_t n);

#endif
