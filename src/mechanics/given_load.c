/* SPDX-License-Identifier: GPL-3.0-or-later
**
** given_load.c - a given force and torque on a link: constant or a function of a position or a speed,
** within a range of crank angles.
*/
#include <math.h>

#include "base/cycle.h"
#include "machine.h"
#include "switch.h"

#define ROUNDING 1e-12 /* of the cycle */

/* 1 if the load acts at a crank angle: if the crank has passed the edge where it enters the range later than
** the other.  It acts at the edge where the crank enters its range, but not where it leaves it. */
static int is_on(const flk_given_load *given, double cycle, double theta2, int sense)
{
    const double *window = given->window;
    int first = sense < 0;

    if (!given->is_windowed || window[1] - window[0] >= cycle * (1 - ROUNDING))
        return 1;
    return flk_cycle_place(sense * (theta2 - window[first]), 0, cycle) <
           flk_cycle_place(sense * (theta2 - window[!first]), 0, cycle);
}

/* value sign(w) (|w| / at_speed)^exponent, with the sign of a speed `within` the cell; if linear, it has no
** corner. */
static double follow_speed(const flk_given_load *given, double w, double within)
{
    double factor = w == 0 ? 0 : pow(fabs(w) / given->at_speed, given->exponent);

    return (given->exponent == 1 ? w : within) < 0 ? -factor : factor;
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
    const flk_given_load *given = element->data;
    const fourlink_state *cell = acting->held ? acting->held : state;
    double x = flk_variable_value(state, given->over), factor;
    double x_held = flk_variable_value(cell, given->over);

    *load = given->load;
    if (given->is_unknown)
        return FOURLINK_OK;
    if (given->at_speed > 0) {
        factor = follow_speed(given, x, x_held);
        load->torque = given->values.torque * factor;
        load->force.x = given->values.force.x * factor;
        load->force.y = given->values.force.y * factor;
    } else if (is_on(given, machine->cycle, x_held, acting->sense)) {
        int falls = given->has_back &&
                    flk_variable_falls(&machine->mechanism, cell, given->over, acting->sense);

        set_load(falls ? &given->back : &given->values, x, FLK_IS_SPEED(given->over) ? x : x_held,
                 load);
    }
    return FOURLINK_OK;
}

/* The points of its curves, the edges of its range, and where its speed or that of its variable is 0. */
static size_t list_load_switches(const flk_element *element, const flk_machine *machine,
                                 flk_switch *list)
{
    const flk_given_load *given = element->data;
    size_t n = flk_switch_of_curve(&given->values.torque_curve, given->over, list);

    n += flk_switch_of_curve(&given->values.force_curve[0], given->over, list + n);
    n += flk_switch_of_curve(&given->back.torque_curve, given->over, list + n);
    n += flk_switch_of_curve(&given->back.force_curve[0], given->over, list + n);
    if (given->is_windowed) {
        flk_switch_at_zero(FLK_THETA2, list + n);
        list[n].period = machine->cycle;
        list[n].level = given->window;
        list[n++].n = given->window[1] - given->window[0] < machine->cycle * (1 - 1e-12) ? 2 : 1;
    }
    if (given->at_speed > 0)
        n += flk_switch_at_zero(given->over, list + n);
    if (given->has_back && given->over != FLK_THETA2)
        n += flk_switch_at_zero(FLK_RATE_OF(given->over), list + n);
    return n;
}

const flk_element_type flk_given_load_type = {FOURLINK_LOAD_OWN, apply_given_load,
                                              list_load_switches, NULL};

void flk_element_of_given_load(flk_given_load *given, flk_element *element)
{
    element->type = &flk_given_load_type;
    element->data = given;
    element->n_loads = 1;
    element->link[0] = given->load.link;
    element->needs_motion = given->over != FLK_THETA2 || given->has_back;
    element->needs_angles = given->over == FLK_THETA4;
    element->has_torque = given->values.torque != 0 || given->values.torque_curve.n > 0;
}
