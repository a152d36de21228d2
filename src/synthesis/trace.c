/* SPDX-License-Identifier: GPL-3.0-or-later
**
** trace.c - the pose of a linkage of any size at a crank angle, with its derivatives.
**
** With A at 0 and D at 1 a coupler point is at
**
**    m = r2 e^(i theta2) + q e^(i theta3),   P = A + (D - A) m
**
** r2, r3, r4 are crank, coupler and rocker relative to the ground.  A crank turns fully if and only if
** |r3 - r4| <= |1 - r2| and r3 + r4 >= 1 + r2: so with numbers s1, s2, s3 that have bounds of their own,
**
**    r2 = s1,   r3 - r4 = |1 - s1| s2,   r3 + r4 = 1 + s1 + s3,   -1 <= s2 <= 1,   s3 >= 0
**
** all of these linkages are in a box: s1 < 1 crank-rockers, s1 > 1 double cranks.  A slider-crank is measured
** by its rod: r2 = s1, offset = (1 - s1) s2.  If the crank need not turn fully, the numbers are the ratios.
**
** From the loop r2 e^(i theta2) + r3 e^(i theta3) = 1 + r4 e^(i theta4), times e^(-i theta4), the real part:
**
**    r3 sin(theta3 - theta4) dtheta3 = dr2 cos(theta2 - theta4) + dr3 cos(theta3 - theta4) - dr4
**                                      - r2 sin(theta2 - theta4) dtheta2
**
** and for a slider-crank, from r2 sin(theta2) + sin(theta3) = e:
**
**    cos(theta3) dtheta3 = de - dr2 sin(theta2) - r2 cos(theta2) dtheta2
**
** The transmission angle, between coupler and rocker, or between rod and the normal of the line of stroke:
**
**    cos(mu) = (r3^2 + r4^2 - f^2) / (2 r3 r4),  f^2 = 1 + r2^2 - 2 r2 cos(theta2);   cos(mu) = sin(theta3)
*/
#include <math.h>
#include <string.h>

#include "points.h"

/* How much rounding may take of the height of a triangle, relative to its side; and the least sine by which
** a rate is divided. */
#define ROUNDING 1e-9
#define LEAST 1e-6

void flk_shape_of(const flk_points *p, const flk_trial *at, flk_shape *shape)
{
    const double *s = &at->x[FLK_SHAPE];
    double side = s[0] < 1 ? -1 : 1, difference = side * (s[0] - 1);
    int k;

    memset(shape, 0, sizeof *shape);
    shape->is_slider = p->kind == FOURLINK_SLIDER_CRANK;
    shape->sign = at->sign;
    for (k = 0; k < 3; k++) {
        shape->ratio[k] = s[k];
        shape->by[k][k] = 1;
    }
    if (!at->turns_fully)
        return;
    if (shape->is_slider) {
        shape->ratio[1] = (1 - s[0]) * s[1];
        shape->by[1][0] = -s[1];
        shape->by[1][1] = 1 - s[0];
        return;
    }
    for (k = 1; k < 3; k++) {
        double half = k == 1 ? 0.5 : -0.5;

        shape->ratio[k] = 0.5 * (1 + s[0] + s[2]) + half * difference * s[1];
        shape->by[k][0] = 0.5 + half * side * s[1];
        shape->by[k][1] = half * difference;
        shape->by[k][2] = 0.5;
    }
}

/* The numbers of a shape with these ratios: of a crank that turns fully, where they are in its box. */
static void find_shape(const flk_points *p, const double ratio[3], flk_trial *at)
{
    double *s = &at->x[FLK_SHAPE], difference = fabs(ratio[0] - 1), s2, s3;
    int is_slider = p->kind == FOURLINK_SLIDER_CRANK;

    s2 = (is_slider ? ratio[1] : ratio[1] - ratio[2]) / difference;
    s3 = is_slider ? 0 : ratio[1] + ratio[2] - 1 - ratio[0];
    at->turns_fully = difference > 0 && fabs(s2) <= 1 && s3 >= 0 && !(is_slider && ratio[0] > 1);
    s[0] = ratio[0];
    s[1] = at->turns_fully ? s2 : ratio[1];
    s[2] = at->turns_fully ? s3 : ratio[2];
}

