/* SPDX-License-Identifier: GPL-3.0-or-later
**
** mathml.h - equations in MathML: in symbols, with the numbers put in, and the result.
**
** An equation is text whose tokens are separated by blanks:
**
**    a, theta3, F12x        symbols: a letter, or the name of a Greek one, and its subscript
**    2, 180deg              numbers, angles
**    + - * = , ( )          a product shows its dot only between numbers
**    ^2 ... ^8  )^2         a power of the symbol, the square of the bracket
**    { x | y }  [ x ]       a fraction, a square root
**    <alpha2 x >            x, unless alpha2 is 0
**    sin cos acos asin atan2
*/
#ifndef FOURLINK_MATHML_H
#define FOURLINK_MATHML_H

#include "math_units.h"
#include "page.h"

#define MATH_SYMBOLS 640
#define MATH_NAME 16  /* bytes of a symbol's name */
#define MATH_DIGITS 6 /* significant digits of a number; angles have 4 decimals of a degree */

/* The unit of a symbol follows from its name.  Values are given in SI units and written in those of
** `units`. */
typedef struct math {
    page *p;
    math_units units;
    double
        size[MATH_UNITS]; /* how large values are: beside them rounding error is 0; 0: not known */
    int n;
    struct {
        char name[MATH_NAME];
        double value;
    } symbol[MATH_SYMBOLS];
} math;

/* Begin on a page with the units of a deck, no symbol and no size. */
void math_begin(math *m, page *p, const fourlink_unit *units);

/* A value in SI units, 0 if it is rounding error; the same in the unit of equations. */
double math_settled(const math *m, double value, math_unit unit);
double math_shown(const math *m, double value, math_unit unit);

/* 1 if a symbol has a value. */
int math_has(const math *m, const char *name);

/* Give a symbol its value; write NAME = VALUE UNIT within a line, too. */
void math_set(math *m, const char *name, double value);
void math_given(math *m, const char *name, double value);

/* Write NAME = EQUATION, the same with numbers, and the value; the symbol has this value from then on. */
void math_let(math *m, const char *name, const char *equation, double value);

/* Write EQUATION = 0, the same with numbers, and the value it comes to, 0 if below 1e-6 of `size`. */
void math_zero(math *m, const char *equation, double value, double size, math_unit unit);

/* Write an equation in symbols alone; with the numbers of those symbols that have a value. */
void math_show(math *m, const char *equation);
void math_show_numbers(math *m, const char *equation);

/* Write a number as it is, or a symbol, as an element within <math>. */
void math_number(page *p, double value);
void math_symbol(page *p, const char *name);

/* Begin the block of an equation and give it its number; a block of another class. */
void math_block(page *p, const char *name_of_class);

/* The beginning of <math> as a block of its own, with a class. */
void math_open(page *p, const char *name_of_class);
void math_close(page *p);

#endif
