/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turning.c - the turning moment over a cycle, and the flywheel that it needs.
**
** With T = -Ts the turning moment, Tm its mean over the cycle of angle c, and the load torque equal to
** Tm, the flywheel takes up the difference:
**
**    E(theta) = integral of (T - Tm) dtheta,    dE = max E - min E
**
** along the motion: over an area that a clockwise crank passes, from its higher angle to its lower.
**
**    coefficient of fluctuation of energy dE / (Tm c),   of speed Cs = dE / (I omega^2)
**
** The cycle is cut at every degree and wherever a load's curve or window has a corner; in such a piece the
** moment is smooth, and GSL's Gauss-Legendre rule is exact to rounding.  E has its extremes at the corners
** and where T crosses Tm, which GSL's root finder tells.
*/
#include <math.h>
#include <stdlib.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>

#include "turning.h"

#define STEP (M_PI / 180)
#define MOST_STEPS 100000
#define POINTS 8     /* of the Gauss-Legendre rule */
#define INSIDE 1e-10 /* rad, from a corner into the piece beside it */

typedef struct moment {
    analysis *a;
    fourlink_branch branch;
    fourlink_crank crank;
    double mean;
    double *cuts; /* rad, rising: the ends of the pieces */
    double *work; /* N m rad, of T in each piece */
    size_t n_cuts;
    gsl_integration_glfixed_table *rule;
    gsl_root_fsolver *solver;
} moment;

/* T - Tm; NaN where the links do not reach. */
static double excess(double theta2, void *data)
{
    moment *m = data;
    result r;

    m->crank.theta2 = theta2;
    analysis_at(m->a, m->branch, &m->crank, &r);
    return r.status == FOURLINK_OK ? -r.forces.Ts - m->mean : GSL_NAN;
}

static double area(moment *m, double from, double to)
{
    gsl_function f;

    f.function = excess;
    f.params = m;
    return gsl_integration_glfixed(&f, from, to, m->rule);
}

/* Where T - Tm changes its sign. */
static double crossing(moment *m, double low, double high)
{
    gsl_function f;
    int i;

    f.function = excess;
    f.params = m;
    gsl_root_fsolver_set(m->solver, &f, low, high);
    for (i = 0; i < 100; i++)
        if (gsl_root_fsolver_iterate(m->solver) != GSL_SUCCESS ||
            gsl_root_test_interval(gsl_root_fsolver_x_lower(m->solver),
                                   gsl_root_fsolver_x_upper(m->solver), 1e-14, 0) == GSL_SUCCESS)
            break;
    return gsl_root_fsolver_root(m->solver);
}

static int rising(const void *x, const void *y)
{
    double a = *(const double *)x, b = *(const double *)y;

    return (a > b) - (a < b);
}

/* A corner, in the cycle that starts at 0. */
static void cut_at(moment *m, double angle)
{
    double cycle = m->a->d->cycle;

    m->cuts[m->n_cuts++] = angle - cycle * floor(angle / cycle);
}

static void cut_at_curve(moment *m, const curve *c)
{
    size_t i;

    for (i = 0; i < c->n; i++)
        cut_at(m, c->x[i]);
}

/* The pieces of the cycle.  0 when out of memory. */
static int cut(moment *m, long steps)
{
    const deck *d = m->a->d;
    size_t most = (size_t)steps + 1 + d->gas.indicator.n, i, n;

    for (i = 0; i < d->n_loads; i++)
        most += d->variations[i].torque.n + 2;
    m->cuts = malloc(2 * most * sizeof *m->cuts);
    if (!m->cuts)
        return 0;
    m->work = m->cuts + most;
    for (i = 0; i <= (size_t)steps; i++)
        m->cuts[m->n_cuts++] = d->cycle * (double)i / (double)steps;
    cut_at_curve(m, &d->gas.indicator);
    for (i = 0; i < d->n_loads; i++) {
        cut_at_curve(m, &d->variations[i].torque);
        if (d->variations[i].is_windowed) {
            cut_at(m, d->variations[i].from);
            cut_at(m, d->variations[i].to);
        }
    }
    qsort(m->cuts, m->n_cuts, sizeof *m->cuts, rising);
    for (i = 1, n = 1; i < m->n_cuts; i++)
        if (m->cuts[i] - m->cuts[n - 1] > 4 * INSIDE)
            m->cuts[n++] = m->cuts[i];
    m->cuts[n - 1] = d->cycle;
    m->n_cuts = n;
    return 1;
}

