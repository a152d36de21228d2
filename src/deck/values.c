/* SPDX-License-Identifier: GPL-3.0-or-later
**
** values.c - second pass over a deck: the texts of its settings to values in SI units.
*/
#include <math.h>
#include <string.h>

#include "base/number.h"
#include "mechanics/coordinate.h"
#include "mechanics/kind.h"
#include "curve_text.h"
#include "parser.h"
#include "pieces.h"
#include "settings.h"
#include "values.h"
#include "vector.h"

/* NAME.length of an actuator, NAME.x or NAME.theta of an output, which [motion] input can be. */
static int is_named_input(text value)
{
    text name, of;

    return flk_text_cut_last(value, ".", &name, &of) && name.length &&
           (flk_text_equal(of, "length") || flk_text_equal(of, "x") || flk_text_equal(of, "theta"));
}

int flk_input_is_angle(const setting *input)
{
    const word_info *word = flk_word_find(KEY_MOTION_INPUT, 0, input->value);
    text name, of;

    if (word)
        return word->value == 0 || flk_coordinates[word->value - 1].is_angle;
    return !is_named_input(input->value) ||
           (flk_text_cut_last(input->value, ".", &name, &of) && flk_text_equal(of, "theta"));
}

#define NAMED_INPUTS 3

static void add_named_inputs(const char **words)
{
    static const char *const named[NAMED_INPUTS + 1] = {"NAME.length", "NAME.x", "NAME.theta",
                                                        NULL};

    while (*words)
        words++;
    memcpy(words, named, sizeof named);
}

static void read_word(parser *p, key_code key, setting *s)
{
    const flk_kind *kind = flk_kind_of((fourlink_kind)flk_setting_find(p, KEY_TOP_MECHANISM)->word);
    const word_info *word = flk_word_find(key, flk_setting_kind(p), s->value);
    const char *advice = flk_word_advice(key, s->value);
    const char *listed[MOST_WORDS + NAMED_INPUTS];
    char list[MESSAGE_SIZE];

    if (!word && flk_key_table[key].form != FORM_WORD) {
        s->word = flk_output_link(p, s->value);
        if (s->word)
            return;
    }
    if (word || (key == KEY_MOTION_INPUT && is_named_input(s->value))) {
        s->word = word ? word->value : FLK_NAMED_INPUT;
        return;
    }
    if (advice) {
        flk_mistake(p->mistakes, s->place, "'%t': %s", s->value, advice);
        return;
    }
    flk_key_words(key, kind ? kind->link : NULL, listed);
    if (key == KEY_MOTION_INPUT)
        add_named_inputs(listed);
    flk_mistake(p->mistakes, s->place, "expected %s, not '%t'%h",
                flk_text_list(listed, ", ", " or ", list, sizeof list), s->value,
                flk_word_nearest(key, flk_setting_kind(p), s->value));
}

static void check_sign(parser *p, const key_info *key, const setting *s)
{
    const char *what = key->section == SECTION_FRICTION && key->q == QUANTITY_NUMBER
                           ? "coefficient of friction "
                           : "";

    if (key->sign == SIGN_POSITIVE && !(s->si[0] > 0))
        flk_mistake(p->mistakes, s->place, "the %s must be positive, not %t", key->name, s->value);
    else if (key->sign == SIGN_NOT_NEGATIVE && s->si[0] < 0)
        flk_mistake(p->mistakes, s->place, "the %s%s must not be negative: %t", what, key->name,
                    s->value);
    else if (key->q == QUANTITY_LENGTH && key->sign == SIGN_POSITIVE &&
             (s->si[0] < FOURLINK_LENGTH_MIN || s->si[0] > FOURLINK_LENGTH_MAX))
        flk_mistake(p->mistakes, s->place, "'%t' is out of range", s->value);
}

void flk_value_name_unit(text t, char name[DECK_NAME_SIZE])
{
    char *c, *end = name;

    flk_text_copy(t, name, DECK_NAME_SIZE);
    for (c = name; *c; c++)
        if (*c != ' ' && *c != '\t')
            *end++ = *c;
        else if (end > name && flk_text_is_word(end[-1]) && flk_text_is_word(c[strspn(c, " \t")]))
            *end++ = '.';
    *end = '\0';
}

