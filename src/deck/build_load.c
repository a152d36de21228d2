/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_load.c - builds [load] from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "build.h"
#include "build_curve.h"
#include "build_mechanism.h"
#include "build_place.h"
#include "parser.h"
#include "settings.h"

/* Build the range of crank angles in which a load acts. */
static void build_window(parser *p, const section_use *use, flk_given_load *given)
{
    const setting *from = flk_setting_of(use, KEY_LOAD_FROM),
                  *to = flk_setting_of(use, KEY_LOAD_TO);

    if (!IS_SET(from) && !IS_SET(to))
        return;
    given->is_windowed = 1;
    given->window[0] = flk_setting_crank_angle(p, from); /* 0 if not given */
    given->window[1] = IS_SET(to) ? flk_setting_crank_angle(p, to) : p->d->machine.cycle;
    given->window[0] -= p->d->axes.angle;
    given->window[1] -= p->d->axes.angle;
    if (use->is_mistaken)
        return;
    if (given->window[1] <= given->window[0])
        flk_mistake(p->mistakes, (IS_SET(from) ? from : to)->place,
                    "the load's 'from' must be less than its 'to', not %t and %t",
                    IS_SET(from) ? from->value : flk_text_of("0"),
                    IS_SET(to) ? to->value : flk_text_of("the end of the cycle"));
    else if (given->window[1] - given->window[0] > p->d->machine.cycle * (1 + 1e-12))
        flk_mistake(p->mistakes, (IS_SET(to) ? to : from)->place,
                    "the load acts for more than a cycle");
}

/* 1 if a link slides along the line of stroke: forces on it need neither a point nor a direction. */
static int is_piston(const parser *p, int link)
{
    return fourlink_slides((int)p->d->machine.mechanism.design.kind, link) == FOURLINK_GROUND;
}

/* 1 if a force on a link needs the point where it acts. */
static int has_length(const parser *p, int link)
{
    const fourlink_mechanism *m = &p->d->machine.mechanism;

    return link > FOURLINK_FOLLOWER
               ? FLK_LINK(m, link)->length > 0
               : flk_kind_of(m->design.kind)->has_length[link] != FLK_NO_LENGTH;
}

/* The argument of the curves of a load. */
static int over_of(const section_use *use)
{
    return flk_setting_of(use, KEY_LOAD_OVER)->word;
}

/* The axes of the components of a force: those of the deck, unless it turns with its link or is along
** the line of stroke. */
static deck_axes axes_of_force(const parser *p, const section_use *use, const setting *force)
{
    deck_axes axes = p->d->axes;

    if (force->is_bare || flk_setting_of(use, KEY_LOAD_FRAME)->word == FOURLINK_FRAME_LINK) {
        axes.cosine = 1;
        axes.sine = 0;
    }
    return axes;
}

/* Take a force, or its curves. */
static void take_force(parser *p, const section_use *use, const setting *force,
                       fourlink_vector *value, curve *curves)
{
    deck_axes axes = axes_of_force(p, use, force);

    value->x = axes.cosine * force->si[0] + axes.sine * force->si[1];
    value->y = axes.cosine * force->si[1] - axes.sine * force->si[0];
    flk_build_curves(p, force, 2, over_of(use), &axes, curves);
}

/* Build the force of a load, and check its point. */
static void build_force(parser *p, const section_use *use, flk_given_load *given)
{
    const setting *force = flk_setting_of(use, KEY_LOAD_FORCE),
                  *at = flk_setting_of(use, KEY_LOAD_AT);
    int link = given->load.link;

    if (!IS_SET(at))
        at = flk_setting_of(use, KEY_LOAD_PLACE);
    if (force->is_bare && link && !is_piston(p, link))
        flk_mistake(p->mistakes, force->place,
                    "expected a force with its direction, such as 50 N at 30 deg or (43, 25) N, "
                    "not '%t'",
                    force->value);
    else if ((force->si[0] != 0 || force->si[1] != 0 || force->curve) && !IS_SET(at) && link &&
             !use->is_mistaken && has_length(p, link))
        flk_mistake(p->mistakes, use->place,
                    "the force needs 'at', the point of the link where it acts");
    if (IS_SET(at) && !IS_SET(force) && !use->is_mistaken)
        flk_mistake(p->mistakes, at->place, "'%s' needs a force", at->is_place ? "place" : "at");
    take_force(p, use, force, &given->values.force, given->values.force_curve);
}

/* Refuse an argument that the mechanism does not have. */
static void check_over(parser *p, const setting *over)
{
    static const int kinds[] = {ANY_KIND, WITH_PIN_D, WITH_STROKE, WITH_SLOT,
                                ANY_KIND, WITH_PIN_D, WITH_STROKE, WITH_SLOT};
    int kind = (int)p->d->machine.mechanism.design.kind;

    if (IS_SET(over) && !(kinds[over->word] & kind))
        flk_mistake(p->mistakes, over->place, "%s %s has no %t",
                    flk_text_article(fourlink_kind_text(kind)), fourlink_kind_text(kind),
                    over->value);
}

/* Build the values on the way back: a curve or a constant, like torque or force. */
static void build_back(parser *p, const section_use *use, flk_given_load *given)
{
    const setting *back = flk_setting_of(use, KEY_LOAD_BACK);

    if (!IS_SET(back))
        return;
    given->has_back = 1;
    if (FLK_IS_SPEED(given->over))
        flk_mistake(p->mistakes, back->place,
                    "'back' is for loads over a position, not over a speed");
    if (IS_SET(flk_setting_of(use, KEY_LOAD_FORCE)) && IS_SET(flk_setting_of(use, KEY_LOAD_TORQUE)))
        flk_mistake(p->mistakes, back->place,
                    "'back' of a force or of a torque? give them in two loads");
    if (IS_SET(flk_setting_of(use, KEY_LOAD_FORCE))) {
        take_force(p, use, back, &given->back.force, given->back.force_curve);
    } else {
        given->back.torque = back->si[0];
        flk_build_curves(p, back, 1, over_of(use), &p->d->axes, &given->back.torque_curve);
    }
}

