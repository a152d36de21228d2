/* SPDX-License-Identifier: GPL-3.0-or-later
**
** klein.c - Klein's construction for a slider-crank, and the crank effort of the rod that follows from it.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "mechanics.h"

/* Klein's construction, point by point, O the origin, B the crank pin, P the piston, u = (P - B) / l:
**
**    M = B + m u with M_x = 0:           m = -B_x / u_x, so BM = |m|
**    circle about B, radius |m|, and circle on BP as diameter: their common chord is normal to BP
**    and cuts it at Q,                   BQ = m^2 / l
**    N on the chord with N_y = O_y = 0:  N = B + BQ u + t (-u_y, u_x)
**
** The triangle OBM is the velocity polygon turned by a right angle, with the scale omega2; the quadrangle
** OBQN is the acceleration polygon turned by two right angles, with the scale omega2^2.
*/
static void find_lengths(fourlink_vector B, fourlink_vector u, double l, double side,
                         fourlink_klein *klein)
{
    double m = -B.x / u.x, q = m * m / l, t = -(B.y + q * u.y) / u.x;

    klein->OM = side * (B.y + m * u.y);
    klein->BM = m;
    klein->BQ = q;
    klein->QN = -t;
    klein->ON = side * (B.x + q * u.x - t * u.y);
}

/* The crank effort of the rod alone (ME3491, example 2, "Graphical method"), from the moments about I, the
** instantaneous centre of the rod; of the forces at its pins only F_T has a moment about I:
**
**    F_T IC = F_C IY - W_C IX,   F_C = m omega2^2 gO,   W_C = m g
**
** IC, here IB, is r / |k3|.  k3 IG, turned left, is k_G, the velocity of G for unit crank speed; a_G, its
** acceleration at that speed, is gO turned by 180 deg:
**
**    F_C IY = [m a_G . k_G + I alpha3 k3] / |k3|,   W_C IX = m g . k_G / |k3|
*/
static void find_crank_effort(const fourlink_mechanism *mechanism, fourlink_vector B,
                              fourlink_vector u, double omega2, fourlink_klein *klein)
{
    const fourlink_link *rod = &mechanism->design.link[3];
    const fourlink_vector *g = &mechanism->design.gravity;
    double k3 = klein->BM / rod->length, kk3 = klein->QN / rod->length;
    double by_inertia, by_weight, F_C, W_C;
    fourlink_vector r, k_G, a_G;

    r.x = rod->cg.x * u.x - rod->cg.y * u.y;
    r.y = rod->cg.x * u.y + rod->cg.y * u.x;
    k_G.x = -B.y - k3 * r.y;
    k_G.y = B.x + k3 * r.x;
    a_G.x = -B.x - kk3 * r.y - k3 * k3 * r.x;
    a_G.y = -B.y + kk3 * r.x - k3 * k3 * r.y;
    F_C = rod->mass * flk_length(a_G.x, a_G.y);
    W_C = rod->mass * flk_length(g->x, g->y);
    by_inertia = rod->mass * FLK_DOT(a_G, k_G) + rod->inertia * kk3 * k3;
    by_weight = rod->mass * FLK_DOT(*g, k_G);
    klein->IX = fabs(k3) < 1e-12 || W_C <= 0 ? FLK_UNDEFINED : by_weight / (W_C * fabs(k3));
    klein->IY = fabs(k3) < 1e-12 || F_C <= 0 ? FLK_UNDEFINED : by_inertia / (F_C * fabs(k3));
    klein->FT = (omega2 * omega2 * by_inertia - by_weight) / mechanism->design.link[2].length;
}

int fourlink_klein_construction(const fourlink_mechanism *mechanism, const fourlink_state *state,
                                fourlink_klein *klein)
{
    const fourlink_link_state *rod;

    if (!mechanism || !state || !klein)
        return FOURLINK_NULL;
    if (mechanism->design.kind != FOURLINK_SLIDER_CRANK)
        return FOURLINK_NOT_AN_ENGINE;
    rod = &state->link[3];
    find_lengths(rod->origin, rod->axis, mechanism->design.link[3].length, (double)state->branch,
                 klein);
    find_crank_effort(mechanism, rod->origin, rod->axis, state->link[2].omega, klein);
    return FOURLINK_OK;
}