static void set_unit(deck_unit *units, quantity q, text name, unit u)
{
    flk_value_name_unit(name, units[q].name);
    units[q].unit = u;
    units[q].is_given = 1;
}

/* Set the unit of the quantity that it fits, and of another one if lb and oz are forces there: lb-in.
** Returns 0 if there is none. */
static int set_result_unit(parser *p, text name)
{
    key_code first = flk_first_key(SECTION_UNITS), end = flk_first_key(SECTION_UNITS + 1), k;
    const quantity_info *before = NULL;
    text bad;
    unit u;

    for (k = first; k < end; k++) {
        const quantity_info *info = &flk_quantities[flk_key_table[k].q];

        if (!flk_unit_read_as(name, info->dim, &u, &bad) ||
            !flk_dimension_equal(u.dim, info->dim) ||
            (before && (flk_dimension_equal(before->dim, info->dim) || flk_unit_is_weight(name))))
            continue;
        set_unit(p->d->units, flk_key_table[k].q, name, u);
        before = info;
    }
    return before != NULL;
}

void flk_values_result_units(parser *p, const char *list)
{
    text rest = flk_reader_plain(p, flk_text_of(list)), item;
    text_place place = {"--units", 0};

    while (flk_text_split(&rest, ',', &item)) {
        item = flk_text_trim(item);
        if (flk_text_same(item, "SI")) {
            flk_deck_set_si(p->d->units);
            p->d->units[QUANTITY_LENGTH].is_given = 1; /* by which the others go */
            continue;
        }
        if (!set_result_unit(p, item))
            flk_mistake(p->mistakes, place, "'%t' is not a unit of results, such as mm, kg or rpm",
                        item);
    }
}

/* How far the unit of length, %s, settles others: areas and volumes always; speeds if it is given; all
** if it is in or ft. */
enum { AREAS, SPEEDS, ALL_UNITS };

static const struct {
    int from;
    quantity q;
    const char *name;
} by_length[] = {{AREAS, QUANTITY_AREA, "%s2"},
                 {AREAS, QUANTITY_VOLUME, "%s3"},
                 {SPEEDS, QUANTITY_SPEED, "%s/s"},
                 {SPEEDS, QUANTITY_ACCELERATION, "%s/s2"},
                 {ALL_UNITS, QUANTITY_MASS, "lb"},
                 {ALL_UNITS, QUANTITY_INERTIA, "lb.%s2"},
                 {ALL_UNITS, QUANTITY_MASS_MOMENT, "lb.%s"},
                 {ALL_UNITS, QUANTITY_FORCE, "lbf"},
                 {ALL_UNITS, QUANTITY_TORQUE, "lbf.%s"},
                 {ALL_UNITS, QUANTITY_ENERGY, "lbf.%s"},
                 {ALL_UNITS, QUANTITY_POWER, "hp"},
                 {ALL_UNITS, QUANTITY_PRESSURE, "psi"},
                 {ALL_UNITS, QUANTITY_STIFFNESS, "lbf/%s"},
                 {ALL_UNITS, QUANTITY_DAMPING, "lbf.s/%s"},
                 {ALL_UNITS, QUANTITY_TORSIONAL_STIFFNESS, "lbf.%s/rad"},
                 {ALL_UNITS, QUANTITY_TORSIONAL_DAMPING, "lbf.%s.s/rad"}};

/* in or ft, if a unit is that of a length; null for others. */
static const char *customary_length(const unit *length)
{
    static const char *const customary[] = {"in", "ft"};
    text bad;
    unit u;
    int i;

    for (i = 0; i < 2; i++)
        if (flk_unit_read(flk_text_of(customary[i]), &u, &bad) && u.up == length->up &&
            u.down == length->down)
            return customary[i];
    return NULL;
}

int flk_values_are_customary(const deck *d, size_t i, quantity *q)
{
    const deck_unit *length = &d->units[QUANTITY_LENGTH], *bare = &d->bare[QUANTITY_LENGTH];

    if (i >= sizeof by_length / sizeof *by_length || !customary_length(&length->unit) ||
        (bare->is_given ? !customary_length(&bare->unit) : length->is_given))
        return 0; /* also where only --units has in or ft */
    *q = by_length[i].q;
    return 1;
}

