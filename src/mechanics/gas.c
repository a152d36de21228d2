/* SPDX-License-Identifier: GPL-3.0-or-later
**
** gas.c - gas in a cylinder: on the piston of a slider-crank, or between rod and cylinder of an inverted
** slider-crank.
**
** Positive towards the crank (ME3491, "Forces on the reciprocating parts of an engine"),
**
**    F = p1 A1 - p2 A2
**
** On the cover side of a piston the volume is (Heywood, Internal Combustion Engine Fundamentals, chapter 2)
**
**    V = V_c + A1 x
**
** with V_c the clearance and x the displacement from the inner dead centre; without a clearance it is the
** volume swept since then.
*/
#include <math.h>
#include <string.h>

#include "base/trig.h"
#include "machine.h"
#include "switch.h"

static double pressure_of(const flk_gas *gas, double theta2, double within)
{
    return gas->indicator.n ? flk_curve_piece(&gas->indicator, theta2, within) : gas->pressure;
}

static double force_of(const flk_gas *gas, double theta2, double held)
{
    return pressure_of(gas, theta2, held) * gas->area - gas->back_pressure * gas->back_area;
}

const flk_gas *flk_gas_on_piston(const flk_machine *machine)
{
    const flk_element *gas = flk_machine_find(machine, &flk_gas_type, 0);

    return gas && gas->n_loads == 1 ? gas->data : NULL;
}

void flk_gas_in_cylinder(const flk_gas *gas, const fourlink_state *state, double within,
                         flk_gas_state *at)
{
    at->volume = gas->clearance + gas->area * state->x;
    at->rate = gas->area * state->v;
    at->pressure = pressure_of(gas, state->link[FOURLINK_CRANK].theta, within);
}

/* p A u on the rod, -p A u on the cylinder, both along the slide: on the rod at B, on the cylinder at the
** point of the slide beside D, or at C. */
static void act_in_cylinder(const fourlink_design *design, double force, fourlink_load load[2])
{
    double sine, cosine;

    load[0].frame = load[1].frame = FOURLINK_FRAME_LINK;
    load[0].force.x = force;
    flk_sine_cosine(design->angle, &sine, &cosine);
    load[1].force.x = -force * cosine;
    load[1].force.y = -force * sine;
    load[1].at.x = design->link[FOURLINK_FOLLOWER].length;
    load[1].at.y = design->offset;
}

static int apply_gas(const flk_element *element, const flk_machine *machine,
                     const fourlink_state *state, fourlink_load *load, flk_acting *acting)
{
    int i;

    for (i = 0; i < element->n_loads; i++) {
        memset(&load[i], 0, sizeof load[i]);
        load[i].link = element->link[i];
    }
    acting->gas_force = force_of(element->data, state->link[FOURLINK_CRANK].theta,
                                 (acting->held ? acting->held : state)->link[FOURLINK_CRANK].theta);
    if (element->n_loads == 1)
        load->force.x = -(double)state->branch * acting->gas_force;
    else
        act_in_cylinder(&machine->mechanism.design, acting->gas_force, load);
    return FOURLINK_OK;
}

static size_t list_gas_switches(const flk_element *element, const flk_machine *machine,
                                flk_switch *list)
{
    const flk_gas *gas = element->data;

    (void)machine;
    return flk_switch_of_curve(&gas->indicator, FLK_THETA2, list);
}

const flk_element_type flk_gas_type = {FOURLINK_LOAD_GAS, apply_gas, list_gas_switches, NULL};

void flk_element_of_gas(flk_gas *gas, fourlink_kind kind, flk_element *element)
{
    int on_piston = fourlink_slides((int)kind, FOURLINK_FOLLOWER) == FOURLINK_GROUND;

    element->type = &flk_gas_type;
    element->name = "gas";
    element->data = gas;
    element->n_loads = on_piston ? 1 : 2;
    element->link[0] = on_piston ? FOURLINK_FOLLOWER : FOURLINK_COUPLER;
    element->link[1] = FOURLINK_FOLLOWER;
}
