/* SPDX-License-Identifier: GPL-3.0-or-later
**
** equation.c - the equation of motion in time, within a cell of the machine.
**
** With s the angle through which the crank has turned, in the sense of the motion,
**
**    ds/dt = omega2,   domega2/dt = alpha2,   dE/dt = (T_m + Q) omega2
**
** omega2 follows from the accelerations, which need J', and E from the work, which does not.
** (J + I_f) omega2^2 / 2 = E checks both.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "equation.h"
#include "mechanics/dormand_prince.h"
#include "mechanics/kind.h"

#define BESIDE 5e-3 /* rad, from a change point: closer values are interpolated from around it */
#define PLACES 6

double flk_equation_theta2(const flk_equation *e, double s)
{
    return e->from + e->sense * s;
}

int flk_equation_torque(const flk_equation *e, const flk_machine_place *place, double speed,
                        flk_machine_torque *torque)
{
    int status = flk_machine_torque_at(&e->machine, place, e->sense * speed, e->acting, torque);

    torque->net *= e->sense;
    torque->alpha2 *= e->sense;
    return status;
}

/* rad passed since the nearest change point, < 0 before it; infinite if the mechanism has none. */
static double after_change(const flk_equation *e, double s)
{
    const fourlink_mechanism *mechanism = &e->machine.mechanism;
    double folded = flk_kind_of(mechanism->design.kind)->folded;
    double nearest = GSL_POSINF;
    int i;

    for (i = 0; i < 2; i++) {
        double turns = (flk_equation_theta2(e, s) - folded - i * M_PI) / (2 * M_PI);
        double after = e->sense * 2 * M_PI * flk_cycle_beside(turns, 1);

        if ((i ? mechanism->change_stretched : mechanism->change_folded) &&
            fabs(after) < fabs(nearest))
            nearest = after;
    }
    return nearest;
}

/* The places, in rad passed, at which values are taken, and their weights; returns their number.  Near a
** change point the motion of the links, which is smooth, is lost in rounding; it is interpolated by a
** polynomial through places around it (Lagrange). */
static int find_places(const flk_equation *e, double s, double *places, double *weights)
{
    static const double nodes[PLACES] = {-3 * BESIDE, -2 * BESIDE, -BESIDE,
                                         BESIDE,      2 * BESIDE,  3 * BESIDE};
    double after = after_change(e, s);
    int i, k;

    places[0] = s;
    weights[0] = 1;
    if (!(fabs(after) < BESIDE))
        return 1;
    for (i = 0; i < PLACES; i++) {
        places[i] = s - after + nodes[i];
        weights[i] = 1;
        for (k = 0; k < PLACES; k++)
            weights[i] *= k == i ? 1 : (after - nodes[k]) / (nodes[i] - nodes[k]);
    }
    return PLACES;
}

static int derive_at(const flk_equation *e, double s, const double *y, flk_machine_place *place,
                     double *dy, double *total)
{
    flk_machine_torque torque;
    int status = flk_machine_at(&e->machine, e->branch, flk_equation_theta2(e, s), place);

    if (status == FOURLINK_OK)
        status = flk_equation_torque(e, place, y[FLK_SPEED], &torque);
    if (status != FOURLINK_OK)
        return status;
    dy[FLK_PASSED] = y[FLK_SPEED];
    dy[FLK_SPEED] = torque.alpha2;
    dy[FLK_ENERGY] = torque.net * y[FLK_SPEED];
    *total = place->total;
    return FOURLINK_OK;
}

int flk_equation_derive(void *equation, double t, const double *y, double *dy)
{
    flk_equation *e = equation;
    double places[PLACES], weights[PLACES], values[FLK_UNKNOWNS], sum[FLK_UNKNOWNS] = {0, 0, 0};
    double total;
    flk_machine_place place;
    int n = find_places(e, y[FLK_PASSED], places, weights), i, k, status;

    (void)t;
    if (n == 1)
        return derive_at(e, y[FLK_PASSED], y, &place, dy, &e->total);
    e->total = 0;
    for (i = 0; i < n; i++) {
        status = derive_at(e, places[i], y, &place, values, &total);
        if (status != FOURLINK_OK)
            return status;
        e->total += weights[i] * total;
        for (k = 0; k < FLK_UNKNOWNS; k++)
            sum[k] += weights[i] * values[k];
    }
    for (k = 0; k < FLK_UNKNOWNS; k++)
        dy[k] = sum[k];
    return FOURLINK_OK;
}

int flk_equation_inertia(const flk_equation *e, double s, double *total)
{
    double places[PLACES], weights[PLACES], sum = 0;
    int n = find_places(e, s, places, weights), i, status;
    flk_machine_place place;

    for (i = 0; i < n; i++) {
        status = flk_machine_at(&e->machine, e->branch, flk_equation_theta2(e, places[i]), &place);
        if (status != FOURLINK_OK)
            return status;
        sum += weights[i] * place.total;
    }
    *total = sum;
    return FOURLINK_OK;
}
