/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turns.c - link angles that are continuous in the crank angle and count full turns.
*/
#include <math.h>

#include <gsl/gsl_math.h>

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
static double line_of_B(const fourlink_mechanism *mechanism, const fourlink_state *state, double *r)
{
    double a = mechanism->design.link[FOURLINK_CRANK].length;
    double d = mechanism->design.link[FOURLINK_GROUND].length, theta2 = state->link[2].theta;
    const fourlink_vector *e2 = &state->link[2].axis;

    *r = gsl_hypot(a * e2->x - d, a * e2->y);
    if (a < d)
        return M_PI + atan2(-a * e2->y, d - a * e2->x);
    if (a > d)
        return theta2 + atan2(d * e2->y, a - d * e2->x);
    *r = 2 * a * sin(theta2 / 2);
    return theta2 / 2 + M_PI_2;
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
    double angle = atan2(sine, cosine), branch = (double)state->branch;
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
static double of_four_bar(const fourlink_mechanism *mechanism, const fourlink_state *state,
                          int link)
{
    const fourlink_link *l = mechanism->design.link;
    double b = l[3].length, c = l[4].length, r, line = line_of_B(mechanism, state, &r);

    if (link == FOURLINK_COUPLER)
        return line - M_PI +
               in_triangle(mechanism, state, c * state->sine / r,
                           (r * r + (b - c) * (b + c)) / (2 * r * b), c > b);
    return line - in_triangle(mechanism, state, b * state->sine / r,
                              (r * r + (c - b) * (c + b)) / (2 * r * c), b > c);
}

/* The rod passes -90 deg at the stretched change point, and 90 deg at the folded one.  With both (l = r,
** e = 0) it turns against the crank, but with it on the crossed branch. */
static double of_rod(const fourlink_mechanism *mechanism, const fourlink_state *state)
{
    const fourlink_vector *e3 = &state->link[3].axis;
    double theta2 = state->link[2].theta;

    if (mechanism->change_stretched && mechanism->change_folded)
        return state->branch == FOURLINK_OPEN ? -theta2 : M_PI + theta2;
    if (mechanism->change_stretched)
        return atan2(e3->x, -e3->y) - M_PI_2;
    if (mechanism->change_folded)
        return M_PI_2 - atan2(e3->x, e3->y);
    return state->branch == FOURLINK_OPEN ? atan2(e3->y, e3->x) : M_PI + atan2(-e3->y, -e3->x);
}

/* The slide: B - D = s u + h n */
static double of_slide(const fourlink_mechanism *mechanism, const fourlink_state *state)
{
    double r, line = line_of_B(mechanism, state, &r);

    if (mechanism->change_folded && mechanism->h == 0)
        return state->branch == FOURLINK_OPEN ? line : line - M_PI;
    return line - atan2(mechanism->h, state->s);
}

double flk_turns_angle(const fourlink_mechanism *mechanism, const fourlink_state *state, int link)
{
    if (link == FOURLINK_GROUND)
        return 0;
    if (link == FOURLINK_CRANK)
        return state->link[2].theta;
    switch (mechanism->design.kind) {
    case FOURLINK_SLIDER_CRANK:
        return link == FOURLINK_COUPLER ? of_rod(mechanism, state) : 0;
    case FOURLINK_INVERTED_SLIDER_CRANK:
        return of_slide(mechanism, state) +
               (link == FOURLINK_COUPLER ? 0 : atan2(mechanism->lever.y, mechanism->lever.x));
    default:
        return of_four_bar(mechanism, state, link);
    }
}
