/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turning.c - the turning moment over a cycle, and the flywheel that it needs.
**
** With T = -Ts the turning moment, Tm its mean over the cycle of angle c, and the load torque equal to
** Tm, the flywheel takes up the difference:
**
**    E(theta) = integral of (T - Tm) dtheta,    dE = max E - min E
**
** along the motion: for a clockwise crank from greater angles to smaller ones.
**
**    coefficient of fluctuation of energy dE / (Tm c),   of speed Cs = dE / (I omega^2)
**
** For an actual motion omega is its mean speed, and I is that of the flywheel and of the motor's rotor.
**
** The cycle is cut every few degrees and wherever a load's curve or window has a corner; in such a piece the
** moment is smooth, and Gauss and Kronrod's rule is exact to rounding or the piece is halved.  E has its
** extremes at the corners and where T crosses Tm, which is sought from degree to degree.
*/
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/solve.h"
#include "turning.h"

#define DEGREE (M_PI / 180)
#define MOST_DEGREES 100000
#define PIECE 10      /* degrees */
#define INSIDE 1e-10  /* rad, from a corner into the piece beside it */
#define HALVINGS 1000 /* of pieces, at most */
#define SHORTEST 1e-9 /* rad: no piece is halved below it */
#define ROUGH 1e-8    /* a smooth piece is exact to 1e-13 if its rules agree to this */
#define FINE 1e-13    /* of the largest moment over the cycle: less need not be found in a piece */
#define FINEST 1e-6   /* rad: a kink, where friction turns round, is not cut more finely */

typedef struct moment {
    flk_analysis *a;
    fourlink_branch branch;
    fourlink_crank crank;
    double mean, without; /* of T, and of the moment without friction */
    double *cuts;         /* rad, rising: the ends of the pieces */
    double *work;         /* N m rad, of T in each piece */
    size_t n_cuts;
} moment;

/* T, and that of the machine without friction; NaN where the links do not reach. */
static void moment_at(double theta2, void *data, double *T)
{
    moment *m = data;
    flk_row row;

    m->crank.theta2 = theta2;
    flk_analysis_at(m->a, NEED_FORCES, m->branch, &m->crank, &row);
    T[0] = row.at.status == FOURLINK_OK ? -row.at.forces.Ts : GSL_NAN;
    T[1] =
        row.at.status == FOURLINK_OK && m->a->d->machine.has_friction ? -row.at.losses.Ts0 : T[0];
}

/* T - Tm */
static double excess(double theta2, void *data)
{
    double T[FLK_INTEGRALS];

    moment_at(theta2, data, T);
    return T[0] - ((const moment *)data)->mean;
}

/* 1 if the crank turns at one speed, or its steady motion has a mean speed. */
static int has_speed(const deck *d)
{
    if (d->drive.mode != DRIVE_GIVEN)
        return d->drive.mode == DRIVE_STEADY;
    return d->motion.speed != 0 && d->motion.acceleration == 0;
}

/* Pieces of the cycle, without corners; 0 if there is no turning moment. */
static size_t turning_pieces(const deck *d)
{
    double degrees = floor(d->machine.cycle / DEGREE + 0.5);

    return !d->has_forces || !has_speed(d) || degrees < 1 || degrees > MOST_DEGREES
               ? 0
               : (size_t)ceil(degrees / PIECE);
}

/* The most pieces that there can be. */
static size_t most_cuts(const flk_analysis *a)
{
    return turning_pieces(a->d) + 1 + HALVINGS +
           flk_corners_most(a->crank_motion.corners, a->d->machine.cycle);
}

int flk_turning_open(flk_analysis *a)
{
    if (!turning_pieces(a->d))
        return 1;
    a->turning_memory = malloc(2 * most_cuts(a) * sizeof *a->turning_memory);
    return a->turning_memory != NULL;
}