/* The mean over the cycle; NaN if the moment is not defined all round. */
static double mean_of(moment *m, double *scale)
{
    double sum = 0;
    size_t i;

    *scale = 0;
    for (i = 0; i + 1 < m->n_cuts; i++) {
        double T = excess(m->cuts[i] + INSIDE, m);

        if (fabs(T) > *scale)
            *scale = fabs(T);
        m->work[i] = area(m, m->cuts[i], m->cuts[i + 1]);
        sum += m->work[i];
        if (gsl_isnan(T) || gsl_isnan(sum))
            return GSL_NAN;
    }
    return sum / m->a->d->cycle;
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

static void end_area(const moment *m, energy *e, double at, turning *t)
{
    if (t->n_areas < TURNING_AREAS) {
        turning_area *new = &t->area[t->n_areas++];

        new->from = e->from;
        new->to = at;
        new->energy = m->crank.omega2 < 0 ? e->E_from - e->E : e->E - e->E_from;
    }
    e->from = at;
    e->E_from = e->E;
}

static double fluctuation_of_energy(moment *m, turning *t)
{
    energy e = {0, 0, 0, 0, 0};
    int was_below = excess(m->cuts[0] + INSIDE, m) < 0;
    size_t i;

    for (i = 0; i + 1 < m->n_cuts; i++) {
        double from = m->cuts[i], to = m->cuts[i + 1];
        double low = from + INSIDE, high = to - INSIDE;
        double dE = m->work[i] - m->mean * (to - from);
        int below = excess(low, m) < 0;

        if (below != was_below) /* a jump */
            end_area(m, &e, from, t);
        was_below = excess(high, m) < 0;
        if (below != was_below) {
            double at = crossing(m, low, high), before = area(m, from, at);

            take_up(&e, before);
            end_area(m, &e, at, t);
            dE -= before;
        }
        take_up(&e, dE);
    }
    end_area(m, &e, m->a->d->cycle, t);
    return e.greatest - e.least;
}

static void find(moment *m, double scale, turning *t)
{
    const deck *d = m->a->d;
    double omega = d->motion.speed;

    if (fabs(m->mean) <= 1e-12 * scale)
        m->mean = 0;
    t->n_areas = 0;
    t->mean_torque = m->mean;
    t->mean_power = m->mean * omega;
    t->energy_fluctuation = fluctuation_of_energy(m, t);
    t->has_coefficient = m->mean != 0;
    t->energy_coefficient = m->mean != 0 ? t->energy_fluctuation / fabs(m->mean * d->cycle) : 0;
    t->inertia = d->flywheel_inertia;
    t->fluctuation = d->flywheel_fluctuation;
    if (t->inertia > 0)
        t->fluctuation = t->energy_fluctuation / (t->inertia * omega * omega);
    else if (t->fluctuation > 0)
        t->inertia = t->energy_fluctuation / (t->fluctuation * omega * omega);
}

int turning_find(analysis *a, fourlink_branch branch, turning *t)
{
    const deck *d = a->d;
    double degrees = floor(d->cycle / STEP + 0.5), scale;
    int found = 0;
    moment m;

    if (!d->has_forces || d->motion.speed == 0 || d->motion.acceleration != 0 || degrees < 1 ||
        degrees > MOST_STEPS)
        return 0;
    m.a = a;
    m.branch = branch;
    m.crank.theta2 = 0;
    m.crank.omega2 = d->motion.speed;
    m.crank.alpha2 = 0;
    m.mean = 0;
    m.cuts = NULL;
    m.n_cuts = 0;
    m.rule = gsl_integration_glfixed_table_alloc(POINTS);
    m.solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    if (m.rule && m.solver && cut(&m, (long)degrees)) {
        m.mean = mean_of(&m, &scale);
        found = !gsl_isnan(m.mean);
        if (found)
            find(&m, scale, t);
    } else {
        a->out_of_memory = 1;
    }
    free(m.cuts);
    if (m.rule)
        gsl_integration_glfixed_table_free(m.rule);
    if (m.solver)
        gsl_root_fsolver_free(m.solver);
    return found;
}
