/* SPDX-License-Identifier: GPL-3.0-or-later
**
** values.c - second pass over a deck: the texts of its settings to values in SI units.
*/
#include <math.h>
#include <string.h>

#include <gsl/gsl_math.h>

#include "base/number.h"
#include "reader.h"

static int is_blank(int c)
{
    return c == ' ' || c == '\t';
}

static int refuse(parser *p, text_place place)
{
    return flk_mistake(p->mistakes, place, "%s", p->why);
}

/* Read the number at the front of `rest`, and the unit `t` (if empty, the deck's); 0 and a mistake if there
** is none. */
static int read_number(parser *p, const setting *s, text *rest, quantity q, double *number)
{
    return flk_quantity_number(rest, s->value, q, number, p->why) || refuse(p, s->place);
}

static int read_unit(parser *p, const setting *s, text t, quantity q, unit *u)
{
    return flk_quantity_unit(t, s->value, q, p->d->units[q].unit, u, p->why) || refuse(p, s->place);
}

static int check_size(parser *p, const setting *s, quantity q, double si)
{
    return flk_quantity_size(si, s->value, q, p->why) || refuse(p, s->place);
}

int flk_values_quantity(parser *p, text_place place, text t, text whole, quantity q,
                        quantity_value *value)
{
    return flk_quantity_read(t, whole, q, p->d->units[q].unit, value, p->why) || refuse(p, place);
}

/* Read a quantity that is a piece of a setting's value. */
static int read_quantity(parser *p, setting *s, text t, quantity q, double *si)
{
    quantity_value value;
    int is_one;

    memset(&value, 0, sizeof value);
    is_one = flk_values_quantity(p, s->place, t, s->value, q, &value);
    s->number = value.number;
    s->unit = value.unit;
    *si = value.si;
    return is_one;
}

void flk_values_direction(double angle, double *x, double *y)
{
    double quarters = angle / M_PI_2, whole = floor(quarters + 0.5);

    *x = cos(angle);
    *y = sin(angle);
    if (fabs(quarters - whole) < 1e-14 && fabs(whole) < 1e6) {
        static const double exact[4] = {1, 0, -1, 0};
        int i = (int)whole % 4;

        i = i < 0 ? i + 4 : i;
        *x = exact[i];
        *y = exact[(i + 3) % 4];
    }
}

/* Where a number starts after a blank, as the value in "20 deg 32 bar"; the text's length if there is
** none. */
static size_t second_number(text t)
{
    size_t i;

    for (i = 1; i < t.length; i++)
        if (is_blank(t.start[i - 1]) && strchr("+-.0123456789", t.start[i]))
            break;
    return t.length ? i : 0;
}

/* Read the next item of a curve, ANGLE VALUE: "20 deg 32 bar", or "20 32" in the deck's units. */
static int read_point(parser *p, const setting *s, text t, quantity q, point *result)
{
    double x, y;
    unit ux, uy;
    text angle;
    size_t i;

    if (!read_number(p, s, &t, QUANTITY_ANGLE, &x))
        return 0;
    i = second_number(t);
    if (i >= t.length)
        return flk_mistake(p->mistakes, s->place,
                           "expected an angle and a value, such as %s, not '%t'",
                           q == QUANTITY_PRESSURE ? "20 deg 32 bar" : "20 deg 3 N m", s->value);
    angle = t;
    angle.length = i;
    t = flk_text_from(t, i);
    if (!read_unit(p, s, angle, QUANTITY_ANGLE, &ux) || !read_number(p, s, &t, q, &y) ||
        !read_unit(p, s, t, q, &uy))
        return 0;
    result->x = flk_unit_to_si(x, ux);
    result->y = flk_unit_to_si(y, uy);
    result->place = s->place;
    result->has_unit = flk_text_trim(t).length > 0;
    result->unit_to_si = flk_unit_to_si(1, uy);
    return check_size(p, s, QUANTITY_ANGLE, result->x) && check_size(p, s, q, result->y);
}

