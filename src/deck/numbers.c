/* SPDX-License-Identifier: GPL-3.0-or-later
**
** numbers.c - the numbers of a deck that a sweep or a host can set: crank.length, load L.force.size.
*/
#include <float.h>
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "base/trig.h"
#include "numbers.h"
#include "parser.h"
#include "pins.h"
#include "settings.h"
#include "values.h"

int flk_target_is_number(const target *t)
{
    const key_info *key = &flk_key_table[t->key];

    if (t->part != PART_NONE)
        return 1;
    return t->key != KEY_COUNT &&
           (key->form == FORM_QUANTITY || key->form == FORM_EITHER || key->form == FORM_CRANK ||
            (key->form == FORM_CURVE && key->q != QUANTITY_PRESSURE));
}

quantity flk_target_quantity(const parser *p, const target *t)
{
    return t->part == PART_ANGLE ? QUANTITY_ANGLE : flk_quantity_of_key(&p->uses[t->use], t->key);
}

/* Read a number back from so many digits; 0 if they are not certain. */
static int read_back(double value, int digits, char words[DIGITS_SIZE], double *number)
{
    text t = flk_text_of(flk_digits_short(value, digits, words));

    return flk_number_read(&t, number) == NUMBER_OK;
}

/* Find the number that in a unit gives exactly the SI value, from 15 digits on. */
static int find_exact(double si, const unit *u, char words[DIGITS_SIZE], double *number)
{
    double value = flk_unit_from_si(si, *u);
    int digits;

    for (digits = DBL_DIG; digits <= DBL_DIG + 2; digits++)
        if (read_back(value, digits, words, number) && flk_unit_to_si(*number, *u) == si)
            return 1;
    return 0;
}

int flk_number_in_unit(double si, const unit *u, char number[DIGITS_SIZE])
{
    double read;

    return find_exact(si, u, number, &read);
}

double flk_number_converted(double number, unit from, unit to)
{
    double value = flk_unit_in(number, from, to), rounded, exactly, back;
    char words[DIGITS_SIZE];

    if (!read_back(value, DBL_DIG, words, &rounded) ||
        !(fabs(rounded - value) <= 2 * DBL_EPSILON * fabs(value)))
        return value;
    exactly = flk_unit_in(rounded, to, from); /* a fraction, 1/3 rev/s, has more digits */
    return exactly == number || (read_back(exactly, DBL_DIG, words, &back) && back == number)
               ? rounded
               : value;
}

