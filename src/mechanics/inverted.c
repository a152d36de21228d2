/* SPDX-License-Identifier: GPL-3.0-or-later
**
** inverted.c - the inverted slider-crank: crank and slotted lever, Whitworth's quick return, the oscillating
** cylinder.
**
** Links: crank a = AB, ground d = AD; the slider, pinned to the crank at B, slides along a line of the lever,
** which turns about D.  Slider and lever turn together.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "coordinate.h"
#include "kind.h"
#include "turns.h"

/* Only the signed distance h of the lever's line from D matters.  With u = (cos(theta3), sin(theta3)) the
** direction of the slide, n = u turned left by 90 deg, s along the slide from the foot of the perpendicular
** from D:
**
**    r = B - D = s u + h n,   h = offset - c sin(gamma)
**    theta4 = theta3 - gamma,  slide = s - c cos(gamma)
**
** c = DC is the length of the lever and gamma the angle of the slide from it; both are 0 if the slide is
** along the x axis of the lever.
**
** Reach.  With f = BD,
**
**    f^2 = (a - d)^2 + 4 a d sin^2(theta2/2)
**    s^2 = f^2 - h^2 = [(a - d)^2 - h^2] + 4 a d sin^2(theta2/2)
**
** Where the bracket, `folded`, is 0 the mechanism has a change point, at 0 deg, and the root of s^2 passes
** smoothly through 0 and changes sign there.
*/
static int inverted_prepare(fourlink_mechanism *mechanism)
{
    const fourlink_design *design = &mechanism->design;
    double a = design->link[2].length, d = design->link[1].length, c = design->link[4].length;
    double sine, cosine, h, slack, folded;

    flk_sine_cosine(c > 0 ? design->angle : 0, &sine, &cosine);
    h = design->offset - c * sine;
    slack = fabs(a - d) - fabs(h);
    folded = slack * (fabs(a - d) + fabs(h));
    mechanism->h = h;
    mechanism->lever.x = cosine;
    mechanism->lever.y = -sine;
    mechanism->stretched = 0;
    mechanism->change_stretched = 0;
    mechanism->change_folded = fabs(folded) <= FLK_DEAD * h * h ||
                               fabs(slack) <= FLK_ROUNDING * (a + d + c + fabs(design->offset));
    mechanism->folded = mechanism->change_folded ? 0 : folded;
    return FOURLINK_OK;
}

static int inverted_reach(const fourlink_mechanism *mechanism, double half_sine, double half_cosine,
                          double *sine)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, d = link[1].length, h = mechanism->h;
    double s2 = mechanism->folded + 4 * a * d * half_sine * half_sine;
    double f2 = s2 + h * h, sine2 = s2 / f2;

    (void)half_cosine;
    if (mechanism->change_folded && half_sine * half_sine <= FLK_DEAD)
        return FOURLINK_CHANGE_POINT;
    if (sine2 < -FLK_DEAD)
        return FOURLINK_TOO_NEAR;
    if (!(sine2 > FLK_DEAD))
        return mechanism->change_folded ? FOURLINK_CHANGE_POINT : FOURLINK_DEAD_POSITION;
    *sine = sqrt(sine2);
    if (mechanism->change_folded && half_sine < 0)
        *sine = -*sine;
    return FOURLINK_OK;
}

/* B - D.  Where A, B and D are nearly in line, 1 - cos(theta2) = sin^2(theta2) / (1 + cos(theta2)) keeps the
** digits of a - d. */
static fourlink_vector from_D(const fourlink_mechanism *mechanism, const fourlink_vector *crank)
{
    double a = mechanism->design.link[2].length, d = mechanism->design.link[1].length;
    fourlink_vector r;

    r.x = crank->x > 0 ? (a - d) - a * crank->y * crank->y / (1 + crank->x) : a * crank->x - d;
    r.y = a * crank->y;
    return r;
}

