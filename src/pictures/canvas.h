/* SPDX-License-Identifier: GPL-3.0-or-later
**
** canvas.h - a picture's panels: their places, margins and titles.
*/
#ifndef FOURLINK_CANVAS_H
#define FOURLINK_CANVAS_H

#include <stddef.h>
#include <stdio.h>

#include "view/notation.h"

/* Pixels of a letter and of a line of text.  A text terminal counts as a picture with characters of this
** size. */
#define CANVAS_LETTER 9.0
#define CANVAS_LINE 18.0
#define CANVAS_TEXT_WIDTH 79 /* characters: a terminal without its last column */

typedef struct canvas {
    FILE *out;
    int is_text;
    double turn; /* rad: drawings are turned by this angle, so that gravity acts downwards */
    int columns, rows, next;      /* of panels; the next panel */
    double width, height;         /* of the picture, in pixels */
    double head, below;           /* pixels above all panels, under each panel */
    double box_width, box_height; /* within the axes of the present panel */
    double left, right;           /* its margins */
    int lines;                    /* above it */
    int curves;                   /* in it */
} canvas;

/* Begin a picture of panels of this size, with some room below each; in text they are below each other. */
void canvas_open(canvas *c, FILE *out, int is_text, int columns, int rows, double width,
                 double height, double below, int has_title);

/* Define title and source, shortened to fit; `rest`, the end of the source, is kept. */
void canvas_name(const canvas *c, const char *title, const char *source, const char *rest);

/* Put title and source above the only panel. */
void canvas_heading(const canvas *c);

/* The name of a column and a unit as they are printed in a book, or plain on a text terminal. */
const char *canvas_symbol(const canvas *c, const char *name, char out[NOTATION_SIZE]);
const char *canvas_unit(const canvas *c, const char *unit, char out[NOTATION_SIZE]);

/* Go on to the next panel, with so many lines above its axes and so many pixels at their right. */
void canvas_panel(canvas *c, int lines, double right);

/* Put the names of the axes of a panel and its title, in a format of flk_message; "" for none. */
void canvas_titles(const canvas *c, const char *x, const char *x_unit, const char *y,
                   const char *y_unit, const char *format, ...);

/* Put the key in a line above the axes. */
void canvas_key(const canvas *c);

/* Put a line of text to the right of the axes, line 0 at their top, in such a format. */
void canvas_note(const canvas *c, int line, const char *format, ...);

/* Put grid lines, except on a text terminal, where they would hide the curves. */
void canvas_grid(const canvas *c);

/* Write to the script, as printf does with %s, %d and %%; %.8g is the same in every locale, %q quotes a
** text for gnuplot, %f the name of a file, and %w a text with subscripts, as canvas_mode has it drawn. */
void canvas_print(const canvas *c, const char *format, ...);

/* gnuplot's word for a text with subscripts, or without. */
const char *canvas_mode(const char *words);

/* The number of UTF-8 characters; their width in pixels. */
int canvas_letters(const char *words);
double canvas_width_of(const char *words);

/* Shorten a text to so many characters: its beginning, or its end, and "..." */
char *canvas_shorten(const char *words, int letters, int keep_end, char *out, size_t size);

#endif
