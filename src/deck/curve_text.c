/* SPDX-License-Identifier: GPL-3.0-or-later
**
** curve_text.c - curves over the crank angle from the text of a deck, or from a file that it names.
*/
#include <string.h>

#include "base/number.h"
#include "reader.h"

static int is_blank(int c)
{
    return c == ' ' || c == '\t';
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

/* 1 if an item follows a digit and a comma, without a blank, as 5 does in 1,5. */
static int follows_comma(text item, text whole)
{
    return item.start - whole.start > 1 && item.start[-1] == ',' &&
           strchr("0123456789", item.start[-2]) != NULL;
}

/* Read the next item of a curve, ANGLE VALUE: "20 deg 32 bar", or "20 32" in the deck's units. */
static int read_point(parser *p, const setting *s, text t, quantity q, point *result)
{
    double x, y;
    unit ux, uy;
    text item = t, angle;
    size_t i;

    if (!flk_values_number(p, s, &t, QUANTITY_ANGLE, &x))
        return 0;
    i = second_number(t);
    if (i >= t.length && follows_comma(item, s->value))
        return flk_mistake(p->mistakes, s->place,
                           "'%t': a comma as decimal mark? write a point, and a blank after the "
                           "comma between two points of a curve",
                           s->value);
    if (i >= t.length)
        return flk_mistake(p->mistakes, s->place,
                           "expected an angle and a value, such as %s, not '%t'",
                           q == QUANTITY_PRESSURE ? "20 deg 32 bar" : "20 deg 3 N m", s->value);
    angle = t;
    angle.length = i;
    t = flk_text_from(t, i);
    if (!flk_values_unit(p, s, angle, QUANTITY_ANGLE, &ux) || !flk_values_number(p, s, &t, q, &y) ||
        !flk_values_unit(p, s, t, q, &uy))
        return 0;
    result->x = flk_unit_to_si(x, ux);
    result->y = flk_unit_to_si(y, uy);
    result->place = s->place;
    result->has_unit = flk_text_trim(t).length > 0;
    result->unit_to_si = flk_unit_to_si(1, uy);
    return flk_values_size(p, s, QUANTITY_ANGLE, result->x) && flk_values_size(p, s, q, result->y);
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

int flk_curve_text_file(text value, text *name)
{
    text after = flk_text_from(value, value.length < 4 ? value.length : 4);

    if (memcmp(value.start, "file", value.length - after.length) != 0 || !flk_text_blank(after))
        return 0;
    if (name)
        *name = flk_text_trim(after);
    return 1;
}

/* file NAME */
static int load_curve(parser *p, setting *s, quantity q, text name)
{
    char file[1024];
    size_t before = p->mistakes->count;
    unsigned long length;
    text contents = {NULL, 0};

    name = flk_text_unquoted(name);
    if (p->load && name.length && name.length < sizeof file)
        contents.start = p->load(p->host, flk_text_copy(name, file, sizeof file), &length);
    if (!contents.start)
        return flk_mistake(p->mistakes, s->place, "cannot read the file '%t'", name);
    contents.length = length;
    s->curve = flk_reader_keep(p, (flk_text_count(contents, '\n') + 1) * sizeof *s->curve);
    if (s->curve)
        s->n_points = read_curve_file(p, s, q, name, s->curve, contents);
    if (p->mistakes->count > before)
        s->curve = NULL;
    return 1;
}

int flk_curve_text_read(parser *p, setting *s, quantity q)
{
    text rest = s->value, item = rest;
    double number;
    point *c;

    if (flk_curve_text_file(rest, &item))
        return load_curve(p, s, q, item);
    if (flk_number_read(&item, &number) == NUMBER_COMMA) /* 0,5 N m */
        return flk_values_piece(p, s, rest, q, &number);
    if (!memchr(rest.start, ',', rest.length) && second_number(rest) >= rest.length &&
        q != QUANTITY_PRESSURE)
        return flk_values_piece(p, s, rest, q, &s->si[0]);
    c = flk_reader_keep(p, (flk_text_count(rest, ',') + 1) * sizeof *c);
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
