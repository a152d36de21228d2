/* SPDX-License-Identifier: GPL-3.0-or-later
**
** four_bar.c - the four-bar linkage.
**
** Links: crank a = AB, coupler b = BC, rocker c = DC, ground d = AD.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "coordinate.h"
#include "kind.h"
#include "turns.h"

/* Reach.  With f = BD, the distance that coupler and rocker must span,
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
** the second for one that can do so at 0 deg: its change points.  There the root of u1 or u2 is 2 sqrt(ad)
** cos(theta2/2) or 2 sqrt(ad) sin(theta2/2), which passes smoothly through 0 and changes sign.  So the side
** on which C lies follows from the angle alone, not from earlier rows.
*/
static int four_bar_prepare(fourlink_mechanism *mechanism)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;
    double sum = a + b + c + d, slack = b + c - a - d;
    double stretched = slack * sum;
    double folded = (a - d - b + c) * (a - d + b - c);

    /* u1 + u2 = 4 b c: where one of them is 0, sine^2 is the other divided by b c */
    mechanism->change_stretched =
        fabs(stretched) <= FLK_DEAD * b * c || fabs(slack) <= FLK_ROUNDING * sum;
    mechanism->change_folded = fabs(folded) <= FLK_DEAD * b * c ||
                               fabs(a - d - b + c) <= FLK_ROUNDING * sum ||
                               fabs(a - d + b - c) <= FLK_ROUNDING * sum;
    mechanism->stretched = mechanism->change_stretched ? 0 : stretched;
    mechanism->folded = mechanism->change_folded ? 0 : folded;
    return FOURLINK_OK;
}

static int four_bar_reach(const fourlink_mechanism *mechanism, double half_sine, double half_cosine,
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
** divides by zero for ordinary linkages, and take theta3 from an arcsine (Alvi eq. 3), which loses the
** quadrant.  Instead, C is found as the intersection of the circles about B and D.  With n the vector BD
** turned left by 90 deg and s = sin(theta4 - theta3), positive where C lies left of B->D:
**
**    (C - B) / b = (f^2 + b^2 - c^2) / (2 b f^2) BD + (c / f^2) s n = (cos(theta3), sin(theta3))
**    (C - D) / c = (b^2 - c^2 - f^2) / (2 c f^2) BD + (b / f^2) s n = (cos(theta4), sin(theta4))
*/
static void four_bar_position(const fourlink_mechanism *mechanism, fourlink_state *state)
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
}

static void four_bar_angles(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    (void)mechanism;
    state->mu = fabs(state->link[4].theta - state->link[3].theta);
    if (state->mu > M_PI)
        state->mu = 2 * M_PI - state->mu;
    if (state->mu > M_PI_2)
        state->mu = M_PI - state->mu;
}

/* Velocity (Alvi eqs. 4.1, with its sign corrected, and 4.2), here for unit crank speed:
**
**    k3 = a sin(theta4 - theta2) / (b sin(theta3 - theta4)),   omega3 = k3 omega2
**    k4 = a sin(theta3 - theta2) / (c sin(theta3 - theta4)),   omega4 = k4 omega2
*/
static void four_bar_velocity(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length;
    double p = -1 / (b * c * state->sine); /* separate: it is computed in parallel with the axes */
    fourlink_link_state *crank = &state->link[2], *coupler = &state->link[3],
                        *rocker = &state->link[4];

    coupler->k = c * p * a * FLK_CROSS(crank->axis, rocker->axis);
    rocker->k = b * p * a * FLK_CROSS(crank->axis, coupler->axis);
    coupler->omega = coupler->k * crank->omega;
    rocker->omega = rocker->k * crank->omega;
    rocker->k_origin = zero;
    rocker->velocity = zero;
}

/* Acceleration (Alvi section 3.3, with the label of the second formula corrected):
**
**    alpha3 = [a alpha2 sin(theta4 - theta2) - a omega2^2 cos(theta4 - theta2)
**              - b omega3^2 cos(theta4 - theta3) + c omega4^2] / (b sin(theta3 - theta4))
**    alpha4 = [a alpha2 sin(theta3 - theta2) - a omega2^2 cos(theta3 - theta2)
**              - b omega3^2 + c omega4^2 cos(theta3 - theta4)] / (c sin(theta3 - theta4))
*/
static void four_bar_acceleration(const fourlink_mechanism *mechanism, fourlink_state *state)
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
}

/* Forces in closed form.  Moments about B and D eliminate the force at that pin; F34 has the link as its arm:
**
**    moments of link 3 about B    b e3 x F34 = -M3
**    moments of link 4 about D    c e4 x F34 =  M4
**
**    F34 = -[(M3 / b) e4 + (M4 / c) e3] / sin(theta4 - theta3)
*/
static void four_bar_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                            const flk_body body[3], double M3, double M4, fourlink_vector *F34,
                            fourlink_forces *forces)
{
    const fourlink_vector *e3 = &state->link[3].axis, *e4 = &state->link[4].axis;
    double b = mechanism->design.link[3].length, c = mechanism->design.link[4].length;
    double p = -1 / (b * c * state->sine);

    (void)body;
    (void)forces;
    M3 *= c * p;
    M4 *= b * p;
    F34->x = M3 * e4->x + M4 * e3->x;
    F34->y = M3 * e4->y + M4 * e3->y;
}

