/* SPDX-License-Identifier: GPL-3.0-or-later
**
** build_drive.c - builds [actuator] and `drive` of [motion]: what drives the machine, if not a torque on
** the crank.
*/
#include <string.h>

#include "mechanics/drive.h"
#include "mechanics/kind.h"
#include "build.h"
#include "build_mechanism.h"
#include "build_place.h"
#include "build_point.h"
#include "parser.h"
#include "settings.h"

/* -------------------------------------------------------------------------------------------- actuators */

/* The link and the point at an end of an actuator. */
static int build_end(parser *p, const section_use *use, const key_code keys[3], fourlink_vector *at)
{
    const setting *link = flk_setting_of(use, keys[0]), *on_link = flk_setting_of(use, keys[1]),
                  *place = flk_setting_of(use, keys[2]);

    if (!IS_SET(link)) {
        if (!use->is_mistaken)
            flk_mistake(p->mistakes, use->place,
                        "[actuator] has no '%s': a link, or the ground, of one of its ends",
                        flk_key_table[keys[0]].name);
        return 0;
    }
    if (link->word != FOURLINK_GROUND && !flk_build_check_link(p, use, link))
        return 0;
    if (!IS_SET(on_link) && !IS_SET(place) && !use->is_mistaken)
        flk_mistake(p->mistakes, use->place, "the actuator needs '%s', its end on the %s",
                    flk_key_table[keys[1]].name,
                    fourlink_link_text((int)p->d->machine.mechanism.design.kind, link->word));
    flk_build_point(p, on_link, place, link->word, at);
    return link->word;
}

static int build_actuator(parser *p, const section_use *use, flk_actuator *x)
{
    static const char *const endings[FLK_ACTUATOR_COLUMNS] = {".length", ".speed", ".acceleration",
                                                              ".force",  ".power", ".pressure"};
    static const key_code from[3] = {KEY_ACTUATOR_LINK, KEY_ACTUATOR_AT, KEY_ACTUATOR_PLACE},
                          to[3] = {KEY_ACTUATOR_TO, KEY_ACTUATOR_TO_AT, KEY_ACTUATOR_TO_PLACE};
    const setting *rod = flk_setting_of(use, KEY_ACTUATOR_ROD_DIAMETER);
    int i;

    flk_build_check_name(p, use, "NAME.length, NAME.force ...");
    x->link = build_end(p, use, from, &x->at);
    x->to = build_end(p, use, to, &x->to_at);
    if (x->link && x->link == x->to)
        flk_mistake(p->mistakes, flk_setting_of(use, KEY_ACTUATOR_TO)->place,
                    "an actuator from the %t to itself does nothing",
                    flk_setting_of(use, KEY_ACTUATOR_TO)->value);
    x->bore = flk_setting_of(use, KEY_ACTUATOR_BORE)->si[0];
    x->rod_diameter = rod->si[0];
    if (IS_SET(rod) && !use->is_mistaken && !(x->rod_diameter < x->bore))
        flk_mistake(p->mistakes, rod->place, "the rod must be thinner than the bore");
    x->name = flk_reader_copy(p, use->name, "");
    for (i = 0; i < FLK_ACTUATOR_COLUMNS; i++)
        x->column_names[i] = flk_reader_copy(p, use->name, endings[i]);
    return !p->out_of_memory;
}

/* A name that would make a column twice is a mistake at its second line. */
static void check_twice(parser *p, const section_use *use)
{
    static const section_code others[] = {SECTION_POINT, SECTION_SPRING, SECTION_ACTUATOR};
    int kind = (int)p->d->machine.mechanism.design.kind, i;
    size_t k;

    for (i = FOURLINK_GROUND; i <= FOURLINK_FOLLOWER; i++)
        if (flk_text_same(use->name, fourlink_link_text(kind, i)))
            flk_mistake(p->mistakes, use->place, "'%t' is the name of a link", use->name);
    for (k = 0; k < sizeof others / sizeof others[0]; k++) {
        const section_use *other = flk_section_find(p, others[k], &use->name);

        if (other && other != use)
            flk_mistake(
                p->mistakes, other->place.line > use->place.line ? other->place : use->place,
                "'%t' is the name of two sections with columns: give one another name", use->name);
    }
}