/* Read two columns of bare numbers in the deck's units, separated by blanks or a comma. */
static size_t read_curve_file(parser *p, setting *s, quantity q, text name, point *points,
                              text contents)
{
    setting row = *s;
    text line;
    size_t n = 0;

    row.place.source = flk_reader_copy(p, name, "");
    row.place.line = 0;
    contents = flk_text_without_mark(contents);
    while (!p->out_of_memory && flk_text_split(&contents, '\n', &line)) {
        const char *comma;

        row.place.line++;
        row.value = flk_line_without_comment(line);
        if (!row.value.length)
            continue;
        comma = memchr(row.value.start, ',', row.value.length);
        if (comma) {
            char *copy = flk_reader_copy(p, row.value, "");

            if (!copy)
                break;
            copy[comma - row.value.start] = ' ';
            row.value.start = copy;
        }
        n += read_point(p, &row, row.value, q, &points[n]) != 0;
    }
    return n;
}

static size_t count(text t, int c)
{
    size_t i, n = 0;

    for (i = 0; i < t.length; i++)
        n += t.start[i] == c;
    return n;
}

static text unquoted(text t)
{
    if (t.length >= 2 && t.start[0] == '"' && t.start[t.length - 1] == '"') {
        t = flk_text_from(t, 1);
        t.length--;
    }
    return t;
}

/* file NAME */
static int load_curve(parser *p, setting *s, quantity q, text name)
{
    char file[1024];
    size_t before = p->mistakes->count;
    unsigned long length;
    text contents = {NULL, 0};

    name = unquoted(name);
    if (p->load && name.length && name.length < sizeof file)
        contents.start = p->load(p->host, flk_text_copy(name, file, sizeof file), &length);
    if (!contents.start)
        return flk_mistake(p->mistakes, s->place, "cannot read the file '%t'", name);
    contents.length = length;
    s->curve = flk_reader_keep(p, (count(contents, '\n') + 1) * sizeof *s->curve);
    if (s->curve)
        s->n_points = read_curve_file(p, s, q, name, s->curve, contents);
    if (p->mistakes->count > before)
        s->curve = NULL;
    return 1;
}

/* A value; or a curve: 0 deg 1 bar, 20 deg 32 bar, ... or file NAME. */
static int read_curve(parser *p, setting *s, quantity q)
{
    text rest = s->value, item = rest;
    double number;
    point *c;

    if (rest.length > 5 && memcmp(rest.start, "file", 4) == 0 && is_blank(rest.start[4]))
        return load_curve(p, s, q, flk_text_trim(flk_text_from(rest, 5)));
    if (flk_number_read(&item, &number) == NUMBER_COMMA) /* 0,5 N m */
        return read_quantity(p, s, rest, q, &number);
    if (!memchr(rest.start, ',', rest.length) && second_number(rest) >= rest.length &&
        q != QUANTITY_PRESSURE)
        return read_quantity(p, s, rest, q, &s->si[0]);
    c = flk_reader_keep(p, (count(rest, ',') + 1) * sizeof *c);
    while (c && flk_text_split(&rest, ',', &item)) {
        const point *new = &c[s->n_points];

        item = flk_text_trim(item);
        if (!item.length && !rest.start)
            break; /* a comma at the very end */
        if (!read_point(p, s, item, q, &c[s->n_points++]))
            return 0;
        if (new->unit_to_si != c->unit_to_si &&new->has_unit != c->has_unit)
            return flk_mistake(p->mistakes, s->place,
                               "either all values of a curve have a unit or none has");
    }
    s->curve = c;
    return 1;
}

static int refuse_components(parser *p, const setting *s, quantity q)
{
    return flk_mistake(p->mistakes, s->place, "expected two components, such as %s, not '%t'",
                       q == QUANTITY_FORCE ? "(43, 25) N" : "(10, 5) mm", s->value);
}