/* Position:
**
**    u = (s r - h J r) / f^2,   J turns a vector left by 90 deg
*/
static void inverted_position(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    const fourlink_link *link = mechanism->design.link;
    fourlink_link_state *slider = &state->link[3], *lever = &state->link[4];
    fourlink_vector r = from_D(mechanism, &state->link[2].axis);
    double f = sqrt(FLK_DOT(r, r)), p = 1 / f;
    double along = p * state->sine, across = p * (p * mechanism->h);

    slider->axis.x = along * r.x + across * r.y;
    slider->axis.y = along * r.y - across * r.x;
    FLK_TURN(lever->axis, slider, mechanism->lever);
    lever->origin.x = link[1].length;
    lever->origin.y = 0;
    state->s = state->sine * f;
    state->slide = state->s - link[4].length * mechanism->lever.x;
}

static void inverted_angles(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    state->mu = mechanism->h == 0 ? M_PI_2 : flk_angle(fabs(state->s), fabs(mechanism->h));
}

/* Velocity, with beta = theta3 - theta2, here for unit crank speed:
**
**    k3 = k4 = a cos(beta) / s,   omega3 = omega4 = k4 omega2
**    ds/dt = a omega2 sin(beta) + h omega4
**
** The Coriolis acceleration of B relative to the lever, 2 omega4 ds/dt, is along n.
*/
static void inverted_velocity(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    double a = mechanism->design.link[2].length;
    const fourlink_link_state *crank = &state->link[2];
    fourlink_link_state *slider = &state->link[3], *lever = &state->link[4];

    slider->k = lever->k = a * FLK_DOT(crank->axis, slider->axis) / state->s;
    slider->omega = lever->omega = lever->k * crank->omega;
    lever->k_origin = zero;
    lever->velocity = zero;
    state->slide_v =
        a * crank->omega * FLK_CROSS(crank->axis, slider->axis) + mechanism->h * lever->omega;
    state->coriolis = 2 * lever->omega * state->slide_v;
}

/* Acceleration:
**
**    alpha3 = alpha4 = [a alpha2 cos(beta) + a omega2^2 sin(beta) - 2 ds/dt omega4 + h omega4^2] / s
**    d2s/dt2 = a alpha2 sin(beta) - a omega2^2 cos(beta) + h alpha4 + s omega4^2
*/
static void inverted_acceleration(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    double a = mechanism->design.link[2].length, h = mechanism->h;
    const fourlink_link_state *crank = &state->link[2];
    fourlink_link_state *slider = &state->link[3], *lever = &state->link[4];
    double cosine = FLK_DOT(crank->axis, slider->axis);
    double sine = FLK_CROSS(crank->axis, slider->axis);
    double a_t = a * crank->alpha, a_n = a * crank->omega * crank->omega;
    double n = lever->omega * lever->omega;

    lever->alpha = (a_t * cosine + a_n * sine - state->coriolis + h * n) / state->s;
    slider->alpha = lever->alpha;
    lever->acceleration = zero;
    state->slide_a = a_t * sine - a_n * cosine + h * lever->alpha + state->s * n;
}

/* Forces in closed form.  N34 acts at B, so it drops out of the moments of the slider about B:
**
**    moments of the slider about B    M34 = -M3
**    moments of the lever about D     N34 s + M34 = M4,   for (B - D) x n = s
*/
static void inverted_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                            const flk_body body[3], double M3, double M4, fourlink_vector *F34,
                            fourlink_forces *forces)
{
    const fourlink_vector *u = &state->link[3].axis;

    (void)mechanism;
    (void)body;
    forces->M34 = -M3;
    forces->N34 = (M4 + M3) / state->s;
    F34->x = -forces->N34 * u->y;
    F34->y = forces->N34 * u->x;
}

static fourlink_type inverted_type(const fourlink_mechanism *mechanism)
{
    const fourlink_link *link = mechanism->design.link;

    if (mechanism->change_folded)
        return FOURLINK_CHANGE_POINT_INVERTED;
    if (mechanism->folded < 0)
        return FOURLINK_INVERTED_ROCKER;
    return link[2].length < link[1].length ? FOURLINK_SLOTTED_LEVER : FOURLINK_WHITWORTH;
}

/* s^2 is positive where sin^2(theta2/2) > -folded / 4ad */
static void inverted_ranges(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    const fourlink_link *link = mechanism->design.link;
    double ad4 = 4 * link[2].length * link[1].length;
    int near = mechanism->folded < 0;
    double nearest = near ? 2 * flk_arc_sine(flk_kind_clamp(sqrt(-mechanism->folded / ad4))) : 0;

    flk_kind_set_ranges(reach, near, nearest, 0, M_PI, 2 * M_PI);
}

