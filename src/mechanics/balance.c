/* SPDX-License-Identifier: GPL-3.0-or-later
**
** balance.c - counterweights that balance the shaking force.
**
** In complex numbers, with z_i the centre of mass in the axes of link i, the first moment of the moving
** masses is a sum of rotating vectors, once the loop equation has eliminated the coupler's direction (Berkof
** and Lowen).  Four-bar, with a e^(i theta2) + b e^(i theta3) = d + c e^(i theta4):
**
**    sum m r = const + e^(i theta2) [m2 z2 + m3 a (1 - z3 / b)] + e^(i theta4) [m4 z4 + m3 (c / b) z3]
**
** Inverted slider-crank, link 3 at the angle gamma to link 4:
**
**    sum m r = const + e^(i theta2) [m2 z2 + m3 a] + e^(i theta4) [m4 z4 + m3 z3 e^(i gamma)]
**
** Slider-crank, with a e^(i theta2) + l e^(i theta3) = X + i e:
**
**    sum m r = const + e^(i theta2) [m2 z2 + m3 a (1 - z3 / l)] + X [m4 + m3 z3 / l]
**
** The counterweights are the negative brackets.  The bracket of X is the reciprocating mass, of which the
** crank balances a fraction: X is a cos(theta2) plus smaller terms of twice the frequency.
*/
#include <math.h>

#include "kind.h"
#include "balance.h"

static void balance_four_bar(const fourlink_link *link, fourlink_balance *u)
{
    double m = link[3].mass, a = link[2].length, b = link[3].length, c = link[4].length;
    const fourlink_vector *z = &link[3].cg;

    u->crank.x = -(link[2].mass * link[2].cg.x + m * a * (1 - z->x / b));
    u->crank.y = -(link[2].mass * link[2].cg.y - m * a * z->y / b);
    u->rocker.x = -(link[4].mass * link[4].cg.x + m * c * z->x / b);
    u->rocker.y = -(link[4].mass * link[4].cg.y + m * c * z->y / b);
}

/* The lever's axis in the slider's axes is e^(-i gamma). */
static void balance_inverted(const fourlink_mechanism *mechanism, fourlink_balance *u)
{
    const fourlink_link *link = mechanism->design.link;
    const fourlink_vector *z = &link[3].cg, *lever = &mechanism->lever;

    u->crank.x = -(link[2].mass * link[2].cg.x + link[3].mass * link[2].length);
    u->crank.y = -link[2].mass * link[2].cg.y;
    u->rocker.x = -(link[4].mass * link[4].cg.x + link[3].mass * FLK_DOT(*lever, *z));
    u->rocker.y = -(link[4].mass * link[4].cg.y + link[3].mass * FLK_CROSS(*lever, *z));
}

double flk_balance_reciprocating(const fourlink_design *design)
{
    const fourlink_link *link = design->link;

    return link[4].mass + link[3].mass * link[3].cg.x / link[3].length;
}

static void balance_engine(const fourlink_design *design, double fraction, fourlink_balance *u)
{
    const fourlink_link *link = design->link;
    double m = link[3].mass, r = link[2].length, l = link[3].length;
    const fourlink_vector *z = &link[3].cg;

    u->crank.x = -(link[2].mass * link[2].cg.x + m * r * (1 - z->x / l) +
                   fraction * flk_balance_reciprocating(design) * r);
    u->crank.y = -(link[2].mass * link[2].cg.y - m * r * z->y / l);
    u->rocker.x = u->rocker.y = 0;
}

int fourlink_balance_of(const fourlink_mechanism *mechanism, double fraction,
                        fourlink_balance *balance)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, balance, &kind);

    if (status != FOURLINK_OK)
        return status;
    switch (kind->kind) {
    case FOURLINK_SLIDER_CRANK:
        if (!FLK_WITHIN(fraction, FOURLINK_NUMBER_MAX))
            return FOURLINK_BAD_NUMBER;
        balance_engine(&mechanism->design, fraction, balance);
        break;
    case FOURLINK_INVERTED_SLIDER_CRANK:
        balance_inverted(mechanism, balance);
        break;
    default:
        balance_four_bar(mechanism->design.link, balance);
    }
    return FOURLINK_OK;
}

/* With the counterweight m_c at z_c, m_c z_c = U, about the new common centre of mass z:
**
**    I = I0 + m0 |z0 - z|^2 + m_c |z_c - z|^2
*/
int fourlink_add_counterweight(const fourlink_link *link, const fourlink_vector *moment,
                               double radius, fourlink_link *balanced, double *mass)
{
    double size, m, x, y, x_c, y_c;
    fourlink_link sum;

    if (!link || !moment || !balanced)
        return FOURLINK_NULL;
    if (!FLK_BOTH_WITHIN(*moment, FOURLINK_NUMBER_MAX) || !FLK_WITHIN(radius, FOURLINK_LENGTH_MAX))
        return FOURLINK_BAD_NUMBER;
    if (radius <= 0)
        return FOURLINK_BAD_BALANCE;
    size = sqrt(moment->x * moment->x + moment->y * moment->y);
    m = size / radius;
    sum = *link;
    if (m > 0) {
        sum.mass += m;
        sum.cg.x = (link->mass * link->cg.x + moment->x) / sum.mass;
        sum.cg.y = (link->mass * link->cg.y + moment->y) / sum.mass;
        x = link->cg.x - sum.cg.x;
        y = link->cg.y - sum.cg.y;
        x_c = moment->x / m - sum.cg.x;
        y_c = moment->y / m - sum.cg.y;
        sum.inertia += link->mass * (x * x + y * y) + m * (x_c * x_c + y_c * y_c);
    }
    *balanced = sum;
    if (mass)
        *mass = m;
    return FOURLINK_OK;
}