/* Set those units that are not given. */
static void set_by_length(deck_unit *units, const char *length, int how_far)
{
    char name[DECK_NAME_SIZE];
    text bad;
    size_t i;

    for (i = 0; i < sizeof by_length / sizeof *by_length; i++) {
        deck_unit *own = &units[by_length[i].q];

        if (own->is_given || by_length[i].from > how_far)
            continue;
        flk_message(name, sizeof name, by_length[i].name, length);
        if (flk_unit_read(flk_text_of(name), &own->unit, &bad))
            strcpy(own->name, name);
    }
}

/* 1 for a unit such as mm; 0 for mm^1 or a product, to which no exponent can be added. */
static int is_one_word(const char *name)
{
    while (flk_text_is_word(*name))
        name++;
    return !*name;
}

static int begins_with_word(text t)
{
    return t.length && flk_text_is_word(t.start[0]) && !('0' <= t.start[0] && t.start[0] <= '9');
}

int flk_unit_of_value(const deck *d, text value, quantity q, text *name, unit *u)
{
    text size = value, rest;

    *u = d->bare[q].unit;
    while (flk_text_cut(value, " + ", &size, &rest)) /* of a point by steps, the first but a word */
        value = begins_with_word(size) ? rest : size;
    size = value;
    if (value.length && value.start[0] == '(')
        flk_text_split(&size, ')', &rest);
    else if (!flk_text_cut(value, " at ", &size, &rest))
        size = value;
    *name = flk_quantity_unit_text(size);
    return !name->length || flk_unit_read_as(*name, flk_quantities[q].dim, u, &rest);
}

int flk_values_written_length(parser *p, text *name, unit *u)
{
    static const key_code lengths[] = {KEY_CRANK_LENGTH, KEY_CRANK_STROKE,  KEY_COUPLER_LENGTH,
                                       KEY_ROD_LENGTH,   KEY_GROUND_LENGTH, KEY_PINS_B,
                                       KEY_PINS_A};
    const size_t n = sizeof lengths / sizeof *lengths;
    const setting *s = NULL;
    size_t i;

    for (i = 0; i < n && !(s && IS_SET(s) && !s->is_pending); i++)
        s = flk_setting_find(p, lengths[i]);
    return flk_unit_of_value(p->d, s->value, QUANTITY_LENGTH, name, u) && name->length;
}

void flk_values_follow_units(parser *p, int deck_units)
{
    deck_unit *units = p->d->units, *length = &units[QUANTITY_LENGTH];
    const char *customary;
    text name;
    unit own;

    if (!length->is_given) {
        if (!deck_units || !flk_values_written_length(p, &name, &own))
            return;
        flk_value_name_unit(name, length->name);
        length->unit = own;
    }
    customary = customary_length(&length->unit);
    if (customary)
        set_by_length(units, customary, ALL_UNITS);
    else if (is_one_word(length->name))
        set_by_length(units, length->name, length->is_given ? SPEEDS : AREAS);
    if (customary && !length->is_given)
        strcpy(length->name, customary); /* for inches and the like */
}

/* A whole number. */
static int read_count(parser *p, setting *s, quantity q)
{
    text t = s->value;

    if (!flk_piece_number(p, s, &t, q, &s->si[0]))
        return 0;
    if (t.length || s->si[0] != floor(s->si[0]))
        return flk_mistake(p->mistakes, s->place, "expected a whole number, not '%t'", s->value);
    return 1;
}

/* The unit of a quantity's text; 0 if it has none. */
static int unit_of_text(text t, unit *u)
{
    text bad;

    t = flk_quantity_unit_text(t);
    return t.length && flk_unit_read(t, u, &bad);
}

int flk_spring_is_torsional(const section_use *use)
{
    unit u;

    return (unit_of_text(flk_setting_of(use, KEY_SPRING_STIFFNESS)->value, &u) && u.dim.rad != 0) ||
           (unit_of_text(flk_setting_of(use, KEY_SPRING_DAMPING)->value, &u) && u.dim.rad != 0);
}

