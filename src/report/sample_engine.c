/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_engine.c - the engine method of the sample calculation: the forces along the line of stroke, the
** effort at the crank, and the torque of an engine whose rod is two masses.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/cycle.h"
#include "mathml.h"
#include "report.h"
#include "sample_engine.h"

static int on_open(const report *r)
{
    return r->now.branch == FOURLINK_OPEN;
}

/* An equation on the open branch; on the crossed one, where the piston is on the other side of the
** crankshaft. */
static const char *on_side(const report *r, const char *open, const char *crossed)
{
    return on_open(r) ? open : crossed;
}

/* A product with a mass and an acceleration, which may need a factor. */
static void let_inertial(math *m, const char *name, const char *product, double value)
{
    char equation[MATH_EQUATION];

    math_let(m, name, math_units_over(equation, product, m->units.per_force), value);
}

/* DFA; ME3491: see mechanics/engine.c. */
static void put_masses(report *r, math *m, const fourlink_rod *rod)
{
    const fourlink_design *design = r->v.design;
    int has_rod = design->link[3].mass > 0, has_mass = has_rod || design->link[4].mass > 0;

    page_print(m->p, "<h3>Engine method</h3>\n<p>%s</p>\n<ul class=\"given\">\n",
               has_rod ? "The rod, of mass m, as two masses at its pins; its centre of mass is at "
                         "the distance b from the gudgeon pin:"
                       : "The rod has no mass:");
    math_given(m, "mP", design->link[4].mass);
    math_set(m, "gx", design->gravity.x);
    math_set(m, "gy", design->gravity.y);
    if (has_rod) {
        math_given(m, "m", design->link[3].mass);
        math_given(m, "b", rod->b);
    }
    math_set(m, "m", design->link[3].mass);
    if (has_rod || design->link[3].inertia > 0)
        math_given(m, "I", design->link[3].inertia);
    if (has_mass && (design->gravity.x != 0 || design->gravity.y != 0)) {
        math_given(m, "gx", design->gravity.x);
        math_given(m, "gy", design->gravity.y);
    }
    page_print(m->p, "</ul>\n");
    math_set(m, "ma", 0);
    math_set(m, "mb", 0);
    if (has_rod) {
        math_let(m, "ma", "{ m * b | l }", rod->m_a);
        math_let(m, "mb", "m - ma", rod->m_b);
    }
}

/* Accelerations by the textbook's series, where the deck asks for it. */
static void put_series(report *r, math *m)
{
    const fourlink_state *now = &r->now.state;
    fourlink_series series;

    fourlink_textbook_series(&r->v.problem.mechanism, now, &series);
    page_print(m->p,
               "<p>By the series for a long rod, with \316\270 from the inner dead centre%s:</p>\n",
               on_side(r, ", which is \316\270\342\202\202", ""));
    math_set(m, "theta",
             flk_cycle_beside(on_open(r) ? r->now.row.crank.theta2 : r->now.row.crank.theta2 - M_PI,
                              2 * M_PI));
    math_let(m, "n", "{ l | r }", r->v.design->link[3].length / r->v.design->link[2].length);
    math_let(m, "aP",
             "r * omega2 ^2 * ( cos theta + { cos ( 2 * theta ) | n } ) <alpha2 + r * alpha2 * ( "
             "sin theta + { sin ( 2 * theta ) | 2 * n } ) >",
             series.a);
    if (r->v.problem.approximation == FOURLINK_SERIES_ALL)
        math_let(m, "alpha3",
                 "{ omega2 ^2 * sin theta | n } <alpha2 - { alpha2 * cos theta | n } >",
                 series.alpha3);
}

/* Positive towards the crankshaft. */
static void put_piston_effort(report *r, math *m, const fourlink_rod *rod,
                              const fourlink_engine *engine)
{
    double side = (double)r->now.branch, mass = r->v.design->link[4].mass + rod->m_b;
    double weight = -side * mass * r->v.design->gravity.x;
    double loads = engine->piston_effort - engine->inertia_force - weight - r->now.gas_force;

    page_print(m->p,
               "<p>The piston effort F, positive towards the crankshaft, is the sum of the forces "
               "along the line of stroke: of the gas, of the inertia (I), of the weight (W), of "
               "other loads.</p>\n");
    math_set(m, "Fgas", r->now.gas_force);
    math_set(m, "Fload", loads);
    math_set(m, "FW", weight);
    math_set(m, "FI", engine->inertia_force);
    if (mass > 0)
        let_inertial(m, "FI",
                     r->v.problem.approximation != FOURLINK_EXACT
                         ? "- ( mP + mb ) * aP"
                         : on_side(r, "( mP + mb ) * aC", "- ( mP + mb ) * aC"),
                     engine->inertia_force);
    if (weight != 0)
        let_inertial(m, "FW", on_side(r, "- ( mP + mb ) * gx", "( mP + mb ) * gx"), weight);
    math_let(m, "F", "<Fgas Fgas > <FI + FI > <FW + FW > <Fload + Fload >", engine->piston_effort);
}

