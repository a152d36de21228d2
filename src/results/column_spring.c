/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_spring.c - the columns of springs and dampers.
*/
#include <math.h>

#include <gsl/gsl_math.h>

#include "base/trig.h"
#include "column_list.h"
#include "column_source.h"
#include "mechanics/spring.h"

/* The columns of springs, and of torsional ones. */
#define SPRING_INFO(q, traits, meaning)                                                \
    {                                                                                  \
        "", QUANTITY_##q, ALL, 0, HAS_CORNERS | traits, NULL, VALUE, 0, 0, meaning, "" \
    }
#define OF_BOTH                                     \
    SPRING_INFO(ENERGY, 0, "energy of the spring"), \
        SPRING_INFO(POWER, 0, "power that spring and damper put into the links")
static const flk_column_info spring_table[2][FLK_ELEMENT_COLUMNS] = {
    {SPRING_INFO(LENGTH, 0, "length of the spring"), SPRING_INFO(FORCE, 0, "tension of the spring"),
     OF_BOTH},
    {SPRING_INFO(ANGLE, COUNTS_TURNS, "angle of the spring, which counts turns"),
     SPRING_INFO(TORQUE, 0, "torque of the spring, -T on 'link' and T on 'to'"), OF_BOTH}};

static size_t count_springs(const deck *d)
{
    return FLK_ELEMENT_COLUMNS * flk_machine_count(&d->machine, &flk_spring_type);
}

static int make_of_spring(const flk_analysis *a, size_t i, flk_column *c)
{
    const flk_element *e =
        flk_machine_find(&a->d->machine, &flk_spring_type, i / FLK_ELEMENT_COLUMNS);
    const fourlink_spring *spring = e->data;
    int component = (int)(i % FLK_ELEMENT_COLUMNS);

    flk_column_start(a->d, &spring_table[spring->is_torsional != 0][component], c);
    c->name = e->column_names[component];
    c->of.spring = spring;
    c->component = component;
    c->is_usual = component < 2;
    return 1;
}

static double value_of_spring(const flk_column *c, const flk_row *row)
{
    fourlink_spring_state at;

    if (fourlink_spring_at(&c->d->machine.mechanism, &row->at.state, c->of.spring, &at) !=
        FOURLINK_OK)
        return GSL_NAN;
    return c->component == 0   ? at.length
           : c->component == 1 ? at.force
           : c->component == 2 ? at.energy
                               : at.power;
}

/* How far an end of a spring is from A, and how fast it is, added to d and u.  Links 3 and 4 are placed
** and moved by the crank: where they stand still, that is the difference of speeds such as the crank
** pin's. */
static void add_end(const fourlink_mechanism *mechanism, const fourlink_state *state, int link,
                    const fourlink_vector *at, double *d, double *u)
{
    double r = mechanism->design.link[FOURLINK_CRANK].length;
    fourlink_vector P = *at, v = {0, 0};

    if (link != FOURLINK_GROUND)
        fourlink_point(state, link, at, &P, &v, NULL);
    *d += flk_length(P.x, P.y);
    *u += flk_length(v.x, v.y);
    if (link > FOURLINK_CRANK) {
        *d += r;
        *u += r * fabs(state->link[FOURLINK_CRANK].omega);
    }
}

/* The same of a torsional spring: half a turn, and how fast the link turns. */
static void add_turning(const fourlink_state *state, int link, double *d, double *u)
{
    *d += M_PI;
    if (link != FOURLINK_GROUND)
        *u += fabs(state->link[link].omega);
    if (link > FOURLINK_CRANK)
        *u += fabs(state->link[FOURLINK_CRANK].omega);
}

/* The rounding error of a spring follows from that of d and u: those of the force are k d and c u, of
** the energy F d with the force F of the spring without its damper, and of the power that of the force
** times u. */
static double size_of_spring(const flk_column *c, const flk_row *row)
{
    const fourlink_mechanism *mechanism = &c->d->machine.mechanism;
    const fourlink_state *state = &row->at.state;
    const fourlink_spring *spring = c->of.spring;
    double d = 0, u = 0, F = 0, size[FLK_ELEMENT_COLUMNS];
    fourlink_spring_state at;

    if (spring->is_torsional) {
        add_turning(state, spring->link, &d, &u);
        add_turning(state, spring->to, &d, &u);
    } else {
        add_end(mechanism, state, spring->link, &spring->at, &d, &u);
        add_end(mechanism, state, spring->to, &spring->to_at, &d, &u);
    }
    if (fourlink_spring_at(mechanism, state, spring, &at) == FOURLINK_OK)
        F = spring->stiffness * (at.length - spring->free_length) + spring->preload;
    size[0] = d;
    size[1] = fabs(spring->stiffness) * d + fabs(spring->preload) + spring->damping * u;
    size[2] = fabs(F) * d;
    size[3] = size[1] * u;
    return size[c->component];
}

const flk_column_source flk_spring_columns = {
    NULL, 0, count_springs, make_of_spring, NULL, value_of_spring, NULL, size_of_spring, 0};
