/* SPDX-License-Identifier: GPL-3.0-or-later
**
** scotch_yoke.c - the Scotch yoke.
**
** Links: crank a = AB; block, pinned to the crank at B, which slides in the slot of the yoke; yoke, which
** slides along the guide y = e. C is the point where the slot's line meets the guide line. Only the crank
** turns.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "base/trig.h"
#include "coordinate.h"
#include "kind.h"

#define ROUNDED 1e-13 /* of the stroke */

/* With beta the angle of the slot, u = (cos(beta), sin(beta)) its direction, n = u turned left by 90 deg, s
** along the slot from C, X along the guide from A:
**
**    a e2 = (X, e) + s u
**    s = (a sin(theta2) - e) / sin(beta)
**    X = a cos(theta2) - s cos(beta) = a sin(beta - theta2) / sin(beta) + e cot(beta)
**
** Linear in s and X: there is one assembly mode, and no position that cannot be assembled. */
static int yoke_prepare(fourlink_mechanism *mechanism)
{
    const fourlink_design *design = &mechanism->design;
    double sine, cosine;

    flk_sine_cosine(design->angle, &sine, &cosine);
    if (fabs(design->angle - M_PI_2) <= FLK_ROUNDING) /* pi / 2 is not exactly 90 deg */
        cosine = 0;
    if (sine * sine <= FLK_DEAD)
        return FOURLINK_PARALLEL_SLOT;
    mechanism->slot.x = cosine;
    mechanism->slot.y = sine;
    mechanism->stretched = mechanism->folded = 0;
    mechanism->change_stretched = mechanism->change_folded = 0;
    mechanism->dead_centre = design->offset * cosine / sine + design->link[2].length / fabs(sine);
    return FOURLINK_OK;
}

static int yoke_reach(const fourlink_mechanism *mechanism, double half_sine, double half_cosine,
                      double *sine)
{
    (void)half_sine;
    (void)half_cosine;
    *sine = mechanism->slot.y;
    return FOURLINK_OK;
}

/* x = X_max - X, the displacement from the inner dead centre, as of a piston: a (1 - cos(theta2)) for a slot
** at 90 deg
*/
static void yoke_position(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double e = mechanism->design.offset;
    fourlink_link_state *block = &state->link[3], *yoke = &state->link[4];

    block->axis = mechanism->slot;
    state->s = state->slide = (block->origin.y - e) / block->axis.y;
    yoke->axis.x = 1;
    yoke->axis.y = 0;
    yoke->origin.x = block->origin.x - state->s * block->axis.x;
    yoke->origin.y = e;
    state->x = mechanism->dead_centre - yoke->origin.x;
}

/* The force of the block on the yoke is normal to the slot, the yoke moves along the guide. */
static void yoke_angles(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    (void)mechanism;
    state->mu = state->link[3].theta;
    if (state->mu < 0)
        state->mu += M_PI;
    if (state->mu > M_PI_2)
        state->mu = M_PI - state->mu;
}

/* Velocity, here for unit crank speed:
**
**    dX/dt = -a omega2 cos(beta - theta2) / sin(beta) = -v,   ds/dt = a omega2 cos(theta2) / sin(beta)
*/
static void yoke_velocity(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double a = mechanism->design.link[2].length;
    const fourlink_link_state *crank = &state->link[2];
    fourlink_link_state *block = &state->link[3], *yoke = &state->link[4];

    block->k = block->omega = yoke->k = yoke->omega = 0;
    yoke->k_origin.x = -a * FLK_DOT(crank->axis, block->axis) / state->sine;
    yoke->k_origin.y = 0;
    yoke->velocity.x = yoke->k_origin.x * crank->omega;
    yoke->velocity.y = 0;
    state->v = -yoke->velocity.x;
    state->slide_v = a * crank->omega * crank->axis.x / state->sine;
}

/* Acceleration:
**
**    d2X/dt2 = -a [alpha2 cos(beta - theta2) + omega2^2 sin(beta - theta2)] / sin(beta)
**    d2s/dt2 = a [alpha2 cos(theta2) - omega2^2 sin(theta2)] / sin(beta)
*/
static void yoke_acceleration(const fourlink_mechanism *mechanism, fourlink_state *state)
{
    double a = mechanism->design.link[2].length;
    const fourlink_link_state *crank = &state->link[2];
    fourlink_link_state *block = &state->link[3], *yoke = &state->link[4];
    double a_t = a * crank->alpha, a_n = a * crank->omega * crank->omega;

    block->alpha = yoke->alpha = 0;
    yoke->acceleration.x =
        -(a_t * FLK_DOT(crank->axis, block->axis) + a_n * FLK_CROSS(crank->axis, block->axis)) /
        state->sine;
    yoke->acceleration.y = 0;
    state->a = -yoke->acceleration.x;
    state->slide_a = (a_t * crank->axis.x - a_n * crank->axis.y) / state->sine;
}

/* Forces in closed form.  The guide has no force along x; N34 acts at B, which has the arm s u from C:
**
**    forces on the yoke along x       N34 = -f4x / sin(beta)
**    moments of the block about B     M34 = -M3
**    moments of the yoke about C      M14 = M4 - M34 - s N34,   for (B - C) x n = s
*/
static void yoke_forces(const fourlink_mechanism *mechanism, const fourlink_state *state,
                        const flk_body body[3], double M3, double M4, fourlink_vector *F34,
                        fourlink_forces *forces)
{
    (void)mechanism;
    F34->x = body[2].force.x;
    forces->N34 = 0 - F34->x / state->sine;
    F34->y = forces->N34 * state->link[3].axis.x;
    forces->M34 = 0 - M3;
    forces->M14 = M4 + M3 - state->s * forces->N34;
}

