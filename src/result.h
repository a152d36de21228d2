/* SPDX-License-Identifier: GPL-3.0-or-later
**
** result.h - one row of results: all that is known of one crank position on one branch.
*/
#ifndef FOURLINK_RESULT_H
#define FOURLINK_RESULT_H

#include "deck.h"

typedef struct result {
    fourlink_row row;
    fourlink_branch branch;
    int status; /* not FOURLINK_OK: the following are not to be used */
    fourlink_state state;
    fourlink_forces forces; /* only if the deck has forces */
} result;

const char *branch_name(fourlink_branch branch);

/* Compute row i of a deck's motion. */
void result_compute(const deck *d, const fourlink_range *range, fourlink_branch branch,
                    unsigned long i, result *r);

#endif
