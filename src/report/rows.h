/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rows.h - the steps of the moving drawing, and the rows of the table at them.
*/
#ifndef FOURLINK_ROWS_H
#define FOURLINK_ROWS_H

#include "view/tracks.h"

typedef struct rows {
    const fourlink_source *source;
    fourlink_results *own; /* opened here; null: none */
    view v;                /* of the deck; one instant has become a cycle */
    unsigned long n;
    double *steps; /* places of the deck's rows, or between them */

    /* one branch */
    fourlink_branch branch;
    int *status;
    double *table; /* by row and column */
} rows;

/* Take the deck that is open, or open it where it is to have other rows or is null, and choose the steps:
** every row of the deck if there are not too many, with others between them if there are few, and the
** crank angle `at`, which may be NaN.  Returns 0 without memory, or if the deck has more loads or points
** than a drawing shows. */
int rows_open(rows *t, const fourlink_source *source, fourlink_results *opened, double at);

void rows_close(rows *t);

/* Leave only every so many of the steps, and one that is kept, unless they are rows of the deck. */
void rows_thin(rows *t, unsigned long stride, double kept);

/* Compute a branch. */
void rows_compute(rows *t, fourlink_branch branch);

#endif