/* (10, 5) mm */
static int read_components(parser *p, setting *s, quantity q)
{
    text rest = flk_text_from(s->value, 1), inside, x;
    unit u;
    int i;

    flk_text_split(&rest, ')', &inside);
    if (!rest.start || count(inside, ',') != 1)
        return refuse_components(p, s, q);
    if (!read_unit(p, s, rest, q, &u))
        return 0;
    for (i = 0; i < 2; i++) {
        double number;

        flk_text_split(&inside, ',', &x);
        if (!read_number(p, s, &x, q, &number))
            return 0;
        if (flk_text_trim(x).length)
            return refuse_components(p, s, q);
        s->si[i] = flk_unit_to_si(number, u);
        if (!check_size(p, s, q, s->si[i]))
            return 0;
    }
    return 1;
}

static int refuse_vector(parser *p, const setting *s, int needs_angle)
{
    return flk_mistake(p->mistakes, s->place,
                       needs_angle
                           ? "expected a force with its direction, such as 50 N at 30 deg or "
                             "(43, 25) N, not '%t'"
                           : "expected a point, such as 10 mm at 5 deg or (10, 5) mm, not '%t'",
                       s->value);
}

/* 10 mm at 30 deg, or (10, 5) mm; also 10 mm if the angle is not needed. */
static int read_vector(parser *p, setting *s, quantity q, int needs_angle)
{
    text size_text = s->value, angle_text, before;
    double size, angle = 0, x, y;

    if (s->value.start[0] == '(')
        return read_components(p, s, q);
    if (memchr(s->value.start, ',', s->value.length))
        return refuse_vector(p, s, needs_angle);
    if (flk_text_cut_last(s->value, " ", &before, &angle_text) && flk_text_same(angle_text, "at"))
        return flk_mistake(p->mistakes, s->place, "expected an angle after 'at', not '%t'",
                           s->value);
    if (flk_text_cut(s->value, " at ", &size_text, &angle_text)) {
        if (!read_quantity(p, s, angle_text, QUANTITY_ANGLE, &angle))
            return 0;
    } else if (needs_angle) {
        return refuse_vector(p, s, needs_angle);
    }
    if (!read_quantity(p, s, size_text, q, &size))
        return 0;
    flk_values_direction(angle, &x, &y);
    s->si[0] = size * x;
    s->si[1] = size * y;
    return 1;
}

static void read_word(parser *p, key_code key, setting *s)
{
    const char *known[16];
    char list[WORDS_SIZE];
    size_t i, n = 0;

    for (i = 0; flk_word_table[i].word; i++)
        if (flk_word_table[i].key == key) {
            if (flk_text_equal(s->value, flk_word_table[i].word)) {
                s->word = flk_word_table[i].value;
                return;
            }
            known[n++] = flk_word_table[i].word;
        }
    known[n] = NULL;
    flk_mistake(p->mistakes, s->place, "expected %s, not '%t'%h", flk_list_words(key, "", "", list),
                s->value, flk_text_nearest(s->value, known));
}

static void check_sign(parser *p, const key_info *key, const setting *s)
{
    if (key->sign == SIGN_POSITIVE && !(s->si[0] > 0))
        flk_mistake(p->mistakes, s->place, "the %s must be positive, not %t", key->name, s->value);
    else if (key->sign == SIGN_NOT_NEGATIVE && s->si[0] < 0)
        flk_mistake(p->mistakes, s->place, "the %s must not be negative:  %t", key->name, s->value);
    else if (key->q == QUANTITY_LENGTH && key->sign == SIGN_POSITIVE &&
             (s->si[0] < FOURLINK_LENGTH_MIN || s->si[0] > FOURLINK_LENGTH_MAX))
        flk_mistake(p->mistakes, s->place, "'%t' is out of range", s->value);
}

/* The name of a unit for tables, as one word: kgf.m for "kgf m". */
static void name_unit(text t, char name[DECK_NAME_SIZE])
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

/* Areas are in the square of the unit of length, unless that has its own exponent. */
static void set_area(deck *d)
{
    const deck_unit *length = &d->units[QUANTITY_LENGTH];
    deck_unit *area = &d->units[QUANTITY_AREA];
    size_t n = strlen(length->name), i;

    for (i = 0; i < n; i++)
        if (!flk_text_is_word(length->name[i]) || n > 8)
            return;
    strcpy(area->name, length->name);
    strcat(area->name, "2");
    area->unit.up = length->unit.up * length->unit.up;
    area->unit.down = length->unit.down * length->unit.down;
}

