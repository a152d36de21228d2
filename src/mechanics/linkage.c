/* SPDX-License-Identifier: GPL-3.0-or-later
**
** linkage.c - the mechanism as a whole: type, reachable crank angles, limit positions.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics.h"

const char *fourlink_type_text(int type)
{
    switch (type) {
        FOURLINK_TYPE_LIST(FLK_CASE)
    default:
        return "unknown type";
    }
}

static int same(double x, double y)
{
    return fabs(x - y) <= FLK_ROUNDING * (x + y);
}

/* Grashof: with s the shortest, l the longest link, p and q the others, some link turns fully if
** s + l < p + q; s + l = p + q is a linkage with a change point.  Which it is follows from the place
** of the shortest link. */
static fourlink_type type_of_four_bar(const fourlink_mechanism *mechanism)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;
    double sum = a + b + c + d, s = a, l = a;
    int i, shortest = 2;

    for (i = 1; i <= 4; i++) {
        if (link[i].length < s) {
            s = link[i].length;
            shortest = i;
        }
        if (link[i].length > l)
            l = link[i].length;
    }
    if (mechanism->change_folded || mechanism->change_stretched) {
        if (same(a, b) && same(b, c) && same(c, d))
            return FOURLINK_RHOMBUS;
        if (same(a, c) && same(b, d))
            return FOURLINK_PARALLELOGRAM;
        if ((same(a, b) && same(c, d)) || (same(a, d) && same(b, c)))
            return FOURLINK_DELTOID;
        return FOURLINK_CHANGE_POINT_LINKAGE;
    }
    if (2 * (s + l) > sum)
        return FOURLINK_TRIPLE_ROCKER;
    switch (shortest) {
    case FOURLINK_GROUND:
        return FOURLINK_DOUBLE_CRANK;
    case FOURLINK_CRANK:
        return FOURLINK_CRANK_ROCKER;
    case FOURLINK_COUPLER:
        return FOURLINK_DOUBLE_ROCKER;
    default:
        return FOURLINK_ROCKER_CRANK;
    }
}

int fourlink_type_of(const fourlink_mechanism *mechanism, fourlink_type *type)
{
    if (!mechanism || !type)
        return FOURLINK_NULL;
    if (mechanism->design.kind == FOURLINK_FOUR_BAR)
        *type = type_of_four_bar(mechanism);
    else if (mechanism->change_folded || mechanism->change_stretched)
        *type = FOURLINK_CHANGE_POINT_SLIDER;
    else
        *type = mechanism->stretched > 0 && mechanism->folded > 0 ? FOURLINK_ENGINE
                                                                  : FOURLINK_SLIDER_ROCKER;
    return FOURLINK_OK;
}

static void add_range(fourlink_reach *reach, double from, double to)
{
    if (from < to) {
        reach->from[reach->n_ranges] = from;
        reach->to[reach->n_ranges] = to;
        reach->n_ranges++;
    }
}

/* acos and asin of what rounding, or a mechanism that never reaches, may have taken past 1 */
static double clamp(double x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}

/* The crank angles at which the triangle BCD exists: u1 and u2 of four_bar.c are positive where
**
**    cos^2(theta2/2) > -stretched / 4ad,   sin^2(theta2/2) > -folded / 4ad
*/
static void reach_of_four_bar(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    const fourlink_link *link = mechanism->design.link;
    double ad4 = 4 * link[2].length * link[1].length;
    int far = mechanism->stretched < 0, near = mechanism->folded < 0;
    double farthest = far ? 2 * acos(clamp(sqrt(-mechanism->stretched / ad4))) : M_PI;
    double nearest = near ? 2 * asin(clamp(sqrt(-mechanism->folded / ad4))) : 0;

    if (!far && !near) {
        add_range(reach, 0, 2 * M_PI);
    } else if (!near) {
        add_range(reach, -farthest, farthest);
    } else if (!far) {
        add_range(reach, nearest, 2 * M_PI - nearest);
    } else {
        add_range(reach, nearest, farthest);
        add_range(reach, 2 * M_PI - farthest, 2 * M_PI - nearest);
    }
}

/* u1 and u2 of slider_crank.c are positive where
**
**    sin(theta2) < 1 + stretched / r,   sin(theta2) > -1 - folded / r
*/
static void reach_of_slider_crank(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    double r = mechanism->design.link[2].length;
    int high = mechanism->stretched < 0, low = mechanism->folded < 0;
    double highest = high ? asin(clamp(1 + mechanism->stretched / r)) : M_PI_2;
    double lowest = low ? asin(clamp(-1 - mechanism->folded / r)) : -M_PI_2;

    if (!high && !low) {
        add_range(reach, 0, 2 * M_PI);
    } else if (!low) {
        add_range(reach, -M_PI - highest, highest);
    } else if (!high) {
        add_range(reach, lowest, M_PI - lowest);
    } else {
        add_range(reach, lowest, highest);
        add_range(reach, M_PI - highest, M_PI - lowest);
    }
}