/* The lever stands still where the crank is at right angles to the slide, d sin(theta3) = h +- a.  With
** phi1 = asin((a + h) / d) and phi2 = asin((a - h) / d):
**
**    open       theta3 from 180 deg - phi1 to 180 deg + phi2, at theta2 = 90 deg - phi1 and 270 deg + phi2
**    crossed    theta3 from -phi2 to phi1, at theta2 = 90 deg - phi2 and 270 deg + phi1
**    swing = phi1 + phi2,   time ratio = (180 deg + swing) / (180 deg - swing)
*/
static void swing_of_lever(const fourlink_mechanism *mechanism, fourlink_branch branch,
                           fourlink_limits *limits)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, d = link[1].length, h = mechanism->h;
    double phi1 = flk_arc_sine(flk_kind_clamp((a + h) / d)),
           phi2 = flk_arc_sine(flk_kind_clamp((a - h) / d));
    double swing = phi1 + phi2, gamma = flk_angle(-mechanism->lever.y, mechanism->lever.x);
    int is_open = branch == FOURLINK_OPEN;

    limits->has_swing = 1;
    limits->theta4_min = (is_open ? M_PI - phi1 : -phi2) - gamma;
    if (limits->theta4_min > M_PI)
        limits->theta4_min -= 2 * M_PI;
    else if (limits->theta4_min <= -M_PI)
        limits->theta4_min += 2 * M_PI;
    limits->theta4_max = limits->theta4_min + swing;
    limits->theta2_min = M_PI_2 - (is_open ? phi1 : phi2);
    limits->theta2_max = 3 * M_PI_2 + (is_open ? phi2 : phi1);
    limits->time_ratio = (M_PI + swing) / (M_PI - swing);
}

/* For a lever that turns fully, the time ratio is that of a tool whose line of stroke passes through D at
** right angles to AD, and which reverses where theta3 = +-90 deg (h = 0: cos(sigma / 2) = d / a):
**
**    sigma = acos((d - h) / a) + acos((d + h) / a),   time ratio = (360 deg - sigma) / sigma
*/
static void inverted_limits(const fourlink_mechanism *mechanism, fourlink_branch branch,
                            fourlink_limits *limits)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, d = link[1].length, h = mechanism->h, sigma;
    int turns_fully = mechanism->folded > 0;
    fourlink_type type = inverted_type(mechanism);

    limits->mu_max = flk_arc_cosine(flk_kind_clamp(fabs(h) / (a + d)));
    limits->mu_min = h == 0        ? M_PI_2
                     : turns_fully ? flk_arc_cosine(flk_kind_clamp(fabs(h) / fabs(a - d)))
                                   : 0;
    if (type == FOURLINK_SLOTTED_LEVER) {
        swing_of_lever(mechanism, branch, limits);
    } else if (type == FOURLINK_WHITWORTH) {
        sigma = flk_arc_cosine(flk_kind_clamp((d - h) / a)) +
                flk_arc_cosine(flk_kind_clamp((d + h) / a));
        if (sigma > M_PI) /* by rounding, if D is at A */
            sigma = M_PI;
        limits->time_ratio = (2 * M_PI - sigma) / sigma;
    }
}

/* The slide: B - D = s u + h n */
static double angle_of_slide(const fourlink_mechanism *mechanism, const fourlink_state *state)
{
    double r, line = flk_turns_of_B(mechanism, state, &r);

    if (mechanism->change_folded && mechanism->h == 0)
        return state->branch == FOURLINK_OPEN ? line : line - M_PI;
    return line - flk_angle(mechanism->h, state->s);
}

static double inverted_turns(const fourlink_mechanism *mechanism, const fourlink_state *state,
                             int link)
{
    return angle_of_slide(mechanism, state) +
           (link == FOURLINK_COUPLER ? 0 : flk_angle(mechanism->lever.y, mechanism->lever.x));
}

