/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_spring.c - builds springs, friction and counterweights from values.
*/
#include <gsl/gsl_math.h>

#include "mechanics/kind.h"
#include "reader.h"

/* ------------------------------------------------------------------------------------------ springs */

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
    return link->word == FOURLINK_GROUND || flk_build_check_link(p, use, link) ? link->word : 0;
}

/* The point at an end of a spring. */
static void read_spring_point(parser *p, const section_use *use, key_code key, int link,
                              fourlink_vector *at)
{
    const setting *place = flk_setting_of(use, key);
    int kind = (int)p->d->design.kind;

    if (!link)
        return;
    if (!IS_SET(place) && !use->is_mistaken &&
        !IS_SET(flk_setting_of(use, KEY_SPRING_FREE_ANGLE)) &&
        (link == FOURLINK_GROUND || fourlink_slides(kind, link) == 0))
        flk_mistake(p->mistakes, use->place, "the spring needs '%s', its end on the %s",
                    flk_key_table[key].name, fourlink_link_text(kind, link));
    flk_build_place(p, place, link, at);
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
    }
    if (s->link && s->link == s->to) {
        flk_mistake(p->mistakes, to->place, "a spring from the %t to itself does nothing",
                    to->value);
    } else if (!s->is_torsional) {
        read_spring_point(p, use, KEY_SPRING_AT, s->link, &s->at);
        read_spring_point(p, use, KEY_SPRING_TO_AT, s->to, &s->to_at);
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
    const section_use *use = NULL;
    flk_element *element;

    while (!p->out_of_memory && (use = flk_section_next(p, SECTION_SPRING, use)) != NULL) {
        element = flk_build_element(p);
        if (element)
            build_spring(p, use, element);
        p->d->has_forces = 1;
    }
}

/* ----------------------------------------------------------------------------------------- friction */

/* The friction circle of a pin, from its own values or from those of all pins; 0 and a mistake if one is
** missing, -1 if that is the radius of all pins. */
static double build_circle(parser *p, const section_use *use, key_code coefficient, key_code key)
{
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

void flk_build_friction(parser *p)
{
    const section_use *use = flk_section_find(p, SECTION_FRICTION, NULL);
    const setting *guide = flk_setting_find(p, KEY_FRICTION_GUIDE),
                  *length = flk_setting_find(p, KEY_FRICTION_GUIDE_LENGTH),
                  *mu = flk_setting_find(p, KEY_FRICTION_MU),
                  *radius = flk_setting_find(p, KEY_FRICTION_RADIUS);
    fourlink_friction *friction = &p->d->machine.friction;
    int i, has_pins = IS_SET(mu), lacks_radius = 0;

    if (!use)
        return;
    for (i = 0; i < 4; i++) {
        has_pins |= IS_SET(flk_setting_of(use, (key_code)(KEY_FRICTION_A + i)));
        friction->circle[i] = build_circle(p, use, (key_code)(KEY_FRICTION_A + i),
                                           (key_code)(KEY_FRICTION_RADIUS_A + i));
        lacks_radius |= friction->circle[i] < 0;
    }
    if (lacks_radius && !use->is_mistaken)
        flk_mistake(p->mistakes, mu->place, "'mu' needs 'radius', that of the pins");
    if (IS_SET(radius) && !has_pins && !use->is_mistaken)
        flk_mistake(p->mistakes, radius->place, "'radius' needs 'mu', the coefficient of friction");
    if (IS_SET(length) && !IS_SET(guide) && !use->is_mistaken)
        flk_mistake(p->mistakes, length->place,
                    "'guide_length' needs 'guide', the coefficient of friction");
    if (!has_pins && !IS_SET(guide) && !IS_SET(radius) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[friction] has no coefficient of friction");
    friction->guide = guide->si[0];
    friction->guide_length = length->si[0];
    friction->direction = flk_setting_find(p, KEY_FRICTION_DIRECTION)->word;
    p->d->machine.has_friction = 1;
}

/* ------------------------------------------------------------------------------------------ balance */

static void apply(parser *p, int link, const fourlink_vector *moment, double *mass)
{
    deck_balance *b = &p->d->balance;
    fourlink_link balanced;

    if (fourlink_add_counterweight(&p->d->design.link[link], moment, b->radius, &balanced, mass) ==
            FOURLINK_OK &&
        flk_setting_find(p, KEY_BALANCE_APPLY)->word)
        p->d->design.link[link] = balanced;
}

void flk_build_balance(parser *p)
{
    const section_use *use = flk_section_find(p, SECTION_BALANCE, NULL);
    const setting *fraction = flk_setting_find(p, KEY_BALANCE_FRACTION),
                  *radius = flk_setting_find(p, KEY_BALANCE_RADIUS),
                  *add = flk_setting_find(p, KEY_BALANCE_APPLY);
    deck_balance *b = &p->d->balance;

    if (!use)
        return;
    b->is_there = 1;
    b->crank = flk_setting_find(p, KEY_BALANCE_CRANK)->word || IS_SET(fraction);
    b->rocker = flk_setting_find(p, KEY_BALANCE_ROCKER)->word;
    b->radius = radius->si[0];
    if (!b->crank && !b->rocker && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "[balance] needs %s",
                    flk_build_has(p, KEY_BALANCE_FRACTION)
                        ? "the fraction of the reciprocating mass to be balanced"
                        : "'crank = yes', 'rocker = yes' or both");
    if (add->word && !IS_SET(radius) && !use->is_mistaken)
        flk_mistake(p->mistakes, add->place,
                    "'apply' needs a radius, at which the counterweights are");
    if (p->mistakes->count ||
        fourlink_balance_of(&p->d->machine.mechanism, fraction->si[0], &b->moment) != FOURLINK_OK)
        return;
    if (flk_build_has(p, KEY_BALANCE_FRACTION))
        b->reciprocating = flk_balance_reciprocating(&p->d->design);
    if (b->crank && b->radius > 0)
        apply(p, FOURLINK_CRANK, &b->moment.crank, &b->mass[0]);
    if (b->rocker && b->radius > 0)
        apply(p, FOURLINK_FOLLOWER, &b->moment.rocker, &b->mass[1]);
    fourlink_prepare(&p->d->design, &p->d->machine.mechanism);
}