/* Read the argument of a load; 0 if 'over' is not one of the words. */
static int read_over(const section_use *use, int *over)
{
    const setting *s = flk_setting_of(use, KEY_LOAD_OVER);
    const word_info *word = IS_SET(s) ? flk_word_find(KEY_LOAD_OVER, 0, s->value) : NULL;

    *over = word ? word->value : FLK_THETA2;
    return !IS_SET(s) || word;
}

quantity flk_values_quantity_over(int over)
{
    static const quantity quantities[] = {
        QUANTITY_ANGLE,         QUANTITY_ANGLE,         QUANTITY_LENGTH, QUANTITY_LENGTH,
        QUANTITY_ANGULAR_SPEED, QUANTITY_ANGULAR_SPEED, QUANTITY_SPEED,  QUANTITY_SPEED};

    return quantities[over];
}

/* The quantity of the argument of a load or of a motor's torque. */
static quantity quantity_of_argument(const section_use *use)
{
    int over = FLK_THETA2;

    if (use->section == SECTION_MOTOR)
        return QUANTITY_ANGULAR_SPEED;
    if (use->section == SECTION_LOAD)
        read_over(use, &over);
    return flk_values_quantity_over(over);
}

/* The quantity of a place of the motion by its unit, or another. */
static quantity quantity_by_unit(const unit *u, quantity other)
{
    static const quantity places[] = {QUANTITY_TIME, QUANTITY_LENGTH, QUANTITY_ANGLE};
    size_t i;

    for (i = 0; i < sizeof places / sizeof *places; i++)
        if (flk_dimension_equal(u->dim, flk_quantities[places[i]].dim))
            return places[i];
    return other;
}

quantity flk_values_quantity_at(const setting *at)
{
    return !IS_SET(at) || at->word ? QUANTITY_ANGLE : quantity_by_unit(&at->unit, QUANTITY_ANGLE);
}

/* Take the angle of `theta2 = 60 deg`; 0 if it is none. */
static int cut_crank(text value, text *angle)
{
    text name, rest;

    if (!flk_text_cut(value, "=", &name, &rest) || !flk_text_equal(name, "theta2"))
        return 0;
    *angle = rest;
    return 1;
}

static quantity quantity_of_place(const section_use *use, key_code key, quantity bare)
{
    const setting *s = flk_setting_of(use, key);
    text angle;
    unit u;

    if (flk_text_equal(s->value, "drawn") || cut_crank(s->value, &angle))
        return QUANTITY_ANGLE;
    return unit_of_text(s->value, &u) ? quantity_by_unit(&u, bare) : bare;
}

/* Motions of a coordinate that is a length are in its units. */
static quantity quantity_of_motion(const section_use *use, key_code key)
{
    const setting *s = flk_setting_of(use, KEY_MOTION_INPUT);

    if (!IS_SET(s) || flk_input_is_angle(s))
        return flk_key_table[key].q;
    switch (key) {
    case KEY_MOTION_FROM:
    case KEY_MOTION_TO:
    case KEY_MOTION_INTERVAL:
        return QUANTITY_LENGTH;
    case KEY_MOTION_AT:
        return quantity_of_place(use, key, QUANTITY_LENGTH);
    case KEY_MOTION_SPEED:
        return QUANTITY_SPEED;
    case KEY_MOTION_ACCELERATION:
        return QUANTITY_ACCELERATION;
    default:
        return flk_key_table[key].q;
    }
}

/* A clearance is a length, a volume or a share of the displacement. */
static quantity quantity_of_clearance(const section_use *use)
{
    unit u;

    if (!unit_of_text(flk_setting_of(use, KEY_GAS_CLEARANCE)->value, &u))
        return QUANTITY_LENGTH;
    return flk_dimension_equal(u.dim, flk_quantities[QUANTITY_VOLUME].dim)   ? QUANTITY_VOLUME
           : flk_dimension_equal(u.dim, flk_quantities[QUANTITY_NUMBER].dim) ? QUANTITY_NUMBER
                                                                             : QUANTITY_LENGTH;
}

