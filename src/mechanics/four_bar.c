/* SPDX-License-Identifier: GPL-3.0-or-later
**
** four_bar.c - position, velocity and acceleration of a four-bar linkage.
**
** Links: crank a = AB, coupler b = BC, rocker c = DC, ground d = AD.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "mechanics.h"

/* Reach.  With f = BD the distance that coupler and rocker have to bridge,
**
**    f^2 = a^2 + d^2 - 2 a d cos(theta2),
**
** the triangle BCD exists where |b - c| <= f <= b + c, that is, where both of these are positive:
**
**    u1 = (b + c)^2 - f^2 = [(b + c)^2 - (a + d)^2] + 4 a d cos^2(theta2/2)
**    u2 = f^2 - (b - c)^2 = [(a - d)^2 - (b - c)^2] + 4 a d sin^2(theta2/2)
**
** and u1 u2 = 16 area^2 = 4 b^2 c^2 sin^2(theta4 - theta3), u1 + u2 = 4 b c.  The brackets, `stretched` and
** `folded`, depend on the lengths alone.  The first is 0 for a linkage that can lie in one line at 180 deg,
** the second for one that can do so at 0 deg: its change points.  There the root of u1, or u2, is
** 2 sqrt(ad) cos(theta2/2), or 2 sqrt(ad) sin(theta2/2), which goes smoothly through 0 and changes
** sign: so the side on which C lies follows from the angle, with no memory of earlier rows.
*/
void flk_fourbar_prepare(fourlink_mechanism *mechanism)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;
    double sum = a + b + c + d, slack = b + c - a - d;
    double stretched = slack * sum;
    double folded = (a - d - b + c) * (a - d + b - c);

    /* u1 + u2 = 4 b c: where one of them is 0, sine^2 is the other over b c */
    mechanism->change_stretched =
        fabs(stretched) <= FLK_DEAD * b * c || fabs(slack) <= FLK_ROUNDING * sum;
    mechanism->change_folded = fabs(folded) <= FLK_DEAD * b * c ||
                               fabs(a - d - b + c) <= FLK_ROUNDING * sum ||
                               fabs(a - d + b - c) <= FLK_ROUNDING * sum;
    mechanism->stretched = mechanism->change_stretched ? 0 : stretched;
    mechanism->folded = mechanism->change_folded ? 0 : folded;
}

int flk_fourbar_reach(const fourlink_mechanism *mechanism, double half_sine, double half_cosine,
                      double *sine)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;
    double u1 = mechanism->stretched + 4 * a * d * half_cosine * half_cosine;
    double u2 = mechanism->folded + 4 * a * d * half_sine * half_sine;
    double scale = 0.5 / (b * c), sine2 = (scale * u1) * (scale * u2);

    if (!(fabs(scale * (u1 + u2) - 2) < FLK_LOST))
        return FOURLINK_LOST_IN_ROUNDING;
    if (sine2 < -FLK_DEAD)
        return u1 < 0 ? FOURLINK_TOO_FAR : FOURLINK_TOO_NEAR;
    if (sine2 <= FLK_DEAD) {
        if ((mechanism->change_stretched && u1 < u2) || (mechanism->change_folded && u2 < u1))
            return FOURLINK_CHANGE_POINT;
        return FOURLINK_DEAD_POSITION;
    }
    *sine = sqrt(sine2);
    if (mechanism->change_stretched && half_cosine < 0)
        *sine = -*sine;
    if (mechanism->change_folded && half_sine < 0)
        *sine = -*sine;
    return FOURLINK_OK;
}

