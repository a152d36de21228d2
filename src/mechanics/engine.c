/* SPDX-License-Identifier: GPL-3.0-or-later
**
** engine.c - textbook methods for a slider-crank: the series, the two masses of the rod, the analytical
** engine method.
*/
#include <float.h>
#include <math.h>

#include <gsl/gsl_math.h>

#include "mechanics.h"

/* The series (DFA eqs. 1 to 4, and the rod's), with n = l/r and the crank angle theta counted from the
** inner dead centre, which on the crossed branch is at 180 deg:
**
**    x = r (1 - cos(theta) + sin^2(theta) / 2n)
**    v = r omega (sin(theta) + sin(2 theta) / 2n)
**    a = r omega^2 (cos(theta) + cos(2 theta) / n) + r alpha (sin(theta) + sin(2 theta) / 2n)
**    dphi/dt = omega cos(theta) / n,   d2phi/dt2 = -omega^2 sin(theta) / n + alpha cos(theta) / n
**
** The terms with alpha, the acceleration of the crank, follow from differentiating the series; the sources
** assume constant speed.  For an infinitely long rod (simple harmonic motion) the terms with n vanish.  The
** rod's angle is theta3 = -phi.
*/
int fourlink_textbook_series(const fourlink_mechanism *mechanism, const fourlink_state *state,
                             fourlink_series *series)
{
    const fourlink_link_state *crank;
    double r, n, s, c, s2, c2, w, al;

    if (!mechanism || !state || !series)
        return FOURLINK_NULL;
    if (mechanism->design.kind != FOURLINK_SLIDER_CRANK)
        return FOURLINK_NOT_AN_ENGINE;
    if (mechanism->design.offset != 0)
        return FOURLINK_NO_SERIES;
    crank = &state->link[2];
    r = mechanism->design.link[2].length;
    n = mechanism->design.link[3].length / r;
    s = (double)state->branch * crank->axis.y;
    c = (double)state->branch * crank->axis.x;
    s2 = 2 * s * c;
    c2 = (c - s) * (c + s);
    w = crank->omega;
    al = crank->alpha;
    series->x = r * (1 - c + s * s / (2 * n));
    series->v = r * w * (s + s2 / (2 * n));
    series->a = r * w * w * (c + c2 / n) + r * al * (s + s2 / (2 * n));
    series->omega3 = -w * c / n;
    series->alpha3 = w * w * s / n - al * c / n;
    series->x_harmonic = r * (1 - c);
    series->v_harmonic = r * w * s;
    series->a_harmonic = r * w * w * c + r * al * s;
    return FOURLINK_OK;
}

/* The rod as two masses, b the distance from the gudgeon pin to G (ME3491; DFA, with its misprint l1 l2
** corrected):
**
**    m_a = m b / l at the crank pin,  m_b = m (l - b) / l at the gudgeon pin
**
** have the mass and centre of mass of the rod, but their radius of gyration k1, k1^2 = b (l - b) (DFA: l1
** l3), is too large.  The dynamically equivalent pair (ME3491):
**
**    m_g = m d / (b + d) at the gudgeon pin,  m_d = m b / (b + d) at d beyond G,  d = k^2 / b
*/
static int find_masses(const fourlink_mechanism *mechanism, fourlink_rod *rod)
{
    const fourlink_link *link = &mechanism->design.link[3];
    double m = link->mass, l = link->length;

    if (mechanism->design.kind != FOURLINK_SLIDER_CRANK)
        return FOURLINK_NOT_AN_ENGINE;
    if (m > 0 && fabs(link->cg.y) > 1e-12 * l)
        return FOURLINK_ROD_OFF_LINE;
    rod->n = l / mechanism->design.link[2].length;
    rod->k = m > 0 ? sqrt(link->inertia / m) : 0;
    rod->b = m > 0 && fabs(l - link->cg.x) > 1e-12 * l ? l - link->cg.x : 0;
    rod->m_a = m * rod->b / l;
    rod->m_b = m - rod->m_a;
    rod->d = rod->b != 0 ? rod->k * rod->k / rod->b : 0;
    rod->L = rod->b != 0 ? rod->b + rod->d : 0;
    rod->m_d = rod->L != 0 ? m * rod->b / rod->L : 0;
    rod->m_g = rod->L != 0 ? m * rod->d / rod->L : 0;
    rod->k1 = rod->b * (l - rod->b) > 0 ? sqrt(rod->b * (l - rod->b)) : 0;
    return FOURLINK_OK;
}

int fourlink_rod_masses(const fourlink_mechanism *mechanism, fourlink_rod *rod)
{
    fourlink_rod found;
    int status;

    if (!mechanism || !rod)
        return FOURLINK_NULL;
    status = find_masses(mechanism, &found);
    if (status != FOURLINK_OK)
        return status;
    if (!FLK_WITHIN(found.k, DBL_MAX) || !FLK_WITHIN(found.L, DBL_MAX) ||
        !FLK_WITHIN(found.m_g, DBL_MAX))
        return FOURLINK_BAD_NUMBER; /* almost no mass, but an inertia */
    *rod = found;
    return FOURLINK_OK;
}