int fourlink_reach_of(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    if (!mechanism || !reach)
        return FOURLINK_NULL;
    memset(reach, 0, sizeof *reach);
    if (mechanism->design.kind == FOURLINK_FOUR_BAR)
        reach_of_four_bar(mechanism, reach);
    else
        reach_of_slider_crank(mechanism, reach);
    return FOURLINK_OK;
}

static double one_turn(double angle)
{
    angle = fmod(angle, 2 * M_PI);
    return angle < 0 ? angle + 2 * M_PI : angle;
}

/* The angle opposite the side z of a triangle x, y, z, by the law of cosines. */
static double angle_in_triangle(double x, double y, double z)
{
    return acos(clamp((x * x + y * y - z * z) / (2 * x * y)));
}

/* The angle between coupler and rocker goes from its value at the least to that at the greatest distance
** BD; the transmission angle is it, or 180 deg less it. */
static void transmission_of_four_bar(const fourlink_mechanism *mechanism, fourlink_limits *limits)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;
    double least = mechanism->folded < 0 ? 0 : angle_in_triangle(b, c, fabs(d - a));
    double most = mechanism->stretched < 0 ? M_PI : angle_in_triangle(b, c, d + a);

    limits->mu_min = least < M_PI - most ? least : M_PI - most;
    limits->mu_max = least <= M_PI_2 && most >= M_PI_2 ? M_PI_2
                     : most < M_PI_2                   ? most
                                                       : M_PI - least;
}

/* Crank and coupler in one line: AC = b + a, and AC = b - a with the crank pointing away from C.  With
** psi the angle ADC the rocker is at 180 deg less psi, above (open) or below the ground (crossed). */
static void swing_of_rocker(const fourlink_mechanism *mechanism, fourlink_branch branch,
                            fourlink_limits *limits)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;
    double extended = angle_in_triangle(d, a + b, c);
    double folded = angle_in_triangle(d, b - a, c) + M_PI, between;

    limits->has_swing = 1;
    limits->theta4_min = M_PI - angle_in_triangle(c, d, a + b);
    limits->theta4_max = M_PI - angle_in_triangle(c, d, b - a);
    limits->theta2_min = extended;
    limits->theta2_max = folded;
    if (branch == FOURLINK_CROSSED) {
        double swap = limits->theta4_min;

        limits->theta4_min = -limits->theta4_max;
        limits->theta4_max = -swap;
        limits->theta2_min = 2 * M_PI - folded;
        limits->theta2_max = 2 * M_PI - extended;
    }
    between = folded - extended;
    limits->time_ratio =
        between > M_PI ? between / (2 * M_PI - between) : (2 * M_PI - between) / between;
}

/* Crank and rod in one line, C at the distance r + l, or l - r with the crank pointing away from C. */
static void stroke_of_piston(const fourlink_mechanism *mechanism, fourlink_branch branch,
                             fourlink_limits *limits)
{
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    double e = mechanism->design.offset, inner = asin(clamp(e / (l + r))),
           outer = M_PI + asin(clamp(e / (l - r)));

    if (branch == FOURLINK_CROSSED) {
        inner = M_PI - inner;
        outer = M_PI - outer;
    }
    limits->has_stroke = 1;
    limits->stroke = sqrt((l + r - e) * (l + r + e)) - sqrt((l - r - e) * (l - r + e));
    limits->inner = one_turn(inner);
    limits->outer = one_turn(outer);
}

static void limits_of_slider_crank(const fourlink_mechanism *mechanism, fourlink_branch branch,
                                   fourlink_limits *limits)
{
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    double e = fabs(mechanism->design.offset);

    limits->mu_min = mechanism->stretched > 0 && mechanism->folded > 0 ? acos((r + e) / l) : 0;
    limits->mu_max = e <= r ? M_PI_2 : acos(clamp((e - r) / l));
    if (mechanism->stretched > 0 && mechanism->folded > 0)
        stroke_of_piston(mechanism, branch, limits);
}

int fourlink_limits_of(const fourlink_mechanism *mechanism, fourlink_branch branch,
                       fourlink_limits *limits)
{
    fourlink_type type;

    if (!mechanism || !limits)
        return FOURLINK_NULL;
    if (branch != FOURLINK_OPEN && branch != FOURLINK_CROSSED)
        return FOURLINK_BAD_BRANCH;
    memset(limits, 0, sizeof *limits);
    if (mechanism->design.kind == FOURLINK_SLIDER_CRANK) {
        limits_of_slider_crank(mechanism, branch, limits);
        return FOURLINK_OK;
    }
    transmission_of_four_bar(mechanism, limits);
    fourlink_type_of(mechanism, &type);
    if (type == FOURLINK_CRANK_ROCKER)
        swing_of_rocker(mechanism, branch, limits);
    return FOURLINK_OK;
}
