/* SPDX-License-Identifier: GPL-3.0-or-later
**
** slider_crank.c - the slider-crank.
**
** Links: crank r = AB, rod l = BC, piston at C on the line of stroke y = e.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/trig.h"
#include "balance.h"
#include "coordinate.h"
#include "kind.h"

/* The stroke S is the distance between the dead centres, where crank and rod are in line (two right
** triangles with the leg e):
**
**    S = sqrt((l + r)^2 - e^2) - sqrt((l - r)^2 - e^2),  r^2 = S^2/4 (4 l^2 - 4 e^2 - S^2) / (4 l^2 - S^2)
**
** which for e = 0 is r = S/2. The longest stroke has r = l - |e|, the longest crank that turns fully: S^2 =
** (l + r)^2 - e^2 = 4 l (l - |e|). A longer stroke would require the sum of the two roots. A yoke has no rod,
** and S = 2 a. */
double flk_slider_crank_of_stroke(double stroke, double rod, double offset)
{
    double S = stroke, l = rod, e = fabs(offset), rest = 4 * l * l - S * S;

    return e > 0 && S * S <= 4 * l * (l - e) ? S / 2 * sqrt((rest - 4 * e * e) / rest) : S / 2;
}

/* Reach.  The rod spans the height r sin(theta2) - e of the crank pin above the line of stroke.  With X the
** piston's coordinate along that line and w = X - r cos(theta2) = l cos(theta3),
**
**    w^2 = l^2 - (r sin(theta2) - e)^2 = u1 u2
**    u1 = l - (r sin(theta2) - e) = [l + e - r] + r (1 - sin(theta2))
**    u2 = l + (r sin(theta2) - e) = [l - e - r] + r (1 + sin(theta2))
**
** and 1 -+ sin(theta2) = (cos(theta2/2) -+ sin(theta2/2))^2.  Where a bracket, `stretched` or
** `folded`, is 0 the mechanism has a change point, at +90 deg or at -90 deg, and the root of u1 or u2 passes
** smoothly through 0 and changes sign there.
*/
static int slider_crank_prepare(fourlink_mechanism *mechanism)
{
    const fourlink_link *link = mechanism->design.link;
    double r = link[2].length, l = link[3].length, e = mechanism->design.offset;
    double stretched = l + e - r, folded = l - e - r;
    double reach2 = (r + l - e) * (r + l + e);
    /* u1 + u2 = 2 l: where one of them is 0, sine^2 = u1 u2 / l^2 is 2 / l times the other */
    double tolerance = 0.5 * FLK_DEAD * l + FLK_ROUNDING * (r + l + fabs(e));

    mechanism->change_stretched = fabs(stretched) <= tolerance;
    mechanism->change_folded = fabs(folded) <= tolerance;
    mechanism->stretched = mechanism->change_stretched ? 0 : stretched;
    mechanism->folded = mechanism->change_folded ? 0 : folded;
    mechanism->dead_centre = reach2 > 0 ? sqrt(reach2) : 0;
    return FOURLINK_OK;
}

static int slider_crank_reach(const fourlink_mechanism *mechanism, double half_sine,
                              double half_cosine, double *sine)
{
    const fourlink_link *link = mechanism->design.link;
    double r = link[2].length, l = link[3].length;
    double root1 = half_cosine - half_sine, root2 = half_cosine + half_sine;
    double u1 = mechanism->stretched + r * root1 * root1;
    double u2 = mechanism->folded + r * root2 * root2;
    double sine2 = (u1 / l) * (u2 / l);

    if (!(fabs((u1 + u2) / l - 2) < FLK_LOST))
        return FOURLINK_LOST_IN_ROUNDING;
    if (sine2 < -FLK_DEAD)
        return FOURLINK_ROD_TOO_SHORT;
    if (sine2 <= FLK_DEAD) {
        if ((mechanism->change_stretched && u1 < u2) || (mechanism->change_folded && u2 < u1))
            return FOURLINK_CHANGE_POINT;
        return FOURLINK_DEAD_POSITION;
    }
    *sine = sqrt(sine2);
    if (mechanism->change_stretched && root1 < 0)
        *sine = -*sine;
    if (mechanism->change_folded && root2 < 0)
        *sine = -*sine;
    return FOURLINK_OK;
}

