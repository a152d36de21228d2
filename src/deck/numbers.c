/* SPDX-License-Identifier: GPL-3.0-or-later
**
** numbers.c - the numbers of a deck that a sweep or a host can set: crank.length, load L.force.size.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "numbers.h"
#include "parser.h"
#include "settings.h"
#include "values.h"

int flk_target_is_number(const target *t)
{
    const key_info *key = &flk_key_table[t->key];

    if (t->part != PART_NONE)
        return 1;
    return t->key != KEY_COUNT && (key->form == FORM_QUANTITY || key->form == FORM_EITHER ||
                                   (key->form == FORM_CURVE && key->q != QUANTITY_PRESSURE));
}

quantity flk_target_quantity(const parser *p, const target *t)
{
    return t->part == PART_ANGLE ? QUANTITY_ANGLE : flk_quantity_of_key(&p->uses[t->use], t->key);
}

int flk_number_in_unit(double si, const unit *u, char number[DIGITS_SIZE])
{
    double value = flk_unit_from_si(si, *u), same;
    int digits;

    for (digits = 15; digits <= 17; digits++) {
        text t = flk_text_of(flk_digits_short(value, digits, number));

        if (flk_number_read(&t, &same) == NUMBER_OK && flk_unit_to_si(same, *u) == si)
            return 1;
    }
    return 0;
}

text flk_setting_text(parser *p, double number, text unit_name)
{
    char *words = flk_reader_keep(p, DIGITS_SIZE + unit_name.length);
    text t = {"", 0};

    if (!words)
        return t;
    flk_number_shortest(number, words);
    t = flk_text_of(words);
    memcpy(words + t.length, unit_name.start, unit_name.length);
    t.length += unit_name.length;
    return t;
}

/* ------------------------------------------------------------------------------- for hosts, by number */

/* A target as a number that is the same for all designs of a deck, and back. */
#define MOST_KEYS 64 /* of a section */
#define PARTS (PART_NONE + 1)

unsigned long flk_target_number(const target *t)
{
    unsigned long key = t->key - flk_first_key(flk_key_table[t->key].section);

    return ((unsigned long)t->use * MOST_KEYS + key) * PARTS + (unsigned long)t->part + 1;
}

static int find_target(const parser *p, unsigned long id, target *t)
{
    unsigned long key = (id - 1) / PARTS;
    section_code section;

    t->use = key / MOST_KEYS;
    if (!id || t->use >= p->n_uses)
        return 0;
    section = p->uses[t->use].section;
    t->key = (key_code)(flk_first_key(section) + key % MOST_KEYS);
    t->part = (vector_part)((id - 1) % PARTS);
    t->name =
        flk_text_of(key % MOST_KEYS < flk_section_keys(section) ? flk_key_table[t->key].name : "");
    return t->name.length > 0;
}

unsigned long flk_number_find(const deck *d, text name)
{
    target t;

    return flk_setting_look(d->settings, name, &t) ? flk_target_number(&t) : 0;
}

/* The setting of a number in use; null if it is words, a list or a curve. */
static const setting *setting_of(const parser *p, const target *t)
{
    section_code section = p->uses[t->use].section;
    const setting *s = flk_setting_of(&p->uses[t->use], t->key);

    if (TAKES_NAMES(section) || section == SECTION_UNITS || !flk_target_is_number(t) || s->curve ||
        s->of_length || s->of_centre ||
        (t->part != PART_NONE && !IS_SET(s) && flk_key_table[t->key].form == FORM_VECTOR) ||
        (t->part == PART_NONE && s->word))
        return NULL;
    return s;
}

int flk_number_describe(const deck *d, unsigned long id, quantity *q, const char **key,
                        double *value)
{
    const parser *p = d->settings;
    const setting *s;
    target t;

    if (!find_target(p, id, &t) || (s = setting_of(p, &t)) == NULL)
        return 0;
    *q = flk_target_quantity(p, &t);
    *key = t.part == PART_NONE ? flk_key_table[t.key].name : flk_part_names[t.part];
    *value = !IS_SET(s)             ? GSL_NAN
             : t.part == PART_SIZE  ? gsl_hypot(s->si[0], s->si[1])
             : t.part == PART_ANGLE ? atan2(s->si[1], s->si[0])
                                    : s->si[t.part == PART_Y];
    *value = flk_unit_from_si(*value, d->units[*q].unit);
    return 1;
}

/* A variable of the sweep that is set has this value. */
static void set_variable(deck_sweep *sweep, const deck_number *set)
{
    size_t i;

    for (i = 0; i < sweep->n_variables; i++)
        if (sweep->variables[i].number == set->id)
            sweep->variables[i].value = set->value;
}

void flk_numbers_assign(parser *p, const deck_number *set, size_t n)
{
    char blank_unit[DECK_NAME_SIZE + 1] = " ";
    size_t i;

    for (i = 0; i < n && !p->out_of_memory; i++) {
        const deck_unit *u;
        quantity_value number;
        text_place place;
        target t;

        if (!find_target(p, set[i].id, &t))
            continue;
        place = flk_setting_of(&p->uses[t.use], t.key)->place;
        if (!place.source)
            place = p->uses[t.use].place;
        u = &p->d->units[flk_target_quantity(p, &t)];
        strcpy(blank_unit + 1, u->name);
        number.number = set[i].value;
        number.unit = u->unit;
        flk_setting_vary(p, place, &t, &number,
                         flk_setting_text(p, number.number,
                                          flk_text_of(strcmp(u->name, "1") ? blank_unit : "")));
        set_variable(&p->d->sweep, &set[i]);
    }
}