static fourlink_type yoke_type(const fourlink_mechanism *mechanism)
{
    (void)mechanism;
    return FOURLINK_YOKE;
}

static void yoke_ranges(const fourlink_mechanism *mechanism, fourlink_reach *reach)
{
    (void)mechanism;
    flk_kind_set_ranges(reach, 0, 0, 0, M_PI, 2 * M_PI);
}

/* The yoke stands still where the crank is at right angles to the slot; the slot is as long as the block's
** way in it.
*/
static void yoke_limits(const fourlink_mechanism *mechanism, fourlink_branch branch,
                        fourlink_limits *limits)
{
    double a = mechanism->design.link[2].length, e = mechanism->design.offset;
    const fourlink_vector *u = &mechanism->slot;
    double beta = flk_angle(u->y, u->x), inner = beta - (u->y > 0 ? M_PI_2 : -M_PI_2);
    double one = (-a - e) / u->y, other = (a - e) / u->y;

    (void)branch;
    limits->mu_min = limits->mu_max = flk_angle(fabs(u->y), fabs(u->x));
    limits->has_stroke = 1;
    limits->stroke = 2 * a / fabs(u->y);
    limits->inner = flk_cycle_place(inner, 0, 2 * M_PI);
    limits->outer = flk_cycle_place(inner + M_PI, 0, 2 * M_PI);
    limits->has_slide = 1;
    limits->slide_min = one < other ? one : other;
    limits->slide_max = one < other ? other : one;
}

static double yoke_turns(const fourlink_mechanism *mechanism, const fourlink_state *state, int link)
{
    (void)state;
    return link == FOURLINK_COUPLER ? flk_angle(mechanism->slot.y, mechanism->slot.x) : 0;
}

/* Counterweights (balance.c), of a fraction of the yoke's mass, whose X is a pure sine turned by 90 deg -
** beta:
**
**    sum m r = const + e^(i theta2) [m2 z2 + m3 a] + X m4
**    X = const + Re[a e^(i theta2) e^(i (90 deg - beta)) / sin(beta)]
*/
static void yoke_balance(const fourlink_mechanism *mechanism, double fraction, fourlink_balance *u)
{
    const fourlink_link *link = mechanism->design.link;
    double a = link[2].length, share = fraction * link[4].mass * a;

    u->crank.x = -(link[2].mass * link[2].cg.x + link[3].mass * a + share);
    u->crank.y = -(link[2].mass * link[2].cg.y + share * mechanism->slot.x / mechanism->slot.y);
    u->rocker.x = u->rocker.y = 0;
}

/* The crank from the yoke.  With beta the angle of the slot and w = (X - e cot(beta)) sin(beta) / a,
**
**    sin(beta - theta2) = w,   theta2 = beta - asin(w), where X falls if sin(beta) > 0, or
**                              beta + 180 deg + asin(w)
**    |w| = 1 - 2 u,            u = x |sin(beta)| / 2a, which keeps the digits near the inner dead centre
**    asin |w| = 90 deg - 2 asin(sqrt(u))
*/
static double yoke_theta2_of(const fourlink_mechanism *mechanism, int coordinate,
                             fourlink_branch branch, int side, double value)
{
    double sine = mechanism->slot.y, beta = flk_angle(sine, mechanism->slot.x);
    double x = coordinate == FLK_OF_PIN ? mechanism->dead_centre - value : value;
    double u = x * fabs(sine) / (2 * mechanism->design.link[2].length), arc;

    (void)branch;
    if (!(u >= -ROUNDED && u <= 1 + ROUNDED))
        return FLK_UNDEFINED;
    arc = M_PI_2 - 2 * flk_angle(sqrt(GSL_MAX(u, 0)), sqrt(GSL_MAX(1 - u, 0)));
    arc = sine > 0 ? arc : -arc;
    if (coordinate == FLK_OF_DISPLACEMENT)
        side = -side; /* x falls where X rises */
    return (side > 0) == (sine > 0) ? beta + M_PI + arc : beta - arc;
}

const flk_kind flk_scotch_yoke = {
    FOURLINK_SCOTCH_YOKE,
    "scotch-yoke",
    "Scotch yoke",
    {NULL, "ground", "crank", "slider", "yoke"},
    {FLK_NO_LENGTH, FLK_NO_LENGTH, FLK_LENGTH, FLK_NO_LENGTH, FLK_NO_LENGTH},
    1,
    FOURLINK_YOKE,
    FOURLINK_YOKE,
    0,
    {
        {"A", 1, 2, 2, 0, 0},
        {"B", 2, 3, 3, 0, 0},
        {"B", 3, 4, 3, 0, 3}, /* the slot */
        {"C", 1, 4, 4, 0, 4}, /* the guide */
    },
    {0, 0, FOURLINK_SHAPE_BAR, FOURLINK_SHAPE_BLOCK, FOURLINK_SHAPE_YOKE},
    {4, 3, 2},
    yoke_prepare,
    yoke_reach,
    yoke_position,
    yoke_velocity,
    yoke_acceleration,
    yoke_angles,
    yoke_forces,
    yoke_type,
    yoke_ranges,
    yoke_limits,
    yoke_turns,
    yoke_balance,
    NULL,
    yoke_theta2_of,
};
