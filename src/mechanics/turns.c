/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turns.c - link angles that are continuous in the crank angle and count full turns.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "kind.h"
#include "turns.h"

/* The line from D to B, of the signed length r, is smooth in theta2.  With t = theta2,
**
**    B - D = a e^(i t) - d   a < d   -d (1 - (a/d) e^(i t))           angle pi + arg(...)
**                            a > d   a e^(i t) (1 - (d/a) e^(-i t))   angle t + arg(...)
**                            a = d   2 a sin(t/2) i e^(i t/2)         angle t/2 + pi/2, r = 2 a sin(t/2)
**
** and the arguments of the brackets are within +-90 deg.
*/
double flk_turns_of_B(const fourlink_mechanism *mechanism, const fourlink_state *state, double *r)
{
    double a = mechanism->design.link[FOURLINK_CRANK].length;
    double d = mechanism->design.link[FOURLINK_GROUND].length, theta2 = state->link[2].theta;
    const fourlink_vector *e2 = &state->link[2].axis;

    *r = flk_length(a * e2->x - d, a * e2->y);
    if (a < d)
        return M_PI + flk_angle(-a * e2->y, d - a * e2->x);
    if (a > d)
        return theta2 + flk_angle(d * e2->y, a - d * e2->x);
    *r = 2 * a * flk_sine(theta2 / 2);
    return theta2 / 2 + M_PI_2;
}

double flk_turns_angle(const fourlink_mechanism *mechanism, const fourlink_state *state, int link)
{
    if (link == FOURLINK_GROUND)
        return 0;
    if (link == FOURLINK_CRANK)
        return state->link[2].theta;
    return flk_kind_of(mechanism->design.kind)->turns(mechanism, state, link);
}