/* Position (ME3491; DFA eq. 1 for e = 0):
**
**    sin(phi) = (r sin(theta2) - e) / l,   phi the obliquity of the rod
**    sin(theta3) = -sin(phi),  X = r cos(theta2) + l cos(theta3)
**    x = sqrt((r + l)^2 - e^2) -+ X,   the displacement from the inner dead centre (open, crossed)
*/
static void slider_crank_position(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double l = mechanism->design.link[3].length, e = mechanism->design.offset;
    fourlink_link_state *rod = &state->link[3], *piston = &state->link[4];

    rod->axis.x = state->sine;
    rod->axis.y = (e - rod->origin.y) / l;
    piston->axis.x = 1;
    piston->axis.y = 0;
    piston->origin.x = rod->origin.x + l * rod->axis.x;
    piston->origin.y = e;
    state->x = mechanism->dead_centre - (double)state->branch * piston->origin.x;
}

static void slider_crank_angles(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    const fourlink_link_state *rod = &state->link[3];

    (void)mechanism;
    state->phi = -rod->theta;
    if (rod->axis.x < 0)
        state->phi = rod->theta > 0 ? rod->theta - M_PI : rod->theta + M_PI;
    state->mu = M_PI_2 - fabs(state->phi);
}

/* Velocity, from the derivative of the loop A-B-C, here for unit crank speed:
**
**    k3 = -r cos(theta2) / (l cos(theta3)),   omega3 = k3 omega2
**    dX/dtheta2 = -r sin(theta2) - k3 l sin(theta3),   dX/dt = -+v
**
** With e = 0, open: omega3 = -dphi/dt, dphi/dt = omega2 cos(theta2) / sqrt(n^2 - sin^2(theta2)),
** n = l/r (ME3491).
*/
static void slider_crank_velocity(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    const fourlink_link_state *crank = &state->link[2];
    fourlink_link_state *rod = &state->link[3], *piston = &state->link[4];

    rod->k = -r * crank->axis.x / (l * rod->axis.x);
    rod->omega = rod->k * crank->omega;
    piston->k = 0;
    piston->omega = 0;
    piston->k_origin.x = -r * crank->axis.y - rod->k * l * rod->axis.y;
    piston->k_origin.y = 0;
    piston->velocity.x = piston->k_origin.x * crank->omega;
    piston->velocity.y = 0;
    state->v = -(double)state->branch * piston->velocity.x;
}

/* Acceleration, from the second derivative of the loop:
**
**    alpha3 = [-r alpha2 cos(theta2) + r omega2^2 sin(theta2) + l omega3^2 sin(theta3)]
**             / (l cos(theta3))
**    d2X/dt2 = -r alpha2 sin(theta2) - r omega2^2 cos(theta2)
**              - l alpha3 sin(theta3) - l omega3^2 cos(theta3),   d2X/dt2 = -+a
*/
static void slider_crank_acceleration(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    const fourlink_link_state *crank = &state->link[2];
    fourlink_link_state *rod = &state->link[3], *piston = &state->link[4];
    double r_t = r * crank->alpha, r_n = r * crank->omega * crank->omega;
    double l_n = l * rod->omega * rod->omega;

    rod->alpha =
        (-r_t * crank->axis.x + r_n * crank->axis.y + l_n * rod->axis.y) / (l * rod->axis.x);
    piston->alpha = 0;
    piston->acceleration.x = -r_t * crank->axis.y - r_n * crank->axis.x -
                             l * rod->alpha * rod->axis.y - l_n * rod->axis.x;
    piston->acceleration.y = 0;
    state->a = -(double)state->branch * piston->acceleration.x;
}

/* Forces in closed form.  Moments of the rod about B eliminate the force at that pin:
**
**    forces on the piston along the stroke   F34x = f4x
**    moments of the rod about B              F34y = [F34x sin(theta3) - M3 / l] / cos(theta3)
**    moments of the piston about C           M14 = M4
*/
static void slider_crank_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                                const flk_body body[3], double M3, double M4, fourlink_vector *F34,
                                fourlink_forces *forces)
{
    const fourlink_vector *e3 = &state->link[3].axis;

    F34->x = body[2].force.x;
    F34->y = (F34->x * e3->y - M3 / mechanism->design.link[3].length) / e3->x;
    forces->M14 = M4;
}