static int same(double x, double y)
{
    return fabs(x - y) <= FLK_ROUNDING * (x + y);
}

/* Grashof: with s the shortest, l the longest link, p and q the others, some link turns fully if
** s + l < p + q; if s + l = p + q the linkage has a change point.  The position of the shortest link decides
** the type. */
static fourlink_type four_bar_type(const fourlink_mechanism *mechanism)
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

/* The crank angles at which the triangle BCD exists: u1 and u2 are positive where
**
**    cos^2(theta2/2) > -stretched / 4ad,   sin^2(theta2/2) > -folded / 4ad
*/
static void four_bar_ranges(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    const fourlink_link *link = mechanism->design.link;
    double ad4 = 4 * link[2].length * link[1].length;
    int far = mechanism->stretched < 0, near = mechanism->folded < 0;
    double farthest =
        far ? 2 * flk_arc_cosine(flk_kind_clamp(sqrt(-mechanism->stretched / ad4))) : M_PI;
    double nearest = near ? 2 * flk_arc_sine(flk_kind_clamp(sqrt(-mechanism->folded / ad4))) : 0;

    flk_kind_set_ranges(reach, near, nearest, far, farthest, 2 * M_PI);
}

/* The angle opposite the side z of a triangle x, y, z, by the law of cosines. */
static double angle_in_triangle(double x, double y, double z)
{
    return flk_arc_cosine(flk_kind_clamp((x * x + y * y - z * z) / (2 * x * y)));
}

/* The angle between coupler and rocker ranges between its values at the smallest and the largest distance BD.
** The transmission angle is this angle, or 180 deg minus it. */
static void transmission(const fourlink_mechanism *mechanism, fourlink_limits *limits)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length, d = link[1].length;
    double least = mechanism->folded < 0 ? 0 : angle_in_triangle(b, c, fabs(d - a));
    double half_turn = M_PI,
           most = mechanism->stretched < 0 ? half_turn : angle_in_triangle(b, c, d + a);

    limits->gamma_min = least;
    limits->gamma_max = most;
    limits->mu_min = least < half_turn - most ? least : half_turn - most;
    limits->mu_max = least <= M_PI_2 && most >= M_PI_2 ? M_PI_2
                     : most < M_PI_2                   ? most
                                                       : M_PI - least;
}

/* Crank and coupler in one line: AC = b + a, or AC = b - a with the crank pointing away from C.  With psi the
** angle ADC, the rocker is at 180 deg - psi, above (open) or below (crossed) the ground. */
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

static void four_bar_limits(const fourlink_mechanism *mechanism, fourlink_branch branch,
                            fourlink_limits *limits)
{
    transmission(mechanism, limits);
    if (four_bar_type(mechanism) == FOURLINK_CRANK_ROCKER)
        swing_of_rocker(mechanism, branch, limits);
}

/* An angle of the triangle BCD, from sine and cosine, continued through 0 and, if it is `turned` at the
** folded change point, through 180 deg.  Between change points it keeps its sign:
**
**    folded change point alone    sign and angle repeat after two turns of the crank, on one side of 180 deg
**    stretched as well            it passes through 0 there, and goes on in one sense
**
** A line of signed length (a = d) keeps it smooth where that length is 0; it then passes through 180 deg only
** if r reaches -(b + c), once in two turns.
*/
static double in_triangle(const fourlink_mechanism *mechanism, const fourlink_state *state,
                          double sine, double cosine, int turned)
{
    double angle = flk_angle(sine, cosine), branch = (double)state->branch;
    double theta2 = state->link[2].theta;
    int is_signed = mechanism->design.link[1].length == mechanism->design.link[2].length;

    if (is_signed && mechanism->change_folded)
        return mechanism->change_stretched
                   ? angle - branch * 2 * M_PI * floor((theta2 + M_PI) / (4 * M_PI))
                   : angle;
    if (!mechanism->change_folded || !turned)
        return angle;
    if (mechanism->change_stretched)
        return angle - branch * 2 * M_PI * floor(theta2 / (2 * M_PI));
    return angle * branch < 0 ? angle + branch * 2 * M_PI : angle;
}

