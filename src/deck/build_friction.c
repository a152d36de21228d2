/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_friction.c - builds [friction] from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "build.h"
#include "build_mechanism.h"
#include "build_motor.h"
#include "parser.h"
#include "settings.h"

/* ----------------------------------------------------------------------------------------- friction */

const key_code flk_friction_keys[4][2] = {{KEY_FRICTION_A, KEY_FRICTION_RADIUS_A},
                                          {KEY_FRICTION_B, KEY_FRICTION_RADIUS_B},
                                          {KEY_FRICTION_C, KEY_FRICTION_RADIUS_C},
                                          {KEY_FRICTION_D, KEY_FRICTION_RADIUS_D}};

/* The friction circle of a pin, from its own values or from those of all pins; 0 and a mistake if one is
** missing, -1 if that is the radius of all pins. */
static double build_circle(parser *p, const section_use *use, const key_code keys[2])
{
    key_code coefficient = keys[0], key = keys[1];
    const setting *own = flk_setting_of(use, coefficient),
                  *all = flk_setting_of(use, KEY_FRICTION_MU),
                  *own_radius = flk_setting_of(use, key),
                  *common_radius = flk_setting_of(use, KEY_FRICTION_RADIUS);
    const setting *mu = IS_SET(own) ? own : all;
    const setting *radius = IS_SET(own_radius) ? own_radius : common_radius;

    if (!flk_build_has(p, coefficient))
        return 0;
    if (IS_SET(all) && !IS_SET(own) && !IS_SET(radius) && mu->si[0] > 0)
        return -1;
    if (IS_SET(mu) && !IS_SET(radius) && mu->si[0] > 0 && !use->is_mistaken)
        flk_mistake(p->mistakes, mu->place, "the friction of %s needs '%s', that of its pin",
                    flk_key_table[coefficient].name, flk_key_table[key].name);
    if (IS_SET(own_radius) && !IS_SET(mu) && !use->is_mistaken)
        flk_mistake(p->mistakes, own_radius->place, "'%s' needs '%s', the coefficient of friction",
                    flk_key_table[key].name, flk_key_table[coefficient].name);
    return mu->si[0] * radius->si[0];
}

/* The way a crank at rest is about to turn: towards the last row, or as it is accelerated. */
static int build_direction(parser *p)
{
    const setting *direction = flk_setting_find(p, KEY_FRICTION_DIRECTION);
    const fourlink_motion *motion = &p->d->motion;

    if (IS_SET(direction) && p->d->mode.kind == MODE_GIVEN)
        return direction->word;
    if (motion->to != motion->from && !flk_setting_find(p, KEY_MOTION_INPUT)->word)
        return motion->to < motion->from ? -1 : 1;
    return flk_build_sense(p);
}

void flk_build_friction(parser *p)
{
    const section_use *use = flk_section_find(p, SECTION_FRICTION, NULL);
    const setting *guide = flk_setting_find(p, KEY_FRICTION_GUIDE),
                  *length = flk_setting_find(p, KEY_FRICTION_GUIDE_LENGTH),
                  *slot = flk_setting_find(p, KEY_FRICTION_SLOT),
                  *slot_length = flk_setting_find(p, KEY_FRICTION_SLOT_LENGTH),
                  *mu = flk_setting_find(p, KEY_FRICTION_MU),
                  *radius = flk_setting_find(p, KEY_FRICTION_RADIUS), *own;
    fourlink_friction *friction = &p->d->machine.friction;
    int i, has_pins = IS_SET(mu), lacks_radius = 0;

    friction->direction = build_direction(p);
    if (!use)
        return;
    for (i = 0; i < 4; i++) {
        has_pins |= IS_SET(flk_setting_of(use, flk_friction_keys[i][0]));
        own = flk_setting_of(use, flk_friction_keys[i][1]);
        p->d->pin_radius[i] = IS_SET(own) ? own->si[0] : radius->si[0];
        friction->circle[i] = build_circle(p, use, flk_friction_keys[i]);
        lacks_radius |= friction->circle[i] < 0;
    }
    if (lacks_radius && !use->is_mistaken)
        flk_mistake(p->mistakes, mu->place, "'mu' needs 'radius', that of the pins");
    if (IS_SET(radius) && !has_pins && !use->is_mistaken)
        flk_mistake(p->mistakes, radius->place, "'radius' needs 'mu', the coefficient of friction");
    if (IS_SET(length) && !IS_SET(guide) && !use->is_mistaken)
        flk_mistake(p->mistakes, length->place,
                    "'guide_length' needs 'guide', the coefficient of friction");
    if (IS_SET(slot_length) && !IS_SET(slot) && !use->is_mistaken)
        flk_mistake(p->mistakes, slot_length->place,
                    "'slot_length' needs 'slot', the coefficient of friction");
    if (!has_pins && !IS_SET(guide) && !IS_SET(slot) && !IS_SET(radius) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[friction] has no coefficient of friction");
    friction->guide = guide->si[0];
    friction->guide_length = length->si[0];
    friction->slot = slot->si[0];
    friction->slot_length = slot_length->si[0];
    p->d->machine.has_friction = 1;
}