/* Counterweights (balance.c), link 3 at the angle gamma to link 4:
**
**    sum m r = const + e^(i theta2) [m2 z2 + m3 a] + e^(i theta4) [m4 z4 + m3 z3 e^(i gamma)]
**
** The lever's axis in the slider's axes is e^(-i gamma). */
static void inverted_balance(const fourlink_mechanism *mechanism, double fraction,
                             fourlink_balance *u)
{
    const fourlink_link *link = mechanism->design.link;
    const fourlink_vector *z = &link[3].cg, *lever = &mechanism->lever;

    (void)fraction;
    u->crank.x = -(link[2].mass * link[2].cg.x + link[3].mass * link[2].length);
    u->crank.y = -link[2].mass * link[2].cg.y;
    u->rocker.x = -(link[4].mass * link[4].cg.x + link[3].mass * FLK_DOT(*lever, *z));
    u->rocker.y = -(link[4].mass * link[4].cg.y + link[3].mass * FLK_CROSS(*lever, *z));
}

/* A dead position, where B is at the foot of the perpendicular from D, s = 0.  The crank stands still; from
** the second derivative of B - D = s u + h n, with beta = theta3 - theta2,
**
**    ds/dt = h omega4,   a alpha2 cos(beta) = h omega4^2,   d2s/dt2 = a alpha2 sin(beta) + h alpha4
*/
static void inverted_swing(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    static const fourlink_vector zero = {0, 0};
    double a = mechanism->design.link[2].length, h = mechanism->h;
    fourlink_link_state *crank = &state->link[2], *lever = &state->link[4];
    const fourlink_link_state *slider = &state->link[3];

    lever->k = 1;
    lever->omega = slider->omega;
    lever->alpha = slider->alpha;
    crank->alpha = h * lever->omega * lever->omega / (a * FLK_DOT(crank->axis, slider->axis));
    lever->k_origin = lever->velocity = lever->acceleration = zero;
    state->slide_v = h * lever->omega;
    state->slide_a = a * crank->alpha * FLK_CROSS(crank->axis, slider->axis) + h * lever->alpha;
    state->coriolis = 2 * lever->omega * state->slide_v;
}

/* The crank from the slide, or from the lever:
**
**    s      theta2 = +-gamma, in the triangle ABD at A, with f^2 = s^2 + h^2; s rises with + gamma where s > 0
**    theta4 sin(theta2 - theta3) = (h - d sin(theta3)) / a; theta3 rises where cos(theta2 - theta3) has the
**           sign of s
*/
static double inverted_theta2_of(const fourlink_mechanism *mechanism, int coordinate,
                                 fourlink_branch branch, int side, double value)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, d = link[1].length, h = mechanism->h;
    double s = value + link[4].length * mechanism->lever.x, theta3, sine, f;

    if (coordinate == FLK_OF_SLIDE) {
        f = flk_length(s, h);
        if ((s > 0) != (branch == FOURLINK_OPEN))
            return FLK_UNDEFINED;
        return (double)branch * side * flk_kind_angle(f, a, d, f + a - d);
    }
    theta3 = value + flk_angle(-mechanism->lever.y, mechanism->lever.x);
    sine = flk_arc_sine((h - d * flk_sine(theta3)) / a);
    return (double)branch * side > 0 ? theta3 + sine : theta3 + M_PI - sine;
}

const flk_kind flk_inverted = {
    FOURLINK_INVERTED_SLIDER_CRANK,
    "inverted-slider-crank",
    "inverted slider-crank",
    {NULL, "ground", "crank", "slider", "lever"},
    {FLK_NO_LENGTH, FLK_LENGTH, FLK_LENGTH, FLK_NO_LENGTH, FLK_LENGTH_OR_NONE},
    0,
    FOURLINK_SLOTTED_LEVER,
    FOURLINK_CHANGE_POINT_INVERTED,
    0,
    {
        {"A", 1, 2, 2, 0, 0},
        {"B", 2, 3, 3, 0, 0},
        {"B", 3, 4, 3, 0, 3}, /* the slide */
        {"D", 1, 4, 4, 0, 0},
    },
    {0, 0, FOURLINK_SHAPE_BAR, FOURLINK_SHAPE_BLOCK, FOURLINK_SHAPE_LEVER},
    {4, 3, 2},
    inverted_prepare,
    inverted_reach,
    inverted_position,
    inverted_velocity,
    inverted_acceleration,
    inverted_angles,
    inverted_forces,
    inverted_type,
    inverted_ranges,
    inverted_limits,
    inverted_turns,
    inverted_balance,
    inverted_swing,
    inverted_theta2_of,
};
