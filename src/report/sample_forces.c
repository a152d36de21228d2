/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_forces.c - the nine equations of the sample calculation, with their numbers, their solution, and the
** check by virtual work.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/text.h"
#include "mathml.h"
#include "report.h"
#include "sample_drive.h"
#include "sample_friction.h"
#include "sample_forces.h"
#include "sample_motion.h"
#include "sample_output_forces.h"
#include "sample_sides.h"
#include "system/format.h"
#include "view/notation.h"

static double dot(fourlink_vector u, fourlink_vector v)
{
    return u.x * v.x + u.y * v.y;
}

/* ------------------------------------------------------------------------------ accelerations */

static const char *const names[5][4] = {{NULL},
                                        {NULL},
                                        {"rho2x", "rho2y", "aG2x", "aG2y"},
                                        {"rho3x", "rho3y", "aG3x", "aG3y"},
                                        {"rho4x", "rho4y", "aG4x", "aG4y"}};

/* Links 2 and 4 turn about fixed pins; link 3 moves with B. */
static const char *const of_centre[5][2] = {
    {NULL},
    {NULL},
    {"<alpha2 - alpha2 * rho2y > - omega2 ^2 * rho2x",
     "<alpha2 alpha2 * rho2x > - omega2 ^2 * rho2y"},
    {"aBx - alpha3 * rho3y - omega3 ^2 * rho3x", "aBy + alpha3 * rho3x - omega3 ^2 * rho3y"},
    {"- alpha4 * rho4y - omega4 ^2 * rho4x", "alpha4 * rho4x - omega4 ^2 * rho4y"}};

static void put_arm(report *r, math *m, const fourlink_body *b, int link)
{
    page_print(m->p, "<p>The %s:</p>\n<ul class=\"given\">\n", r->v.kind.link[link]);
    math_given(m, names[link][0], b->arm.x);
    math_given(m, names[link][1], b->arm.y);
    page_print(m->p, "</ul>\n");
}

static void put_centre(report *r, math *m, const fourlink_body *b, int link)
{
    put_arm(r, m, b, link);
    math_let(m, names[link][2], of_centre[link][0], b->acceleration.x);
    math_let(m, names[link][3], of_centre[link][1], b->acceleration.y);
}

/* 1 if link 4 slides on the ground, and its centre of mass is not at C. */
static int has_arm(const report *r, const fourlink_body bodies[5])
{
    return r->v.kind.guided && r->v.design->link[4].mass > 0 &&
           (bodies[4].arm.x != 0 || bodies[4].arm.y != 0);
}

static void put_centres(report *r, math *m, const fourlink_body bodies[5])
{
    int link;

    page_print(m->p,
               "<h3>Accelerations of the centres of mass</h3>\n<p>\317\201 is the vector from a "
               "link's pin (A, B%s) to its centre of mass G.</p>\n",
               has_arm(r, bodies) ? ", C"
               : r->v.kind.guided ? ""
                                  : ", D");
    math_set(m, "omega4", r->now.state.link[4].omega);
    math_set(m, "alpha4", r->now.state.link[4].alpha);
    for (link = 2; link <= 4; link++) {
        if (!(r->v.design->link[link].mass > 0))
            continue;
        if (link == 3 && !math_has(m, "aBx"))
            page_print(m->p, "<p>Pin B:</p>\n");
        if (link == 3)
            sample_put_acceleration_of_B(r, m);
        if (link == r->v.kind.guided) {
            if (has_arm(r, bodies))
                put_arm(r, m, &bodies[4], link);
            math_let(m, "aG4x", "aC", bodies[4].acceleration.x);
        } else if (link == 3 && r->v.kind.has_one_branch) { /* it does not turn */
            math_let(m, "aG3x", "aBx", bodies[3].acceleration.x);
            math_let(m, "aG3y", "aBy", bodies[3].acceleration.y);
        } else
            put_centre(r, m, &bodies[link], link);
    }
}

/* ------------------------------------------------------------------------------ nine equations */

