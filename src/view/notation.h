/* SPDX-License-Identifier: GPL-3.0-or-later
**
** notation.h - names and units as they are printed in a book: theta2 is a theta with a subscript, N.m has a
** raised dot.
**
** Tables, csv and terminals keep the plain names.
*/
#ifndef FOURLINK_NOTATION_H
#define FOURLINK_NOTATION_H

#include <stddef.h>

enum { NOTATION_SIZE = 120 };

/* In a name for a drawing: what follows, to the next of them or a blank, is a subscript or a superscript.
** They are characters for private use, in UTF-8. */
#define NOTATION_SUB "\356\200\201"
#define NOTATION_SUPER "\356\200\202"
enum { NOTATION_MARK = 3 }; /* bytes */

/* -1 at the mark of a subscript, 1 at that of a superscript, else 0. */
int notation_mark(const char *words);

/* A part of a text: `level` -1 a subscript, 1 a superscript, 0 neither.  A hyphen that stands for a minus,
** before a number or a name, is a part of its own. */
typedef struct notation_part {
    const char *words;
    size_t n;
    int level, is_minus;
} notation_part;

#define NOTATION_MINUS "\342\210\222" /* in UTF-8 */

/* The next part of a text: `x` begins as {words, 0, 0, 0}; 0 at the end. */
int notation_next(const char *all, notation_part *x);

/* A name in its parts, in UTF-8: F, 12x and "along" of F12_along; max(...) has all of it in `symbol`. */
typedef struct notation {
    char symbol[NOTATION_SIZE];
    char sub[8];
    const char *rest; /* behind the underscore; "": nothing */
} notation;

/* Take a name of a column or a fact apart; 0 if it is no such symbol: then `symbol` is the name. */
int notation_split(const char *name, notation *n);

/* All that stands below the symbol: "12x along". */
char *notation_below(const notation *n, char out[NOTATION_SIZE]);

/* The name in one line, with the subscripts of UTF-8; the unit: m/s2 with its power, deg as the sign. */
char *notation_name(const char *name, char out[NOTATION_SIZE]);
char *notation_unit(const char *unit, char out[NOTATION_SIZE]);

#endif
