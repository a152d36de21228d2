/* SPDX-License-Identifier: GPL-3.0-or-later
**
** analysis.h - a deck at work: all that is known of one crank position on one branch.
*/
#ifndef FOURLINK_ANALYSIS_H
#define FOURLINK_ANALYSIS_H

#include "deck/deck.h"
#include "derived.h"

/* What is computed beside the motion of the links. */
enum {
    NEED_FORCES = 1,
    NEED_ENGINE = 2,
    NEED_SERIES = 4,
    NEED_KLEIN = 8,
    NEED_DERIVED = 16,
    NEED_SUPERPOSITION = 32
};

/* One row. */
typedef struct flk_row {
    fourlink_instant at;
    fourlink_engine engine; /* these only if they are needed */
    fourlink_series series;
    fourlink_klein klein;
    flk_derived derived; /* of motion, and of forces if these are needed */
} flk_row;

/* The turning moment of a branch, found once. */
typedef struct flk_turning {
    int is_known, is_there;
    fourlink_turning t;
} flk_turning;

/* A deck at work. */
typedef struct flk_analysis {
    const deck *d;
    int possible; /* what the deck can give of the things above */
    fourlink_range range;
    unsigned long n_loads;  /* the gas included */
    fourlink_load *loads;   /* memory for those of the row that is being computed */
    int is_fast;            /* 1: rows are computed in closed form, whatever the deck says */
    double *turning_memory; /* from flk_turning_open; null: the deck has no turning moment */
    flk_turning turning[2]; /* open, crossed */
} flk_analysis;

/* Set up an analysis; 0 when out of memory. */
int flk_analysis_open(flk_analysis *a, const deck *d);
void flk_analysis_close(flk_analysis *a);

/* Compute any crank position: row->at.row is for the caller to fill.  `needs` is what is computed. */
void flk_analysis_at(flk_analysis *a, int needs, fourlink_branch branch,
                     const fourlink_crank *crank, flk_row *row);

/* Row i of the deck's motion, and the row at an angle of it, in the deck's unit. */
void flk_analysis_row(flk_analysis *a, int needs, fourlink_branch branch, unsigned long i,
                      flk_row *row);
void flk_analysis_at_angle(flk_analysis *a, int needs, fourlink_branch branch, double angle,
                           flk_row *row);

/* The last crank angle of the motion, in the deck's unit. */
double flk_analysis_end(const flk_analysis *a);

/* 1 if the motion is one revolution whose ends are one position, at one speed. */
int flk_analysis_is_periodic(const flk_analysis *a);

/* The angle of the motion that an angle is, but for whole periods (a turn, a cycle of several), all in the
** deck's unit; 0 if the motion does not reach it. */
int flk_analysis_find_angle(const flk_analysis *a, double angle, double *at);

#endif
