/* SPDX-License-Identifier: GPL-3.0-or-later
**
** own_load.c - a given force and torque on a link: constant or a function of a position or a speed, within a
** range of crank angles.
*/
#include <math.h>

#include "machine.h"
#include "switch.h"

#define ROUNDING 1e-12 /* of the cycle */

/* 1 if the load acts at a crank angle.  It acts at the edge where the crank enters its range, but not where
** it leaves it. */
static int is_on(const flk_own_load *own, double cycle, double theta2, int sense)
{
    double after = sense < 0 ? own->window[1] - theta2 : theta2 - own->window[0];

    if (!own->is_windowed)
        return 1;
    after -= cycle * floor(after / cycle + ROUNDING);
    return after < own->window[1] - own->window[0] - ROUNDING * cycle;
}

/* value sign(w) (|w| / at_speed)^exponent, with the sign of a speed `within` the cell; if linear, it has no
** corner. */
static double follow_speed(const flk_own_load *own, double w, double within)
{
    double factor = w == 0 ? 0 : pow(fabs(w) / own->at_speed, own->exponent);

    return (own->exponent == 1 ? w : within) < 0 ? -factor : factor;
}

/* Set a load to its values, with curves evaluated at x on the piece that contains x_held. */
static void set_load(const flk_load_values *values, double x, double x_held, fourlink_load *load)
{
    load->torque =
        values->torque_curve.n ? flk_curve_piece(&values->torque_curve, x, x_held) : values->torque;
    load->force = values->force;
    if (values->force_curve[0].n) {
        load->force.x = flk_curve_piece(&values->force_curve[0], x, x_held);
        load->force.y = flk_curve_piece(&values->force_curve[1], x, x_held);
    }
}

static int apply_given_load(const flk_element *element, const flk_machine *machine,
                            const fourlink_state *state, fourlink_load *load, flk_acting *acting)
{
    const flk_own_load *own = element->data;
    const fourlink_state *cell = acting->held ? acting->held : state;
    double x = flk_variable_value(state, own->over), factor;
    double x_held = flk_variable_value(cell, own->over);

    *load = own->load;
    if (own->at_speed > 0) {
        factor = follow_speed(own, x, x_held);
        load->torque = own->values.torque * factor;
        load->force.x = own->values.force.x * factor;
        load->force.y = own->values.force.y * factor;
    } else if (is_on(own, machine->cycle, x_held, acting->sense)) {
        int falls = own->has_back &&
                    flk_variable_falls(&machine->mechanism, cell, own->over, acting->sense);

        set_load(falls ? &own->back : &own->values, x, FLK_IS_SPEED(own->over) ? x : x_held, load);
    }
    return FOURLINK_OK;
}

/* The points of its curves, the edges of its range, and where its speed or that of its variable is 0. */
static size_t list_load_switches(const flk_element *element, const flk_machine *machine,
                                 flk_switch *list)
{
    const flk_own_load *own = element->data;
    size_t n = flk_switch_of_curve(&own->values.torque_curve, own->over, list);

    n += flk_switch_of_curve(&own->values.force_curve[0], own->over, list + n);
    n += flk_switch_of_curve(&own->back.torque_curve, own->over, list + n);
    n += flk_switch_of_curve(&own->back.force_curve[0], own->over, list + n);
    if (own->is_windowed) {
        flk_switch_at_zero(FLK_THETA2, list + n);
        list[n].period = machine->cycle;
        list[n].level = own->window;
        list[n++].n = own->window[1] - own->window[0] < machine->cycle * (1 - 1e-12) ? 2 : 1;
    }
    if (own->at_speed > 0)
        n += flk_switch_at_zero(own->over, list + n);
    if (own->has_back && own->over != FLK_THETA2)
        n += flk_switch_at_zero(FLK_RATE_OF(own->over), list + n);
    return n;
}

const flk_sort flk_own_sort = {FOURLINK_LOAD_OWN, apply_given_load, list_load_switches, NULL};

void flk_element_of_own(flk_own_load *own, flk_element *element)
{
    element->sort = &flk_own_sort;
    element->data = own;
    element->n_loads = 1;
    element->link[0] = own->load.link;
    element->needs_motion = own->over != FLK_THETA2 || own->has_back;
    element->needs_angles = own->over == FLK_THETA4;
    element->has_torque = own->values.torque != 0 || own->values.torque_curve.n > 0;
}