void flk_trial_from(const flk_points *p, const fourlink_solution *from, flk_trial *at)
{
    const fourlink_link *link = from->design.link;
    int is_slider = p->kind == FOURLINK_SLIDER_CRANK;
    double unit = link[is_slider ? FOURLINK_COUPLER : FOURLINK_GROUND].length, ratio[3];
    unsigned long j;

    memset(at, 0, sizeof *at);
    ratio[0] = link[FOURLINK_CRANK].length / unit;
    ratio[1] = (is_slider ? from->design.offset : link[FOURLINK_COUPLER].length) / unit;
    ratio[2] = is_slider ? 0 : link[FOURLINK_FOLLOWER].length / unit;
    find_shape(p, ratio, at);
    at->x[FLK_AX] = (from->origin.x - p->centre.x) / p->size;
    at->x[FLK_AY] = (from->origin.y - p->centre.y) / p->size;
    at->x[FLK_DX] = at->x[FLK_AX] + unit / p->size * cos(from->direction);
    at->x[FLK_DY] = at->x[FLK_AY] + unit / p->size * sin(from->direction);
    at->x[FLK_QX] = from->point.x / unit;
    at->x[FLK_QY] = from->point.y / unit;
    at->sign = from->branch == FOURLINK_OPEN ? 1 : -1;
    for (j = 0; j < p->n; j++)
        at->theta2[j] = from->position[j].theta2;
    at->sense = p->has_timing && p->timing[1] * (at->theta2[1] - at->theta2[0]) < 0 ? -1 : 1;
    at->x[FLK_START] = p->has_timing ? at->theta2[0] : 0;
    at->x[FLK_ATTITUDE] =
        p->has_angle ? from->position[0].theta3 + from->direction - p->angle[0] : 0;
}

static double away_from_zero(double x)
{
    return fabs(x) > LEAST ? x : x < 0 ? -LEAST : LEAST;
}

/* Set how the coupler turns, from how it turns with the three ratios and the crank. */
static void set_turn(const flk_shape *shape, const double with[3], double crank, flk_pose *pose)
{
    int k;

    for (k = 0; k < 3; k++)
        pose->turn[k] =
            with[0] * shape->by[0][k] + with[1] * shape->by[1][k] + with[2] * shape->by[2][k];
    pose->turn[3] = crank;
}

static int slider_pose(const flk_shape *shape, flk_pose *pose)
{
    double r2 = shape->ratio[0], sine = shape->ratio[1] - r2 * pose->crank.y;
    double square = 1 - sine * sine, cosine, with[3] = {0, 0, 0};

    if (!(square >= -ROUNDING))
        return 0;
    cosine = shape->sign * sqrt(square > 0 ? square : 0);
    pose->coupler.x = cosine;
    pose->coupler.y = sine;
    cosine = away_from_zero(cosine);
    with[0] = -pose->crank.y / cosine;
    with[1] = 1 / cosine;
    set_turn(shape, with, -r2 * pose->crank.x / cosine, pose);
    return 1;
}

int flk_pose_at(const flk_shape *shape, double theta2, flk_pose *pose)
{
    double r2 = shape->ratio[0], r3 = shape->ratio[1], r4 = shape->ratio[2];
    double fx, fy, square, along, height, down, with[3];
    fourlink_vector rocker;

    pose->crank.x = cos(theta2);
    pose->crank.y = sin(theta2);
    if (shape->is_slider)
        return slider_pose(shape, pose);
    fx = 1 - r2 * pose->crank.x; /* from B to D */
    fy = -r2 * pose->crank.y;
    square = fx * fx + fy * fy;
    along = 0.5 * (1 + (r3 - r4) * (r3 + r4) / square);
    height = r3 * r3 / square - along * along;
    if (!(r3 > 0 && r4 > 0 && height >= -ROUNDING * (1 + r3 * r3 / square)))
        return 0;
    height = shape->sign * sqrt(height > 0 ? height : 0);
    pose->coupler.x = (along * fx - height * fy) / r3;
    pose->coupler.y = (along * fy + height * fx) / r3;
    rocker.x = (r3 * pose->coupler.x - fx) / r4;
    rocker.y = (r3 * pose->coupler.y - fy) / r4;
    down = r3 * away_from_zero(pose->coupler.y * rocker.x - pose->coupler.x * rocker.y);
    with[0] = (pose->crank.x * rocker.x + pose->crank.y * rocker.y) / down;
    with[1] = (pose->coupler.x * rocker.x + pose->coupler.y * rocker.y) / down;
    with[2] = -1 / down;
    set_turn(shape, with, -r2 * (pose->crank.y * rocker.x - pose->crank.x * rocker.y) / down, pose);
    return 1;
}

double flk_transmission(const flk_shape *shape, double theta2, double by[4])
{
    double r2 = shape->ratio[0], r3 = shape->ratio[1], r4 = shape->ratio[2], mu, with[3];
    double cosine = cos(theta2), sine = sin(theta2);
    int k;

    if (shape->is_slider) {
        mu = r3 - r2 * sine;
        with[0] = -sine;
        with[1] = 1;
        with[2] = 0;
        by[3] = -r2 * cosine;
    } else {
        mu = (r3 * r3 + r4 * r4 - 1 - r2 * r2 + 2 * r2 * cosine) / (2 * r3 * r4);
        with[0] = (cosine - r2) / (r3 * r4);
        with[1] = 1 / r4 - mu / r3;
        with[2] = 1 / r3 - mu / r4;
        by[3] = -r2 * sine / (r3 * r4);
    }
    for (k = 0; k < 3; k++)
        by[k] = with[0] * shape->by[0][k] + with[1] * shape->by[1][k] + with[2] * shape->by[2][k];
    return mu;
}