/* The pieces of the cycle: equal ones, and the corners between them. */
static void cut(moment *m)
{
    double cycle = m->a->d->machine.cycle, corner, end, at = 0;
    size_t n = turning_pieces(m->a->d), i;
    flk_direction direction;
    flk_piece_end what;

    direction.corners = m->a->crank_motion.corners;
    direction.branch = m->branch;
    direction.from = 0;
    direction.sense = direction.has_loads = 1;
    m->cuts[m->n_cuts++] = 0;
    for (i = 1; i <= n; i++, at = end) {
        end = i < n ? cycle * (double)i / (double)n : cycle;
        while ((corner = flk_corners_next(&direction, at, NULL, 0, &what)) <
               end - FLK_CORNERS_CLOSE(end))
            m->cuts[m->n_cuts++] = at = corner;
        m->cuts[m->n_cuts++] = end;
    }
}

/* Halve piece i. */
static void halve(moment *m, size_t i)
{
    size_t n = m->n_cuts - i - 1;

    memmove(m->cuts + i + 2, m->cuts + i + 1, n * sizeof *m->cuts);
    m->cuts[i + 1] = 0.5 * (m->cuts[i] + m->cuts[i + 2]);
    m->n_cuts++;
}

/* The mean over the cycle; NaN if the moment is not defined all round.  A piece in which the rule is not
** exact is halved: near a change point the moment has a peak far narrower than a degree, and where friction
** turns round a kink.  Where that does
** not end, the moment is unbounded. */
static double mean_of(moment *m, double *scale)
{
    size_t most = most_cuts(m->a), i = 0;
    double sum = 0;
    int is_rough;

    *scale = 0;
    while (i + 1 < m->n_cuts) {
        double T = excess(m->cuts[i] + INSIDE, m), length = m->cuts[i + 1] - m->cuts[i];
        flk_integral work[2];

        flk_integrate(moment_at, m, 2, m->cuts[i], m->cuts[i + 1], work);
        if (gsl_isnan(T) || gsl_isnan(work[0].value))
            return GSL_NAN;
        *scale = GSL_MAX_DBL(*scale, fabs(T));
        is_rough = work[0].error > ROUGH * (work[0].size + *scale * length);
        if (is_rough && (m->n_cuts == most || length < SHORTEST))
            return GSL_NAN;
        if (is_rough || (work[0].error > FINE * *scale * m->a->d->machine.cycle &&
                         m->n_cuts < most && length > FINEST)) {
            halve(m, i);
            continue;
        }
        m->work[i++] = work[0].value;
        sum += work[0].value;
        m->without += work[1].value / m->a->d->machine.cycle;
    }
    return sum / m->a->d->machine.cycle;
}

/* The energy that the flywheel has taken up, at a corner or a crossing. */
typedef struct energy {
    double E, least, greatest;
    double from, E_from; /* where the present area began */
} energy;

static void take_up(energy *e, double dE)
{
    e->E += dE;
    e->least = e->E < e->least ? e->E : e->least;
    e->greatest = e->E > e->greatest ? e->E : e->greatest;
}

static void end_area(const moment *m, energy *e, double at, fourlink_turning *t)
{
    if (t->n_areas < FOURLINK_AREAS) {
        fourlink_area *new = &t->area[t->n_areas++];

        new->from = e->from;
        new->to = at;
        new->energy = m->crank.omega2 < 0 ? e->E_from - e->E : e->E - e->E_from;
    }
    e->from = at;
    e->E_from = e->E;
}

/* Take up the energy of a piece; an area ends at each crossing in it. */
static void take_up_piece(moment *m, size_t i, energy *e, int *is_below, fourlink_turning *t)
{
    double from = m->cuts[i], to = m->cuts[i + 1], taken = 0;
    int n = (int)ceil((to - from) / DEGREE - INSIDE), k;
    flk_sample low, high;

    low.x = from + INSIDE;
    low.value = excess(low.x, m);
    if ((low.value < 0) != *is_below) /* a jump */
        end_area(m, e, from, t);
    *is_below = low.value < 0;
    for (k = 1; k <= n; k++, low = high) {
        high.x = k < n ? from + (to - from) * k / n : to - INSIDE;
        high.value = excess(high.x, m);
        if ((high.value < 0) != *is_below) {
            flk_bracket b = flk_bracket_of(low.x, high.x, low.value, high.value);
            double at = flk_find_zero(excess, m, &b, 0);
            flk_integral work;

            flk_integrate(moment_at, m, 1, from, at, &work);
            work.value -= m->mean * (at - from);
            take_up(e, work.value - taken);
            end_area(m, e, at, t);
            taken = work.value;
            *is_below = high.value < 0;
        }
    }
    take_up(e, m->work[i] - m->mean * (to - from) - taken);
}

