/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample.c - the sample calculation of a report, as a textbook writes it.
*/
#include "mathml.h"
#include "report.h"
#include "sample_engine.h"
#include "sample_flywheel.h"
#include "sample_forces.h"
#include "sample_input.h"
#include "sample_klein.h"
#include "sample_limits.h"
#include "sample_motion.h"
#include "sample_output.h"
#include "sample_program.h"
#include "view/rounding.h"

static void set_sizes(const report *r, math *m)
{
    static const quantity quantities[MATH_UNITS] = {
        QUANTITY_LENGTH,        QUANTITY_AREA,
        QUANTITY_ANGLE,         QUANTITY_NUMBER,
        QUANTITY_SPEED,         QUANTITY_ACCELERATION,
        QUANTITY_ANGULAR_SPEED, QUANTITY_ANGULAR_ACCELERATION,
        QUANTITY_FORCE,         QUANTITY_TORQUE,
        QUANTITY_ENERGY,        QUANTITY_POWER,
        QUANTITY_MASS,          QUANTITY_INERTIA,
        QUANTITY_TIME};
    double sizes[QUANTITY_COUNT];
    int i;

    view_find_sizes(&r->v, &r->now, r->loads, sizes);
    for (i = 0; i < MATH_UNITS; i++)
        m->size[i] = sizes[quantities[i]];
}

void report_put_sample(report *r)
{
    page *p = &r->page;
    math m;

    if (r->now.status != FOURLINK_OK) {
        page_print(p, "<p>At \316\270\342\202\202 = %s there is none: %s.</p>\n", r->at,
                   fourlink_status_text(r->now.status));
        return;
    }
    if (*r->why)
        page_print(p, "<p>Chosen position: %s.</p>\n", r->why);
    math_begin(&m, p, r->v.units);
    set_sizes(r, &m);
    page_print(p,
               "<p>At \316\270\342\202\202 = %s, %s branch, in%U,%U and s; angles and torques are "
               "positive counter-clockwise.  Numbers are computed with 16 digits and printed with "
               "%d, angles with four decimals.</p>\n",
               r->at, fourlink_branch_text((int)r->now.branch), m.units.of[MATH_LENGTH].name,
               m.units.of[MATH_FORCE].name, MATH_DIGITS);
    if (r->v.problem.axes_on_page)
        page_print(p,
                   "<p>These equations are in the axes of link 1. Its x axis is at %.9g%U on the "
                   "page, and "
                   "\316\270\342\202\202 there is %.9g%U.</p>\n",
                   view_value(&r->v, QUANTITY_ANGLE, r->v.problem.x_angle),
                   r->v.units[QUANTITY_ANGLE].name,
                   view_value(&r->v, QUANTITY_ANGLE, r->now.row.crank.theta2),
                   r->v.units[QUANTITY_ANGLE].name);
    sample_put_program(r, &m);
    sample_put_motion(r, &m);
    sample_put_input(r, &m);
    sample_put_klein(r, &m);
    sample_put_limits(r, &m);
    sample_put_outputs(r, &m);
    if (r->v.problem.has_forces) {
        sample_put_forces(r, &m);
        sample_put_engine(r, &m);
        sample_put_flywheel(r, &m);
    } else {
        page_print(p, "<p>The deck has no masses and no loads, so there are no forces.</p>\n");
    }
}
