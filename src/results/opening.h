/* SPDX-License-Identifier: GPL-3.0-or-later
**
** opening.h - opens decks and their designs for results.
*/
#ifndef FOURLINK_OPENING_H
#define FOURLINK_OPENING_H

#include "opened.h"

/* Where the mistakes of a deck go: as in fourlink_results_open. */
typedef struct flk_mistake_list {
    unsigned long max;
    fourlink_mistake *mistakes;
    unsigned long *n;
} flk_mistake_list;

/* Open the deck of a source, or another design of an opened deck's sweep, with `n_set` numbers set; that one
** shares the settings of `from`, which must live longer.  Return the status of fourlink_results_open. */
int flk_opened_read(const fourlink_source *source, const flk_mistake_list *list,
                    flk_opened **opened);
int flk_opened_design(const flk_opened *from, unsigned long design, const deck_number *set,
                      size_t n_set, const flk_mistake_list *list, flk_opened **opened);
void flk_opened_free(flk_opened *o);

#endif
