/* SPDX-License-Identifier: GPL-3.0-or-later
**
** analysis.h - analysis of a deck: all results at one crank position on one branch.
*/
#ifndef FOURLINK_ANALYSIS_H
#define FOURLINK_ANALYSIS_H

#include "motion/actual.h"
#include "deck/deck.h"
#include "derived.h"
#include "motion/corners.h"

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
    NEED_ACTUAL = 512   /* columns of the actual motion */
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
    int possible; /* what of the above can be computed */
    fourlink_range range;
    flk_acting acting; /* the loads of the present row */
    flk_corners *corners;
    flk_actual *actual;     /* null: the motion is given */
    int is_fast;            /* 1: compute rows in closed form, whatever the deck says */
    int winds;              /* 1: a spring is wound up, so that no cycle is as the one before */
    double *turning_memory; /* from flk_turning_open; null: the deck has no turning moment */
    flk_turning turning[2]; /* open, crossed */
    double rows_left;       /* that a search may compute, as rows without loads */
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

/* The last crank angle of the motion, in the deck's unit. */
double flk_analysis_end(const flk_analysis *a);

/* The crank angle, rad, after which a motion that repeats is the same: the cycle, at least one turn, and two
** turns if the mechanism has one change point, after which the links return on the other side. */
double flk_analysis_period(const deck *d);

/* 1 if the actual motion of a branch took too many steps: what is known of it depends on where the budget ended. */
int flk_analysis_stops(const flk_analysis *a, fourlink_branch branch);

/* 1 if speed and acceleration are the same in every period. */
int flk_analysis_repeats(const flk_analysis *a);

/* 1 if the motion is one revolution that ends with the position and speed of its beginning. */
int flk_analysis_is_periodic(const flk_analysis *a);

/* Find the angle of the motion that differs from an angle by whole periods (a turn, or a cycle of several),
** in the deck's unit; 0 if the motion does not reach it. */
int flk_analysis_find_angle(const flk_analysis *a, double angle, double *at);

#endif
