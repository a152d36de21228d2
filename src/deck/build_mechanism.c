/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_mechanism.c - builds the mechanism from values.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "mechanics/kind.h"
#include "reader.h"

/* Find the kind of the mechanism, and refuse sections and keys that it does not have. */
int flk_build_kind(parser *p)
{
    const setting *s = flk_setting_find(p, KEY_TOP_MECHANISM);
    size_t i;
    fourlink_kind kind;
    const char *words;
    key_code k;

    if (!IS_SET(s)) {
        text_place place = flk_reader_end(p);
        const char *kinds[MOST_WORDS];
        char list[MESSAGE_SIZE];

        place.line = 1;
        flk_key_words(KEY_TOP_MECHANISM, NULL, kinds);
        flk_text_list(kinds, "', 'mechanism = ", "' or 'mechanism = ", list, sizeof list);
        return flk_mistake(p->mistakes, place, "expected 'mechanism = %s' before the first section",
                           list);
    }
    if (!s->word)
        return 0;
    kind = (fourlink_kind)s->word;
    p->d->design.kind = kind;
    words = fourlink_kind_text((int)kind);
    for (i = 0; i < p->n_uses; i++) {
        const section_use *use = &p->uses[i];

        if (!(flk_section_table[use->section].kinds & (int)kind)) {
            flk_mistake(p->mistakes, use->place,
                        flk_link_of_section(use->section) == FOURLINK_COUPLER
                            ? "%s %s has no [%s]; its link 3 is the [%s]"
                            : "%s %s has no [%s]",
                        flk_text_article(words), words, flk_section_table[use->section].name,
                        fourlink_link_text((int)kind, FOURLINK_COUPLER));
            continue;
        }
        for (k = flk_first_key(use->section); k < flk_first_key(use->section + 1); k++) {
            s = flk_setting_of(use, k);
            if (IS_SET(s) && !(flk_key_table[k].kinds & (int)kind))
                flk_mistake(p->mistakes, s->place, "%s%s%s%s %s has no %s",
                            use->section == SECTION_TOP ? "" : "the ",
                            flk_section_table[use->section].name,
                            use->section == SECTION_TOP ? "" : " of ", flk_text_article(words),
                            words, flk_key_table[k].name);
        }
    }
    return 1;
}

/* A length in the unit in which another length is written, and the text of that unit. */
static double in_unit_of(parser *p, const setting *s, double length, text *written)
{
    *written = flk_quantity_unit_text(s->value);
    if (!written->length)
        *written = flk_text_of(p->d->bare[QUANTITY_LENGTH].name);
    return flk_unit_from_si(length, s->unit);
}

/* A length as it is written, with the unit of a bare number. */
static text with_unit(parser *p, const setting *s)
{
    char ending[DECK_NAME_SIZE + 1] = " ";
    const char *copy;

    if (flk_quantity_unit_text(s->value).length)
        return s->value;
    copy = flk_reader_copy(p, s->value, strcat(ending, p->d->bare[QUANTITY_LENGTH].name));
    return copy ? flk_text_of(copy) : s->value;
}

/* The slide of a lever: its offset, or its angle at the end of the lever. */
static void build_slide(parser *p)
{
    const setting *offset = flk_setting_find(p, KEY_LEVER_OFFSET),
                  *length = flk_setting_find(p, KEY_LEVER_LENGTH),
                  *angle = flk_setting_find(p, KEY_LEVER_ANGLE);

    p->d->design.offset = IS_SET(offset) ? offset->si[0] : flk_setting_or(p, KEY_GROUND_OFFSET, 0);
    p->d->design.angle = angle->si[0];
    if (IS_SET(offset) && (IS_SET(length) || IS_SET(angle)))
        flk_mistake(p->mistakes, offset->place,
                    "give the lever either an offset, or a length and an angle, not both");
    else if (flk_section_is_mistaken(p, SECTION_LEVER))
        return;
    else if (IS_SET(length) && !IS_SET(angle))
        flk_mistake(p->mistakes, length->place,
                    "a lever with a length needs an angle, that of the slide from the line D-C");
    else if (IS_SET(angle) && !IS_SET(length))
        flk_mistake(p->mistakes, angle->place,
                    "a lever with an angle needs a length, from D to C on the slide");
}