double flk_number_written(double si, unit own, unit wanted)
{
    char words[DIGITS_SIZE];
    double number;

    return find_exact(si, &own, words, &number) ? flk_number_converted(number, own, wanted)
                                                : flk_unit_from_si(si, wanted);
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

int flk_number_follows(const deck *d, unsigned long id)
{
    target t;

    return find_target(d->settings, id, &t) && flk_pins_give(d, t.key);
}

/* The setting of a number in use; null if it is words, a list or a curve. */
static const setting *setting_of(const parser *p, const target *t)
{
    section_code section = p->uses[t->use].section;
    const setting *s = flk_setting_of(&p->uses[t->use], t->key);

    if (TAKES_NAMES(section) || section == SECTION_UNITS || !flk_target_is_number(t) || s->curve ||
        s->of_length || s->of_centre || s->of_pins ||
        (t->part != PART_NONE && !IS_SET(s) && flk_key_table[t->key].form != FORM_POINT) ||
        (t->part != PART_ANGLE && s->word))
        return NULL;
    return s;
}

int flk_number_describe(const deck *d, unsigned long id, quantity *q, const char **key, double *si)
{
    const parser *p = d->settings;
    const setting *s;
    target t;

    if (!find_target(p, id, &t) || (s = setting_of(p, &t)) == NULL)
        return 0;
    *q = flk_target_quantity(p, &t);
    *key = t.part == PART_NONE ? flk_key_table[t.key].name : flk_part_names[t.part];
    *si = !IS_SET(s)             ? GSL_NAN
          : t.part == PART_SIZE  ? flk_length(s->si[0], s->si[1])
          : t.part == PART_ANGLE ? flk_angle(s->si[1], s->si[0])
                                 : s->si[t.part == PART_Y];
    return 1;
}

/* The text of the line that gives a number: a part that a design or a host has set has that of its vector. */
static text text_of(const parser *p, const target *t)
{
    const setting *s = flk_setting_of(&p->uses[t->use], t->key);
    text angle, size;

    if (t->part != PART_NONE && s->parts && s->parts[t->part].source == GIVEN_BY_CHANGE)
        return s->parts[t->part].line;
    if (!s->line.start)
        return flk_text_of("");
    if (t->part != PART_ANGLE)
        return s->line;
    return flk_text_cut(s->line, " at ", &size, &angle) ? angle : flk_text_of("");
}

int flk_number_unit(const deck *d, unsigned long id, deck_unit *u)
{
    const parser *p = d->settings;
    target t;
    text name;
    quantity q;

    if (!find_target(p, id, &t) || !setting_of(p, &t))
        return 0;
    q = flk_target_quantity(p, &t);
    *u = d->bare[q];
    if (flk_unit_of_value(d, text_of(p, &t), q, &name, &u->unit) && name.length)
        flk_value_name_unit(name, u->name);
    return 1;
}

int flk_number_read_text(const deck *d, text whole, deck_number *number, char message[MESSAGE_SIZE])
{
    text name, value, unit_name;
    quantity_value read;
    const char *key;
    double si;
    quantity q;

    if (!flk_text_cut(whole, "=", &name, &value) || !name.length) {
        flk_message(message, MESSAGE_SIZE, "expected NAME = NUMBER UNIT, not '%t'", whole);
        return FOURLINK_NO_SUCH_NAME;
    }
    number->id = flk_number_find(d, name);
    if (!number->id) {
        flk_message(message, MESSAGE_SIZE, "'%t' is no number of this deck", name);
        return FOURLINK_NO_SUCH_NAME;
    }
    if (!flk_number_unit(d, number->id, &number->unit) ||
        !flk_number_describe(d, number->id, &q, &key, &si)) {
        flk_message(message, MESSAGE_SIZE, "'%t' is not a number", name);
        return FOURLINK_NOT_A_NUMBER;
    }
    if (!flk_quantity_read(value, value, q, number->unit.unit, &read, message))
        return FOURLINK_BAD_NUMBER;
    number->value = read.number;
    number->unit.unit = read.unit;
    unit_name = flk_quantity_unit_text(value);
    if (unit_name.length)
        flk_value_name_unit(unit_name, number->unit.name);
    return FOURLINK_OK;
}

/* A variable of the sweep that is set has this value. */
static void set_variable(deck *d, const deck_number *set)
{
    size_t i;

    for (i = 0; i < d->sweep.n_variables; i++) {
        deck_variable *v = &d->sweep.variables[i];

        if (v->number == set->id)
            v->value = flk_unit_in(set->value, set->unit.unit, d->units[v->q].unit);
    }
}

void flk_numbers_assign(parser *p, const deck_number *set, size_t n)
{
    char blank_unit[DECK_NAME_SIZE + 1] = " ";
    size_t i;

    for (i = 0; i < n && !p->out_of_memory; i++) {
        const char *name = set[i].unit.name;
        quantity_value number;
        text_place place;
        target t;

        if (!find_target(p, set[i].id, &t))
            continue;
        place = flk_setting_of(&p->uses[t.use], t.key)->place;
        if (!place.source)
            place = p->uses[t.use].place;
        strcpy(blank_unit + 1, name);
        number.number = set[i].value;
        number.unit = set[i].unit.unit;
        flk_setting_vary(
            p, place, &t, &number,
            flk_setting_text(p, number.number, flk_text_of(strcmp(name, "1") ? blank_unit : "")));
        set_variable(p->d, &set[i]);
    }
}
