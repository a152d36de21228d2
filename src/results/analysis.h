/* SPDX-License-Identifier: GPL-3.0-or-later
**
** analysis.h - analysis of a deck: all results at one crank position on one branch.
*/
#ifndef FOURLINK_ANALYSIS_H
#define FOURLINK_ANALYSIS_H

#include "motion/crank_motion.h"
#include "deck/deck.h"
#include "derived.h"

/* What is computed in addition to the motion of the links. */
enum {
    NEED_FORCES = 1,
    NEED_ENGINE = 2,
    NEED_SERIES = 4,
    NEED_KLEIN = 8,
    NEED_DERIVED = 16,
    NEED_SUPERPOSITION = 32,
    NEED_GAS = 64,
    NEED_LOSSES = 128,  /* columns of friction */
    NEED_BALANCE = 256, /* of an engine with [balance] */
    NEED_ACTUAL = 512,  /* columns of the actual motion */
    NEED_ANGLES = 1024, /* theta3, theta4, mu, phi */
    NEED_WANTED = 2048, /* of a linkage found for a function */
    NEED_TIME = 4096,   /* of a crank that moves */
    NEED_RUBBING = 8192 /* of pins that have a radius */
};

/* One row. */
typedef struct flk_row {
    fourlink_instant at;
    fourlink_engine engine; /* computed only if needed */
    fourlink_series series;
    fourlink_klein klein;
    flk_derived derived;   /* from the motion, and from the forces if needed */
    flk_actual_row actual; /* of a deck whose motion is not given */
} flk_row;

/* The turning moment of a branch, computed once. */
typedef struct flk_turning {
    int is_known, is_there;
    fourlink_turning t;
    double efficiency; /* 1, of the cycle, with friction */
} flk_turning;

/* A deck with the memory that its analysis needs. */
typedef struct flk_analysis {
    const deck *d;
    int possible; /* which of the above the deck can give */
    flk_crank_motion crank_motion;
    flk_acting acting;      /* the loads of the present row */
    int is_fast;            /* 1: compute rows in closed form, whatever the deck says */
    double *turning_memory; /* from flk_turning_open; null: the deck has no turning moment */
    flk_turning turning[2]; /* open, crossed */
    double
        rows_left; /* that a search may still compute; a row with loads counts as more than one */
} flk_analysis;

/* Set up an analysis; 0 if out of memory. */
int flk_analysis_open(flk_analysis *a, const deck *d);
void flk_analysis_close(flk_analysis *a);

/* Compute any crank position; the caller fills row->at.row.  `needs` says what to compute. */
void flk_analysis_at(flk_analysis *a, int needs, fourlink_branch branch,
                     const fourlink_crank *crank, flk_row *row);

/* Row i of the deck's motion; the row at an angle of the motion, in the deck's unit. */
void flk_analysis_row(flk_analysis *a, int needs, fourlink_branch branch, unsigned long i,
                      flk_row *row);
void flk_analysis_at_angle(flk_analysis *a, int needs, fourlink_branch branch, double angle,
                           flk_row *row);

/* The row at a time, of a deck with rows by time. */
void flk_analysis_at_time(flk_analysis *a, int needs, fourlink_branch branch, double time,
                          flk_row *row);

#endif
