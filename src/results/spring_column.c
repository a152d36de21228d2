/* SPDX-License-Identifier: GPL-3.0-or-later
**
** spring_column.c - the values of a spring's columns.
*/
#include <gsl/gsl_math.h>

#include "spring_column.h"

double flk_spring_column_value(const fourlink_mechanism *mechanism, const fourlink_spring *spring,
                               int component, const fourlink_state *state)
{
    fourlink_spring_state at;

    if (fourlink_spring_at(mechanism, state, spring, &at) != FOURLINK_OK)
        return GSL_NAN;
    return component == 0   ? at.length
           : component == 1 ? at.force
           : component == 2 ? at.energy
                            : at.power;
}