/* Coupler and rocker: with r the signed length of BD, f = |r|, beta and delta the angles at B and D of the
** triangle BCD, positive where C is to the left of B->D,
**
**    sin(beta) = c sine / r,   cos(beta) = (r^2 + b^2 - c^2) / (2 r b),   theta3 = angle(D - B) + beta
**    sin(delta) = b sine / r,   cos(delta) = (r^2 + c^2 - b^2) / (2 r c),   theta4 = angle(B - D) - delta
*/
static double four_bar_turns(const fourlink_mechanism *mechanism, const fourlink_state *state,
                             int link)
{
    const fourlink_link *l = mechanism->design.link;
    double b = l[3].length, c = l[4].length, r, line = flk_turns_of_B(mechanism, state, &r);

    if (link == FOURLINK_COUPLER)
        return line - M_PI +
               in_triangle(mechanism, state, c * state->sine / r,
                           (r * r + (b - c) * (b + c)) / (2 * r * b), c > b);
    return line - in_triangle(mechanism, state, b * state->sine / r,
                              (r * r + (c - b) * (c + b)) / (2 * r * c), b > c);
}

/* Counterweights (balance.c), with a e^(i theta2) + b e^(i theta3) = d + c e^(i theta4):
**
**    sum m r = const + e^(i theta2) [m2 z2 + m3 a (1 - z3 / b)] + e^(i theta4) [m4 z4 + m3 (c / b) z3]
*/
static void four_bar_balance(const fourlink_mechanism *mechanism, double fraction,
                             fourlink_balance *u)
{
    const fourlink_link *link = mechanism->design.link;
    double m = link[3].mass, a = link[2].length, b = link[3].length, c = link[4].length;
    const fourlink_vector *z = &link[3].cg;

    (void)fraction;
    u->crank.x = -(link[2].mass * link[2].cg.x + m * a * (1 - z->x / b));
    u->crank.y = -(link[2].mass * link[2].cg.y - m * a * z->y / b);
    u->rocker.x = -(link[4].mass * link[4].cg.x + m * c * z->x / b);
    u->rocker.y = -(link[4].mass * link[4].cg.y + m * c * z->y / b);
}

/* A dead position, where coupler and rocker lie in one line, u3 = s u4, s = +-1.  The crank stands still,
** and from the velocity and the acceleration of C, on both links, along u4 and across it,
**
**    omega4 = s b omega3 / c
**    alpha2 = (s b omega3^2 - c omega4^2) / (a sin(theta4 - theta2))
**    alpha4 = [a alpha2 cos(theta4 - theta2) + s b alpha3] / c
*/
static void four_bar_swing(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, c = link[4].length;
    fourlink_link_state *crank = &state->link[2], *coupler = &state->link[3],
                        *rocker = &state->link[4];
    double s = FLK_DOT(coupler->axis, rocker->axis) < 0 ? -1 : 1;

    rocker->k = s * b / c;
    rocker->omega = rocker->k * coupler->omega;
    crank->alpha = (s * b * coupler->omega * coupler->omega - c * rocker->omega * rocker->omega) /
                   (a * FLK_CROSS(crank->axis, rocker->axis));
    rocker->alpha =
        (a * crank->alpha * FLK_DOT(crank->axis, rocker->axis) + s * b * coupler->alpha) / c;
    rocker->k_origin = rocker->velocity = rocker->acceleration = zero;
}

/* The crank from the rocker.  With C = D + c (cos(theta4), sin(theta4)), f = AC and gamma the angle of
** the triangle ABC at A, theta2 = angle of AC +- gamma; theta4 rises with + gamma on the open branch, -
** gamma on the crossed one. */
static double four_bar_theta2_of(const fourlink_mechanism *mechanism, int coordinate,
                                 fourlink_branch branch, int side, double value)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, b = link[3].length, sine, cosine, f;
    fourlink_vector C;

    (void)coordinate;
    flk_sine_cosine(value, &sine, &cosine);
    C.x = link[1].length + link[4].length * cosine;
    C.y = link[4].length * sine;
    f = flk_length(C.x, C.y);
    return flk_angle(C.y, C.x) + (double)branch * side * flk_kind_angle(b, a, f, a + b - f);
}

const flk_kind flk_four_bar = {
    FOURLINK_FOUR_BAR,
    "four-bar",
    "four-bar linkage",
    {NULL, "ground", "crank", "coupler", "rocker"},
    {FLK_NO_LENGTH, FLK_LENGTH, FLK_LENGTH, FLK_LENGTH, FLK_LENGTH},
    0,
    FOURLINK_CRANK_ROCKER,
    FOURLINK_CHANGE_POINT_LINKAGE,
    0,
    {
        {"A", 1, 2, 2, 0, 0},
        {"B", 2, 3, 3, 0, 0},
        {"C", 3, 4, 3, 1, 0},
        {"D", 1, 4, 4, 0, 0},
    },
    {0, 0, FOURLINK_SHAPE_BAR, FOURLINK_SHAPE_BAR, FOURLINK_SHAPE_BAR},
    {3, 4, 2},
    four_bar_prepare,
    four_bar_reach,
    four_bar_position,
    four_bar_velocity,
    four_bar_acceleration,
    four_bar_angles,
    four_bar_forces,
    four_bar_type,
    four_bar_ranges,
    four_bar_limits,
    four_bar_turns,
    four_bar_balance,
    four_bar_swing,
    four_bar_theta2_of,
};