static void set_unit(deck *d, quantity q, text name, unit u)
{
    name_unit(name, d->units[q].name);
    d->units[q].unit = u;
    if (q == QUANTITY_LENGTH)
        set_area(d);
}

/* origin, end, or a point */
static void read_pin(parser *p, setting *s, quantity q)
{
    s->word = flk_text_equal(s->value, "origin") ? PIN_ORIGIN
              : flk_text_equal(s->value, "end")  ? PIN_END
                                                 : PIN_POINT;
    if (s->word == PIN_POINT)
        read_vector(p, s, q, 0);
}

/* Read the parts of a vector that are set separately; the others come from the whole vector. */
static void read_parts(parser *p, setting *s, quantity q)
{
    double part[PART_NONE], x, y;
    int i, is_polar = 0;

    part[PART_X] = s->si[0];
    part[PART_Y] = s->si[1];
    part[PART_SIZE] = gsl_hypot(s->si[0], s->si[1]);
    part[PART_ANGLE] = atan2(s->si[1], s->si[0]);
    for (i = 0; i < PART_NONE; i++) {
        setting *own = &s->parts[i];

        if (!IS_SET(own))
            continue;
        read_quantity(p, own, own->value, i == PART_ANGLE ? QUANTITY_ANGLE : q, &own->si[0]);
        part[i] = own->si[0];
        is_polar = i >= PART_SIZE;
    }
    flk_values_direction(part[PART_ANGLE], &x, &y);
    s->si[0] = is_polar ? part[PART_SIZE] * x : part[PART_X];
    s->si[1] = is_polar ? part[PART_SIZE] * y : part[PART_Y];
}

/* A whole number. */
static int read_count(parser *p, setting *s, quantity q)
{
    text t = s->value;

    if (!read_number(p, s, &t, q, &s->si[0]))
        return 0;
    if (t.length || s->si[0] != floor(s->si[0]))
        return flk_mistake(p->mistakes, s->place, "expected a whole number, not '%t'", s->value);
    return 1;
}

static void read_value(parser *p, key_code code, setting *s)
{
    const key_info *key = &flk_key_table[code];

    switch (key->form) {
    case FORM_TEXT:
        s->value = unquoted(s->value);
        break;
    case FORM_WORD:
        read_word(p, code, s);
        break;
    case FORM_UNIT:
        if (read_unit(p, s, s->value, key->q, &s->unit))
            set_unit(p->d, key->q, s->value, s->unit);
        break;
    case FORM_QUANTITY:
        if (read_quantity(p, s, s->value, key->q, &s->si[0]))
            check_sign(p, key, s);
        break;
    case FORM_COUNT:
        if (read_count(p, s, key->q))
            check_sign(p, key, s);
        break;
    case FORM_VECTOR:
    case FORM_POINT:
        read_vector(p, s, key->q, key->form == FORM_VECTOR);
        if (s->parts)
            read_parts(p, s, key->q);
        break;
    case FORM_PIN:
        read_pin(p, s, key->q);
        break;
    case FORM_CURVE:
        read_curve(p, s, key->q);
        break;
    case FORM_NAMES:
    default:
        break;
    }
}

void flk_values_read_section(parser *p, const section_use *use)
{
    key_code k;

    for (k = flk_first_key(use->section); k < flk_first_key(use->section + 1); k++) {
        setting *s = flk_setting_of(use, k);

        if (IS_SET(s) && s->value.length)
            read_value(p, k, s);
    }
}

void flk_values_read(parser *p, int units_only)
{
    size_t i;

    for (i = 0; i < p->n_uses; i++)
        if (p->uses[i].section != SECTION_SWEEP &&
            (p->uses[i].section == SECTION_UNITS) == units_only)
            flk_values_read_section(p, &p->uses[i]);
}