/* What mass times acceleration is divided by, where their units do not go together. */
static void put_factor(math *m)
{
    const math_units *u = &m->units;
    char product[80];

    if (u->per_force != 1)
        page_print(m->p,
                   " Masses are in%U: m a and I \316\261 are divided by %.6g, as 1%U = "
                   "%.6g%U.",
                   u->of[MATH_MASS].name, u->per_force, u->of[MATH_FORCE].name, u->per_force,
                   flk_text_join(product, sizeof product, u->of[MATH_MASS].name, ".",
                                 u->of[MATH_ACCELERATION].name, (char *)NULL));
}

static void put_sides(report *r, math *m, const fourlink_body bodies[FOURLINK_LINKS],
                      const sample_carried *carried, const double b[9])
{
    page *p = m->p;
    int link, i;

    page_print(p,
               "<h3>The nine equations</h3>\n<p>For each moving link the forces along x and along "
               "y, and the moments about its centre of mass; F<sub>ij</sub> is the force of link i "
               "on link j.  What is known stands on the right: mass times acceleration, less "
               "weight, less loads%m.",
               r->v.design->n_groups ? ", less what outputs do" : "");
    put_factor(m);
    page_print(p, "</p>\n");
    sample_begin_sides(r, m, "What is known of the nine equations");
    for (link = 2; link <= 4; link++) {
        sample_side side[3];

        sample_find_sides(&r->v.design->link[link], &bodies[link], &r->now.state.link[link], 0,
                          side);
        side[0].carried = carried->force[link].x;
        side[1].carried = carried->force[link].y;
        side[2].carried = carried->moment[link];
        for (i = 0; i < 3; i++)
            side[i].b = b[3 * (link - 2) + i];
        sample_put_sides(r, m, r->v.kind.link[link], side);
    }
    page_table_end(p);
}

static void put_entry(math *m, double value)
{
    page_print(m->p, "<mtd>");
    math_number(m->p, value);
    page_print(m->p, "</mtd>");
}

/* A coefficient: in the equations of moments a force has an arm, and the torque of a drive on an output
** is a force by way of one. */
static double shown_coefficient(const math *m, double value, int is_moment, int of_torque)
{
    if (of_torque && !is_moment)
        return math_shown(m, value, MATH_ONE) / math_units_value(&m->units, 1, MATH_LENGTH);
    return math_shown(m, value, is_moment && !of_torque ? MATH_LENGTH : MATH_ONE);
}

/* 1 if unknown i is a torque; the ninth is what drives: Ts, or the effort of what drives elsewhere. */
static int is_torque(const report *r, int i)
{
    fourlink_value effort;

    if (i == 8 && r->v.problem.mechanism.drive &&
        fourlink_results_find(r->v.results, "drive", &effort) == FOURLINK_OK)
        return strcmp(effort.quantity, "torque") == 0;
    return strchr("MT", fourlink_unknown_text((int)r->v.kind.kind, i)[0]) != NULL;
}

static const char *name_unknown(const report *r, int i)
{
    return i < 8 || !r->v.problem.mechanism.drive ? fourlink_unknown_text((int)r->v.kind.kind, i)
           : is_torque(r, i)                      ? "Tdrive"
                                                  : "Fdrive";
}

/* A x = b as one table, so that rows stand side by side; the style puts the brackets.  In the equations
** of moments a force has an arm. */
static void put_matrix(report *r, math *m, double A[9][9], const double b[9])
{
    page *p = m->p;
    int i, j;

    math_block(p, "equation wide");
    math_open(p, "matrix");
    page_print(p, "<mtable>\n");
    for (i = 0; i < 9; i++) {
        int is_moment = i % 3 == 2;

        page_print(p, "<mtr>");
        for (j = 0; j < 9; j++)
            put_entry(m, shown_coefficient(m, A[i][j], is_moment, is_torque(r, j)));
        page_print(p, "<mtd>");
        math_symbol(p, name_unknown(r, i));
        page_print(p, "</mtd><mtd>%m</mtd>", i == 4 ? "<mo>=</mo>" : "");
        put_entry(m, math_shown(m, b[i], is_moment ? MATH_TORQUE : MATH_FORCE));
        page_print(p, "</mtr>\n");
    }
    page_print(p, "</mtable>");
    math_close(p);
    page_print(p, "</div>\n");
}

