/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sweep.h - the designs of a deck's [sweep], one after the other: rows of each, or a line for each.
*/
#ifndef FOURLINK_SWEEP_H
#define FOURLINK_SWEEP_H

#include <stdio.h>

#include "deck/deck.h"

/* What every design is read from, and which of them are wanted. */
typedef struct sweep_request {
    fourlink_source source;    /* of the first */
    unsigned long part, parts; /* the part-th of so many parts; 1, 1: all */
    int csv;
} sweep_request;

typedef enum sweep_result {
    SWEEP_OK,
    SWEEP_MEMORY,     /* not enough */
    SWEEP_INTERRUPTED /* by the signal *signal_number; whole lines were written */
} sweep_result;

/* Look at the deck's list of outputs; 0 and mistakes if it has none of these. */
int sweep_check(deck *d);

/* Print the designs; `d` is the first, and `failed` receives how many rows or designs have no result. */
sweep_result sweep_print(FILE *out, const deck *d, const sweep_request *request,
                         unsigned long *failed, int *signal_number);

#endif
