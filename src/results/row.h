/* SPDX-License-Identifier: GPL-3.0-or-later
**
** row.h - a deck at work: all that is known of one crank position on one branch.
*/
#ifndef FOURLINK_ROW_H
#define FOURLINK_ROW_H

#include "deck/deck.h"
#include "derived.h"

/* What is computed beside the motion of the links. */
enum {
    NEED_FORCES = 1,
    NEED_ENGINE = 2,
    NEED_SERIES = 4,
    NEED_KLEIN = 8,
    NEED_EXTRAS = 16,
    NEED_SUPERPOSITION = 32
};

/* One row of results. */
typedef struct result {
    fourlink_row row;
    fourlink_branch branch;
    int status; /* not FOURLINK_OK: the following are not to be used */
    fourlink_state state;
    fourlink_forces forces; /* these only if they are needed */
    fourlink_engine engine;
    fourlink_series series;
    fourlink_klein klein;
    extras extras; /* of motion, and of forces if these are needed */
} result;

typedef struct analysis {
    const deck *d;
    int needs;
    fourlink_range range;
    fourlink_load *loads; /* as they are at the present crank angle, the gas last */
    unsigned long n_loads;
    int out_of_memory; /* 1: a search for an extreme or the turning moment had no memory */
} analysis;

const char *branch_name(fourlink_branch branch);

/* What a deck can give of the things above. */
int analysis_possible(const deck *d);

/* Set up the analysis of a deck; 0 when out of memory. */
int analysis_open(analysis *a, const deck *d, int needs);
void analysis_close(analysis *a);

/* Compute row i of the deck's motion, or any crank position: then r->row is for the caller to fill. */
void analysis_row(analysis *a, fourlink_branch branch, unsigned long i, result *r);
void analysis_at(analysis *a, fourlink_branch branch, const fourlink_crank *crank, result *r);

/* The last crank angle of the motion, in the deck's unit. */
double analysis_end(const analysis *a);

/* 1 if the motion is one revolution whose ends are one position, at one speed. */
int analysis_is_periodic(const analysis *a);

/* The row that is k of so many equal steps into the motion. */
void analysis_spread(const analysis *a, int k, int steps, fourlink_row *row);

/* The angle of the motion that an angle is, but for whole periods (a turn, a cycle of several), all in the
** deck's unit; 0 if the motion does not reach it. */
int analysis_find_angle(const analysis *a, double angle, double *at);

#endif