quantity flk_quantity_of_key(const section_use *use, key_code key)
{
    if (key == KEY_GAS_CLEARANCE)
        return quantity_of_clearance(use);
    if (key == KEY_LOAD_AT_SPEED)
        return quantity_of_argument(use) == QUANTITY_SPEED ? QUANTITY_SPEED
                                                           : QUANTITY_ANGULAR_SPEED;
    if (key == KEY_LOAD_BACK && IS_SET(flk_setting_of(use, KEY_LOAD_FORCE)))
        return QUANTITY_FORCE;
    if (key == KEY_EXPECT_AT || key == KEY_MISPRINT_AT)
        return quantity_of_place(use, key, QUANTITY_ANGLE);
    if (use->section == SECTION_MOTION)
        return quantity_of_motion(use, key);
    if (flk_key_table[key].form != FORM_EITHER || !flk_spring_is_torsional(use))
        return flk_key_table[key].q;
    return key == KEY_SPRING_STIFFNESS ? QUANTITY_TORSIONAL_STIFFNESS
           : key == KEY_SPRING_DAMPING ? QUANTITY_TORSIONAL_DAMPING
                                       : QUANTITY_TORQUE;
}

/* Stiffness and damping need a unit, which determines the sort of spring, and a clearance, which may be
** any of three quantities. */
static int has_unit(parser *p, key_code key, const setting *s)
{
    if (key == KEY_SPRING_PRELOAD || flk_quantity_unit_text(s->value).length)
        return 1;
    if (key == KEY_GAS_CLEARANCE)
        return flk_mistake(p->mistakes, s->place,
                           "the clearance needs a unit: a length such as 5 mm, a volume such as 40 "
                           "cm3, or a share of the displacement such as 8 %%");
    return flk_mistake(p->mistakes, s->place, "the %s of a spring needs a unit: %s",
                       flk_key_table[key].name,
                       key == KEY_SPRING_STIFFNESS ? "N/m, or N m/rad of a torsional spring"
                                                   : "N s/m, or N m s/rad of a torsional spring");
}

/* 0 if the quantity of this key is unknown because of a mistake in another key of the section. */
static int has_meaning(const section_use *use, key_code key)
{
    value_form form = flk_key_table[key].form;
    int over;

    if (key == KEY_SPRING_PRELOAD)
        return !use->is_mistaken;
    if (use->section != SECTION_LOAD ||
        (form != FORM_VECTOR && form != FORM_CURVE && key != KEY_LOAD_AT_SPEED))
        return 1;
    if (!read_over(use, &over))
        return 0;
    if (key == KEY_LOAD_BACK)
        return !FLK_IS_SPEED(over) && IS_SET(flk_setting_of(use, KEY_LOAD_FORCE)) !=
                                          IS_SET(flk_setting_of(use, KEY_LOAD_TORQUE));
    return key != KEY_LOAD_AT_SPEED || FLK_IS_SPEED(over);
}

/* 1 if a value keeps its characters: a title, and names. */
static int is_verbatim(key_code code, text value)
{
    return code == KEY_TOP_TITLE || code == KEY_GRADING_TEXT || code == KEY_TABLE_COLUMNS ||
           code == KEY_SWEEP_OUTPUT || flk_curve_text_file(value, NULL);
}

/* `drawn` needs a drawing. */
static int check_drawn(parser *p, const setting *s)
{
    return (p->is_answers ? p->d->pins.is_there
                          : flk_section_find(p, SECTION_PINS, NULL) != NULL) ||
           flk_mistake(p->mistakes, s->place,
                       "'drawn' needs [pins], the places of the pins as drawn");
}

/* Read `unknown at 30 deg` as a force of 1 N, and `unknown` as a torque of 1 N m, of a load that drives. */
static int read_unknown(parser *p, key_code code, setting *s)
{
    static const char unknown[] = "unknown";
    text front = s->value, rest = flk_text_from(s->value, sizeof unknown - 1), value = s->value;

    s->word = 0;
    if ((code != KEY_LOAD_FORCE && code != KEY_LOAD_TORQUE) || value.length < sizeof unknown - 1)
        return 0;
    front.length = sizeof unknown - 1;
    if (!flk_text_equal(front, unknown) || (rest.length && !flk_text_blank(rest)))
        return 0;
    s->word = 1;
    s->value = flk_text_of(flk_reader_copy(p, flk_text_of(code == KEY_LOAD_FORCE ? "1 N" : "1 N m"),
                                           rest.length ? flk_reader_copy(p, rest, "") : ""));
    flk_curve_text_read(p, s, code == KEY_LOAD_FORCE ? QUANTITY_FORCE : QUANTITY_TORQUE);
    s->value = value;
    return 1;
}