static double fluctuation_of_energy(moment *m, fourlink_turning *t)
{
    energy e = {0, 0, 0, 0, 0};
    int is_below = excess(m->cuts[0] + INSIDE, m) < 0;
    size_t i;

    for (i = 0; i + 1 < m->n_cuts; i++)
        take_up_piece(m, i, &e, &is_below, t);
    end_area(m, &e, m->a->d->machine.cycle, t);
    return e.greatest - e.least;
}

static void find_turning(moment *m, double scale, fourlink_turning *t)
{
    const deck *d = m->a->d;
    const flk_actual_facts *actual = flk_actual_facts_of(m->a->crank_motion.actual, m->branch);
    double omega = m->crank.omega2, inertia = actual ? actual->inertia : d->machine.flywheel;

    if (fabs(m->mean) <= 1e-12 * scale)
        m->mean = 0;
    t->n_areas = 0;
    t->mean_torque = m->mean;
    t->mean_power = m->mean * omega;
    t->energy_fluctuation = fluctuation_of_energy(m, t);
    t->has_coefficient = m->mean != 0;
    t->energy_coefficient =
        m->mean != 0 ? t->energy_fluctuation / fabs(m->mean * d->machine.cycle) : 0;
    t->inertia = actual ? actual->flywheel : d->machine.flywheel;
    t->fluctuation = actual ? 0 : d->flywheel_fluctuation;
    if (inertia > 0)
        t->fluctuation = t->energy_fluctuation / (inertia * omega * omega);
    else if (t->fluctuation > 0)
        t->inertia = t->energy_fluctuation / (t->fluctuation * omega * omega);
}

/* Work without friction over work with it, if the crank drives; if it is driven, the reverse.  Undefined if
** there is no work. */
static double efficiency_of(const moment *m)
{
    double sense = m->crank.omega2 < 0 ? 1 : -1;
    double with = sense * m->mean, without = sense * m->without;

    if (with > 0)
        return without > 0 ? without / with : 0;
    return without < 0 ? with / without : with == without ? FLK_UNDEFINED : 0;
}

/* The speed of the crank, or the mean of its steady motion; NaN if it has none. */
static double speed_of(const flk_analysis *a, fourlink_branch branch)
{
    const flk_actual_facts *actual = flk_actual_facts_of(a->crank_motion.actual, branch);

    return actual ? actual->mean_speed : a->d->motion.speed;
}

const fourlink_turning *flk_turning_find(flk_analysis *a, fourlink_branch branch)
{
    flk_turning *t = &a->turning[branch == FOURLINK_OPEN ? 0 : 1];
    int was_fast = a->is_fast;
    double scale;
    moment m;

    if (t->is_known || !a->turning_memory)
        return t->is_there ? &t->t : NULL;
    m.a = a;
    m.branch = branch;
    m.crank.theta2 = 0;
    m.crank.omega2 = speed_of(a, branch);
    m.crank.alpha2 = 0;
    m.mean = m.without = 0;
    m.cuts = a->turning_memory;
    m.work = m.cuts + most_cuts(a);
    m.n_cuts = 0;
    t->is_known = 1;
    if (!gsl_finite(m.crank.omega2))
        return NULL;
    a->is_fast = 1;
    cut(&m);
    m.mean = mean_of(&m, &scale);
    t->is_there = !gsl_isnan(m.mean);
    if (t->is_there)
        find_turning(&m, scale, &t->t);
    if (t->is_there && a->d->machine.has_friction)
        t->efficiency = efficiency_of(&m);
    a->is_fast = was_fast;
    return t->is_there ? &t->t : NULL;
}