static void put_crank_effort(report *r, math *m, const fourlink_engine *engine)
{
    page_print(m->p, "<p>The thrust in the rod, the force of the guide on the piston, and at the "
                     "crank pin the crank effort and the radial force:</p>\n");
    math_let(m, "Frod", on_side(r, "{ F | cos theta3 }", "- { F | cos theta3 }"),
             engine->rod_force);
    math_let(m, "FN",
             on_side(r, "- { F * sin theta3 | cos theta3 }", "{ F * sin theta3 | cos theta3 }"),
             engine->side_thrust);
    math_let(m, "FT",
             on_side(r, "{ F * sin ( theta2 - theta3 ) | cos theta3 }",
                     "- { F * sin ( theta2 - theta3 ) | cos theta3 }"),
             engine->crank_effort);
    math_let(m, "FR",
             on_side(r, "{ F * cos ( theta2 - theta3 ) | cos theta3 }",
                     "- { F * cos ( theta2 - theta3 ) | cos theta3 }"),
             engine->radial_force);
}

static void put_torques(const report *r, math *m, const fourlink_engine *engine, int is_series)
{
    page_print(m->p, "<p>The torques on the crankshaft: of the piston effort");
    page_print(m->p, "%m%m%m:</p>\n",
               engine->correction_couple != 0 ? ", of the correction couple of the two masses" : "",
               engine->T_weight_a != 0 ? ", of the weight of m<sub>a</sub>" : "",
               engine->T_inertia_a != 0 ? ", of its inertia" : "");
    math_let(m, "Tpiston", "FT * r", engine->T_piston);
    math_set(m, "Tcorrection", engine->T_correction);
    math_set(m, "Tweight,a", engine->T_weight_a);
    math_set(m, "Tinertia,a", engine->T_inertia_a);
    if (engine->correction_couple != 0) {
        let_inertial(m, "Tcouple", "( I <m - m * b * ( l - b ) > ) * alpha3",
                     engine->correction_couple);
        math_let(m, "Tcorrection", "Tcouple * { r * cos theta2 | l * cos theta3 }",
                 engine->T_correction);
    }
    if (engine->T_weight_a != 0)
        let_inertial(m, "Tweight,a", "ma * r * ( gy * cos theta2 - gx * sin theta2 )",
                     engine->T_weight_a);
    if (engine->T_inertia_a != 0)
        let_inertial(m, "Tinertia,a", "- ma * r ^2 * alpha2", engine->T_inertia_a);
    math_let(
        m, "Tengine",
        "Tpiston <Tcorrection + Tcorrection > <Tweight,a + Tweight,a > <Tinertia,a + Tinertia,a >",
        engine->T_engine);
    if (r->v.design->n_groups) {
        page_print(m->p, "<p>All this is of the four links alone: T<sub>s</sub> above has what "
                         "the outputs do, too.</p>\n");
        return;
    }
    page_print(m->p,
               "<p>Of a crank without mass, and without friction, T<sub>s</sub> above is "
               "\342\210\222T<sub>engine</sub>%s.</p>\n",
               is_series ? ", but for the error of the series" : "");
}

void sample_put_engine(report *r, math *m)
{
    const fourlink_problem *problem = &r->v.problem;
    fourlink_engine engine;
    fourlink_rod rod;

    if (r->v.design->kind != FOURLINK_SLIDER_CRANK || problem->mechanism.drive ||
        fourlink_rod_masses(&problem->mechanism, &rod) != FOURLINK_OK ||
        fourlink_engine_method(&problem->mechanism, &r->now.state, 0, r->loads, problem->n_loads,
                               problem->approximation, &engine) != FOURLINK_OK ||
        (engine.piston_effort == 0 && engine.inertia_force == 0))
        return;
    put_masses(r, m, &rod);
    if (problem->approximation != FOURLINK_EXACT)
        put_series(r, m);
    put_piston_effort(r, m, &rod, &engine);
    put_crank_effort(r, m, &engine);
    put_torques(r, m, &engine, problem->approximation != FOURLINK_EXACT);
}
