/* SPDX-License-Identifier: GPL-3.0-or-later
**
** angle.c - the angle of a link's axis.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "mechanics.h"

/* The angle of a unit vector, to 6e-16, without the division and the checks of the C library's atan2,
** of which every crank position would need two.
**
** In the first octant sin(theta) = s is near k/16, k = 0 to 11, whose arcsine t_k is tabulated: what is
** left is d = sin(theta - t_k) = s cos(t_k) - c k/16, less than 0.05, and
**
**    theta - t_k = d + d^3/6 + 3 d^5/40 + 15 d^7/336 + 105 d^9/3456 + ...
**
** of which the next term is below 5e-17.  A vector whose length differs from 1 by more than rounding,
** as beside a dead position, or is no number, goes to atan2.
*/
double flk_angle(const fourlink_vector *u)
{
    static const struct {
        double sine, cosine, angle;
    } table[] = {
        {0, 1, 0},
        {0.0625, 0.998044963916957, 0.062540761796491391},
        {0.125, 0.99215674164922147, 0.1253278311680654},
        {0.1875, 0.98226460284385694, 0.1886163861754041},
        {0.25, 0.96824583655185422, 0.25268025514207865},
        {0.3125, 0.94991775959816648, 0.31782370392788075},
        {0.375, 0.92702481088695787, 0.38439677449563908},
        {0.4375, 0.89921841062113491, 0.45281659474492557},
        {0.5, 0.86602540378443865, 0.52359877559829887},
        {0.5625, 0.82679728470768456, 0.59740641664535021},
        {0.625, 0.78062474979979978, 0.67513153293703165},
        {0.6875, 0.72618437741389067, 0.75804076542623596},
    };
    double x = fabs(u->x), y = fabs(u->y);
    double s = x < y ? x : y, c = x < y ? y : x, d, d2, angle;
    int k;

    if (y < 4e-16 && x > 0) /* one that is at 180 deg but for rounding is not at -180 */
        return u->x < 0 ? M_PI : 0;
    if (!(fabs(x * x + y * y - 1) < 4e-15))
        return atan2(u->y, u->x);
    k = (int)(16 * s + 0.5);
    d = s * table[k].cosine - c * table[k].sine;
    d2 = d * d;
    angle = table[k].angle +
            (d + d * d2 * (1 / 6.0 + d2 * (3 / 40.0 + d2 * (15 / 336.0 + d2 * (105 / 3456.0)))));
    if (x < y)
        angle = M_PI_2 - angle;
    if (u->x < 0)
        angle = M_PI - angle;
    return u->y < 0 ? -angle : angle;
}
