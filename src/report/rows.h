/* SPDX-License-Identifier: GPL-3.0-or-later
**
** rows.h - the numbers of the interactive drawing: tracks, each a vector or a number at every step of
** the motion, in the deck's units.  Steps are crank angles, or times if the deck has rows by time.
*/
#ifndef FOURLINK_ROWS_H
#define FOURLINK_ROWS_H

#include "view/tracks.h"

enum { ROWS_LOADS = 42, ROWS_POINTS = 24 };

typedef struct rows_track {
    char name[TRACKS_NAME];
    int is_number; /* 1: only x is used */
    double *x, *y; /* by row; NaN where the linkage cannot be assembled */
    double size;   /* the largest magnitude */
} rows_track;

typedef struct rows {
    int out_of_memory;
    fourlink_results *own; /* opened here; null: none */
    view v;                /* of the deck; one instant has become a cycle */
    unsigned long n;
    double *steps;  /* crank angles or times, in the deck's unit */
    double *values; /* room for those of all tracks */

    /* one branch */
    fourlink_branch branch;
    int *status;
    double largest; /* force of the motion, but for rows near dead positions; 0: none is known */
    double *table;  /* by row and column */
    rows_track tracks[TRACKS_MOST];
    int n_tracks;
    fourlink_load *loads; /* at one crank angle */
    tracks now;           /* the same */
} rows;

/* Take the deck that is open, or open it where it is to have other rows or is null, and choose the steps:
** every row of the deck if there are not too many, with others between them if there are few, and the
** crank angle `at`, which may be NaN.  Returns 0 without memory, or if the deck has more loads or points
** than a drawing shows. */
int rows_open(rows *t, const fourlink_source *source, fourlink_results *opened, double at);

/* Where an instant lies among the steps, in their unit. */
double rows_step_of(const rows *t, const fourlink_instant *now);
void rows_close(rows *t);

/* Compute a branch; 0 if it has no rows. */
int rows_compute(rows *t, fourlink_branch branch);

/* The track of a name; null if there is none. */
const rows_track *rows_find(const rows *t, const char *name);

#endif