static int turns_fully(const fourlink_mechanism *mechanism)
{
    return mechanism->stretched > 0 && mechanism->folded > 0;
}

static fourlink_type slider_crank_type(const fourlink_mechanism *mechanism)
{
    if (mechanism->change_folded || mechanism->change_stretched)
        return FOURLINK_CHANGE_POINT_SLIDER;
    return turns_fully(mechanism) ? FOURLINK_ENGINE : FOURLINK_SLIDER_ROCKER;
}

/* u1 and u2 are positive where
**
**    sin(theta2) < 1 + stretched / r,   sin(theta2) > -1 - folded / r
*/
static void slider_crank_ranges(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    double r = mechanism->design.link[2].length;
    int high = mechanism->stretched < 0, low = mechanism->folded < 0;
    double highest = high ? flk_arc_sine(flk_kind_clamp(1 + mechanism->stretched / r)) : M_PI_2;
    double lowest = low ? flk_arc_sine(flk_kind_clamp(-1 - mechanism->folded / r)) : -M_PI_2;

    flk_kind_set_ranges(reach, low, lowest, high, highest, M_PI);
}

/* Crank and rod in one line, C at the distance r + l, or l - r with the crank pointing away from C.  `slow`
** is the crank angle of the slower stroke. */
static void stroke_of_piston(const fourlink_mechanism *mechanism, fourlink_branch branch,
                             fourlink_limits *limits)
{
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    double e = mechanism->design.offset, inner = flk_arc_sine(flk_kind_clamp(e / (l + r))),
           outer = M_PI + flk_arc_sine(flk_kind_clamp(e / (l - r))),
           slow = M_PI + fabs(outer - M_PI - inner), half_turn = M_PI;

    if (branch == FOURLINK_CROSSED) {
        inner = half_turn - inner;
        outer = half_turn - outer;
    }
    limits->has_stroke = 1;
    if (e != 0)
        limits->time_ratio = slow / (2 * M_PI - slow);
    limits->stroke = sqrt((l + r - e) * (l + r + e)) - sqrt((l - r - e) * (l - r + e));
    limits->inner = flk_cycle_place(inner, 0, 2 * M_PI);
    limits->outer = flk_cycle_place(outer, 0, 2 * M_PI);
}

static void slider_crank_limits(const fourlink_mechanism *mechanism, fourlink_branch branch,
                                fourlink_limits *limits)
{
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    double e = fabs(mechanism->design.offset);

    limits->mu_min = turns_fully(mechanism) ? flk_arc_cosine((r + e) / l) : 0;
    limits->mu_max = e <= r ? M_PI_2 : flk_arc_cosine(flk_kind_clamp((e - r) / l));
    if (turns_fully(mechanism))
        stroke_of_piston(mechanism, branch, limits);
}

/* The rod passes -90 deg at the stretched change point, and 90 deg at the folded one.  With both (l = r,
** e = 0) it turns against the crank, but with it on the crossed branch. */
static double slider_crank_turns(const fourlink_mechanism *mechanism, const fourlink_state *state,
                                 int link)
{
    const fourlink_vector *e3 = &state->link[3].axis;
    double theta2 = state->link[2].theta;

    if (link == FOURLINK_FOLLOWER)
        return 0;
    if (mechanism->change_stretched && mechanism->change_folded)
        return state->branch == FOURLINK_OPEN ? -theta2 : M_PI + theta2;
    if (mechanism->change_stretched)
        return flk_angle(e3->x, -e3->y) - M_PI_2;
    if (mechanism->change_folded)
        return M_PI_2 - flk_angle(e3->x, e3->y);
    return state->branch == FOURLINK_OPEN ? flk_angle(e3->y, e3->x)
                                          : M_PI + flk_angle(-e3->y, -e3->x);
}

