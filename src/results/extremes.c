/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extremes.c - the extremes that a deck asks for: which are found together, and what was found.
*/
#include <stdlib.h>

#include "extreme.h"

int flk_extremes_open(flk_extremes *x, size_t most)
{
    int k;

    x->together[0] = malloc(4 * most * sizeof *x->together[0]);
    x->asked = calloc(most, sizeof *x->asked);
    if (!x->together[0] || !x->asked)
        return 0;
    x->most = most;
    for (k = 0; k < 2; k++) {
        x->together[k] = x->together[0] + (size_t)k * most;
        x->alone[k] = x->together[0] + (size_t)(2 + k) * most;
    }
    return 1;
}

int flk_extremes_prepare(flk_extremes *x)
{
    if (!x->bests)
        x->bests = malloc((x->most + 1) * sizeof *x->bests);
    return x->bests && flk_samples_open(&x->room, x->most + 1);
}

void flk_extremes_close(flk_extremes *x)
{
    free(x->together[0]);
    free(x->bests);
    free(x->asked);
    flk_samples_close(&x->room);
}

void flk_extremes_ask(flk_extremes *x, const flk_column *c)
{
    int k;

    if (x->asked[c->number])
        return;
    for (k = 0; k < 2; k++) {
        flk_extreme_pair *together = &x->together[k][x->n], *alone = &x->alone[k][x->n];

        together->c = alone->c = *c;
        together->is_searched = alone->is_searched = 0;
    }
    x->asked[c->number] = ++x->n;
}

#define FEW 8 /* columns that cost hardly more than one */

static const flk_extreme_pair *pair_of(flk_extremes *x, flk_analysis *a, const flk_column *c,
                                       fourlink_branch branch, int all)
{
    int k = branch == FOURLINK_OPEN ? 0 : 1;
    size_t i = x->asked[c->number];
    int is_alone = !i || !(all || x->is_together || x->n <= FEW);
    flk_extreme_pair *pair = !i         ? &x->other[k]
                             : is_alone ? &x->alone[k][i - 1]
                                        : &x->together[k][i - 1];

    if (!i && !(pair->is_searched && pair->c.number == c->number)) {
        pair->c = *c;
        pair->is_searched = 0;
    }
    if (!pair->is_searched)
        flk_extreme_search(a, &x->room, x->bests, branch, is_alone ? pair : x->together[k],
                           is_alone ? 1 : x->n);
    return pair;
}

int flk_extremes_find(flk_extremes *x, flk_analysis *a, const flk_column *c, fourlink_branch branch,
                      flk_statistic statistic, int all, flk_extreme *found)
{
    const flk_extreme_pair *pair = pair_of(x, a, c, branch, all);

    *found = statistic == FLK_MAX ? pair->max : pair->min;
    if (pair->status != FOURLINK_OK)
        return pair->status;
    return found->is_there ? FOURLINK_OK : FOURLINK_NOT_REACHED;
}
