/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_info.h - what column.c says about each column, for column_value.c.
*/
#ifndef FOURLINK_COLUMN_INFO_H
#define FOURLINK_COLUMN_INFO_H

#include <stddef.h>

#include "analysis.h"

/* How a column's value is computed from the numbers of a row. */
typedef enum column_form {
    VALUE,           /* the first */
    POLAR_SIZE,      /* the first, the size of a vector; the second is its direction */
    POLAR_DIRECTION, /* the first, the direction of a vector; the second is its size */
    SIZE,            /* resultant of two components */
    DIRECTION,       /* their direction */
    PRODUCT,         /* of two */
    DIFFERENCE       /* of two */
} column_form;

/* Traits, besides FOURLINK_OF_CRANK, FOURLINK_CRANK_ANGLE and FOURLINK_OF_ROUNDING. */
enum {
    OF_MOTION_ALONE = 0x1000, /* loads have no corners in it, though it needs forces */
    COLUMN_FLAGS = FOURLINK_OF_CRANK | FOURLINK_CRANK_ANGLE | FOURLINK_OF_ROUNDING
};

/* The denominator of a column that is infinite where this is 0. */
typedef double flk_denominator(const fourlink_state *state);

struct flk_column_info {
    const char *name;
    quantity q;
    int kinds;  /* mechanisms that have it, and USUAL ...: printed when the deck names no columns */
    int need;   /* NEED_FORCES ...; a deck that cannot give all of these does not have the column */
    int traits; /* FOURLINK_OF_CRANK ..., see above */
    flk_denominator *denominator; /* null: the column is finite */
    column_form form;
    size_t x, y; /* places of the numbers in a row */
    const char *meaning, *source_name;
};

flk_denominator flk_denominator_13, flk_denominator_24, flk_denominator_advantage,
    flk_denominator_klein;

#endif
