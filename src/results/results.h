/* SPDX-License-Identifier: GPL-3.0-or-later
**
** results.h - a deck opened for results.
*/
#ifndef FOURLINK_RESULTS_H
#define FOURLINK_RESULTS_H

#include "extreme.h"
#include "list.h"

struct fourlink_results {
    deck d;
    flk_analysis a;
    flk_extremes extremes;
    flk_column *columns; /* those that the deck asks for, */
    size_t n_columns;
    int needs;                            /* and what they need */
    flk_list lists[FOURLINK_OUTPUTS + 1]; /* by FOURLINK_COLUMNS ... */
    fourlink_value *facts;                /* room for all that flk_fact_list can tell */
    char *names;                          /* texts of inputs, outputs and variables; of extremes */
};

#endif
