/* SPDX-License-Identifier: GPL-3.0-or-later
**
** indicated.c - what the indicator card of an engine says: the work of the gas in a cycle, its power, the
** mean effective pressure.
**
** Over a cycle of the angle c, along the motion (Heywood, Internal Combustion Engine Fundamentals, chapter
** 2),
**
**    W = integral of p dV,   P = W |omega| / c,   mep = W / V_s
**
** where V_s is the displacement.  A constant pressure, such as that on the crank side, does no work in a
** cycle.  For a clockwise crank, which passes the card backwards, W has the other sign.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "indicated.h"
#include "mechanics/mechanism.h"

/* The integral over the crank angle at unit speed.  Between two points of the indicator p is a cubic, and
** the piston moves smoothly but at a change point; Gauss and Kronrod's rule is exact to rounding for a part,
** or the part is halved. */

#define PART (M_PI / 12) /* rad, at most, at first */
#define EXACT 1e-13      /* error of a part, relative to the largest */
#define ROUNDING 1e-13   /* of the work of the parts, in their sum */
#define HALVINGS 40      /* of one part */
#define MOST_PARTS 1e5

typedef struct card {
    const flk_gas *gas;
    const fourlink_mechanism *mechanism;
    fourlink_branch branch;
    double within;  /* rad, the middle of the present part */
    double largest; /* J, integral of |p dV| over a part, */
    double size;    /* ... and over all parts, so far */
    double parts;   /* computed */
} card;

static void power_at(double theta2, void *data, double *power)
{
    const card *c = data;
    fourlink_crank crank;
    fourlink_state state;
    flk_gas_state at;

    crank.theta2 = theta2;
    crank.omega2 = 1;
    crank.alpha2 = 0;
    if (flk_mechanism_move(c->mechanism, c->branch, &crank, 0, &state) != FOURLINK_OK) {
        *power = GSL_NAN;
        return;
    }
    flk_gas_in_cylinder(c->gas, &state, c->within, &at);
    *power = at.pressure * at.rate;
}

/* The work between two crank angles; NaN where the links do not reach. */
static double work_between(card *c, double from, double to, int halvings)
{
    double middle = 0.5 * (from + to);
    flk_integral work;

    c->within = middle;
    c->parts++;
    flk_integrate(power_at, c, 1, from, to, &work);
    c->largest = GSL_MAX_DBL(c->largest, work.size);
    if (!(work.error > EXACT * c->largest) || halvings == HALVINGS || c->parts > MOST_PARTS) {
        c->size += work.size;
        return work.value;
    }
    return work_between(c, from, middle, halvings + 1) + work_between(c, middle, to, halvings + 1);
}

/* The work in the cycle of a crank that turns counter-clockwise. */
static double work_of_cycle(card *c)
{
    const curve *p = &c->gas->indicator;
    double sum = 0;
    size_t i;
    int k;

    for (i = 0; i < p->n; i++) {
        double from = p->x[i], length = (i + 1 < p->n ? p->x[i + 1] : p->x[0] + p->period) - from;
        int n = (int)ceil(length / PART);

        for (k = 0; k < n; k++)
            sum += work_between(c, from + length * k / n, from + length * (k + 1) / n, 0);
    }
    return fabs(sum) <= ROUNDING * c->size ? 0 : sum;
}

/* 1 if an angle is a number of whole turns. */
static int is_of_turns(double angle)
{
    double turns = angle / (2 * M_PI);

    return turns > 0.5 && fabs(turns - floor(turns + 0.5)) < 1e-9 * turns;
}

/* 1 if this speed is that of each cycle. */
static int has_constant_speed(const deck *d)
{
    return d->mode.kind == MODE_STEADY ||
           (d->mode.kind == MODE_GIVEN && d->motion.acceleration == 0 && !d->program);
}

/* The stroke of a piston that an indicator drives through whole cycles; 0 if there is none. */
static double stroke_of(const deck *d, const flk_gas *gas, fourlink_branch branch)
{
    fourlink_limits limits;

    return gas && gas->indicator.n && !d->prescribed && is_of_turns(d->machine.cycle) &&
                   fourlink_limits_of(&d->machine.mechanism, branch, &limits) == FOURLINK_OK &&
                   limits.has_stroke
               ? limits.stroke
               : 0;
}

int flk_indicated_find(const flk_analysis *a, fourlink_branch branch, flk_indicated *found)
{
    const deck *d = a->d;
    double omega = flk_analysis_mean_speed(a, branch), stroke, work;
    card c;

    c.gas = flk_gas_on_piston(&d->machine);
    c.mechanism = &d->machine.mechanism;
    c.branch = branch;
    c.largest = c.size = c.parts = 0;
    stroke = stroke_of(d, c.gas, branch);
    work = stroke > 0 ? work_of_cycle(&c) : GSL_NAN;
    if (gsl_isnan(work))
        return 0;
    found->work = omega < 0 ? -work : work;
    found->power = has_constant_speed(d) && omega != 0
                       ? found->work * fabs(omega) / d->machine.cycle
                       : GSL_NAN;
    found->mean_effective = found->work / (c.gas->area * stroke);
    return 1;
}
