/* SPDX-License-Identifier: GPL-3.0-or-later
**
** end.c - where the motion and the stroke end, for pictures and the report.
*/
#include <math.h>

#include "picture.h"

double picture_end(const fourlink_motion *motion)
{
    fourlink_range range;
    fourlink_row last;

    fourlink_motion_range(motion, &range);
    fourlink_motion_row(motion, &range, range.n_rows - 1, &last);
    return range.stops ? range.stop_angle : last.angle;
}

/* Rod and crank are in one line, x^2 + e^2 = (l - r)^2; a crank that does not turn fully has no such position. */
double picture_outer_end(const fourlink_mechanism *mechanism)
{
    const fourlink_design *d = &mechanism->design;
    double difference = d->link[FOURLINK_COUPLER].length - d->link[FOURLINK_CRANK].length;

    return difference >= fabs(d->offset)
               ? sqrt((difference - d->offset) * (difference + d->offset))
               : mechanism->dead_centre - 2 * d->link[FOURLINK_CRANK].length;
}
