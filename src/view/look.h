/* SPDX-License-Identifier: GPL-3.0-or-later
**
** look.h - colours, widths and dashes of all lines and arrows of drawings, and of curves: their only table.
**
** On paper without colour crank, coupler and rocker differ in grey and width, forces and loads in width and
** dashes.  What is an arrow or a text has a contrast of 4.5 at least with the white paper.
*/
#ifndef FOURLINK_LOOK_H
#define FOURLINK_LOOK_H

/* name, which is the class of an SVG, colour, width in points, dashes (line and gap in turn, "": none),
** what it is: an arrow or a text has LOOK_ARROW */
#define LOOK_LIST(X)                                                \
    X(GROUND, "ground", "000000", 1.5, "", LOOK_ARROW)              \
    X(CRANK, "crank", "0A2F7A", 5, "", LOOK_ARROW)                  \
    X(COUPLER, "coupler", "C25000", 4, "", LOOK_ARROW)              \
    X(FOLLOWER, "follower", "005A40", 3, "", LOOK_ARROW)            \
    X(PATH, "path", "A6447C", 1.5, "", LOOK_LINE)                   \
    X(GHOST, "ghost", "D0D0D0", 1, "", LOOK_PALE)                   \
    X(FORCE, "force", "000000", 2, "", LOOK_ARROW)                  \
    X(LOAD, "load", "A3195B", 3, "", LOOK_ARROW)                    \
    X(CONSTRUCTION, "construction", "666666", 1, "4,4", LOOK_ARROW) \
    X(RESULT, "result", "8A5A00", 3, "9,3", LOOK_ARROW)             \
    X(OTHER, "other", "666666", 1.5, "", LOOK_LINE)                 \
    X(LEADER, "leader", "444444", 0.75, "", LOOK_LINE)              \
    X(SENSE, "sense", "0A2F7A", 1.5, "", LOOK_ARROW)                \
    X(WANTED, "wanted", "A6447C", 1, "2,3", LOOK_LINE)

/* Curves of diagrams in turn; a number beside a curve has its colour. */
#define LOOK_CURVES(X)         \
    X("0072B2", "")            \
    X("C04A00", "10,5")        \
    X("00734F", "5,3")         \
    X("000000", "12,4,2,4")    \
    X("A6447C", "6,3,2,3,2,3") \
    X("8A5A00", "3,5")

/* The areas of the turning moment above and below its mean. */
#define LOOK_ABOVE "56B4E9"
#define LOOK_BELOW "E69F00"

#define LOOK_CODE(code, name, colour, width, dashes, use) LOOK_##code,
typedef enum look_code { LOOK_NONE, LOOK_LIST(LOOK_CODE) LOOK_COUNT } look_code;
#undef LOOK_CODE

typedef enum look_use {
    LOOK_ARROW, /* contrast 4.5 at least */
    LOOK_LINE,  /* 3 */
    LOOK_PALE   /* in the background */
} look_use;

typedef struct look {
    const char *name, *colour; /* colour: six hexadecimal digits */
    double width;
    const char *dashes;
    look_use use;
} look;

/* By look_code; curves from 0. */
extern const look look_table[LOOK_COUNT];
enum { LOOK_CURVE_COUNT = 6 };
extern const look look_curves[LOOK_CURVE_COUNT];

#endif