/* A boom's cylinder has columns cylinder.length ..., which another part with that name would have too. */
static void check_cylinder(parser *p)
{
    static const section_code sections[] = {SECTION_SPRING, SECTION_ACTUATOR};
    text name = flk_text_of("cylinder");
    const section_use *use;
    size_t i;

    for (i = 0; i < sizeof sections / sizeof sections[0]; i++) {
        use = flk_section_find(p, sections[i], &name);
        if (p->d->has_cylinder && use)
            flk_mistake(p->mistakes, use->place,
                        "the cylinder of a %t has columns with this name: give it another one",
                        flk_setting_find(p, KEY_TOP_MECHANISM)->value);
    }
}

static void build_actuators(parser *p)
{
    deck *d = p->d;
    const section_use *use = NULL;

    if (!flk_section_find(p, SECTION_ACTUATOR, NULL))
        return;
    d->actuators = flk_reader_keep(p, p->n_uses * sizeof *d->actuators);
    while (!p->out_of_memory && (use = flk_section_next(p, SECTION_ACTUATOR, use)) != NULL) {
        if (build_actuator(p, use, &d->actuators[d->n_actuators]))
            d->n_actuators++;
        check_twice(p, use);
    }
}

/* ----------------------------------------------------------------------------------------------- drives */

/* The drive of the link that is named; 0 if it names none. */
static int drive_of_link(parser *p, text name, flk_drive *drive)
{
    int kind = (int)p->d->machine.mechanism.design.kind;

    if (flk_text_equal(name, fourlink_link_text(kind, FOURLINK_FOLLOWER)))
        drive->sort = fourlink_slides(kind, FOURLINK_FOLLOWER) ? FLK_DRIVE_ALONG : FLK_DRIVE_TORQUE;
    else if (flk_text_equal(name, "slide") && kind == FOURLINK_INVERTED_SLIDER_CRANK)
        drive->sort = FLK_DRIVE_SLIDE;
    else
        return 0;
    return 1;
}

/* The drive of the slider or rocker of an output that is named; 0 if it names none. */
static int drive_of_output(parser *p, text name, flk_drive *drive)
{
    int i = flk_deck_output(p->d, name);

    if (i < 0)
        return 0;
    drive->sort = FLK_DRIVE_OUTPUT;
    drive->link = FOURLINK_END_OF(i);
    drive->is_torque = p->d->groups[i].end == FOURLINK_GROUP_TURNS;
    drive->to = drive->is_torque ? p->d->groups[i].to : 0;
    return 1;
}

/* The drive of the actuator or of the load that is named; 0 if it names none. */
static int drive_by_name(parser *p, text name, flk_drive *drive)
{
    deck *d = p->d;
    int actuator = flk_deck_actuator(d, name);
    size_t i;

    if (actuator >= 0) {
        drive->sort = FLK_DRIVE_ENDS;
        drive->actuator = &d->actuators[actuator];
        return 1;
    }
    for (i = 0; i < d->machine.n_elements; i++) {
        const flk_element *e = &d->machine.element[i];
        const flk_given_load *given = e->data;

        if (e->type == &flk_given_load_type && given->is_unknown && flk_text_same(name, e->name)) {
            drive->sort = FLK_DRIVE_LOAD;
            drive->load = given->load;
            drive->load.force = given->values.force;
            drive->load.torque = given->values.torque;
            return 1;
        }
    }
    return 0;
}

