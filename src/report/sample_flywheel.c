/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_flywheel.c - the flywheel in the sample calculation: the areas between the turning moment and its
** mean, the fluctuation of energy, and what moment of inertia it needs.
*/
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "mathml.h"
#include "report.h"
#include "sample_flywheel.h"

#define MOST_AREAS 12 /* that are written; more are of no use to a reader */

/* Area i in the order of the motion. */
static const fourlink_area *area_of(const fourlink_turning *t, double omega, int i)
{
    return &t->area[omega < 0 ? t->n_areas - 1 - i : i];
}

/* E1 + E2 + ... up to area n; 0 of none. */
static const char *sum_of(int n, char out[MATH_EQUATION])
{
    char name[MATH_NAME];
    int i;

    flk_text_join(out, MATH_EQUATION, n ? "" : "0", (char *)NULL);
    for (i = 1; i <= n; i++) {
        char before[MATH_EQUATION];

        sprintf(name, "E%d", i);
        flk_text_join(before, sizeof before, out, (char *)NULL);
        flk_text_join(out, MATH_EQUATION, before, i > 1 ? " + " : "", name, (char *)NULL);
    }
    return out;
}

/* The energy that the flywheel has taken up is greatest after one area, and least after another. */
static void put_areas(math *m, const fourlink_turning *t, double omega)
{
    double E = 0, highest = 0, lowest = 0;
    int after_highest = 0, after_lowest = 0, i;
    char sum[MATH_EQUATION], name[MATH_NAME];

    page_print(m->p,
               "<p>Areas E between the turning moment \342\210\222T<sub>s</sub> and its mean, in "
               "the order of the motion from the beginning of the cycle:</p>\n<ul "
               "class=\"given\">\n");
    for (i = 0; i < t->n_areas; i++) {
        double energy = area_of(t, omega, i)->energy;

        E += energy;
        sprintf(name, "E%d", i + 1);
        math_given(m, name, energy);
        if (E > highest) {
            highest = E;
            after_highest = i + 1;
        }
        if (E < lowest) {
            lowest = E;
            after_lowest = i + 1;
        }
    }
    page_print(m->p, "</ul>\n<p>The largest and the smallest energy of the flywheel, and the "
                     "fluctuation between them:</p>\n");
    math_let(m, "Emax", sum_of(after_highest, sum), highest);
    math_let(m, "Emin", sum_of(after_lowest, sum), lowest);
    math_let(m, "DE", "Emax - Emin", t->energy_fluctuation);
}

/* A moment of inertia has energies divided by squares of angular speeds, which may need a factor. */
static void put_inertia(report *r, math *m, const fourlink_turning *t, double omega)
{
    double given = r->v.problem.flywheel_inertia, per = 1 / m->units.per_force;
    double all = t->energy_fluctuation / (t->fluctuation * omega * omega), rotor = all - t->inertia;
    char equation[MATH_EQUATION];

    page_print(m->p, given > 0 ? "<p>The coefficient of fluctuation of speed that a flywheel "
                                 "I<sub>f</sub> leaves:</p>\n"
                               : "<p>The flywheel I<sub>f</sub> for the coefficient of fluctuation "
                                 "of speed C<sub>s</sub>:</p>\n");
    page_print(m->p, "<ul class=\"given\">\n");
    if (given > 0)
        math_given(m, "If", t->inertia);
    else
        math_given(m, "Cs", t->fluctuation);
    math_set(m, "Ir", fabs(rotor) > 1e-6 * all ? rotor : 0);
    if (fabs(rotor) > 1e-6 * all)
        math_given(m, "Ir", rotor);
    page_print(m->p, "</ul>\n");
    if (fabs(rotor) > 1e-6 * all)
        page_print(m->p, "<p>I<sub>r</sub> is the inertia of the motor's rotor.</p>\n");
    if (given > 0) {
        math_let(m, "Cs", math_units_over(equation, "{ DE | ( If <Ir + Ir > ) * omega ^2 }", per),
                 t->fluctuation);
        return;
    }
    math_units_over(equation, "{ DE | Cs * omega ^2 }", per);
    flk_text_join(equation + strlen(equation), sizeof equation - strlen(equation), " <Ir - Ir >",
                  (char *)NULL);
    math_let(m, "If", equation, t->inertia);
}

/* The speed at which the turning moment is found: that of the crank, or the mean of a steady motion; 0
** if there is none. */
static double speed_of(const fourlink_turning *t)
{
    return t->mean_torque != 0 ? t->mean_power / t->mean_torque : 0;
}

/* See results/mean.c. */
void sample_put_flywheel(report *r, math *m)
{
    fourlink_turning t;
    char equation[MATH_EQUATION];
    double omega;

    if (r->v.problem.mechanism.drive ||
        fourlink_results_turning(r->v.results, r->now.branch, &t) != FOURLINK_OK ||
        !(t.energy_fluctuation > 0) || t.n_areas > MOST_AREAS)
        return;
    omega = speed_of(&t);
    page_print(m->p, "<h3>Turning moment and flywheel</h3>\n");
    if (omega != 0) {
        page_print(m->p,
                   "<p>The mean T<sub>m</sub> of the turning moment over the cycle "
                   "\316\270<sub>c</sub>, at the "
                   "%sspeed \317\211:</p>\n<ul class=\"given\">\n",
                   r->v.problem.mode == FOURLINK_MODE_GIVEN ? "" : "mean ");
        math_given(m, "Tm", t.mean_torque);
        math_given(m, "omega", omega);
        math_given(m, "thetac", r->v.problem.cycle);
        page_print(m->p, "</ul>\n");
        math_let(m, "Pm", math_units_over(equation, "Tm * omega", m->units.per_power),
                 t.mean_power);
    }
    put_areas(m, &t, omega < 0 ? -1 : omega > 0 ? 1 : r->now.row.crank.omega2);
    if (t.has_coefficient) {
        page_print(m->p, "<p>The coefficient of fluctuation of energy:</p>\n");
        math_let(m, "Ce", t.mean_torque < 0 ? "- { DE | Tm * thetac }" : "{ DE | Tm * thetac }",
                 t.energy_coefficient);
    }
    if (omega != 0 && t.inertia > 0 && t.fluctuation > 0)
        put_inertia(r, m, &t, omega);
}
