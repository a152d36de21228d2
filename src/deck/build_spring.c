/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_spring.c - builds [spring] from values.
*/
#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "build.h"
#include "build_mechanism.h"
#include "build_place.h"
#include "build_point.h"
#include "parser.h"
#include "settings.h"
#include "values.h"

/* Refuse a key that only the other sort of spring has. */
static void check_sort(parser *p, const section_use *use, key_code key, int is_torsional)
{
    const setting *s = flk_setting_of(use, key),
                  *stiffness = flk_setting_of(use, KEY_SPRING_STIFFNESS);

    if (!IS_SET(s) || (!is_torsional && use->is_mistaken)) /* the sort is unknown */
        return;
    if (is_torsional)
        flk_mistake(p->mistakes, s->place, "a torsional spring has no %s", flk_key_table[key].name);
    else
        flk_mistake(p->mistakes, s->place,
                    IS_SET(stiffness)
                        ? "a free_angle needs a torsional spring, with its stiffness in N m/rad, "
                          "not '%t'"
                        : "a free_angle needs a torsional spring, with its damping in N m s/rad",
                    stiffness->value);
}

/* The link at an end of a spring; 0 and a mistake if there is none. */
static int read_spring_link(parser *p, const section_use *use, key_code key)
{
    const setting *link = flk_setting_of(use, key);

    if (!IS_SET(link) && key == KEY_SPRING_TO) {
        if (!use->is_mistaken)
            flk_mistake(p->mistakes, use->place,
                        "[spring] has no 'to': the ground or another link");
        return 0;
    }
    if (link->word > FOURLINK_FOLLOWER) {
        flk_mistake(p->mistakes, link->place,
                    "springs are between the four links and the ground, not on %t, which is of an "
                    "[output]",
                    link->value);
        return 0;
    }
    return link->word == FOURLINK_GROUND || flk_build_check_link(p, use, link) ? link->word : 0;
}

/* The point at an end of a spring. */
static void read_spring_point(parser *p, const section_use *use, key_code key, key_code place_key,
                              int link, fourlink_vector *at)
{
    const setting *on_link = flk_setting_of(use, key), *place = flk_setting_of(use, place_key);
    int kind = (int)p->d->machine.mechanism.design.kind;

    if (!link)
        return;
    if (!IS_SET(on_link) && !IS_SET(place) && !use->is_mistaken &&
        !IS_SET(flk_setting_of(use, KEY_SPRING_FREE_ANGLE)) &&
        (link == FOURLINK_GROUND || fourlink_slides(kind, link) == 0))
        flk_mistake(p->mistakes, use->place, "the spring needs '%s', its end on the %s",
                    flk_key_table[key].name, fourlink_link_text(kind, link));
    flk_build_point(p, on_link, place, link, at);
}

/* The links of a spring, and its ends on them. */
static void build_ends(parser *p, const section_use *use, fourlink_spring *s)
{
    const setting *to = flk_setting_of(use, KEY_SPRING_TO);

    s->link = read_spring_link(p, use, KEY_SPRING_LINK);
    s->to = read_spring_link(p, use, KEY_SPRING_TO);
    if (s->is_torsional) {
        check_sort(p, use, KEY_SPRING_AT, 1);
        check_sort(p, use, KEY_SPRING_TO_AT, 1);
        check_sort(p, use, KEY_SPRING_PLACE, 1);
        check_sort(p, use, KEY_SPRING_TO_PLACE, 1);
    }
    if (s->link && s->link == s->to) {
        flk_mistake(p->mistakes, to->place, "a spring from the %t to itself does nothing",
                    to->value);
    } else if (!s->is_torsional) {
        read_spring_point(p, use, KEY_SPRING_AT, KEY_SPRING_PLACE, s->link, &s->at);
        read_spring_point(p, use, KEY_SPRING_TO_AT, KEY_SPRING_TO_PLACE, s->to, &s->to_at);
    }
}

