/* SPDX-License-Identifier: GPL-3.0-or-later
**
** sample_drive.c - in the sample calculation, the power of what drives a machine that no torque on the
** crank drives: that of its loads, which is also that of the torque on the crank in its place.
*/
#include <math.h>
#include <stdio.h>

#include "base/text.h"
#include "mathml.h"
#include "report.h"
#include "sample_drive.h"

/* The force of one of the loads, E or H, and the velocity of its point. */
static double put_force(report *r, math *m, const fourlink_load *load, char point)
{
    fourlink_vector at, velocity, acceleration;
    char name[MATH_NAME];

    fourlink_point(&r->now.state, load->link, &load->at, &at, &velocity, &acceleration);
    sprintf(name, "F%cx", point);
    math_given(m, name, load->force.x);
    sprintf(name, "F%cy", point);
    math_given(m, name, load->force.y);
    sprintf(name, "v%cx", point);
    math_given(m, name, velocity.x);
    sprintf(name, "v%cy", point);
    math_given(m, name, velocity.y);
    return load->force.x * velocity.x + load->force.y * velocity.y;
}

static void put_product(math *m, const char *product, double power)
{
    char equation[MATH_EQUATION];

    math_let(m, "Pdrive", math_units_over(equation, product, m->units.per_power), power);
}

/* A torque on a link, and the opposite one on the link with its pin. */
static void put_power_of_torque(report *r, math *m, const fourlink_load *load, int n)
{
    char product[60], first[MATH_NAME], second[MATH_NAME];
    double omega = r->now.state.link[load[0].link].omega;

    sprintf(first, "omega%d", load[0].link);
    math_set(m, first, omega);
    sprintf(product, "Tdrive * %s", first);
    if (n > 1) {
        sprintf(second, "omega%d", load[1].link);
        math_set(m, second, r->now.state.link[load[1].link].omega);
        sprintf(product, "Tdrive * ( %s - %s )", first, second);
        omega -= r->now.state.link[load[1].link].omega;
    }
    math_set(m, "Tdrive", load[0].torque);
    put_product(m, product, load[0].torque * omega);
}

static void put_power_of_forces(report *r, math *m, const fourlink_load *load, int n)
{
    double power;

    page_print(m->p, "<p>The force on the %s at its point E",
               fourlink_deck_link_text(r->v.deck, load[0].link));
    if (n > 1)
        page_print(m->p, ", and the opposite one on the %s at H",
                   fourlink_deck_link_text(r->v.deck, load[1].link));
    page_print(m->p, ", and the velocities of these points:</p>\n<ul class=\"given\">\n");
    power = put_force(r, m, &load[0], 'E');
    if (n > 1)
        power += put_force(r, m, &load[1], 'H');
    page_print(m->p, "</ul>\n");
    put_product(m,
                n > 1 ? "FEx * vEx + FEy * vEy + FHx * vHx + FHy * vHy" : "FEx * vEx + FEy * vEy",
                power);
}

/* 1 if a load is the force along the line of a piston or yoke. */
static int is_along(const report *r, const fourlink_load *load, int n)
{
    return n == 1 && r->v.kind.guided == load->link && load->force.y == 0 && load->at.x == 0 &&
           load->at.y == 0;
}

void sample_put_drive(report *r, math *m)
{
    fourlink_load load[2];
    int n;

    if (!r->v.problem.mechanism.drive ||
        fourlink_drive_loads(r->v.mechanism, &r->now.state, r->now.forces.drive, load, &n) !=
            FOURLINK_OK ||
        n == 0)
        return;
    page_print(m->p, "<h3>What drives</h3>\n<p>Its power is that of the torque T<sub>s</sub> "
                     "on the crank in its place:</p>\n");
    if (load[0].torque != 0)
        put_power_of_torque(r, m, load, n);
    else if (is_along(r, load, n) && math_has(m, "vC"))
        put_product(m, "Fdrive * vC", load->force.x * r->now.state.link[4].velocity.x);
    else
        put_power_of_forces(r, m, load, n);
}
