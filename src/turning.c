/* SPDX-License-Identifier: GPL-3.0-or-later
**
** turning.c - the turning moment over a cycle, and the flywheel that it needs.
**
** With T = -Ts the turning moment, Tm its mean over the cycle of angle c, and the load torque equal to
** Tm, the flywheel takes up the difference:
**
**    E(theta) = integral of (T - Tm) dtheta,    dE = max E - min E
**    coefficient of fluctuation of energy dE / (Tm c),   of speed Cs = dE / (I omega^2)
**
** E has its extremes where T crosses Tm: those crossings are found by GSL's root finder, and the areas
** between them by its quadrature.
*/
#include <math.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>

#include "turning.h"

typedef struct moment {
    analysis *a;
    fourlink_branch branch;
    fourlink_crank crank;
    double mean;
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

#define STEP (M_PI / 180)

static double area(gsl_function *f, double from, double to, gsl_integration_cquad_workspace *w)
{
    double sum = 0;

    if (to > from)
        gsl_integration_cquad(f, from, to, 0, 1e-11, w, &sum, NULL, NULL);
    return sum;
}

static double crossing(gsl_function *f, double low, double high, gsl_root_fsolver *solver)
{
    int i;

    gsl_root_fsolver_set(solver, f, low, high);
    for (i = 0; i < 100; i++)
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS ||
            gsl_root_test_interval(gsl_root_fsolver_x_lower(solver),
                                   gsl_root_fsolver_x_upper(solver), 1e-14, 0) == GSL_SUCCESS)
            break;
    return gsl_root_fsolver_root(solver);
}

/* The mean over the cycle, and the scale of the moment; NaN if it is not defined all round. */
static double mean_of(gsl_function *f, long steps, double cycle, double *scale,
                      gsl_integration_cquad_workspace *w)
{
    double sum = 0, step = cycle / (double)steps;
    long i;

    *scale = 0;
    for (i = 0; i < steps; i++) {
        double T = GSL_FN_EVAL(f, (double)i * step);

        if (gsl_isnan(T))
            return GSL_NAN;
        if (fabs(T) > *scale)
            *scale = fabs(T);
    }
    for (i = 0; i < steps; i += 30)
        sum += area(f, (double)i * step, (double)(i + 30 < steps ? i + 30 : steps) * step, w);
    return sum / cycle;
}

static void find_fluctuation(gsl_function *f, long steps, double cycle, gsl_root_fsolver *solver,
                             gsl_integration_cquad_workspace *w, turning *t)
{
    double step = cycle / (double)steps, from = 0, E = 0, least = 0, greatest = 0;
    double before = GSL_FN_EVAL(f, 0);
    long i;

    t->from = t->to = 0;
    for (i = 1; i <= steps; i++) {
        double x = (double)i * step, now = GSL_FN_EVAL(f, x);

        if ((before < 0) != (now < 0) || i == steps) {
            double at = (before < 0) != (now < 0) ? crossing(f, x - step, x, solver) : x;

            E += area(f, from, at, w);
            from = at;
            if (E < least) {
                least = E;
                t->from = at;
            }
            if (E > greatest) {
                greatest = E;
                t->to = at;
            }
        }
        before = now;
    }
    t->energy_fluctuation = greatest - least;
}

int turning_find(analysis *a, fourlink_branch branch, turning *t)
{
    const deck *d = a->d;
    gsl_integration_cquad_workspace *w = gsl_integration_cquad_workspace_alloc(100);
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    double omega = d->motion.speed, scale = 0;
    long steps = (long)floor(d->cycle / STEP + 0.5);
    moment m;
    gsl_function f;
    int found = 0;

    m.a = a;
    m.branch = branch;
    m.crank.theta2 = 0;
    m.crank.omega2 = omega;
    m.crank.alpha2 = 0;
    m.mean = 0;
    f.function = excess;
    f.params = &m;
    if (w && solver && d->has_forces && omega != 0 && d->motion.acceleration == 0 && steps > 0 &&
        steps < 100000) {
        m.mean = mean_of(&f, steps, d->cycle, &scale, w);
        found = !gsl_isnan(m.mean);
    }
    if (found) {
        if (fabs(m.mean) <= 1e-12 * scale)
            m.mean = 0;
        t->mean_torque = m.mean;
        t->mean_power = m.mean * omega;
        find_fluctuation(&f, steps, d->cycle, solver, w, t);
        t->has_coefficient = m.mean != 0;
        t->energy_coefficient = m.mean != 0 ? t->energy_fluctuation / fabs(m.mean * d->cycle) : 0;
        t->inertia = d->flywheel_inertia;
        t->fluctuation = d->flywheel_fluctuation;
        if (t->inertia > 0)
            t->fluctuation = t->energy_fluctuation / (t->inertia * omega * omega);
        else if (t->fluctuation > 0)
            t->inertia = t->energy_fluctuation / (t->fluctuation * omega * omega);
    }
    if (w)
        gsl_integration_cquad_workspace_free(w);
    if (solver)
        gsl_root_fsolver_free(solver);
    return found;
}
