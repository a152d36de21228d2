/* SPDX-License-Identifier: GPL-3.0-or-later
**
** deck.c - the memory of a deck.
*/
#include <stdlib.h>
#include <string.h>

#include "deck.h"

void flk_deck_start(deck *d)
{
    text bad;
    int q;

    memset(d, 0, sizeof *d);
    for (q = 0; q < QUANTITY_COUNT; q++) {
        strcpy(d->units[q].name, flk_quantities[q].unit);
        flk_unit_read(flk_text_of(flk_quantities[q].unit), &d->units[q].unit, &bad);
    }
}

/* A piece of memory of the deck's, in front of what it holds. */
typedef struct kept {
    struct kept *next;
    double contents[1]; /* aligned for all that is kept */
} kept;

void *flk_deck_keep(deck *d, size_t size)
{
    kept *k = malloc(sizeof *k + size);

    if (!k)
        return NULL;
    k->next = d->storage;
    d->storage = k;
    return k->contents;
}

void flk_deck_free(deck *d)
{
    kept *k, *next;
    unsigned long i;

    flk_mistakes_free(&d->mistakes);
    for (i = 0; d->variations && i < d->n_loads; i++)
        flk_curve_free(&d->variations[i].torque);
    flk_curve_free(&d->gas.indicator);
    free(d->variations);
    free(d->points);
    free(d->loads);
    free(d->expectations);
    for (k = d->storage; k; k = next) {
        next = k->next;
        free(k);
    }
    memset(d, 0, sizeof *d);
}
