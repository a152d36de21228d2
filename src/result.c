/* SPDX-License-Identifier: GPL-3.0-or-later
**
** result.c - one row of results: all that is known of one crank position on one branch.
*/
#include "result.h"

const char *branch_name(fourlink_branch branch)
{
    return branch == FOURLINK_OPEN ? "open" : "crossed";
}

void result_compute(const deck *d, const fourlink_range *range, fourlink_branch branch,
                    unsigned long i, result *r)
{
    r->branch = branch;
    r->status = fourlink_motion_row(&d->motion, range, i, &r->row);
    if (r->status == FOURLINK_OK)
        r->status = fourlink_analyse(&d->mechanism, branch, &r->row.crank, d->loads, d->n_loads,
                                     &r->state, d->has_forces ? &r->forces : NULL);
}
