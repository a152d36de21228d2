/* SPDX-License-Identifier: GPL-3.0-or-later
**
** switch.c - where a machine is not smooth: a variable of its state crosses one of its levels.
*/
#include <math.h>

#include "base/cycle.h"
#include "kind.h"
#include "friction.h"
#include "switch.h"

static const double zero = 0;

size_t flk_switch_of_curve(const curve *c, flk_variable over, flk_switch *s)
{
    flk_switch_at_zero(over, s);
    s->period = c->period;
    s->level = c->x;
    s->n = c->n;
    return c->n > 0;
}

size_t flk_switch_at_zero(flk_variable of, flk_switch *s)
{
    s->of = of;
    s->joint = 0;
    s->element = NULL;
    s->period = 0;
    s->level = &zero;
    s->n = 1;
    return 1;
}

size_t flk_switch_of_element(const flk_element *element, flk_switch *s)
{
    flk_switch_at_zero(FLK_X, s);
    s->element = element;
    return 1;
}

/* Friction reverses where a joint is at rest. */
static size_t list_joint_switches(const flk_machine *m, flk_switch *list)
{
    const flk_kind *kind = flk_kind_of(m->mechanism.design.kind);
    size_t n = 0;
    int joint;

    for (joint = 1; joint < 4 && m->has_friction; joint++) {
        if (!(flk_friction_of(kind, joint, &m->friction) > 0))
            continue;
        if (list) {
            flk_switch_at_zero(FLK_THETA2, &list[n]);
            list[n].joint = joint;
        }
        n++;
    }
    return n;
}

size_t flk_switch_list(const flk_machine *m, flk_switch *list)
{
    flk_switch own[FLK_ELEMENT_SWITCHES];
    size_t n = list_joint_switches(m, list), k, i;

    for (k = 0; k < m->n_elements; k++) {
        const flk_element *e = &m->element[k];
        size_t of_element = e->type->switches ? e->type->switches(e, m, own) : 0;

        for (i = 0; i < of_element; i++, n++)
            if (list)
                list[n] = own[i];
    }
    return n;
}

int flk_switch_is_of_position(const flk_switch *s)
{
    return s->joint || !FLK_IS_SPEED(s->of) || (s->n == 1 && s->level[0] == 0);
}

double flk_switch_value(const flk_machine *m, const flk_switch *s, const fourlink_state *state)
{
    const flk_kind *kind = flk_kind_of(m->mechanism.design.kind);

    if (s->element)
        return s->element->type->switching(s->element, m, state);
    return s->joint ? flk_friction_speed(&m->mechanism, state, &kind->joint[s->joint])
                    : flk_variable_value(state, s->of);
}

size_t flk_switch_below(const double *level, size_t n, double x)
{
    size_t low = 0, high = n;

    while (low < high) {
        size_t middle = (low + high) / 2;

        if (level[middle] < x)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The number of levels below x, counted through all periods. */
static double count_below(const flk_switch *s, double x)
{
    double turns = s->period > 0 ? flk_cycle_count(x - s->level[0], s->period) : 0;

    x -= turns * s->period;
    return turns * (double)s->n + (double)flk_switch_below(s->level, s->n, x);
}

double flk_switch_level(const flk_switch *s, double number)
{
    double turns = s->period > 0 ? flk_cycle_count(number, (double)s->n) : 0;

    return s->level[(size_t)(number - turns * (double)s->n)] + turns * s->period;
}

size_t flk_switch_passes(const flk_switch *s, double from, double to, double *first, int *step)
{
    double below = count_below(s, from), after = count_below(s, to);

    *step = after > below ? 1 : -1;
    *first = after > below ? below : below - 1;
    return (size_t)fabs(after - below);
}
