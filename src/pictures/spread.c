/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spread.c - the spread of an output of many designs over one quantity: extremes, quartiles and median.
*/
#include <stdlib.h>

#include <gsl/gsl_statistics_double.h>

#include "spread.h"

#define OF_NEIGHBOURS 40 /* groups, where each design has its own x */

static int by_x(const void *a, const void *b)
{
    const spread_point *p = a, *q = b;

    return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->y > q->y) - (p->y < q->y);
}

static int by_y(const void *a, const void *b)
{
    const spread_point *p = a, *q = b;

    return (p->y > q->y) - (p->y < q->y);
}

static void take_group(spread_point *designs, size_t n, spread_group *g)
{
    int i;

    g->x = gsl_stats_mean(&designs->x, 2, n);
    qsort(designs, n, sizeof *designs, by_y);
    for (i = 0; i < SPREAD_SIZES; i++)
        g->y[i] =
            gsl_stats_quantile_from_sorted_data(&designs->y, 2, n, (double)i / (SPREAD_SIZES - 1));
}

size_t spread_find(spread_point *designs, size_t n, spread_group groups[SPREAD_MOST])
{
    size_t n_groups = 0, begin, i, distinct = n > 0;

    qsort(designs, n, sizeof *designs, by_x);
    for (i = 1; i < n; i++)
        distinct += designs[i].x != designs[i - 1].x;
    if (distinct > SPREAD_MOST)
        for (i = 0; i < OF_NEIGHBOURS; i++) {
            begin = n * i / OF_NEIGHBOURS;
            take_group(designs + begin, n * (i + 1) / OF_NEIGHBOURS - begin, &groups[n_groups++]);
        }
    else
        for (begin = 0; begin < n; begin = i) {
            for (i = begin + 1; i < n && designs[i].x == designs[begin].x; i++)
                ;
            take_group(designs + begin, i - begin, &groups[n_groups++]);
        }
    return n_groups;
}
