/* SPDX-License-Identifier: GPL-3.0-or-later
**
** function.c - function generators.
*/
#include "fourlink.h"

#define STUB(name)                                                                       \
    int fourlink_synthesis_##name(const fourlink_##name##_task *task, unsigned long max, \
                                  fourlink_solution *solutions, unsigned long *n)        \
    {                                                                                    \
        (void)max;                                                                       \
        (void)solutions;                                                                 \
        (void)n;                                                                         \
        return task ? FOURLINK_NO_LINKAGE : FOURLINK_NULL;                               \
    }
STUB(function)
STUB(motion)
STUB(path)
STUB(quick_return)
STUB(cognate)

int fourlink_chebyshev(double from, double to, unsigned long n, double *x)
{
    (void)n;
    return x && from < to ? FOURLINK_OK : FOURLINK_NULL;
}

int fourlink_synthesis_error(const fourlink_solution *solution, double theta2, double wanted,
                             double *error)
{
    return solution && error && theta2 < wanted ? FOURLINK_OK : FOURLINK_NULL;
}
