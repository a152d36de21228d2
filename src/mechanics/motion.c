/* SPDX-License-Identifier: GPL-3.0-or-later
**
** motion.c - the crank positions to compute.
**
** The paper's three kinds of motion (Alvi, section 5, the program): one revolution at constant
** speed; a run-up from rest at constant acceleration, then one revolution at the speed reached; one
** instant.  In addition, any range from - to at constant acceleration.
*/
#include <float.h>
#include <limits.h>
#include <math.h>

#include <gsl/gsl_math.h>

#include "mechanics.h"

/* The last crank angle, in the motion's unit. */
static double last_angle(const fourlink_motion *motion)
{
    double revolution = 2 * M_PI / motion->angle_unit;

    if (motion->run_up > 0)
        return motion->acceleration > 0 ? motion->from + motion->run_up + revolution
                                        : motion->from - motion->run_up - revolution;
    return motion->to;
}

/* The direction in which the range runs, +1 or -1. */
static double direction(const fourlink_motion *motion)
{
    return last_angle(motion) < motion->from ? -1 : 1;
}

/* The angle through which the crank turns before it comes to rest, in its direction of rotation and the
** motion's unit: omega2^2 = speed^2 + 2 acceleration s is 0.  Negative: it does not come to rest.
*/
static double stopping_angle(const fourlink_motion *motion)
{
    int slows = motion->speed > 0 ? motion->acceleration < 0 : motion->acceleration > 0;
    double s;

    if (motion->hold || motion->run_up > 0 || motion->speed == 0 || !slows)
        return -1;
    s = motion->speed * (motion->speed / (2 * motion->acceleration));
    return fabs(s) / motion->angle_unit;
}

/* The number of intervals in a span; the last may be short.  A span that is a whole number of intervals,
** except for rounding, has no short one at its end. */
static double intervals(double span, double interval)
{
    double n = span / interval, whole = floor(n + 0.5);
    double rounding = 8e-16 * whole > 1e-9 ? 8e-16 * whole : 1e-9;

    return fabs(n - whole) <= rounding && whole > 0 ? whole : ceil(n);
}

/* As stopping_angle; negative also if the range ends before. */
static double stop_within_range(const fourlink_motion *motion)
{
    double stop = stopping_angle(motion), span = fabs(last_angle(motion) - motion->from);

    return stop < span * (1 - 1e-12) ? stop : -1;
}

double flk_motion_intervals(const fourlink_motion *motion)
{
    double stop = stop_within_range(motion);

    if (stop >= 0)
        return floor(stop / motion->interval * (1 + 1e-12));
    return intervals(fabs(last_angle(motion) - motion->from), motion->interval);
}

int fourlink_motion_range(const fourlink_motion *motion, fourlink_range *range)
{
    double stop, n, turning;
    fourlink_row last;
    int stops;

    if (!motion || !range)
        return FOURLINK_NULL;
    if (!FLK_WITHIN(motion->angle_unit, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(motion->from, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(motion->to, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(motion->interval, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(motion->run_up, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(motion->speed, FOURLINK_NUMBER_MAX) ||
        !FLK_WITHIN(motion->acceleration, FOURLINK_NUMBER_MAX) || motion->angle_unit <= 0)
        return FOURLINK_BAD_NUMBER;
    if (motion->interval <= 0)
        return FOURLINK_BAD_INTERVAL;
    if (motion->run_up > 0 && motion->acceleration == 0)
        return FOURLINK_NO_RUN_UP;
    turning = motion->speed != 0 ? motion->speed : motion->acceleration;
    if (motion->run_up <= 0 && !motion->hold && motion->acceleration != 0 &&
        motion->from != motion->to && turning * direction(motion) < 0)
        return FOURLINK_BAD_RANGE;

    stop = stop_within_range(motion);
    stops = stop >= 0;
    n = flk_motion_intervals(motion);
    if (n >= FLK_MOTION_MOST || n >= (double)ULONG_MAX)
        return FOURLINK_TOO_MANY_ROWS;
    if (fourlink_motion_at(motion, stops ? motion->from : last_angle(motion), &last) != FOURLINK_OK)
        return FOURLINK_BAD_NUMBER; /* the crank is so slow that its time is infinite */
    range->n_rows = (unsigned long)n + 1;
    range->stops = stops;
    range->stop_angle = stops ? motion->from + direction(motion) * stop : 0;
    return FOURLINK_OK;
}

/* Speed, acceleration and time after the crank has turned through s:
**
**    omega2^2 = speed^2 + 2 acceleration s,   t = 2 s / (speed + omega2)
*/
static void accelerate_crank(double speed, double acceleration, double s, fourlink_row *row)
{
    double square = speed * speed + 2 * acceleration * s;
    /* the square of a tiny speed is 0 */
    double omega2 = acceleration == 0 ? fabs(speed) : square > 0 ? sqrt(square) : 0;

    if (speed < 0 || (speed == 0 && acceleration < 0))
        omega2 = -omega2;
    row->crank.omega2 = omega2;
    row->crank.alpha2 = acceleration;
    row->time = speed + omega2 != 0 ? 2 * s / (speed + omega2) : 0;
}

double flk_motion_theta2(const fourlink_motion *motion, double angle)
{
    return angle * motion->angle_unit - motion->x_at;
}

int fourlink_motion_at(const fourlink_motion *motion, double angle, fourlink_row *row)
{
    fourlink_row at;
    double s, end;

    if (!motion || !row)
        return FOURLINK_NULL;
    if (motion->run_up > 0 && motion->acceleration == 0)
        return FOURLINK_NO_RUN_UP;
    at.angle = at.place = angle;
    at.side = 0;
    at.crank.theta2 = flk_motion_theta2(motion, angle);
    s = (angle - motion->from) * motion->angle_unit;
    if (motion->run_up > 0) {
        end = direction(motion) * motion->run_up * motion->angle_unit;
        if (fabs(s) < fabs(end) * (1 - 1e-12)) {
            accelerate_crank(0, motion->acceleration, s, &at);
        } else {
            accelerate_crank(0, motion->acceleration, end, &at);
            at.crank.alpha2 = 0;
            at.time += (s - end) / at.crank.omega2;
        }
    } else if (motion->hold) {
        at.crank.omega2 = motion->speed;
        at.crank.alpha2 = motion->acceleration;
        at.time = motion->acceleration == 0 && motion->speed != 0 ? s / motion->speed : 0;
    } else {
        accelerate_crank(motion->speed, motion->acceleration, s, &at);
    }
    if (!FLK_WITHIN(at.crank.theta2 + at.crank.omega2 + at.crank.alpha2 + at.time, DBL_MAX))
        return FOURLINK_BAD_NUMBER;
    *row = at;
    return FOURLINK_OK;
}

double flk_motion_angle(const fourlink_motion *motion, const fourlink_range *range, unsigned long i)
{
    double turned = (double)i * motion->interval; /* rounded here: 100 x 0.01 is 1, as on paper */

    return i > 0 && i == range->n_rows - 1 && !range->stops
               ? last_angle(motion)
               : motion->from + direction(motion) * turned;
}

int fourlink_motion_row(const fourlink_motion *motion, const fourlink_range *range, unsigned long i,
                        fourlink_row *row)
{
    if (!motion || !range || !row)
        return FOURLINK_NULL;
    if (i >= range->n_rows)
        return FOURLINK_NO_SUCH_ROW;
    return fourlink_motion_at(motion, flk_motion_angle(motion, range, i), row);
}
