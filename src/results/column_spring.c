/* SPDX-License-Identifier: GPL-3.0-or-later
**
** column_spring.c - the columns of springs and dampers.
*/
#include <gsl/gsl_math.h>

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

const flk_column_source flk_spring_columns = {
    NULL, 0, count_springs, make_of_spring, NULL, value_of_spring, NULL, 0};