/* Counterweights (balance.c), with r e^(i theta2) + l e^(i theta3) = X + i e:
**
**    sum m r = const + e^(i theta2) [m2 z2 + m3 r (1 - z3 / l)] + X [m4 + m3 z3 / l]
**
** The bracket of X is the reciprocating mass, of which the crank balances a fraction: X is r cos(theta2) plus
** smaller terms of twice the frequency.
*/
static void slider_crank_balance(const fourlink_mechanism *mechanism, double fraction,
                                 fourlink_balance *u)
{
    const fourlink_link *link = mechanism->design.link;
    double m = link[3].mass, r = link[2].length, l = link[3].length;
    const fourlink_vector *z = &link[3].cg;

    u->crank.x = -(link[2].mass * link[2].cg.x + m * r * (1 - z->x / l) +
                   fraction * flk_balance_reciprocating(&mechanism->design) * r);
    u->crank.y = -(link[2].mass * link[2].cg.y - m * r * z->y / l);
    u->rocker.x = u->rocker.y = 0;
}

/* A dead position, where the rod is perpendicular to the line of stroke.  The crank stands still, and C
** stays on its line:
**
**    dX/dt = -l omega3 sin(theta3),   r alpha2 cos(theta2) = l omega3^2 sin(theta3)
**    d2X/dt2 = -r alpha2 sin(theta2) - l alpha3 sin(theta3)
*/
static void slider_crank_swing(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    fourlink_link_state *crank = &state->link[2], *rod = &state->link[3], *piston = &state->link[4];
    double sense = -(double)state->branch;

    crank->alpha = l * rod->omega * rod->omega * rod->axis.y / (r * crank->axis.x);
    piston->k = piston->omega = piston->alpha = 0;
    piston->k_origin.x = -l * rod->axis.y;
    piston->velocity.x = piston->k_origin.x * rod->omega;
    piston->acceleration.x = -r * crank->alpha * crank->axis.y - l * rod->alpha * rod->axis.y;
    piston->k_origin.y = piston->velocity.y = piston->acceleration.y = 0;
    state->v = sense * piston->velocity.x;
    state->a = sense * piston->acceleration.x;
}

/* The crank from the piston.  With C = (X, e), f = AC and gamma the angle of the triangle at A,
**
**    theta2 = angle of AC -+ gamma, rod opposite:   X rises with - gamma on the open branch, + gamma on the
**                                                   crossed one, x with + gamma on both
**    r + l - f = x (2 x_dc - x) / (r + l + f),      which keeps the digits near the inner dead centre
*/
static double slider_crank_theta2_of(const fourlink_mechanism *mechanism, int coordinate,
                                     fourlink_branch branch, int side, double value)
{
    double r = mechanism->design.link[2].length, l = mechanism->design.link[3].length;
    double e = mechanism->design.offset, centre = mechanism->dead_centre;
    double X = coordinate == FLK_OF_PIN ? value : (double)branch * (centre - value);
    double f = flk_length(X, e), slack = r + l - f;
    double sense = coordinate == FLK_OF_PIN ? -(double)branch : 1;

    if (coordinate == FLK_OF_DISPLACEMENT && centre > 0)
        slack = value * (2 * centre - value) / (r + l + f);
    return flk_angle(e, X) + sense * side * flk_kind_angle(l, r, f, slack);
}

const flk_kind flk_slider_crank = {
    FOURLINK_SLIDER_CRANK,
    "slider-crank",
    "slider-crank",
    {NULL, "ground", "crank", "rod", "piston"},
    {FLK_NO_LENGTH, FLK_NO_LENGTH, FLK_LENGTH, FLK_LENGTH, FLK_NO_LENGTH},
    0,
    FOURLINK_ENGINE,
    FOURLINK_CHANGE_POINT_SLIDER,
    -M_PI_2,
    {
        {"A", 1, 2, 2, 0, 0},
        {"B", 2, 3, 3, 0, 0},
        {"C", 3, 4, 4, 0, 0},
        {"C", 1, 4, 4, 0, 4}, /* the guide */
    },
    {0, 0, FOURLINK_SHAPE_BAR, FOURLINK_SHAPE_BAR, FOURLINK_SHAPE_BLOCK},
    {3, 4, 2},
    slider_crank_prepare,
    slider_crank_reach,
    slider_crank_position,
    slider_crank_velocity,
    slider_crank_acceleration,
    slider_crank_angles,
    slider_crank_forces,
    slider_crank_type,
    slider_crank_ranges,
    slider_crank_limits,
    slider_crank_turns,
    slider_crank_balance,
    slider_crank_swing,
    slider_crank_theta2_of,
};
