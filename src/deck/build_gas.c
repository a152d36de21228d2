/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_gas.c - builds [gas] from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "build.h"
#include "build_curve.h"
#include "build_mechanism.h"
#include "parser.h"
#include "settings.h"
#include "values.h"

/* The volume that a clearance leaves at the inner dead centre: given as such, as the length of this volume in
** the cylinder, or as a share of the displacement.  0 if there is none. */
static double clearance_of(parser *p, const section_use *use, double area)
{
    const setting *s = flk_setting_of(use, KEY_GAS_CLEARANCE);
    fourlink_limits limits;

    if (!IS_SET(s) || use->is_mistaken)
        return 0;
    switch (flk_quantity_of_key(use, KEY_GAS_CLEARANCE)) {
    case QUANTITY_VOLUME:
        return s->si[0];
    case QUANTITY_LENGTH:
        return s->si[0] * area;
    default:
        if (fourlink_limits_of(&p->d->machine.mechanism, FOURLINK_OPEN, &limits) != FOURLINK_OK)
            return 0; /* a mistake elsewhere */
        if (!limits.has_stroke)
            flk_mistake(
                p->mistakes, s->place,
                "a clearance of %t is a share of the displacement, which needs a crank that "
                "turns fully: give a length or a volume",
                s->value);
        return s->si[0] * area * limits.stroke;
    }
}

void flk_build_gas(parser *p)
{
    section_use *use = flk_section_find(p, SECTION_GAS, NULL);
    const setting *bore = flk_setting_find(p, KEY_GAS_BORE),
                  *rod = flk_setting_find(p, KEY_GAS_PISTON_ROD);
    const setting *pressure = flk_setting_find(p, KEY_GAS_PRESSURE),
                  *card = flk_setting_find(p, KEY_GAS_INDICATOR);
    double d_rod = rod->si[0];
    flk_element *element;
    flk_gas *gas;

    if (!use || !flk_build_has(p, KEY_GAS_BORE))
        return;
    p->d->has_forces = 1;
    if (!IS_SET(bore)) {
        if (!use->is_mistaken)
            flk_mistake(p->mistakes, use->place, "[gas] has no bore");
        return;
    }
    if (!use->is_mistaken && !IS_SET(pressure) && !IS_SET(card) &&
        !IS_SET(flk_setting_find(p, KEY_GAS_BACK_PRESSURE)))
        flk_mistake(p->mistakes, use->place, "[gas] has neither a pressure nor an indicator");
    if (IS_SET(pressure) && IS_SET(card))
        flk_mistake(p->mistakes, pressure->place,
                    "give either the pressure or the indicator, not both");
    if (d_rod >= bore->si[0] && bore->si[0] > 0)
        flk_mistake(p->mistakes, rod->place, "the piston_rod, %t, is not thinner than the bore",
                    rod->value);
    gas = flk_reader_keep(p, sizeof *gas);
    element = flk_build_element(p, use);
    if (!gas || !element)
        return;
    gas->area = M_PI / 4 * bore->si[0] * bore->si[0];
    gas->back_area = gas->area - M_PI / 4 * d_rod * d_rod;
    gas->pressure = pressure->si[0];
    gas->clearance = clearance_of(p, use, gas->area);
    gas->back_pressure = flk_setting_or(p, KEY_GAS_BACK_PRESSURE, 0);
    flk_build_curves(p, card, 1, FLK_THETA2, &flk_ground_axes, &gas->indicator);
    flk_element_of_gas(gas, p->d->machine.mechanism.design.kind, element);
}
