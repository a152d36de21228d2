/* SPDX-License-Identifier: GPL-3.0-or-later
**
** polynomial.c - a polynomial through points, by divided differences.
*/
#include <math.h>

#include "polynomial.h"

void flk_polynomial_add(flk_polynomial *p, double x, double y)
{
    int i;

    p->x[p->n] = x;
    p->c[p->n] = y;
    for (i = 0; i < p->n; i++)
        p->c[p->n] = (p->c[p->n] - p->c[i]) / (x - p->x[i]);
    p->n++;
}

double flk_polynomial_value(const flk_polynomial *p, double x, double *slope)
{
    double value = 0;
    int i;

    *slope = 0;
    for (i = p->n - 1; i >= 0; i--) {
        *slope = *slope * (x - p->x[i]) + value;
        value = value * (x - p->x[i]) + p->c[i];
    }
    return value;
}

int flk_polynomial_find_flat(const flk_polynomial *p, double low, double high, double *at)
{
    double rise_low, rise_high, rise, enough = 1e-10 * (high - low);
    int i, side = 0;

    flk_polynomial_value(p, low, &rise_low);
    flk_polynomial_value(p, high, &rise_high);
    if ((rise_low > 0) == (rise_high > 0))
        return 0;
    for (i = 0; i < 60 && high - low > enough; i++) {
        double before = *at;

        *at = (low * rise_high - high * rise_low) / (rise_high - rise_low);
        flk_polynomial_value(p, *at, &rise);
        if (rise == 0 || (i > 0 && fabs(*at - before) <= enough))
            break;
        if ((rise > 0) == (rise_low > 0)) {
            low = *at;
            rise_low = rise;
            rise_high *= side == 1 ? 0.5 : 1;
            side = 1;
        } else {
            high = *at;
            rise_high = rise;
            rise_low *= side == -1 ? 0.5 : 1;
            side = -1;
        }
    }
    return 1;
}