/* A slide can be reached at some angle if its distance is at most the sum of the two links that have a
** length. */
static void check_slide(parser *p, const flk_kind *kind, double sum)
{
    const fourlink_design *design = &p->d->design;
    const setting *s = flk_setting_find(p, KEY_LEVER_ANGLE);
    double distance = fabs(design->link[FOURLINK_FOLLOWER].length * sin(design->angle));
    double in_unit;
    const char *first =
        kind->link[kind->has_length[FOURLINK_GROUND] ? FOURLINK_GROUND : FOURLINK_CRANK];
    const char *second =
        kind->link[kind->has_length[FOURLINK_GROUND] ? FOURLINK_CRANK : FOURLINK_COUPLER];
    text written;

    if (IS_SET(s) && distance > sum) {
        const setting *length = flk_setting_find(p, KEY_LEVER_LENGTH);

        in_unit = in_unit_of(p, length, sum, &written);
        flk_mistake(p->mistakes, s->place,
                    "the slide passes D at %.6g %t, farther than %s and %s together, %.6g %t: the "
                    "linkage cannot be assembled",
                    in_unit * distance / sum, written, first, second, in_unit, written);
    }
    if (IS_SET(s) || fabs(design->offset) <= sum)
        return;
    s = flk_setting_find(p, KEY_LEVER_OFFSET);
    if (!IS_SET(s))
        s = flk_setting_find(p, KEY_GROUND_OFFSET);
    in_unit = in_unit_of(p, s, sum, &written);
    flk_mistake(p->mistakes, s->place,
                "the offset, %t, is larger than %s and %s together, %.6g %t: the linkage cannot be "
                "assembled",
                with_unit(p, s), first, second, in_unit, written);
}

/* A linkage can be assembled at some angle if no link is longer than the sum of the other three.  A linkage
** with a slide can be assembled if the other links reach it. */
static void check_reach(parser *p, const flk_kind *kind)
{
    const fourlink_link *link = p->d->design.link;
    const setting *s;
    int i, longest = FOURLINK_GROUND;
    double sum = 0, in_unit;
    text written;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++) {
        if (kind->has_length[i] != FLK_LENGTH)
            continue;
        if (!(link[i].length > 0))
            return; /* already reported */
        sum += link[i].length;
        if (link[i].length > link[longest].length)
            longest = i;
    }
    if (flk_kind_has_slide(kind->kind)) {
        check_slide(p, kind, sum);
        return;
    }
    sum -= link[longest].length;
    if (link[longest].length > sum * (1 + 1e-14)) {
        s = flk_setting_by_name(p, flk_find_section(flk_text_of(kind->link[longest])), "length");
        in_unit = in_unit_of(p, s, sum, &written);
        flk_mistake(
            p->mistakes, s->place,
            "the %s, %t, is longer than the other three together, %.6g %t: the linkage cannot be "
            "assembled",
            kind->link[longest], with_unit(p, s), in_unit, written);
    }
}

void flk_build_mechanism(parser *p)
{
    fourlink_design *design = &p->d->design;
    const flk_kind *kind = flk_kind_of(design->kind);
    double direction, g;
    int i;

    build_slide(p);
    flk_build_link(p, kind, FOURLINK_GROUND);
    for (i = 0; i < 2; i++) /* the rod before a crank that is computed from the stroke */
        flk_build_link(p, kind,
                       i == flk_build_has(p, KEY_CRANK_STROKE) ? FOURLINK_CRANK : FOURLINK_COUPLER);
    flk_build_link(p, kind, FOURLINK_FOLLOWER);
    g = flk_setting_or(p, KEY_GRAVITY_ACCELERATION, STANDARD_GRAVITY);
    direction =
        flk_setting_or(p, KEY_GRAVITY_DIRECTION, -M_PI_2) - flk_setting_or(p, KEY_GROUND_ANGLE, 0);
    flk_vector_direction(direction, &design->gravity.x, &design->gravity.y);
    design->gravity.x *= g;
    design->gravity.y *= g;
    for (i = FOURLINK_CRANK; i <= FOURLINK_FOLLOWER; i++)
        if (design->link[i].mass > 0 || design->link[i].inertia > 0)
            p->d->has_forces = 1;
    check_reach(p, kind);
    if (p->mistakes->count)
        return;
    i = fourlink_prepare(design, &p->d->machine.mechanism);
    if (i != FOURLINK_OK)
        flk_mistake(p->mistakes, flk_section_find(p, SECTION_CRANK, NULL)->place, "%s",
                    fourlink_status_text(i));
}

/* The approximations of the engine method, which exist only for the kind of engine in the sources. */
void flk_build_series(parser *p)
{
    const setting *s = flk_setting_find(p, KEY_TOP_SERIES);

    p->d->approximation = (fourlink_approximation)s->word;
    if (p->d->approximation != FOURLINK_EXACT && p->d->design.offset != 0)
        flk_mistake(p->mistakes, s->place, "%s", fourlink_status_text(FOURLINK_NO_SERIES));
}