/* Position.  The sources solve Freudenstein's equation by a half-angle tangent (Alvi eq. 2), which
** divides by zero for ordinary linkages, and take theta3 from an arcsine (Alvi eq. 3), which loses
** the quadrant.  Instead C is where the circles about B and D meet.  With n the vector BD turned
** left by 90 deg and s = sin(theta4 - theta3), positive where C lies left of B->D:
**
**    (C - B) / b = (f^2 + b^2 - c^2) / (2 b f^2) BD + (c / f^2) s n = (cos(theta3), sin(theta3))
**    (C - D) / c = (b^2 - c^2 - f^2) / (2 c f^2) BD + (b / f^2) s n = (cos(theta4), sin(theta4))
*/
void flk_fourbar_position(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    const fourlink_link *link = mechanism->design.link;
    double b = link[3].length, c = link[4].length, d = link[1].length;
    fourlink_link_state *coupler = &state->link[3], *rocker = &state->link[4];
    double b2_c2 = (b - c) * (b + c), f2, p, along, across;
    fourlink_vector BD;

    BD.x = d - coupler->origin.x;
    BD.y = -coupler->origin.y;
    f2 = FLK_DOT(BD, BD);
    p = 0.5 / (f2 * (b * c));
    along = c * p * (f2 + b2_c2);
    across = 2 * (b * c) * (c * p);
    coupler->axis.x = along * BD.x - across * BD.y * state->sine;
    coupler->axis.y = along * BD.y + across * BD.x * state->sine;
    along = b * p * (b2_c2 - f2);
    across = 2 * (b * c) * (b * p);
    rocker->axis.x = along * BD.x - across * BD.y * state->sine;
    rocker->axis.y = along * BD.y + across * BD.x * state->sine;
    rocker->origin.x = d;
    rocker->origin.y = 0;
    state->phi = 0;
    state->x = 0;
}

void flk_fourbar_angles(fourlink_state *state)
{
    fourlink_link_state *coupler = &state->link[3], *rocker = &state->link[4];

    coupler->theta = flk_angle(&coupler->axis);
    rocker->theta = flk_angle(&rocker->axis);
    state->mu = fabs(rocker->theta - coupler->theta);
    if (state->mu > M_PI)
        state->mu = 2 * M_PI - state->mu;
    if (state->mu > M_PI_2)
        state->mu = M_PI - state->mu;
}

/* Velocity (Alvi eqs. 4.1, its sign mended, and 4.2), here for a unit crank speed:
**
**    k3 = a sin(theta4 - theta2) / (b sin(theta3 - theta4)),   omega3 = k3 omega2
**    k4 = a sin(theta3 - theta2) / (c sin(theta3 - theta4)),   omega4 = k4 omega2
*/
void flk_fourbar_velocity(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length;
    double p = -1 / (b * c * state->sine); /* apart, so that it is found beside the axes */
    fourlink_link_state *crank = &state->link[2], *coupler = &state->link[3],
                        *rocker = &state->link[4];

    coupler->k = c * p * a * FLK_CROSS(crank->axis, rocker->axis);
    rocker->k = b * p * a * FLK_CROSS(crank->axis, coupler->axis);
    coupler->omega = coupler->k * crank->omega;
    rocker->omega = rocker->k * crank->omega;
    rocker->k_origin = zero;
    rocker->velocity = zero;
    state->v = 0;
}

/* Acceleration (Alvi section 3.3, the second formula's label mended):
**
**    alpha3 = [a alpha2 sin(theta4 - theta2) - a omega2^2 cos(theta4 - theta2)
**              - b omega3^2 cos(theta4 - theta3) + c omega4^2] / (b sin(theta3 - theta4))
**    alpha4 = [a alpha2 sin(theta3 - theta2) - a omega2^2 cos(theta3 - theta2)
**              - b omega3^2 + c omega4^2 cos(theta3 - theta4)] / (c sin(theta3 - theta4))
*/
void flk_fourbar_acceleration(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length;
    fourlink_link_state *crank = &state->link[2], *coupler = &state->link[3],
                        *rocker = &state->link[4];
    double s42 = FLK_CROSS(crank->axis, rocker->axis), c42 = FLK_DOT(crank->axis, rocker->axis);
    double s32 = FLK_CROSS(crank->axis, coupler->axis), c32 = FLK_DOT(crank->axis, coupler->axis);
    double c43 = FLK_DOT(coupler->axis, rocker->axis), p = -1 / (b * c * state->sine);
    double a_t = a * crank->alpha, a_n = a * crank->omega * crank->omega;
    double b_n = b * coupler->omega * coupler->omega;
    double c_n = c * rocker->omega * rocker->omega;

    coupler->alpha = c * p * (a_t * s42 - a_n * c42 + (c_n - b_n * c43));
    rocker->alpha = b * p * (a_t * s32 - a_n * c32 + (c_n * c43 - b_n));
    rocker->acceleration = zero;
    state->a = 0;
}
