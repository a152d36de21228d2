/* SPDX-License-Identifier: GPL-3.0-or-later
**
** canvas.h - a picture's panels: where each one stands, its margins, its titles.
*/
#ifndef FOURLINK_CANVAS_H
#define FOURLINK_CANVAS_H

#include <stddef.h>
#include <stdio.h>

/* Pixels that a letter and a line of text take.  A text terminal is a picture, too, of which each
** character is as large as that. */
#define CANVAS_LETTER 9.0
#define CANVAS_LINE 18.0
#define CANVAS_TEXT_WIDTH 79 /* characters: a terminal without its last column */

typedef struct canvas {
    FILE *out;
    int is_text;
    int columns, rows, next;      /* of panels; the one to come */
    double width, height;         /* of the picture, in pixels */
    double below;                 /* of that, under each panel */
    double box_width, box_height; /* within the axes of the present panel */
    double left, right;           /* its margins */
    int lines;                    /* above it */
    int curves;                   /* in it */
} canvas;

/* A picture of panels of a size, with some room below each; in text they stand one below another. */
void canvas_open(canvas *c, FILE *out, int is_text, int columns, int rows, double width,
                 double height, double below);

/* Define title and source as words that fit; `rest` is the end of the source, which stays. */
void canvas_name(const canvas *c, const char *title, const char *source, const char *rest);

/* Put title and source above a panel that is all. */
void canvas_heading(const canvas *c);

/* Go on to the next panel, with so many lines above its axes and so many pixels at their right. */
void canvas_panel(canvas *c, int lines, double right);

/* Title and names of the axes of a panel; "" is none. */
void canvas_titles(const canvas *c, const char *title, const char *x, const char *x_unit,
                   const char *y, const char *y_unit);

/* The key in a line above the axes. */
void canvas_key(const canvas *c);

/* Grid lines, which would hide the curves of a text terminal. */
void canvas_grid(const canvas *c);

/* Write to the script: as printf with %s, %d and %%, with numbers as %.8g, the same under every locale, and
** with %q, a text in quotes of gnuplot. */
void canvas_print(const canvas *c, const char *format, ...);

/* Characters of UTF-8; the same in pixels. */
int canvas_letters(const char *words);
double canvas_width_of(const char *words);

/* For gnuplot: a text at the right (1) of its place is aligned left, one at the left (-1) right. */
const char *canvas_side(int side);

/* Text of at most so many characters: its beginning, or its end, and "..." */
char *canvas_shorten(const char *words, int letters, int keep_end, char *out, size_t size);

#endif