static void put_solution(report *r, math *m)
{
    int i;
    double x[9];

    fourlink_unknowns(&r->v.problem.mechanism, &r->now.forces, x);
    page_print(m->p,
               "<p>The solution of (<a href=\"#equation-%d\">%d</a>):</p>\n<ul class=\"given "
               "solution\">\n",
               m->p->n_equations, m->p->n_equations);
    for (i = 0; i < 9; i++)
        math_given(m, name_unknown(r, i), x[i]);
    page_print(m->p, "</ul>\n");
    if (r->v.problem.mechanism.drive)
        page_print(m->p,
                   "<p>%s<sub>drive</sub> is the %s of what drives. T<sub>s</sub> below is the "
                   "torque on the crank that would do the same work.</p>\n",
                   is_torque(r, 8) ? "T" : "F", is_torque(r, 8) ? "torque" : "force");
    page_print(m->p, "<p>The resultants of the pins:</p>\n");
    math_let(m, "F12", "[ F12x ^2 + F12y ^2 ]", gsl_hypot(x[0], x[1]));
    math_let(m, "F23", "[ F23x ^2 + F23y ^2 ]", gsl_hypot(x[2], x[3]));
    if (!r->v.kind.slotted)
        math_let(m, "F34", "[ F34x ^2 + F34y ^2 ]", gsl_hypot(x[4], x[5]));
    if (!r->v.kind.guided)
        math_let(m, "F14", "[ F14x ^2 + F14y ^2 ]", gsl_hypot(x[6], x[7]));
}

/* ------------------------------------------------------------------------------ virtual work */

/* Write the terms of a link, or their sum. */
static void put_works(math *m, const char *name, const double work[3])
{
    page_row(m->p, "%s|%.6g|%.6g|%.6g", name, math_shown(m, work[0], MATH_TORQUE),
             math_shown(m, work[1], MATH_TORQUE), math_shown(m, work[2], MATH_TORQUE));
}

static const fourlink_link *data_of(const report *r, int link)
{
    return link <= FOURLINK_FOLLOWER ? &r->v.design->link[link]
                                     : &r->v.design->group[(link - 5) / 2].body[(link - 5) % 2];
}

/* 1 if a link of this number is a rod and not a block in a slot. */
static int has_rod(const report *r, int link)
{
    return r->v.design->group[(link - 5) / 2].hang == FOURLINK_HANGS_BY_ROD;
}

/* Virtual work: with the velocities of a unit crank speed,
**
**    Ts = sum (m a_G.v_G + I alpha omega) - sum W.v_G - sum (F.v_P + M omega)
*/
static void put_virtual_work(report *r, math *m, const fourlink_body bodies[5])
{
    double sum[3] = {0, 0, 0}, work[3];
    char caption[SAMPLE_HEADING];
    page *p = m->p;
    int link, i;

    page_print(p,
               "<h3>Check by virtual work</h3>\n<p>The driving torque without the pin forces: the "
               "sum of all forces times the velocities of their points for a unit crank speed, of "
               "all torques times the angular velocities.</p>\n");
    page_table_of(
        p, "facts works",
        sample_with_units(caption, "Terms of virtual work", m->units.of[MATH_TORQUE].name, NULL),
        "Link|m a\302\267v + I \316\261 \317\211|\342\210\222 weight\302\267v|"
        "\342\210\222 loads\302\267v");
    for (link = 2; link <= r->now.state.last; link++) {
        const fourlink_body *b = &bodies[link];
        const fourlink_link *data = data_of(r, link);
        const fourlink_link_state *now = &r->now.state.link[link];

        work[0] = data->mass * dot(b->acceleration, b->k) + data->inertia * now->alpha * now->k;
        work[1] = -dot(b->weight, b->k);
        work[2] = -b->work;
        if (link > FOURLINK_FOLLOWER && link % 2 && !has_rod(r, link))
            continue; /* a block without mass */
        put_works(m, fourlink_deck_link_text(r->v.deck, link), work);
        for (i = 0; i < 3; i++)
            sum[i] += work[i];
    }
    put_works(m, "sum", sum);
    page_table_end(p);
    math_set(m, "Tinertia", sum[0]);
    math_set(m, "Tweight", sum[1]);
    math_set(m, "Tloads", sum[2]);
    math_let(m, "Ts", "Tinertia + Tweight + Tloads", r->now.forces.Ts_work);
    page_print(p,
               "<p>The nine equations give %.6g%U; relative to the largest term of the "
               "balance, the difference is %.2g.</p>\n",
               math_shown(m, r->now.forces.at_crank, MATH_TORQUE), m->units.of[MATH_TORQUE].name,
               fabs(r->now.forces.residual));
}

