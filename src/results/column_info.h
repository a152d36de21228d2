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

struct flk_column_info {
    const char *name;
    quantity q;
    int kinds; /* mechanisms that have it, and USUAL ...: printed when the deck names no columns */
    int need;  /* NEED_FORCES ...; a deck that cannot give all of these does not have the column */
    column_form form;
    size_t x, y; /* places of the numbers in a row */
    const char *meaning, *source_name;
};

/* Places of numbers in a row. */
#define ROW(member) offsetof(flk_row, at.row.member)
#define FORCE(member) offsetof(flk_row, at.forces.member)
#define DERIVED(member) offsetof(flk_row, derived.member)

#endif