/* Build a value that follows a speed, which needs the speed at which it is reached. */
static void build_power_law(parser *p, const section_use *use, int is_clear, int has_curve,
                            flk_given_load *given)
{
    const setting *over = flk_setting_of(use, KEY_LOAD_OVER),
                  *exponent = flk_setting_of(use, KEY_LOAD_EXPONENT),
                  *speed = flk_setting_of(use, KEY_LOAD_AT_SPEED);
    const setting *first = IS_SET(speed) ? speed : exponent;

    given->exponent = IS_SET(exponent) ? exponent->si[0] : 1;
    given->at_speed = speed->si[0];
    if (!is_clear)
        return;
    if (IS_SET(first) && !FLK_IS_SPEED(given->over))
        flk_mistake(p->mistakes, first->place, "'%s' needs 'over', the speed that the load follows",
                    IS_SET(speed) ? "at_speed" : "exponent");
    else if (IS_SET(first) && has_curve)
        flk_mistake(p->mistakes, first->place, "'%s' is for a value; this load has a curve",
                    IS_SET(speed) ? "at_speed" : "exponent");
    else if (FLK_IS_SPEED(given->over) && !has_curve && !IS_SET(speed))
        flk_mistake(p->mistakes, over->place,
                    "a load over a speed needs 'at_speed', the speed at which it has its value, or "
                    "a curve");
}

static void build_law(parser *p, const section_use *use, flk_given_load *given)
{
    const setting *over = flk_setting_of(use, KEY_LOAD_OVER),
                  *force = flk_setting_of(use, KEY_LOAD_FORCE),
                  *torque = flk_setting_of(use, KEY_LOAD_TORQUE),
                  *from = flk_setting_of(use, KEY_LOAD_FROM),
                  *to = flk_setting_of(use, KEY_LOAD_TO);
    int has_curve = force->curve || torque->curve;
    int is_clear = !use->is_mistaken && (IS_SET(force) || IS_SET(torque));

    given->over = (flk_variable)over->word;
    check_over(p, over);
    build_back(p, use, given);
    build_power_law(p, use, is_clear, has_curve, given);
    if (!given->over && !given->has_back)
        return;
    if (IS_SET(over) && !FLK_IS_SPEED(given->over) && !has_curve && !given->has_back && is_clear)
        flk_mistake(p->mistakes, over->place,
                    "'over' needs a curve: a force or torque that varies");
    if (IS_SET(from) || IS_SET(to))
        flk_mistake(p->mistakes, (IS_SET(from) ? from : to)->place,
                    "'%s' is a crank angle: a load with 'over' or 'back' has none",
                    IS_SET(from) ? "from" : "to");
}

/* A load whose size is unknown drives: it has a direction, and acts throughout. */
static void build_unknown(parser *p, const section_use *use, flk_given_load *given)
{
    static const key_code others[] = {KEY_LOAD_OVER, KEY_LOAD_BACK,     KEY_LOAD_FROM,
                                      KEY_LOAD_TO,   KEY_LOAD_EXPONENT, KEY_LOAD_AT_SPEED};
    const setting *force = flk_setting_of(use, KEY_LOAD_FORCE),
                  *torque = flk_setting_of(use, KEY_LOAD_TORQUE);
    size_t i;

    given->is_unknown = force->word || torque->word;
    if (!given->is_unknown)
        return;
    if (IS_SET(force) && IS_SET(torque))
        flk_mistake(p->mistakes, force->word ? force->place : torque->place,
                    "an unknown load has either a force or a torque");
    for (i = 0; i < sizeof others / sizeof others[0]; i++) {
        const setting *s = flk_setting_of(use, others[i]);

        if (IS_SET(s))
            flk_mistake(p->mistakes, s->place, "'%s' is for a load that is given, not unknown",
                        flk_key_table[others[i]].name);
    }
}

static void build_load(parser *p, const section_use *use, flk_given_load *given)
{
    const setting *link = flk_setting_of(use, KEY_LOAD_LINK),
                  *torque = flk_setting_of(use, KEY_LOAD_TORQUE),
                  *frame = flk_setting_of(use, KEY_LOAD_FRAME);

    given->load.link = flk_build_check_link(p, use, link) ? link->word : 0;
    if (!IS_SET(flk_setting_of(use, KEY_LOAD_FORCE)) && !IS_SET(torque) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[load] has neither a force nor a torque");
    given->load.frame = (fourlink_frame)frame->word;
    build_force(p, use, given);
    flk_build_point(p, flk_setting_of(use, KEY_LOAD_AT), flk_setting_of(use, KEY_LOAD_PLACE),
                    given->load.link, &given->load.at);
    given->values.torque = torque->si[0];
    flk_build_curves(p, torque, 1, over_of(use), &p->d->axes, &given->values.torque_curve);
    build_window(p, use, given);
    build_law(p, use, given);
    build_unknown(p, use, given);
}

void flk_build_loads(parser *p)
{
    section_use *use = NULL;
    flk_element *element;
    flk_given_load *given;

    while (!p->out_of_memory && (use = flk_section_next(p, SECTION_LOAD, use)) != NULL) {
        given = flk_reader_keep(p, sizeof *given);
        element = flk_build_element(p, use);
        if (!given || !element)
            return;
        build_load(p, use, given);
        element->name = flk_reader_copy(p, use->name, "");
        flk_element_of_given_load(given, element);
        p->d->has_forces = 1;
    }
}