/* The engine method (DFA; ME3491).  With F the piston effort towards the crank, the crank angle counted from
** the inner dead centre, and no offset,
**
**    F = p1 A1 - p2 A2 - (m_p + m_b) a  +- weight of m_p + m_b along the stroke
**    rod force F / cos(phi),  side thrust F tan(phi)
**    crank effort F sin(theta + phi) / cos(phi),  radial force F cos(theta + phi) / cos(phi)
**    correction couple dT = m b (l - L) phi'' = F_y l cos(phi),  L = b + k^2 / b
**    T_piston = crank effort r = F r [sin(theta) + sin(2 theta) / 2 sqrt(n^2 - sin^2(theta))]
**    T_correction = F_y r cos(theta) = dT cos(theta) / sqrt(n^2 - sin^2(theta)) = dT dphi/dtheta
**    T_weight_a = -+ m_a g r cos(theta),   T_inertia_a = -m_a r^2 alpha
**    T_weight_b = +- m_b g r [sin(theta) + sin(2 theta) / 2 sqrt(n^2 - sin^2(theta))], in T_piston
**
** In general (with offset or inclination; the crossed branch turned by 180 deg) theta + phi is
** theta2 - theta3, phi'' is -alpha3, dphi/dtheta is -k3, and cos(phi) is cos(theta3), or -cos(theta3) on the
** crossed branch.  The weight of m_a does work along the path of the crank pin.
** m b (l - L) is written as m b (l - b) - I, which needs no division by b.
*/
int fourlink_engine_method(const fourlink_mechanism *mechanism, const fourlink_state *state,
                           double gas_force, const fourlink_load *loads, unsigned long n_loads,
                           fourlink_approximation approximation, fourlink_engine *engine)
{
    const fourlink_link_state *crank, *link3;
    const fourlink_vector *gravity;
    double side, reciprocating, a, alpha3, r, F, cos_phi, excess;
    fourlink_rod rod;
    fourlink_series series;
    unsigned long i;
    int status;

    if (!mechanism || !state || !engine)
        return FOURLINK_NULL;
    if (!FLK_WITHIN(gas_force, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    if (approximation != FOURLINK_EXACT && approximation != FOURLINK_SERIES_PISTON &&
        approximation != FOURLINK_SERIES_ALL)
        return FOURLINK_BAD_APPROXIMATION;
    status = find_masses(mechanism, &rod);
    if (status == FOURLINK_OK)
        status = flk_check_loads(mechanism, loads, n_loads);
    if (status != FOURLINK_OK)
        return status;
    crank = &state->link[2];
    link3 = &state->link[3];
    a = state->a;
    alpha3 = link3->alpha;
    if (approximation != FOURLINK_EXACT) {
        status = fourlink_textbook_series(mechanism, state, &series);
        if (status != FOURLINK_OK)
            return status;
        a = series.a;
        if (approximation == FOURLINK_SERIES_ALL)
            alpha3 = series.alpha3;
    }
    gravity = &mechanism->design.gravity;
    side = (double)state->branch; /* the piston is at +x or -x: towards the crank is -side */
    r = mechanism->design.link[2].length;
    reciprocating = mechanism->design.link[4].mass + rod.m_b;
    cos_phi = side * link3->axis.x; /* negative past a change point */

    engine->gas_force = gas_force;
    engine->inertia_force = -reciprocating * a;
    F = gas_force + engine->inertia_force - side * reciprocating * gravity->x;
    for (i = 0; i < n_loads; i++)
        if (loads[i].link == FOURLINK_FOLLOWER)
            F -= side * loads[i].force.x;
    engine->piston_effort = F;
    engine->rod_force = F / cos_phi;
    engine->side_thrust = -F * link3->axis.y / cos_phi;
    engine->crank_effort = -F * FLK_CROSS(crank->axis, link3->axis) / cos_phi;
    engine->radial_force = F * FLK_DOT(crank->axis, link3->axis) / cos_phi;
    excess = mechanism->design.link[3].mass * rod.b * (mechanism->design.link[3].length - rod.b) -
             mechanism->design.link[3].inertia;
    engine->correction_couple = -excess * alpha3;
    engine->T_piston = engine->crank_effort * r;
    engine->T_correction = -engine->correction_couple * link3->k;
    engine->T_weight_a = rod.m_a * FLK_DOT(*gravity, link3->k_origin);
    engine->correction_force =
        side * engine->correction_couple / (mechanism->design.link[3].length * cos_phi);
    engine->T_weight_b = rod.m_b * FLK_DOT(*gravity, state->link[4].k_origin);
    engine->T_inertia_a = -rod.m_a * r * r * crank->alpha;
    engine->T_engine =
        engine->T_piston + engine->T_correction + engine->T_weight_a + engine->T_inertia_a;
    return FOURLINK_OK;
}
