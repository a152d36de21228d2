/* SPDX-License-Identifier: GPL-3.0-or-later
**
** actual.c - the actual motion of the machine.
*/
#include "analysis.h"

int flk_actual_open(flk_analysis *a)
{
    (void)a;
    return 1;
}

void flk_actual_close(flk_analysis *a)
{
    (void)a;
}

int flk_actual_at(const flk_analysis *a, fourlink_branch branch, double angle, flk_actual_row *row)
{
    (void)a;
    (void)branch;
    row->angle = angle;
    return FOURLINK_NO_STEADY;
}

int flk_actual_at_row(const flk_analysis *a, fourlink_branch branch, unsigned long i,
                      flk_actual_row *row)
{
    (void)i;
    return flk_actual_at(a, branch, 0, row);
}

const flk_actual_facts *flk_actual_facts_of(const flk_analysis *a, fourlink_branch branch)
{
    (void)a;
    (void)branch;
    return 0;
}