/* The power of the crank: a torque and a power can have units that do not go together. */
static void put_power(report *r, math *m)
{
    const math_units *u = &m->units;
    double per = u->per_power;
    char equation[MATH_EQUATION], number[FORMAT_SIZE], rate[60];

    math_units_over(equation, "Ts * omega2", per);
    if (per != 1) {
        format_general(per > 1 ? per : 1 / per, 9, number);
        flk_text_join(rate, sizeof rate, u->of[MATH_TORQUE].name, "/s", (char *)NULL);
        page_print(m->p, "<p>The power, where 1%U = %s%U:</p>\n",
                   per > 1 ? u->of[MATH_POWER].name : rate, number,
                   per > 1 ? rate : u->of[MATH_POWER].name);
    }
    math_let(m, "P", equation, r->now.forces.at_crank * r->now.row.crank.omega2);
}

/* Add what drives to the loads of the links of outputs; 1 if it acts on one. */
static int add_drive(report *r, fourlink_body bodies[FOURLINK_LINKS])
{
    fourlink_body more[FOURLINK_LINKS];
    fourlink_load load[2];
    int n, i, acts = 0;

    fourlink_drive_loads(r->v.mechanism, &r->now.state, r->now.forces.drive, load, &n);
    for (i = 0; i < n; i++) {
        int link = load[i].link;

        if (link <= FOURLINK_FOLLOWER)
            continue;
        fourlink_bodies(r->v.mechanism, &r->now.state, &load[i], 1, more);
        bodies[link].force.x += more[link].force.x;
        bodies[link].force.y += more[link].force.y;
        bodies[link].moment += more[link].moment;
        acts = 1;
    }
    return acts;
}

/* Forces of outputs are found first, unless what drives acts on an output: that is the ninth unknown. */
void sample_put_forces(report *r, math *m)
{
    double A[9][9], b[9];
    fourlink_body bodies[FOURLINK_LINKS], driven[FOURLINK_LINKS];
    sample_carried carried;
    int drives;

    fourlink_bodies(&r->v.problem.mechanism, &r->now.state, r->loads, r->v.problem.n_loads, bodies);
    fourlink_system(&r->v.problem.mechanism, &r->now.state, r->loads, r->v.problem.n_loads, A, b);
    memcpy(driven, bodies, sizeof driven);
    drives = r->v.mechanism->drive && add_drive(r, driven);
    put_centres(r, m, bodies);
    sample_put_output_centres(r, m, bodies);
    sample_find_carried(r, bodies, 0, &carried);
    if (drives)
        page_print(m->p, "<p>What drives acts on an output: it is an unknown of the nine equations "
                         "first, and then a load on the output.</p>\n");
    else
        sample_put_output_forces(r, m, bodies, &carried);
    put_sides(r, m, bodies, &carried, b);
    put_matrix(r, m, A, b);
    put_solution(r, m);
    if (drives) {
        sample_find_carried(r, bodies, 1, &carried);
        sample_put_output_forces(r, m, driven, &carried);
    }
    sample_put_friction(r, m);
    put_virtual_work(r, m, bodies);
    put_power(r, m);
    sample_put_drive(r, m);
}