/* What drives if the deck does not say: its actuator, or the link of what is prescribed. */
static int usual_drive(parser *p, flk_drive *drive)
{
    deck *d = p->d;
    const setting *input = flk_setting_find(p, KEY_MOTION_INPUT);
    int kind = (int)d->machine.mechanism.design.kind;

    if (d->n_actuators == 1) {
        drive->sort = FLK_DRIVE_ENDS;
        drive->actuator = &d->actuators[0];
        drive->name = d->actuators[0].name;
        return 1;
    }
    if (!input->word)
        return 0;
    if (input->word == FLK_NAMED_INPUT) {
        text name, of;

        flk_text_cut_last(input->value, ".", &name, &of);
        drive->name = flk_reader_copy(p, name, "");
        return drive_of_output(p, name, drive);
    }
    drive->name = flk_coordinates[input->word - 1].what == FLK_OF_SLIDE
                      ? "slide"
                      : fourlink_link_text(kind, FOURLINK_FOLLOWER);
    return drive_of_link(p, flk_text_of(drive->name), drive);
}

/* Refuse what needs a torque on the crank. */
static void check_others(parser *p, text_place place)
{
    const setting *fluctuation = flk_setting_find(p, KEY_FLYWHEEL_FLUCTUATION);
    const section_use *motor = flk_section_find(p, SECTION_MOTOR, NULL);

    if (p->d->mode.kind != MODE_GIVEN || motor)
        flk_mistake(p->mistakes, place,
                    "a motion that is computed is driven at the crank: mode = given, without "
                    "[motor]");
    if (IS_SET(fluctuation))
        flk_mistake(p->mistakes, fluctuation->place,
                    "a flywheel is for a torque on the crank: drive = crank");
}

/* A load of unknown size has to drive. */
static void check_unknown(parser *p, const flk_drive *drive)
{
    const section_use *use = NULL;

    while ((use = flk_section_next(p, SECTION_LOAD, use)) != NULL) {
        const setting *force = flk_setting_of(use, KEY_LOAD_FORCE),
                      *torque = flk_setting_of(use, KEY_LOAD_TORQUE);
        const setting *s = force->word ? force : torque;

        if (s->word &&
            !(drive && drive->sort == FLK_DRIVE_LOAD && flk_text_same(use->name, drive->name)))
            flk_mistake(p->mistakes, s->place,
                        "an unknown load is what drives: [motion] drive = %t", use->name);
    }
}

static const char *list_drives(parser *p, char out[MESSAGE_SIZE])
{
    int kind = (int)p->d->machine.mechanism.design.kind;

    return flk_message(out, MESSAGE_SIZE,
                       "crank, %s, %sthe name of an actuator%s or of a load whose "
                       "size is unknown",
                       fourlink_link_text(kind, FOURLINK_FOLLOWER),
                       kind == FOURLINK_INVERTED_SLIDER_CRANK ? "slide, " : "",
                       p->d->machine.mechanism.design.n_groups ? ", of an output" : "");
}

void flk_build_drive(parser *p)
{
    const setting *s = flk_setting_find(p, KEY_MOTION_DRIVE);
    const section_use *second = flk_section_find(p, SECTION_ACTUATOR, NULL);
    char list[MESSAGE_SIZE];
    flk_drive *drive;

    build_actuators(p);
    check_cylinder(p);
    drive = flk_reader_keep(p, sizeof *drive);
    if (!drive || p->out_of_memory || flk_mistakes_count(p->mistakes))
        return;
    if (IS_SET(s) && flk_text_equal(s->value, "crank")) {
        drive = NULL;
    } else if (IS_SET(s)) {
        drive->name = flk_reader_copy(p, s->value, "");
        if (!drive_of_link(p, s->value, drive) && !drive_by_name(p, s->value, drive) &&
            !drive_of_output(p, s->value, drive)) {
            flk_mistake(p->mistakes, s->place, "expected %s, not '%t'", list_drives(p, list),
                        s->value);
            drive = NULL;
        }
    } else if (p->d->n_actuators > 1) {
        flk_mistake(p->mistakes, flk_section_next(p, SECTION_ACTUATOR, second)->place,
                    "of several actuators [motion] drive = NAME says which drives");
        drive = NULL;
    } else if (!usual_drive(p, drive)) {
        drive = NULL;
    }
    check_unknown(p, drive);
    if (drive) {
        check_others(p, IS_SET(s) ? s->place : second ? second->place : flk_reader_end(p));
    }
    p->d->machine.mechanism.drive = drive;
    p->d->has_forces |= drive != NULL;
}