/* Refuse a spring between two points at the same pin: its length is always 0. */
static void check_length(parser *p, const section_use *use, const fourlink_spring *spring)
{
    const fourlink_mechanism *mechanism = &p->d->machine.mechanism;
    double size = mechanism->design.link[FOURLINK_CRANK].length;
    fourlink_crank crank = {0, 0, 0};
    fourlink_spring_state at;
    fourlink_state state;
    int i, n = 0;

    for (i = 0; i < 12; i++) {
        crank.theta2 = 0.3 + i * M_PI / 6;
        if (fourlink_analyse_dyad(mechanism, FOURLINK_OPEN, &crank, NULL, 0, &state, NULL) !=
            FOURLINK_OK)
            continue;
        if (fourlink_spring_at(mechanism, &state, spring, &at) == FOURLINK_OK &&
            at.length > 1e-12 * size)
            return;
        n++;
    }
    if (n)
        flk_mistake(p->mistakes, use->place,
                    "the spring has no length: its ends are the same point at every crank angle");
}

static void build_spring(parser *p, const section_use *use, flk_element *new)
{
    static const char *const endings[2][FLK_ELEMENT_COLUMNS] = {
        {".length", ".force", ".energy", ".power"}, {".angle", ".torque", ".energy", ".power"}};
    const setting *stiffness = flk_setting_of(use, KEY_SPRING_STIFFNESS),
                  *damping = flk_setting_of(use, KEY_SPRING_DAMPING),
                  *preload = flk_setting_of(use, KEY_SPRING_PRELOAD),
                  *free_length = flk_setting_of(use, KEY_SPRING_FREE_LENGTH),
                  *free_angle = flk_setting_of(use, KEY_SPRING_FREE_ANGLE),
                  *only = flk_setting_of(use, KEY_SPRING_ONLY);
    fourlink_spring *s = flk_reader_keep(p, sizeof *s);
    int i;

    if (!s)
        return;
    flk_build_check_name(p, use, "NAME.length, NAME.force ...");
    s->is_torsional = flk_spring_is_torsional(use);
    build_ends(p, use, s);
    check_sort(p, use, s->is_torsional ? KEY_SPRING_FREE_LENGTH : KEY_SPRING_FREE_ANGLE,
               s->is_torsional);
    if (!IS_SET(stiffness) && !IS_SET(damping) && !IS_SET(preload) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place,
                    "[spring] has neither a stiffness nor a damping nor a preload");
    if ((IS_SET(free_length) || IS_SET(free_angle)) && !IS_SET(stiffness) && !use->is_mistaken)
        flk_mistake(p->mistakes, (IS_SET(free_length) ? free_length : free_angle)->place,
                    "'%s' needs a stiffness", IS_SET(free_length) ? "free_length" : "free_angle");
    s->stiffness = stiffness->si[0];
    s->free_length = s->is_torsional ? free_angle->si[0] : free_length->si[0];
    s->preload = preload->si[0];
    s->damping = damping->si[0];
    s->only = only->word;
    if (s->only == FOURLINK_PUSHES && !s->is_torsional && !IS_SET(free_length) && !use->is_mistaken)
        flk_mistake(p->mistakes, only->place,
                    "a spring that only pushes needs a free_length, below which it acts");
    new->name = flk_reader_copy(p, use->name, "");
    for (i = 0; i < FLK_ELEMENT_COLUMNS; i++)
        new->column_names[i] = flk_reader_copy(p, use->name, endings[s->is_torsional][i]);
    flk_element_of_spring(s, new);
    if (p->mistakes->count)
        return;
    fourlink_spring_prepare(&p->d->machine.mechanism, s);
    if (!s->is_torsional)
        check_length(p, use, s);
}

void flk_build_springs(parser *p)
{
    section_use *use = NULL;
    flk_element *element;

    while (!p->out_of_memory && (use = flk_section_next(p, SECTION_SPRING, use)) != NULL) {
        element = flk_build_element(p, use);
        if (element)
            build_spring(p, use, element);
        p->d->has_forces = 1;
    }
}
