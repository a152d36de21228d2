/* SPDX-License-Identifier: GPL-3.0-or-later
**
** statistics.h - statistics of the outputs of a sweep, and its yield.
*/
#ifndef FOURLINK_STATISTICS_H
#define FOURLINK_STATISTICS_H

#include "sheet.h"

/* The values of one output on one branch, but for NaN. */
typedef struct statistics_sample {
    double *values;
    size_t n;
    int has_words; /* 1: some are words, which have no statistics */
} statistics_sample;

/* Of a sweep, one after the other. */
typedef struct statistics {
    const fourlink_value *outputs, *conditions;
    unsigned long n_outputs, n_conditions;
    statistics_sample *samples; /* by branch and output */
    unsigned long designs[2];   /* by branch: open, crossed */
    unsigned long *passed;      /* by branch and condition; after these, all conditions */
} statistics;

/* Begin; the lists stay the caller's.  Returns 0 if out of memory. */
int statistics_open(statistics *x, const fourlink_value *outputs, unsigned long n_outputs,
                    const fourlink_value *conditions, unsigned long n_conditions);
void statistics_close(statistics *x);

/* 1 if a value meets a condition of the yield; NaN meets none. */
int statistics_meets(const fourlink_value *condition, double value);

/* Add a design to s->statistics: its outputs on a branch; null: it could not be computed. */
void statistics_add(sheet *s, fourlink_branch branch, const sheet_output *outputs);

/* Write them as a sheet of their own, which the caller has begun. */
void statistics_write(sheet *s, fourlink_results *results, statistics *x);

#endif
