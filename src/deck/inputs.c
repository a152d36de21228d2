/* SPDX-License-Identifier: GPL-3.0-or-later
**
** inputs.c - the values that a deck gives, section by section.
*/
#include <string.h>

#include "inputs.h"
#include "numbers.h"
#include "settings.h"
#include "vector.h"

/* The link that a point of an [output] is on. */
static int link_of_output(const deck *d, const section_use *use, key_code key)
{
    if (key == KEY_OUTPUT_AT || key == KEY_OUTPUT_TO_AT)
        return flk_setting_of(use, key == KEY_OUTPUT_AT ? KEY_OUTPUT_LINK : KEY_OUTPUT_TO)->word;
    return flk_output_link(d->settings, use->name) - (key == KEY_OUTPUT_ROD_CG);
}

/* The link that a point in a section is on: the link that the section names, or its own. */
static const fourlink_link *link_of(const deck *d, const section_use *use, key_code key)
{
    int link = FOURLINK_GROUND;

    if (use->section == SECTION_LOAD)
        link = flk_setting_of(use, KEY_LOAD_LINK)->word;
    else if (use->section == SECTION_POINT)
        link = flk_setting_of(use, KEY_POINT_LINK)->word;
    else if (use->section == SECTION_OUTPUT)
        link = link_of_output(d, use, key);
    else if (use->section == SECTION_SPRING)
        link = flk_setting_of(use, key == KEY_SPRING_AT ? KEY_SPRING_LINK : KEY_SPRING_TO)->word;
    else if (use->section == SECTION_ACTUATOR)
        link =
            flk_setting_of(use, key == KEY_ACTUATOR_AT ? KEY_ACTUATOR_LINK : KEY_ACTUATOR_TO)->word;
    else
        while (link < FOURLINK_FOLLOWER &&
               flk_section_of_link(d->machine.mechanism.design.kind, link) != use->section)
            link++;
    return FLK_LINK(&d->machine.mechanism, link);
}

/* 1 for the force or torque of the load that drives, whose size is unknown. */
static int is_unknown(key_code key, const setting *s)
{
    return (key == KEY_LOAD_FORCE || key == KEY_LOAD_TORQUE) && s->word != 0;
}

/* The meaning of a key where another coordinate than the crank angle is prescribed. */
static const char *meaning_of(key_code key)
{
    switch (key) {
    case KEY_MOTION_SPEED:
        return "speed of the input";
    case KEY_MOTION_ACCELERATION:
        return "acceleration of the input";
    case KEY_MOTION_FROM:
        return "first value of the input";
    case KEY_MOTION_TO:
        return "last value of the input";
    case KEY_MOTION_INTERVAL:
        return "interval of the input";
    case KEY_MOTION_AT:
        return "value of the input, or crank angle";
    default:
        return flk_key_table[key].meaning;
    }
}

/* Describe the value of a target, which is set; 0 if it is not an input. */
static int describe_input(const deck *d, const target *t, deck_input *x)
{
    const section_use *use = &d->settings->uses[t->use];
    const key_info *key = &flk_key_table[t->key];
    const setting *s = flk_setting_of(use, t->key);
    const word_info *word = flk_word_find(t->key, (int)d->machine.mechanism.design.kind, s->value);
    int is_part = t->part != PART_NONE;
    char name[DECK_NAME_SIZE];

    memset(x, 0, sizeof *x);
    x->meaning = d->prescribed ? meaning_of(t->key) : key->meaning;
    if (s->curve)
        x->words = key->form == FORM_LINE ? "two points" : "a curve";
    else if (word)
        x->words = word->word;
    else if (t->key == KEY_MOTION_INPUT)
        x->words = d->prescribed->q->name; /* NAME.length */
    else if (s->word > FOURLINK_FOLLOWER && (key->form == FORM_LINK || key->form == FORM_BODY))
        x->words = fourlink_deck_link_text(d, s->word);
    else if (s->word && key->form == FORM_CRANK)
        x->words = IS_DRAWN(s) ? "drawn" : "a crank angle";
    else if (s->word)
        x->words = is_unknown(t->key, s)
                       ? "unknown"
                       : "constant"; /* torque of a motor that balances the loads */
    else
        x->number = flk_target_number(t);
    if (s->of_pins) {
        const fourlink_link *link = link_of(d, use, t->key);
        double place[2];

        flk_vector_by_distances(s->si[0], s->si[1], link->length, s->of_pins, &place[0], &place[1]);
        x->place = place[t->part];
    }
    if (s->of_length || s->of_centre) {
        const fourlink_link *link = link_of(d, use, t->key);

        x->place = s->si[t->part] * (s->of_length ? link->length : 1);
        if (s->of_centre)
            x->place += t->part == PART_X ? link->cg.x : link->cg.y;
    }
    flk_text_copy(use->name, name, sizeof name);
    flk_text_join(x->name, sizeof x->name, flk_section_table[use->section].name, *name ? " " : "",
                  name, ".", key->name, is_part ? "." : "", is_part ? flk_part_names[t->part] : "",
                  (char *)NULL);
    return key->form != FORM_TEXT &&
           (!is_part || key->form == FORM_PLACE || s->si[t->part] != 0 || x->place != 0);
}

void flk_inputs_walk(const deck *d, section_code section, deck_input_taker *take, void *host)
{
    const parser *p = d->settings;
    const section_use *use = NULL;
    deck_input x;
    target t;

    while ((use = flk_section_next(p, section, use)) != NULL)
        for (t.key = flk_first_key(section); t.key < flk_first_key(section + 1); t.key++) {
            const setting *s = flk_setting_of(use, t.key);
            value_form form = flk_key_table[t.key].form;
            int has_parts = (form == FORM_VECTOR || form == FORM_POINT || form == FORM_PLACE) &&
                            !s->curve && !is_unknown(t.key, s);
            int part = has_parts ? PART_X : PART_NONE, last = has_parts ? PART_Y : PART_NONE;

            t.use = (size_t)(use - p->uses);
            for (; part <= last && IS_SET(s) && !s->is_pending; part++) {
                t.part = (vector_part)part;
                if (describe_input(d, &t, &x))
                    take(host, &x);
            }
        }
}

size_t flk_inputs_limit(const deck *d)
{
    const parser *p = d->settings;
    size_t i, k, n = 0;

    for (i = 0; i < p->n_uses; i++)
        for (k = 0; k < flk_section_keys(p->uses[i].section); k++)
            n += IS_SET(&p->uses[i].settings[k]) ? 2 : 0; /* of a vector x and y */
    return n;
}