/* An instant may be named by its crank angle, whatever the rows go over. */
static void read_crank(parser *p, const section_use *use, key_code code, setting *s)
{
    int may_name = code == KEY_MOTION_AT || code == KEY_EXPECT_AT || code == KEY_MISPRINT_AT;
    text angle = s->value;

    s->word = flk_text_equal(s->value, "drawn")         ? CRANK_DRAWN
              : may_name && cut_crank(s->value, &angle) ? CRANK_NAMED
                                                        : 0;
    if (IS_DRAWN(s))
        check_drawn(p, s);
    else
        flk_piece_read(p, s, angle,
                       IS_CRANK_NAMED(s) ? QUANTITY_ANGLE : flk_quantity_of_key(use, code),
                       &s->si[0]);
}

static void read_setting(parser *p, const section_use *use, key_code code, setting *s)
{
    const key_info *key = &flk_key_table[code];

    if (!is_verbatim(code, s->value))
        s->value = flk_reader_plain(p, s->value);
    s->argument = quantity_of_argument(use);
    switch (key->form) {
    case FORM_TEXT:
        s->value = flk_text_unquoted(s->value);
        break;
    case FORM_WORD:
    case FORM_LINK:
    case FORM_BODY:
        read_word(p, code, s);
        break;
    case FORM_UNIT:
        if (flk_piece_unit(p, s, s->value, key->q, &s->unit)) {
            set_unit(p->d->units, key->q, s->value, s->unit);
            set_unit(p->d->bare, key->q, s->value, s->unit);
        }
        break;
    case FORM_CRANK:
        read_crank(p, use, code, s);
        break;
    case FORM_QUANTITY:
    case FORM_EITHER:
        s->word = code == KEY_MOTOR_TORQUE && flk_text_equal(s->value, "constant");
        if (s->word)
            break;
        if ((key->form != FORM_EITHER || has_unit(p, code, s)) &&
            flk_piece_read(p, s, s->value, flk_quantity_of_key(use, code), &s->si[0]))
            check_sign(p, key, s);
        break;
    case FORM_COUNT:
        if (read_count(p, s, key->q))
            check_sign(p, key, s);
        break;
    case FORM_LINE:
        flk_vector_read_line(p, s, key->q);
        break;
    case FORM_VECTOR:
    case FORM_POINT:
    case FORM_PLACE:
        s->is_place = key->form == FORM_PLACE;
        if (key->form != FORM_VECTOR)
            flk_vector_read(p, s, key->q);
        else if (!read_unknown(p, code, s))
            flk_curve_text_read(p, s, key->q);
        if (s->parts)
            flk_vector_read_parts(p, s, key->q);
        break;
    case FORM_CURVE:
        if (!read_unknown(p, code, s))
            flk_curve_text_read(p, s, flk_quantity_of_key(use, code));
        break;
    }
}

void flk_values_read_section(parser *p, section_use *use)
{
    key_code k;

    use->is_read = 1;
    for (k = flk_first_key(use->section); k < flk_first_key(use->section + 1); k++) {
        setting *s = flk_setting_of(use, k);

        if (IS_SET(s) && !s->is_read && !s->is_pending) {
            size_t before = flk_mistakes_count(p->mistakes);

            s->is_read = 1;
            if (has_meaning(use, k))
                read_setting(p, use, k, s);
            use->is_mistaken |= flk_mistakes_count(p->mistakes) > before;
        }
    }
}

void flk_values_read(parser *p, int units_only)
{
    size_t i;

    for (i = 0; i < p->n_uses; i++)
        if (!p->uses[i].is_read && p->uses[i].section != SECTION_SWEEP &&
            (p->uses[i].section == SECTION_UNITS) == units_only)
            flk_values_read_section(p, &p->uses[i]);
}
