/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_place.c - builds points of links and of the ground, and directions, in the axes that the engine has.
*/
#include <math.h>

#include "base/trig.h"
#include "mechanics/kind.h"
#include "build_place.h"
#include "parser.h"
#include "pieces.h"
#include "pins.h"
#include "settings.h"
#include "vector.h"

fourlink_vector flk_build_direction(const parser *p, fourlink_vector u)
{
    const deck_axes *axes = &p->d->axes;
    fourlink_vector v;

    v.x = axes->cosine * u.x + axes->sine * u.y;
    v.y = axes->cosine * u.y - axes->sine * u.x;
    return v;
}

fourlink_vector flk_build_on_ground(const parser *p, fourlink_vector place)
{
    place.x -= p->d->axes.A.x;
    place.y -= p->d->axes.A.y;
    return flk_build_direction(p, place);
}

int flk_build_is_without_length(parser *p, const flk_kind *kind, int number)
{
    section_code section = flk_section_of_link(kind->kind, number);

    return kind->has_length[number] != FLK_LENGTH && !flk_section_is_mistaken(p, section) &&
           !(p->d->pins.length[number] > 0) && !IS_SET(flk_setting_by_name(p, section, "length"));
}

const char *flk_build_length_in(parser *p, const setting *s, double length, char out[MESSAGE_SIZE])
{
    text written = flk_quantity_unit_text(s->value);

    if (!written.length)
        written = flk_text_of(p->d->bare[QUANTITY_LENGTH].name);
    return flk_message(out, MESSAGE_SIZE, "%.6g %t", flk_unit_from_si(length, s->unit), written);
}

/* A point by its distances from the two pins of its link. */
static void place_by_distances(parser *p, const setting *s, int link, fourlink_vector *at)
{
    double length = FLK_LINK(&p->d->machine.mechanism, link)->length;
    const char *name = fourlink_deck_link_text(p->d, link);
    const deck_unit *u = &p->d->units[QUANTITY_LENGTH];

    at->x = at->y = 0;
    if (!link || p->mistakes->count)
        return;
    if (!(length > 0))
        flk_mistake(p->mistakes, s->place,
                    "'%t' is by the distances from two pins of the link, and the %s has one: give "
                    "the point in another way",
                    s->value, name);
    else if (!flk_vector_by_distances(s->si[0], s->si[1], length, s->of_pins, &at->x, &at->y))
        flk_mistake(p->mistakes, s->place,
                    "no point has these distances, %t, from the pins of the %s, which are %.6g %s "
                    "apart",
                    s->value, name, flk_unit_from_si(length, u->unit), u->name);
}

void flk_build_place(parser *p, const setting *s, int link, fourlink_vector *at)
{
    const fourlink_link *data = FLK_LINK(&p->d->machine.mechanism, link);
    double length = data->length;
    const flk_kind *kind = flk_kind_of(p->d->machine.mechanism.design.kind);

    if (s->of_pins) {
        place_by_distances(p, s, link, at);
        return;
    }
    at->x = s->si[0] * (s->of_length ? length : 1);
    at->y = s->si[1] * (s->of_length ? length : 1);
    if (link == FOURLINK_GROUND && !s->of_length && !flk_text_equal(s->value, "origin"))
        *at = flk_build_on_ground(p, *at);
    if (s->of_centre && link) {
        at->x += data->cg.x;
        at->y += data->cg.y;
        if (!(data->mass > 0))
            flk_mistake(p->mistakes, s->place,
                        "'%t' is from the centre of mass, and the %s has no mass", s->value,
                        fourlink_deck_link_text(p->d, link));
    }
    if (!s->of_length || !link)
        return;
    if (link > FOURLINK_FOLLOWER ? !(length > 0) : flk_build_is_without_length(p, kind, link))
        flk_mistake(p->mistakes, s->place,
                    "'%t' is a part of the length, and the %s has none: give the point in a unit "
                    "of length",
                    s->value, fourlink_deck_link_text(p->d, link));
    else
        flk_piece_size(p, s, QUANTITY_LENGTH, flk_length(at->x, at->y));
}

int flk_build_point(parser *p, const setting *at, const setting *place, int link,
                    fourlink_vector *on_link)
{
    if (IS_SET(at) && IS_SET(place))
        return flk_mistake(p->mistakes, place->place,
                           "give the point either on its link or by its place as drawn, not both");
    if (IS_SET(place))
        return link && flk_pins_place(p, place, link, on_link);
    flk_build_place(p, at, link, on_link);
    return 1;
}
