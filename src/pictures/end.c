/* SPDX-License-Identifier: GPL-3.0-or-later
**
** end.c - where the motion ends, for pictures and the report.
*/
#include "picture.h"

double picture_end(const fourlink_motion *motion)
{
    fourlink_range range;
    fourlink_row last;

    fourlink_motion_range(motion, &range);
    fourlink_motion_row(motion, &range, range.n_rows - 1, &last);
    return range.stops ? range.stop_angle : last.angle;
}
