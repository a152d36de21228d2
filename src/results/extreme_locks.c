/* SPDX-License-Identifier: GPL-3.0-or-later
**
** extreme_locks.c - where friction begins and ends to lock the mechanism.
**
** No formula gives these angles: samples show them, and bisection finds them to rounding.  Towards them friction grows
** as the inverse of the distance, or, where two solutions meet, ends as its root; so they are treated as dead
** positions are.
*/
#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "extreme_search.h"

static int is_locked(const flk_search *x, double passed)
{
    flk_row row;

    flk_search_compute(x, x->needs, passed, &row);
    return row.at.status == FOURLINK_LOCKED;
}

/* Its sign says whether the mechanism is locked. */
static double lock_at(double passed, void *data)
{
    const flk_search *const *x = data;

    return is_locked(*x, passed) ? GSL_NEGINF : GSL_POSINF;
}

int flk_search_find_lock(const flk_search *x, double *edge)
{
    double low, high;
    flk_bracket b;
    int first;
    size_t i;

    *edge = GSL_POSINF;
    if (!x->n)
        return 0;
    low = high = flk_search_passed(x, x->s[0]);
    first = is_locked(x, low);
    for (i = 1; i < x->n && high == low; i++) {
        double at = flk_search_passed(x, x->s[i]);

        if (is_locked(x, at) == first)
            low = high = at;
        else
            high = at;
    }
    if (high == low)
        return first;
    b = flk_bracket_of(low, high, first ? GSL_NEGINF : GSL_POSINF, first ? GSL_POSINF : GSL_NEGINF);
    flk_find_zero(lock_at, &x, &b, 0);
    *edge = first ? b.high : b.low;
    return first;
}
