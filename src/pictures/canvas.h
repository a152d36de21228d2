/* SPDX-License-Identifier: GPL-3.0-or-later
**
** canvas.h - a picture's panels: their places, margins and titles.
*/
#ifndef FOURLINK_CANVAS_H
#define FOURLINK_CANVAS_H

#include <stddef.h>

#include "drawing/display.h"
#include "view/notation.h"

/* Pixels of a letter and of a line of text.  A text terminal counts as a picture with characters of this
** size. */
#define CANVAS_LETTER 9.0
#define CANVAS_LINE 18.0
#define CANVAS_TEXT_WIDTH 79 /* characters: a terminal without its last column */

/* An entry of a key: a line of a pen, a point, or an area, and its words. */
typedef struct canvas_entry {
    display_sort sort;
    int pen;
    unsigned long key; /* of a drawing that moves */
    char words[100];
} canvas_entry;

#define CANVAS_ENTRIES 48

typedef struct canvas {
    display *d;
    int is_text;
    double turn; /* rad: drawings are turned by this angle, so that gravity acts downwards */
    int columns, rows, next;      /* of panels; the next panel */
    int fills_row;                /* 1: the next panel has all columns of its row */
    double width, height;         /* of the picture, in pixels */
    double head, below;           /* pixels above all panels, under each panel */
    double box_width, box_height; /* within the axes of the present panel */
    double left, right;           /* its margins */
    place_box box;                /* its axes, in pixels */
    place_box axes;               /* what they show */
    double x_step, y_step;        /* of their numbers */
    int has_zero_axes;            /* 1: lines through 0 in all panels */
    int is_bare;                  /* 1: no axes and no titles, but scales below the drawing */
    int has_no_scale;             /* 1: no axes */
    int has_scale_bars;           /* 1: no axes, but scales below the drawing */
    int lines;                    /* above it */
    int has_key_below_title;      /* 1: its key is in lines above the axes; 0: at their right */
    canvas_entry entries[CANVAS_ENTRIES];
    int n_entries;
    struct labels_motion *motion; /* of a drawing that moves; null: of none */
} canvas;

/* Begin a picture of panels of this size, with some room below each; in text they are below each other. */
void canvas_open(canvas *c, display *d, int is_text, int columns, int rows, double width,
                 double height, double below, int has_title);

/* Put title and source above all panels, shortened to fit; `rest`, the end of the source, is kept. */
void canvas_name(const canvas *c, const char *title, const char *source, const char *rest);

/* The name of a column and a unit as they are printed in a book, or plain on a text terminal. */
const char *canvas_symbol(const canvas *c, const char *name, char out[NOTATION_SIZE]);
const char *canvas_unit(const canvas *c, const char *unit, char out[NOTATION_SIZE]);

/* 1 if scales stand below a drawing, in place of axes. */
int canvas_has_scales(const canvas *c);

/* The length of an arrow's head as a fraction of the width; 0: as usual. */
double canvas_head(const canvas *c);

/* Begin the next panel; place its axes, with so many lines above them and so many pixels at their right; the
** ranges of the axes and the steps of their numbers, 0: as many as fit; end it, or leave it out. */
void canvas_begin_panel(canvas *c);
void canvas_place_panel(canvas *c, int lines, double right);
void canvas_set_axes(canvas *c, place_box axes, double x_step, double y_step);
void canvas_end_panel(canvas *c);
void canvas_drop_panel(canvas *c);

/* Put the names of the axes of a panel and its title, in a format of flk_message; "" for none. */
void canvas_titles(const canvas *c, const char *x, const char *x_unit, const char *y,
                   const char *y_unit, const char *format, ...);

/* Add to the key of the panel. */
void canvas_add_key(canvas *c, display_sort sort, int stroke, const char *words);

/* Put a scale below a bare drawing: a length in pixels, as an arrow of this pen or, 0, as a line with ends,
** its value and unit.  Returns where the next may begin. */
double canvas_scale(const canvas *c, double from, double length, int stroke, const char *value,
                    const char *unit);

/* Put a line of text to the right of the axes, line 0 at their top, in such a format. */
display_item *canvas_note(const canvas *c, int line, const char *format, ...);

/* The number of UTF-8 characters; their width in pixels. */
int canvas_letters(const char *words);
double canvas_width_of(const char *words);

/* Shorten a text to so many characters: its beginning, or its end, and "..." */
char *canvas_shorten(const char *words, int letters, int keep_end, char *out, size_t size);

#endif
