/* SPDX-License-Identifier: GPL-3.0-or-later
**
** balance.c - counterweights that balance the shaking force.
**
** In complex numbers, with z_i the centre of mass in the axes of link i, the first moment of the moving
** masses is a sum of rotating vectors, once the loop equation has eliminated the coupler's direction (Berkof
** and Lowen):
**
**    sum m r = const + e^(i theta2) [ ... ] + e^(i theta4) [ ... ]
**
** and the counterweights on crank and rocker are the negative brackets.  The file of each kind has its own.
*/
#include <math.h>

#include "kind.h"
#include "balance.h"

double flk_balance_reciprocating(const fourlink_design *design)
{
    const fourlink_link *link = design->link;

    return link[4].mass + link[3].mass * link[3].cg.x / link[3].length;
}

int fourlink_balance_of(const fourlink_mechanism *mechanism, double fraction,
                        fourlink_balance *balance)
{
    const flk_kind *kind;
    int status = flk_kind_find(mechanism, balance, &kind);

    if (status != FOURLINK_OK)
        return status;
    if (fourlink_slides((int)kind->kind, FOURLINK_FOLLOWER) &&
        !FLK_WITHIN(fraction, FOURLINK_NUMBER_MAX))
        return FOURLINK_BAD_NUMBER;
    kind->balance(mechanism, fraction, balance);
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
    if (radius < FOURLINK_LENGTH_MIN)
        return FOURLINK_BAD_NUMBER;
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
